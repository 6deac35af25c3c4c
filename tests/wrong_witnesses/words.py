#!/usr/bin/env python3
"""Hides in right programs words that a control reads otherwise than a reader of plain moves might, and has clearcut-check refuse each.

    words.py CHECKER PART FOLDER

FOLDER holds CONTROL.nc and CONTROL.ccw of the part for each control below: a pocket and two drilled holes. The witness stays as it is, about the changed
program: none of the words is a motion, or is one that the control carries out as the witness has it. Ends with 1 where the checker accepts one, or refuses
it for another reason. Where a reason begins with "accepted:" the program is right, and what is taken as true must be said.
"""
import hashlib
import os
import re
import subprocess
import sys
import tempfile

import wrong


def put(before, words):
    """A line before the first one that `before` matches."""
    return lambda text: re.sub(f"(?m)^(?={before})", lambda _: words + "\n", text, count=1)


def instead(old, new):
    return lambda text: re.sub(f"(?m){old}", lambda _: new, text, count=1)


def at_the_end_of(line, words):
    return lambda text: re.sub(f"(?m)^({line}.*)$", lambda found: found[1] + words, text, count=1)


def home_from_the_pocket(way):
    """The last way home begins in the pocket, by this line."""
    return lambda text: re.sub(r"(?m)^G0 Z10\.?\n(M5\n)(?:G91 G28|G53 G0|SUPA G0) Z0.*$(?![\s\S]*^G0 Z10)", lambda found: found[1] + way, text)


LEVEL = "X[0-9.]+\\n"  # a level feed in the pocket
# Control, what the control does, change, why the checker refuses; then numbers of tools that the witness states otherwise.
WORDS = [
    ("linuxcnc", "ends after the dwell", put(LEVEL, "G4 P0.1 M2"), "a dwell with other words"),
    ("linuxcnc", "changes the tool after the dwell", put(LEVEL, "G4 P0.1 M6"), "a dwell with other words"),
    ("fanuc", "begins another program", put(LEVEL, "O0002"), "a second program begins"),
    ("fanuc", "goes to Z0 of the part first", instead("^N1 G91 G28 Z0\\.", "G91 G90 G28 Z0."), "G90 and G91 in one block"),
    ("fanuc", "moves three axes at once out of the pocket", home_from_the_pocket("G91 G28 X0. Y0. Z0."), "straight up first"),
    ("linuxcnc", "moves three axes at once out of the pocket", instead("^G0 Z10\nM5\nM2$", "G53 G0 X0 Y0 Z0\nM5\nM2"), "straight up first"),
    ("siemens", "moves three axes at once out of the pocket", home_from_the_pocket("SUPA G0 X0 Y0 Z0"), "straight up first"),
    ("fanuc", "takes what follows for another block", at_the_end_of("G17 G40", "; G1 Z-50."), "follows the end of a block"),
    ("siemens", "drills at every place until MCALL", put("MCALL$", "G1 X10 Y10"), "a motion while a cycle is called"),
    ("siemens", "drills on the way home", instead("^MCALL\n(?=; OPERATION 3)", "SUPA G0 Z0\nMCALL\n"), "a way home while a cycle is called"),
    ("siemens", "counts the depth from the cylinder's end", instead("CYCLE81\\(10,1,0,-6\\)", "CYCLE81(10,1,0,-6,,,1)"), "is not claimed"),
    ("siemens", "drills along another axis", instead("CYCLE81\\(10,1,0,-6\\)", "CYCLE83(10,1,0,-6,,-2,,,,,1,0,1)"), "is not claimed"),
    ("siemens", "moves after the call", instead("(?<=CYCLE81\\(10,1,0,-6\\))$", " Z-50"), "is not claimed"),
    ("grbl", "begins a line at the carriage return", at_the_end_of("G17", " (\rG1 Z-50\r)"), "printed ones"),
    ("marlin", "begins a line at the carriage return", at_the_end_of("G90", " ;\rG1 Z-50"), "printed ones"),
    ("grbl", "is reset by a character in a comment", at_the_end_of("G17", " (\x18)"), "printed ones"),
    ("linuxcnc", "retracts to R or to the height before", instead("G98 ", ""), "without G98 or G99"),
    ("linuxcnc", "moves with the tool before, or with the next one", instead("^T1 M6\n", "T1 M6 X10 Y10\n"), "a tool change with a motion"),
    ("fanuc", "knows no length of the tool", instead("G43 H2", "G43 H0"), "H0, which"),
    ("siemens", "knows no length of the tool", instead("^D1 Z10", "D0 Z10"), "D0, which"),
    ("heidenhain", "ends", put("[0-9]+ L X", "29 M30"), "follows the end of the program"),
    ("heidenhain", "has its tool along X", instead("TOOL CALL 2 Z", "TOOL CALL 2 X"), "its axis, Z"),
    ("heidenhain", "counts the depth from the cylinder's end", instead("^  Q206=\\+300", "  Q395=+1 ~\n  Q206=+300"), "a cycle with Q395=+1"),
    ("linuxcnc", "empties the spindle", instead("^T1 M6", "T0 M6"), "is not cut by", {1: 0}),
    ("linuxcnc", "goes through the change of the tool that is in, in the pocket", put(LEVEL, "T1 M6"), "below the top"),
    ("linuxcnc", "is elsewhere after the change of the tool that is in", instead("^G0 Z10\n(?=X[0-9.]+ Y[0-9.]+\nZ1)", "G0 Z10\nT1 M6\nG1 X10 Y10\n"), "the first motions must be rapids"),
    ("fanuc", "moves by the length of the tool before", instead("G43 H1 ", ""), "without the tool's length"),
    ("linuxcnc", "takes the tool's length off", instead("^T1 M6\nG43$", "T1 M6\nG43\nG49"), "without the tool's length"),
    ("fanuc", "returns to where the first cycle began", instead("^G98 (G81 .*)$(?=[\\s\\S]*^X30)", "G99 G81 X10. Y10. Z-6. R1. F300.\nG98 G81 X10. Y10. Z-6. R1."), "a cycle begins within another"),
    ("heidenhain", "drills at a rapid, turned over", instead("Q201=-6", "Q201=+1"), "turns it over"),
    ("siemens", "begins above the surface", instead("CYCLE81\\(10,1,0,-6\\)", "CYCLE81(10,1,-0.5,-6)"), "below its surface"),
    ("fanuc", "drills upwards, or not at all", instead("Z-6. R1. F300", "Z2. R1. F300"), "ends above"),
    ("linuxcnc", "follows what stands before the word by no stated bound", lambda text: instead("^M5$", "M5\nG61")(instead("^G64.*\n", "")(text)), "accepted: the program says nothing of it"),
]


