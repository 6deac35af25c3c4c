#!/usr/bin/env python3
"""Random parts of all kinds of cutters, planned, mutated, and judged twice: by the product, and by a field of heights.

    campaign.py CLEARCUT JUDGE FOLDER [--first SEED] [--parts N] [--mutants N] [--seconds S] [--anew]

Each part is one line of FOLDER/results.jsonl; parts that stand there are not made again, so that a campaign may end and go on at any
time. What the two judges see differently stays in FOLDER: part, description and program. Ends with 1 where the field is certain that
something is wrong that the product does not call FAULTY, where a plan is FAULTY, and where a command crashes or hangs.
"""
import argparse
import collections
import json
import pathlib
import random
import re
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from mutants import mutants  # noqa: E402
from parts import make  # noqa: E402

ACCEPTED = [word for name in ("out-of-reach", "engraved-by-mill", "leaning-walls", "loose-part") for word in ("--accept", name)]
VERDICTS = ("CLEAN", "CONDITIONAL", "FAULTY")
ASKED_OF_CHECKS = ("--tabs", "--finish")
LONGEST = 120    # seconds of one command


class Bench:
    def __init__(self, command, judge, folder):
        self.command, self.judge, self.folder = command, judge, folder

    def run(self, words):
        """The verdict of a command, and what it printed. Other outcomes are REFUSED, CRASHED and HUNG."""
        try:
            done = subprocess.run([self.command, *words], capture_output=True, text=True, timeout=LONGEST)
        except subprocess.TimeoutExpired:
            return "HUNG", ""
        lines = [line.strip() for line in done.stdout.splitlines() if line.strip()]
        verdict = next((line for line in lines if line in VERDICTS), "REFUSED" if done.returncode > 0 else "CRASHED")
        return verdict, (done.stdout + done.stderr).strip()

    def plan(self, part, file, program):
        words = ["plan", file, "-o", program, "--quiet", *ACCEPTED, *part.tools()]
        verdict, said = self.run(words + part.options)
        while verdict == "REFUSED" and part.options:
            # A wish that cannot be met with this part and these tools: without it.
            part.options = without_refused(part.options, said)
            verdict, said = self.run(words + part.options)
        return verdict, said

    def check(self, part, file, program):
        asked = [word for i, word in enumerate(part.options)
                 if word in ASKED_OF_CHECKS or (i > 0 and part.options[i - 1] in ASKED_OF_CHECKS) or word == "--rest"]
        return self.run(["verify", program, "--part", file, "--quiet", *ACCEPTED, *part.tools(), *asked])

    def field(self, description, programs):
        """What the field of heights is certain of, a text for each program; the first is the plan."""
        done = subprocess.run([self.judge, description, *programs], capture_output=True, text=True, timeout=10 * LONGEST)
        if done.returncode != 0:
            sys.exit(f"{self.judge} {description}: {done.stderr}")
        return done.stdout.split("\n")[:len(programs)]

    def part(self, seed, count):
        """One part with its mutants, as a line of the results."""
        part = make(seed)
        ending, text = part.text()
        file, description, program = (str(self.folder / f"{seed}.{e}") for e in (ending, "made", "ngc"))
        pathlib.Path(file).write_text(text)
        verdict, said = self.plan(part, file, program)
        # Cutters have their numbers in the order of the command line.
        pathlib.Path(description).write_text(part.description())
        line = {"seed": seed, "kinds": part.kinds, "plan": verdict, "words": " ".join(part.tools() + part.options), "mutants": []}
        kept = set()
        if verdict not in ("CLEAN", "CONDITIONAL", "FAULTY"):
            line["said"] = said[:300]
        elif verdict == "FAULTY":
            line["said"], line["field"] = said[:300], self.field(description, [program])[0]
            kept.add(program)
        else:
            kept |= self.mutate(seed, count, part, file, description, program, line)
        if not kept and verdict not in ("CRASHED", "HUNG"):
            for path in (file, description, program):
                pathlib.Path(path).unlink(missing_ok=True)
        return line

    def mutate(self, seed, count, part, file, description, program, line):
        """Adds the plan's and the mutants' verdicts to the line; the programs to keep."""
        checked, said = self.check(part, file, program)
        asked = conditions(said)
        if checked != line["plan"]:
            line["checked"], line["said"] = checked, said[:300]
        made = mutants(pathlib.Path(program).read_text(), count, random.Random(seed + 1))
        files = []
        for i, (_, text) in enumerate(made):
            files.append(str(self.folder / f"{seed}_{i}.ngc"))
            pathlib.Path(files[-1]).write_text(text)
        field = self.field(description, [program, *files])
        line["field"] = field[0]
        kept = {program} if field[0] or "checked" in line else set()
        for (kind, _), name, wrongs in zip(made, files, field[1:]):
            verdict, said = self.check(part, file, name)
            if verdict == "CONDITIONAL" and conditions(said) <= asked:
                verdict = "CLEAN"    # but for what is asked of the plan
            line["mutants"].append([kind, verdict, wrongs])
            if verdict in ("CRASHED", "HUNG") or (wrongs and verdict == "CLEAN"):
                kept |= {program, name}
            else:
                pathlib.Path(name).unlink()
        return kept


