#!/usr/bin/env python3
"""Times of plans on three machines, by each way to feed, and against another build of the command.

    benchmarks/machine_times.py CLEARCUT SHAPE.json... [--before OTHER_CLEARCUT] [--strategy NAME]...

For each shape, strategy and machine one line: certified time by the planner of LinuxCNC and of Grbl, s; length / feed as a share of
LinuxCNC's; with --before the other build's time and the change; the times with --feed-by chip and --feed-by removal and their change;
F words. Machines: A 5000 mm/min, 500 mm/s2, F1000; B the same at F3000; C 10000 mm/min, 2000 mm/s2, F3000.
"""
import argparse
import json
import os
import re
import subprocess
import tempfile

MACHINES = {"A": (5000, 500, 1000), "B": (5000, 500, 3000), "C": (10000, 2000, 3000)}


def planned(command, shape, strategy, machine, more, post="linuxcnc"):
    """Certified seconds, length / feed in seconds, verdict, F words; None where it is refused."""
    rapid, acceleration, feed = MACHINES[machine]
    with tempfile.TemporaryDirectory() as folder:
        program, certificate = os.path.join(folder, "p.ngc"), os.path.join(folder, "p.json")
        words = [command, "plan", shape, "--tool", "endmill:6", "--strategy", strategy, "--feed", str(feed),
                 "--rapid", str(rapid), "--acceleration", str(acceleration), "--post", post,
                 "-o", program, "--certificate", certificate, "--quiet"] + more
        if '"depth"' not in open(shape).read():
            words += ["--depth", "3"]
        subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        if not os.path.exists(certificate):
            return None
        found = json.load(open(certificate))
        text = open(program).read()
    return (found["time_s"], found["time_naive_s"], found["verdict"],
            len(re.findall(r"^[^(;\n]*F[0-9]", text, re.M)))


def change(after, before):
    return f"{after:8.1f} {100 * (after / before - 1):+6.1f} %"


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("command")
    ask.add_argument("shapes", nargs="+")
    ask.add_argument("--before")
    ask.add_argument("--strategy", action="append")
    given = ask.parse_args()
    print("shape strategy machine | time s, Grbl s, length/feed of it | before | by chip | by removal | F words")
    for shape in given.shapes:
        for strategy in given.strategy or ["contour", "adaptive"]:
            limit = ["--engagement", "60"] if strategy == "adaptive" else []
            for machine in MACHINES:
                plain = planned(given.command, shape, strategy, machine, limit)
                if plain is None:
                    continue
                grbl = planned(given.command, shape, strategy, machine, limit, "grbl")
                line = [f"{os.path.basename(shape)[:-5]} {strategy} {machine} |",
                        f"{plain[0]:8.1f} {grbl[0]:8.1f} {plain[1] / plain[0]:5.2f} |"]
                if given.before:
                    other = planned(given.before, shape, strategy, machine, limit)
                    line.append((change(plain[0], other[0]) if other else "refused") + " |")
                words, verdicts = [plain[3]], [plain[2]]
                for by in ("chip", "removal"):
                    one = planned(given.command, shape, strategy, machine, limit + ["--feed-by", by])
                    line.append((change(one[0], plain[0]) if one else "refused") + " |")
                    if one:
                        words.append(one[3])
                        verdicts.append(one[2])
                line.append("/".join(map(str, words)))
                if "FAULTY" in verdicts:
                    line.append("FAULTY")
                print(" ".join(line), flush=True)


if __name__ == "__main__":
    main()
