#!/usr/bin/env python3
"""Lists the numbers in the sources of the published methods, and which of them scripts/mutants.sh changes.

Usage: scripts/constants.py [--all]. Prints the lines whose numbers no mutant changes (with --all every line), then both counts.
0, 1, numbers of digits and comments do not count: a change of one of them is a change of structure, which does not compile or is another
rule. Run scripts/mutants.sh to see which mutants the tests find.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = [
    "src/plan/contour/formulas.cpp",
    "src/plan/contour/side_offsets.cpp",
    "src/plan/contour/step_rule.cpp",
    "src/kinematics/kinematics.h",
    "src/kinematics/kinematics.cpp",
    "src/order/objective.h",
    "src/order/objective.cpp",
    "src/order/genetic/genetic.h",
    "src/order/genetic/pool.cpp",
    "src/order/genetic/selection.cpp",
    "src/pipeline/tour/engagement_model.cpp",
    "src/pipeline/tool_sets.cpp",
    "src/plan/grid/interpolate.cpp",
    "src/plan/grid/visit.cpp",
]
NUMBER = re.compile(r"(?<![\w.\"{%:])(\d+\.?\d*(?:e-?\d+)?)(?![\w\"}])")
STRUCTURE = {"0", "1", "0.0", "1.0"}


def mutants():
    """The texts that mutants replace, by source."""
    script = (ROOT / "scripts/mutants.sh").read_text()
    names = dict(re.findall(r"^(\w+)=(src/\S+)$", script, re.M))
    changed = {}
    for source, text in re.findall(r"^mutant (\S+) '([^']*)'", script, re.M):
        source = names.get(source.lstrip("$"), source)
        changed.setdefault(source, []).append(text)
    return changed


def numbers(line):
    code = re.sub(r'"[^"]*"', '""', line.split("//")[0])
    return [one for one in NUMBER.findall(code) if one not in STRUCTURE] if not code.startswith("#") else []


def main():
    changed = mutants()
    found = covered = 0
    for source in SOURCES:
        path = ROOT / source
        if not path.exists():
            sys.exit(f"{source}: no such file; bring SOURCES in {sys.argv[0]} up to date")
        for number, line in enumerate(path.read_text().splitlines(), 1):
            here = numbers(line)
            if not here:
                continue
            is_covered = any(text in line for text in changed.get(source, []))
            found += len(here)
            covered += len(here) if is_covered else 0
            if "--all" in sys.argv or not is_covered:
                print(f"{'changed' if is_covered else 'NOT    '} {source}:{number}: {line.strip()}")
    print(f"{found} numbers in {len(SOURCES)} sources, {covered} on lines that a mutant changes")


if __name__ == "__main__":
    main()
