"""Checks every program in a folder against one part, into a table: verify_folder.py PART TOOL FOLDER."""
import sys
from pathlib import Path

import pandas

import clearcut

part, tool, folder = sys.argv[1:4]
rows: list[dict[str, object]] = []
for file in sorted(Path(folder).iterdir()):
    if file.suffix not in {".ngc", ".nc", ".gcode", ".tap", ".h"}:
        continue
    try:
        check = clearcut.verify_file(part, file, tools=tool)
    except clearcut.InputError as error:
        rows.append({"program": file.name, "verdict": "UNREADABLE", "worst": str(error)})
        continue
    figures = check.findings.all
    rows.append({"program": file.name, "read as": check.dialect, "verdict": check.verdict, "time, s": round(figures.time_s, 1),
                 "gouge, mm": round(figures.gouge_mm, 3), "uncut, mm": round(figures.uncut_thickness_mm, 3),
                 "rapids in material": figures.rapid_in_material,
                 "worst": check.faults[0].text if check.faults else ""})
table = pandas.DataFrame(rows)
table.to_csv("programs.csv", index=False)
print(table.to_string(index=False))
