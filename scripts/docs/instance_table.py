#!/usr/bin/env python3
"""instance_table.py TOUR_BENCHMARK DATA: makes the table of reference instances in docs/tour.md from what the benchmark prints.

DATA is the folder of the TSPLIB files. Takes some four minutes of a core; the seconds are those of the processor, of all threads.
"""
import pathlib
import subprocess
import sys

BEGIN, END = "<!-- instances: made by scripts/docs/instance_table.py -->", "<!-- end of instances -->"
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "tour.md"


def runs_of(benchmark, data):
    """Instance -> runs as the benchmark prints them, in its order."""
    printed = subprocess.run([benchmark, data], check=True, capture_output=True, text=True).stdout
    runs = {}
    for line in printed.splitlines()[1:]:
        words = line.split()
        runs.setdefault(words[0], []).append(words)
    return runs


def row_of(name, runs):
    """Worst of all seeds; columns as the benchmark's heading names them."""
    def worst(column):
        return max(float(run[column]) for run in runs)

    least, most = min(float(run[8]) for run in runs), worst(8)
    to_best = f"{most:.2f}" if f"{least:.2f}" == f"{most:.2f}" else f"{least:.2f} to {most:.2f}"
    at_best = sum(float(run[5]) == 0 for run in runs)
    over = f"{worst(5):.4f} %" if at_best < len(runs) else "0"
    return f"| {name} | {at_best} of {len(runs)} | {worst(3):.0f} | {over} | {to_best} | {worst(10):.2f} | {worst(11):.0f} MB |"


def main():
    rows = [row_of(name, runs) for name, runs in runs_of(sys.argv[1], sys.argv[2]).items()]
    heading = ("| instance | seeds at the best known | length | over it | CPU s to it | CPU s in all | memory |\n"
               "|---|---|---|---|---|---|---|\n")
    text = PAGE.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    PAGE.write_text(text[:begin] + "\n\n" + heading + "\n".join(rows) + "\n\n" + text[end:])


if __name__ == "__main__":
    main()
