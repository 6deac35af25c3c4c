#!/usr/bin/env python3
"""Where the time of planning goes: a table in Markdown, one line for each input.

    benchmarks/planning_profile.py CLEARCUT [--only NAME]... [--without-profile]

The inputs are made here, from fixed seeds: a rectangle with an island, a wavy pocket, smooth and noisy outlines of 100 000 vertices, a
sheet of 500 features, boards of 200 and 2000 pads. Columns: processor time, elapsed time, greatest memory; then the shares of the
samples that lie in or below one stage each, by `perf record` (Linux; the command keeps its tables for unwinding). Shares of
stages within each other do not add up: `shorten` is part of `contour`, which is part of `plan`.
"""
import argparse
import json
import math
import os
import random
import re
import resource
import subprocess
import tempfile
import time

# What is counted, and a function that every sample of it has in its stack.
STAGES = {
    "contour": "contour::plan_contour",
    "shorten": "contour::shorten_passes",
    "rounding": "plan::round_corners",
    "diagrams": "voronoi::make_diagram",
    "link": "link::link_layers",
    "order": "order::solve",
    "out of reach": "pipeline::out_of_reach",
    "coverage": "verify::coverage_of",
    "gouges": "verify::gouge_of",
    "loads": "verify::(anonymous namespace)::measure_moves",
}


def outline(points, islands=()):
    return json.dumps({"name": "profile", "units": "mm", "outer": [[x, y, 0.0] for x, y in points],
                       "islands": [[[x, y, 0.0] for x, y in one] for one in islands], "top": 0.0, "depth": 2.0})


def wave(count, radius, waves, noise=0.0):
    rnd, points = random.Random(1), []
    for i in range(count):
        t = 2 * math.pi * i / count
        r = radius * (1 + sum(share * math.sin(times * t) for times, share in waves)) + noise * rnd.uniform(-1, 1)
        points.append((r * math.cos(t), r * math.sin(t)))
    return points


WIDE = [(5, 0.25), (37, 0.03), (301, 0.004)]


def rectangle():
    return outline([(0, 0), (100, 0), (100, 60), (0, 60)], [[(40, 20), (60, 20), (60, 40), (40, 40)]])


def sheet():
    rnd, entities = random.Random(2), []

    def ring(points, layer):
        entities.append(f"0\nLWPOLYLINE\n8\n{layer}\n90\n{len(points)}\n70\n1\n" +
                        "".join(f"10\n{x:.4f}\n20\n{y:.4f}\n" for x, y in points))

    for k in range(500):
        x, y, kind = k // 20 * 50 + 25, k % 20 * 50 + 25, k % 3
        count, least = [(4, 14), (rnd.randint(5, 12), 10), (60, 15)][kind]
        ring([(x + r * math.cos(t), y + r * math.sin(t)) for t, r in
              ((2 * math.pi * i / count, rnd.uniform(least, 18 if kind < 2 else 15.2)) for i in range(count))],
             ["pocket_d3", "pocket_d3", "profile_d3"][kind])
    return ("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + "".join(entities) +
            "0\nENDSEC\n0\nEOF\n")


def board(pads, tracks):
    rnd, side = random.Random(3), math.ceil(math.sqrt(pads))
    places = [(i % side, i // side) for i in range(pads)]

    def at(x, y, what):
        return f"X{round(x * 2.54e6)}Y{round(y * 2.54e6)}{what}*"

    lines = ["%FSLAX46Y46*%", "%MOMM*%", "%TF.FileFunction,Copper,L1,Top*%", "%ADD10C,1.6*%", "%ADD11R,1.5X1.5*%",
             "%ADD12C,0.25*%", "G01*", "D10*"]
    lines += [at(x, y, "D03") for x, y in places[::2]] + ["D11*"] + [at(x, y, "D03") for x, y in places[1::2]] + ["D12*"]
    for _ in range(tracks):
        x, y = rnd.choice(places)
        dx, dy = rnd.choice([(1, 0), (0, 1)])
        lines += [at(x, y, "D02"), at(min(x + dx, side - 1), min(y + dy, side - 1), "D01")]
    return "\n".join(lines + ["M02*", ""])


MILL = ["--tool", "endmill:6", "--strategy", "contour"]
COPPER = ["--depth", "0.1", "--tool", "endmill:0.2", "--feed", "300", "--strategy", "contour"]
INPUTS = {
    "rectangle with an island": ("part.json", rectangle, MILL),
    "wavy pocket, 200 mm": ("part.json", lambda: outline(wave(400, 78, [(5, 0.25), (17, 0.05)])), MILL),
    "smooth, 100 000 vertices": ("part.json", lambda: outline(wave(100000, 165, WIDE)), MILL),
    "noisy, 100 000 vertices": ("part.json", lambda: outline(wave(100000, 165, WIDE, 0.02)), MILL),
    "sheet of 500 features": ("part.dxf", sheet, ["--tool", "endmill:6", "--op", "pocket_d3:pocket_d3",
                                                  "--op", "profile_d3:profile_d3"]),
    "board of 200 pads": ("board-F_Cu.gbr", lambda: board(200, 320), COPPER),
    "board of 2000 pads": ("board-F_Cu.gbr", lambda: board(2000, 3200), COPPER),
}


def run(words):
    """Processor seconds, elapsed seconds, MB of one child."""
    pid, begun = os.fork(), time.time()
    if pid == 0:
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, 1)
        os.dup2(null, 2)
        os.execvp(words[0], words)
    _, status, used = os.wait4(pid, 0)
    return used.ru_utime + used.ru_stime, time.time() - begun, used.ru_maxrss / 1024, os.waitstatus_to_exitcode(status)


def shares(words, folder, seconds):
    data = os.path.join(folder, "perf.data")
    rate = max(29, min(1999, int(600 / max(seconds, 0.01))))
    subprocess.run(["perf", "record", "-o", data, "--call-graph", "dwarf,16000", "-F", str(rate)] + words,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    text = subprocess.run(["perf", "report", "-i", data, "--children", "-g", "none", "--no-inline", "--stdio"],
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False).stdout
    found = {}
    for name, function in STAGES.items():
        rows = [line for line in text.splitlines()
                if re.search(r"clearcut::[a-z_:]*" + re.escape(function) + r"(\(|$|\s)", line)]
        found[name] = max([float(line.split("%")[0]) for line in rows], default=0.0)
    return found


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("command")
    ask.add_argument("--only", action="append")
    ask.add_argument("--without-profile", action="store_true")
    given = ask.parse_args()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.environ.setdefault("CLEARCUT_MEMORY", "4")
    stages = [] if given.without_profile else list(STAGES)
    print("| input | CPU s | s | MB |" + "".join(f" {name} % |" for name in stages))
    print("|---|---|---|---|" + "---|" * len(stages))
    for name, (file, make, options) in INPUTS.items():
        if given.only and not any(one in name for one in given.only):
            continue
        with tempfile.TemporaryDirectory() as folder:
            part = os.path.join(folder, file)
            with open(part, "w") as out:
                out.write(make())
            words = [given.command, "plan", part, "-o", os.path.join(folder, "p.ngc"), "--quiet"] + options
            cpu, elapsed, memory, code = run(words)
            row = f"| {name} | {cpu:.2f} | {elapsed:.2f} | {memory:.0f} |"
            if stages:
                of_stage = shares(words, folder, cpu)
                row += "".join(f" {of_stage[stage]:.0f} |" for stage in stages)
            print(row + (f" (exit code {code})" if code > 1 else ""), flush=True)


if __name__ == "__main__":
    main()
