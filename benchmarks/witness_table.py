#!/usr/bin/env python3
"""The witnesses of the examples as a table: tiles, bytes, seconds, engagement.

    witness_table.py COMMAND [CONTROLLER ...]

COMMAND is the program clearcut, with clearcut-check beside it. Without controllers, linuxcnc alone; "all" for all of them, in mm and inches.
"""
import os
import re
import subprocess
import sys
import tempfile
import time

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "examples")
JOBS = [
    ["bracket.json", "--tool", "endmill:6"],
    ["bracket.dxf", "--tool", "endmill:6"],
    ["bracket.svg", "--depth", "5", "--tool", "endmill:6"],
    ["bracket.step", "--tool", "endmill:6"],
    ["bracket.dxf", "--op", "profile_d6:1", "--op", "pocket_d3:2,3", "--tool", "endmill:5"],
    ["bracket.json", "--tool", "endmill:6", "--strategy", "adaptive"],
    ["bracket.toml"],
    ["fishhead.p21"],
    ["fishhead_sloped.p21"],
    ["strategies.p21"],
    ["inch_plate.dxf", "--tool", "endmill:6"],
    ["inlay_hole.dxf", "--depth", "3", "--tool", "endmill:3"],
    ["nested.step", "--tool", "endmill:10", "--tool", "endmill:4", "--rest"],
    ["plate_and_pins.step", "--body", "PLATE", "--tool", "endmill:4"],
    ["sideways.step", "--tool", "endmill:6"],
    ["two_sided.step", "--tool", "endmill:6"],
    ["disc.step", "--tool", "endmill:6"],
    ["handle.step", "--tool", "endmill:6"],
    ["board-Edge_Cuts.gbr", "--depth", "1.6", "--tool", "endmill:2"],
    ["board-PTH.drl", "--depth", "1.6", "--tool", "drill:0.8", "--tool", "drill:1", "--tool", "endmill:0.8"],
]
CONTROLLERS = ["linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3", "mach4", "marlin", "siemens"]


def run(command):
    start = os.times()
    done = subprocess.run(command, capture_output=True, text=True)
    end = os.times()
    return done, end.children_user + end.children_system - start.children_user - start.children_system


def row(command, folder, job, controller, unit):
    program, witness = os.path.join(folder, "p.nc"), os.path.join(folder, "p.ccw")
    for file in (program, witness, witness + ".json"):
        if os.path.exists(file):
            os.remove(file)
    part = os.path.join(EXAMPLES, job[0])
    extra = ["--inch"] if unit == "inch" else []
    planned, _ = run([command, "plan", part, *job[1:], "--post", controller, *extra, "-o", program, "--witness", witness])
    said = planned.stdout + planned.stderr
    name = " ".join(job) + f" | {controller} {unit}"
    if not os.path.exists(witness):
        return f"| {name} | - | - | - | - | {said.strip().splitlines()[-1][:200] if said.strip() else 'nothing said'} |"
    outline = witness + ".json" if os.path.exists(witness + ".json") else part
    checker = os.path.join(os.path.dirname(command), "clearcut-check")
    tiles = options = ""
    for line in said.splitlines():
        found = re.match(r"witness: (\d+) tiles.*?p\.ccw ?(.*)", line)
        if found:
            tiles, options = found[1], found[2].replace(outline, "").replace(witness, "").strip()
    for words in ([], ["--straight"], ["--uncut", "0.012"], ["--uncut", "0.012", "--straight"]):
        checked, seconds = run([checker, program, outline, witness, "--partial", *words])
        if checked.returncode == 0:
            break
    engagement = re.search(r"C4 engagement: at most ([0-9.]+)", checked.stdout)
    missing = [line for line in said.splitlines() if "NOT PROVED" in line]
    rest = "; ".join(missing) or ("accepted" if checked.returncode == 0 else checked.stderr.strip())
    return (f"| {name} | {tiles} | {os.path.getsize(witness)} | {seconds:.2f} | {engagement[1] if engagement else '-'} | "
            f"{' '.join(words)} {rest[:200]} |")


def main():
    command = os.path.abspath(sys.argv[1])
    controllers = sys.argv[2:] or ["linuxcnc"]
    pairs = [(c, u) for c in CONTROLLERS for u in ("mm", "inch")] if controllers == ["all"] else [(c, "mm") for c in controllers]
    print("| job | control | tiles | bytes | checked in, s | engagement | |\n|---|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for job in JOBS if len(pairs) < 3 else [JOBS[0], JOBS[-1]]:
            for controller, unit in pairs:
                print(row(command, folder, job, controller, unit), flush=True)


if __name__ == "__main__":
    main()
