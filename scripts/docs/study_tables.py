#!/usr/bin/env python3
"""study_tables.py CLEARCUT [FOLDER]: makes the table of studies in docs/tour.md from `clearcut study NAME --minutes`.

FOLDER (build/studies) keeps the rows of the runs, so that a second call takes no time; the first takes some ten minutes of a core.
"""
import pathlib
import re
import subprocess
import sys

# In the order of the text.
STUDIES = ["population", "selection", "crossover", "mutation", "neighbours", "crossover-rate", "mutation-rate", "sensitivity", "size",
           "time", "spread"]
BEGIN, END = "<!-- studies: made by scripts/docs/study_tables.py -->", "<!-- end of studies -->"


def printed(command, name, folder):
    """What the command prints, as Markdown."""
    call = [command, "study", name, "--minutes", "--csv", str(folder / f"{name}.csv"), "--markdown"]
    return subprocess.run(call, check=True, capture_output=True, text=True).stdout


def row_of(name, text):
    """One row of the table: the study, what the text finds, what the runs say of it, their means with the error of 99 %."""
    lines = text.splitlines()
    place, quantity = re.fullmatch(r"### Tour (.*?): (.*)", lines[0]).groups()
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if line.startswith("|")][2:]
    means = ", ".join(f"{level}: {float(mean):.4g} ± {float(error):.2g}" for level, _, mean, error, *_ in cells)
    scale = next(line for line in lines if " generations of " in line)
    scale = re.sub(r", objective length; the text: .*", "", scale)
    findings = [re.fullmatch(r"the text: (.*); here: (.*?) \((?:by )?(.*?)(?:, 99 %)?\)", line) for line in lines]
    findings = [found.groups() for found in findings if found]
    said = "; ".join(f"{text}: {here} ({by.replace('+-', '±')})" for text, here, by in findings) or "prints no finding"
    return f"| `{name}`, {place} | {said} | {quantity}; {scale}, {cells[0][1]} runs each: {means} |"


def main():
    command = str(pathlib.Path(sys.argv[1]).resolve())
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "build/studies")
    folder.mkdir(parents=True, exist_ok=True)
    rows = [row_of(name, printed(command, name, folder)) for name in STUDIES]
    page = pathlib.Path(__file__).resolve().parents[2] / "docs" / "tour.md"
    text = page.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    table = "\n\n| study | the text's findings, and what the runs say of them | ours (mean ± error of 99 %) |\n|---|---|---|\n"
    page.write_text(text[:begin] + table + "\n".join(rows) + "\n\n" + text[end:])


if __name__ == "__main__":
    main()
