#!/usr/bin/env python3
"""instance_table.py PRINTED: makes the table of reference instances in docs/tour.md from what the benchmark printed.

PRINTED is a file: `tour_benchmark DATA "" 0 60 1 > PRINTED` with the folder of the TSPLIB files, 60 seconds by the clock and one thread
takes some six minutes of a core. The seconds of the table are those of the processor.
"""
import pathlib
import sys

BEGIN, END = "<!-- instances: made by scripts/docs/instance_table.py -->", "<!-- end of instances -->"
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "tour.md"


def runs_of(printed):
    """Instance -> runs as the benchmark prints them, in its order."""
    runs = {}
    for line in printed.splitlines()[1:]:
        words = line.split()
        runs.setdefault(words[0], []).append(words)
    return runs


def row_of(name, runs):
    """Worst of all seeds; columns as the benchmark's heading names them."""
    def worst(column):
        return max(float(run[column]) for run in runs)

    def spread(column):
        least, most = f"{min(float(run[column]) for run in runs):.2f}", f"{worst(column):.2f}"
        return most if least == most else f"{least} to {most}"

    at_best = sum(float(run[5]) == 0 for run in runs)
    over = f"{worst(5):.4f} %" if at_best < len(runs) else "0"
    return f"| {name} | {at_best} of {len(runs)} | {worst(3):.0f} | {over} | {spread(8)} | {spread(10)} | {worst(11):.0f} MB |"


def main():
    rows = [row_of(name, runs) for name, runs in runs_of(pathlib.Path(sys.argv[1]).read_text()).items()]
    heading = ("| instance | seeds at the best known | length | over it | CPU s to it | CPU s in all | memory |\n"
               "|---|---|---|---|---|---|---|\n")
    text = PAGE.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    PAGE.write_text(text[:begin] + "\n\n" + heading + "\n".join(rows) + "\n\n" + text[end:])


if __name__ == "__main__":
    main()
