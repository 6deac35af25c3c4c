#!/usr/bin/env python3
"""reproduced_tables.py CLEARCUT [--long] [FOLDER]: makes docs/reproduced.html, and from the same run of `clearcut reproduce` the tables of
docs/tour.md and docs/methods.md that stand between marks naming this script.

With --long the table of the published genetic algorithm is made instead, from two runs that take half an hour of a core; all others take
ten minutes. FOLDER (build/reproduced) keeps what is done, so that a call that was broken off is taken up and a second one takes no time;
remove a file of it to have its tables made again. The reference instances are read from tsp/ in $CLEARCUT_DATA.
"""
import json
import pathlib
import re
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
# Those of the published algorithm; fi10639 ends by the clock, so that its figures are those of one machine and its load.
LONG = ["genetic", "genetic-lattices"]
LEFT_OUT = ["fi10639", *LONG]


def table(heading, rows):
    """Markdown."""
    lines = ["| " + " | ".join(row) + " |" for row in [heading, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(heading), *lines[1:]])


def plain(cell):
    """A cell without its mark, with the sign for an error."""
    return cell.replace(" (differs)", "").replace(" +- ", " ± ")


def rows_of(tables, name):
    return [[plain(cell) for cell in row] for row in tables[name]["rows"] if row]


def lengths(tables, shape, title):
    rows = [[row[1], row[6], row[7]] for row in rows_of(tables, "lengths") if row[0] == shape]
    return table([f"{title}, R = 4, step 7.2 mm", "total, theirs", "ours"], rows)


def genetic(tables):
    rows = []
    for row in rows_of(tables, "genetic") + rows_of(tables, "genetic-lattices"):
        points, objective, optimum, printed, fitness, ours, ours_fitness, error, _, runs, thousands, _, operators = row
        if operators != "as published":
            continue
        points = points.removesuffix(".tsp").upper() if points.endswith(".tsp") else points
        share = f"{ours_fitness} ± {error} %" if error else f"{ours_fitness} %"
        rows.append([points, objective, optimum, printed, f"{float(fitness):g} %", ours, share, runs, f"{thousands} thousand"])
    return table(["points", "objective", "optimum", "printed", "fitness", "ours", "fitness", "runs", "individuals"], rows)


def readings(tables):
    """Table 6.5: the reading that is nearest to print."""
    all_rows = rows_of(tables, "fishhead")
    printed = [row for row in all_rows if row[0].startswith("printed")]
    of = {row[0]: row for row in all_rows}
    ours, deep = of["D, layers that hold material"], of["D, every 2 mm layer"]
    columns = [(1, " mm"), (4, ""), (5, " mm"), (8, "°")]

    def spread(column, unit):
        values = sorted(int(row[column]) for row in printed)
        return f"{values[0]} to {values[-1]}{unit}"

    rows = [["printed, least to most"] + [spread(*column) for column in columns],
            ["ours, that reading"] + [ours[at] + unit for at, unit in columns],
            ["ours / the text's GA"] + [f"{int(ours[at]) / int(printed[0][at]):.2f}" for at, _ in columns],
            ["FACE3 from the top of the part"] + [deep[at] + unit for at, unit in columns]]
    return table(["", "feed, bidirectional", "turns", "feed, spiral", "turn angle"], rows)


def programs(tables):
    """Table 6.5 by programs: the whole part."""
    rows, travel = [], ""
    for row in rows_of(tables, "fishhead-published"):
        if row[1] == "printed":
            travel = row[0]
        if row[1] == "printed" or row[0] == "all":
            name = {"printed": f"{travel}, printed", "published": "published algorithm", "ours": "ours, one seed"}[row[1]]
            rows.append([name, *row[2:]])
    return table(["", "feed", "rapid", "total", "turns", "turn angle", "time", "left uncut", "rapids in material"], rows)


def tours_of_grids(tables):
    """Objective -> row of table 6.4, for each grid."""
    grids = {}
    for row in rows_of(tables, "objectives"):
        if row[0] != "printed":
            grids.setdefault(row[0], {})[row[2]] = row
    return grids