def without_refused(options, said):
    """The options but for the one whose refusal was said; where none was named, only those that hold the part."""
    named = re.search(r"clearcut: (--[a-z-]+): ", said)
    if named and named.group(1) in options:
        i = options.index(named.group(1))
        end = next((k for k in range(i + 1, len(options)) if options[k].startswith("--")), len(options))
        return options[:i] + options[end:]
    kept = options[options.index("--tabs"):][:2] if "--tabs" in options else []
    return [] if kept == options else kept


def conditions(said):
    """The names of the open conditions that a command has printed."""
    return {line.split(":")[0] for line in said.splitlines() if line.startswith("condition")}


def tally(lines):
    """Numbers of plans and mutants by what both judges say."""
    counts = collections.Counter()
    for line in lines:
        counts["plans", both(line["plan"], line.get("field", ""))] += 1
        if "checked" in line:
            counts["plans", f"{line['checked']} by verify, {line['plan']} by plan"] += 1
        for kind, verdict, wrongs in line["mutants"]:
            counts["mutants", both(verdict, wrongs)] += 1
    return counts


def both(verdict, wrongs):
    if verdict in ("REFUSED", "CRASHED", "HUNG"):
        return verdict.lower()
    if verdict == "FAULTY":
        return "wrong by both" if wrongs else "FAULTY, the field sees nothing"
    if verdict == "CONDITIONAL":
        return "CONDITIONAL, wrong by the field" if wrongs else "CONDITIONAL, the field sees nothing"
    return "HOLE: wrong by the field alone" if wrongs else "right by both"


def asked_of(doc, kind, number, mutants):
    """What a campaign of `number` parts or files, which are its `kind`, is asked by default; its folder is made."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("clearcut")
    parser.add_argument("judge")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=1, help=f"seed of the first of the {kind}")
    parser.add_argument(f"--{kind}", dest="number", type=int, default=number)
    parser.add_argument("--mutants", type=int, default=mutants, help=f"of each of the {kind}")
    parser.add_argument("--seconds", type=float, default=float("inf"), help=f"no more {kind} after this time")
    parser.add_argument("--anew", action="store_true", help="forget earlier results of the folder")
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    return asked


def judged(asked, results, judge):
    """The lines of all seeds: those that stand in the file of results, and new ones by judge(seed), which are appended to it at once."""
    if asked.anew:
        results.unlink(missing_ok=True)
    lines = [json.loads(line) for line in results.read_text().splitlines()] if results.exists() else []
    done, end = {line["seed"] for line in lines}, time.monotonic() + asked.seconds
    for seed in range(asked.first, asked.first + asked.number):
        if seed in done:
            continue
        if time.monotonic() > end:
            break
        lines.append(judge(seed))
        with results.open("a") as out:
            out.write(json.dumps(lines[-1]) + "\n")
    return lines


def main():
    asked = asked_of(__doc__, "parts", 2000, 3)
    bench = Bench(asked.clearcut, asked.judge, asked.folder)
    lines = judged(asked, asked.folder / "results.jsonl", lambda seed: bench.part(seed, asked.mutants))
    counts = tally(lines)
    for (what, said), count in sorted(counts.items()):
        print(f"{count:6} {what}: {said}")
    bad = [said for what, said in counts if said.startswith(("HOLE", "crashed", "hung"))
           or (what == "plans" and ("FAULTY" in said or said.startswith("wrong") or "by verify" in said))]
    return 1 if bad or not lines else 0


if __name__ == "__main__":
    sys.exit(main())