def changed_witness(data, program, numbers):
    """The witness about another program, with other numbers of tools."""
    w = wrong.Witness(data)
    w.hashes = hashlib.sha256(program).digest() + w.hashes[32:]
    for tool in w.tools:
        tool[0] = numbers.get(tool[0], tool[0])
    return w.bytes()


def main():
    checker, part, folder = sys.argv[1:4]
    faults = 0
    with tempfile.TemporaryDirectory() as scratch:
        program_path, witness_path = os.path.join(scratch, "p.nc"), os.path.join(scratch, "p.ccw")
        for control, what, change, reason, *numbers in WORDS:
            with open(os.path.join(folder, control + ".nc"), newline="") as file:
                right = file.read()
            program = change(right).encode("latin-1")
            with open(os.path.join(folder, control + ".ccw"), "rb") as file:
                witness = changed_witness(file.read(), program, numbers[0] if numbers else {})
            with open(program_path, "wb") as file:
                file.write(program)
            with open(witness_path, "wb") as file:
                file.write(witness)
            answer = subprocess.run([checker, program_path, part, witness_path], capture_output=True, text=True)
            is_as_told = reason[10:] in answer.stdout if reason.startswith("accepted: ") else answer.returncode != 0 and reason in answer.stderr
            if program == right.encode("latin-1") or not is_as_told:
                faults += 1
                print(f"{control} {what}: ended with {answer.returncode}: {answer.stdout[:80]}{answer.stderr[:200]}")
    print(f"{len(WORDS)} programs with hidden words, {faults} not refused for their reason")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