def objectives(tables):
    rows = []
    for grid, of in tours_of_grids(tables).items():
        name, points = grid.replace("PLANAR_", ""), of["length"][1]
        all_three = of.get("1 : 20 : 0.1")
        beside = [f"{all_three[4]} %", f"{all_three[6]} %", of["turns"][7], all_three[7]] if all_three else [""] * 4
        gaps = [f"{of[one][10]} %" if of[one][10] else "none" for one in ("length", "turns", "turn angle", "time")]
        rows.append([name, points, *beside, *gaps])
    return table(["grid", "points", "length over", "turns over", "deviation, turns alone", "all three", "gap of length", "turns",
                  "angle", "time"], rows)


# Grid -> the length (mm) for which the integer programme of docs/tour.md was solved, and the turns that it proves at least.
PROVEN = {"FACE3": (2764.5, 51), "FACE4": (1653.5, 35), "100x100, 4 islands": (1494.8, 32)}


def turns_of_short_tours(tables):
    rows = []
    for grid, of in tours_of_grids(tables).items():
        name = grid.replace("PLANAR_", "")
        if name not in PROVEN:
            continue
        solved_for, at_least = PROVEN[name]
        longest = 1.01 * min(float(row[3]) for row in of.values())
        if abs(longest - solved_for) > 1:  # lengths are printed to the millimetre
            raise SystemExit(f"{name}: {longest:.1f} mm are 1.01 of the least length, and the programme was solved for {solved_for}")
        rows.append([name, f"{solved_for} mm", str(at_least), str(min(int(row[5]) for row in of.values()))])
    return table(["", "length at most 1.01 of the least", "turns at least", "fewest turns found, at any length"], rows)


def engagement(tables):
    spacings = {}  # target -> [eq. 4.8, matched], each of raster and exact
    for row in rows_of(tables, "tour-engagement"):
        spacings.setdefault(row[0], []).append(row)
    rows = []
    for target, of in spacings.items():
        at = int(target.removesuffix(" %")) // 10
        cells = [target]
        for raster, exact in (of[0:2], of[2:4]):
            within = sum(int(bin) for bin in exact[5:][at - 1 : at + 1])
            cells += [f"{float(raster[1]):g} mm", raster[4], exact[4], f"{within} %"]
        rows.append(cells)
    return table(["target", "eq. 4.8", "raster", "exact", "within", "matched", "raster", "exact", "within"], rows)


# Page -> name of a mark -> what stands there.
MADE = {
    "methods.md": {"lengths of the star": lambda tables: lengths(tables, "concave", "four-pointed star"),
                   "lengths of the quadrilateral": lambda tables: lengths(tables, "convex", "quadrilateral")},
    "tour.md": {"fishhead": readings, "fishhead-published": programs, "objectives": objectives,
                "turns of short tours": turns_of_short_tours, "tour-engagement": engagement},
}

MADE_OF_LONG = {"tour.md": {"genetic": genetic}}


def with_made(text, name, made):
    begin = re.search(f"<!-- {name}: made by scripts/docs/reproduced_tables.py(?: --long)? -->", text)[0]
    end = f"<!-- end of {name} -->"
    before, rest = text.split(begin)
    return f"{before}{begin}\n\n{made}\n\n{end}{rest.split(end)[1]}"


def reproduced(command, names, file, page):
    """Name -> table as `clearcut reproduce --json` writes it; `page` holds all of them."""
    written = ["--html", page] if page else []
    subprocess.run([command, "reproduce", *names, "--json", file, "--resume", *written], check=True, stdout=subprocess.DEVNULL)
    return {one["name"]: one for one in json.loads(file.read_text())}


def all_names(command):
    listed = subprocess.run([command, "reproduce", "--list"], check=True, capture_output=True, text=True).stdout
    return re.findall(r"^([a-z0-9-]+)(?: \*)?  ", listed, re.MULTILINE)[1:]  # under a heading


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--long"]
    is_long = len(arguments) + 1 < len(sys.argv)
    command = str(pathlib.Path(arguments[0]).resolve())
    folder = pathlib.Path(arguments[1] if len(arguments) > 1 else "build/reproduced")
    folder.mkdir(parents=True, exist_ok=True)
    names = LONG if is_long else [name for name in all_names(command) if name not in LEFT_OUT]
    tables = reproduced(command, names, folder / ("long.json" if is_long else "reproduced.json"),
                        None if is_long else DOCS / "reproduced.html")
    for page, marks in (MADE_OF_LONG if is_long else MADE).items():
        text = (DOCS / page).read_text()
        for name, make in marks.items():
            text = with_made(text, name, make(tables))
        (DOCS / page).write_text(text)


if __name__ == "__main__":
    main()
