"""Right programs for every controller, in chunks that a case may change, and the folders they are written into."""
import json
import shutil
import sys
from pathlib import Path

OUT = Path(sys.argv[1])  # the folder that everything is written into
WORD = ["linuxcnc", "grbl", "fanuc", "haas", "mach3", "mach4", "marlin"]
ALL = WORD + ["heidenhain"]
CHANGER = ["linuxcnc", "fanuc", "haas", "mach3", "mach4"]
ENDING = {"linuxcnc": ".ngc", "grbl": ".nc", "fanuc": ".nc", "haas": ".nc", "mach3": ".tap", "mach4": ".tap",
          "marlin": ".gcode", "heidenhain": ".H", "siemens": ".mpf", "mazak": ".eia", "tormach": ".nc",
          "okuma": ".min", "grblhal": ".nc"}
TOOL = ["endmill:6:T1"]
#: Controls of machining centres with a magazine: numbers with points, the length on the way down.
POINTED = ("fanuc", "haas", "mazak", "okuma")


class Text:
    """Blocks in the words of one controller."""

    def __init__(self, dialect):
        self.d = dialect

    def n(self, value):
        text = f"{value:.4f}".rstrip("0").rstrip(".")
        text = "0" if text in ("-0", "") else text
        if self.d == "heidenhain":
            return text if text.startswith("-") else "+" + text
        if self.d in POINTED and "." not in text:
            text += "."
        return text

    def comment(self, text):
        return "; " + text if self.d in ("marlin", "heidenhain", "siemens") else f"({text})"

    def axes(self, to):
        return " ".join(a.upper() + self.n(to[a]) for a in "xyz" if a in to)

    def rapid(self, **to):
        if self.d == "heidenhain":
            return f"L {self.axes(to)} R0 FMAX"
        return f"G0 {self.axes(to)}" + (" F3000" if self.d == "marlin" else "")

    def feed(self, f=400, **to):
        if self.d == "heidenhain":
            return f"L {self.axes(to)} F{f}"
        return f"G1 {self.axes(to)} F{self.n(f)}"

    def dwell(self, seconds):
        if self.d == "heidenhain":
            return ["CYCL DEF 9.0 DWELL TIME", f"CYCL DEF 9.1 DWELL {seconds}"]
        return ["G4 " + {"fanuc": f"X{seconds}.", "mazak": f"X{seconds}.", "haas": f"P{seconds}.", "marlin": f"S{seconds}", "siemens": f"F{seconds}", "okuma": f"F{seconds}."}.get(
            self.d, f"P{seconds}")]


def rings(t, halves, cx=10, cy=10, z=-2):
    """Square rings about a centre from the inside out, staying down."""
    blocks = [t.rapid(z=1), t.feed(120, z=z)]
    for h in halves:
        for x, y in [(-h, -h), (h, -h), (h, h), (-h, h), (-h, -h)]:
            blocks.append(t.feed(x=cx + x, y=cy + y))
    return blocks


def nothing(_):
    """Leaves a right program as it is."""


class Program:
    """A right program in named chunks, each a list of blocks; a case changes what it is about."""

    def __init__(self, dialect):
        self.t = t = Text(dialect)
        d = self.d = dialect
        klartext = d == "heidenhain"
        self.head = [t.comment("POCKET")]
        self.units = [] if klartext else ["G710"] if d == "siemens" else ["G21"]
        self.modes = {"grbl": ["G17 G40 G49 G54 G80 G90 G91.1 G94"], "marlin": ["G90"], "heidenhain": [],
                      "fanuc": ["G17 G40 G49 G54 G80 G90 G94"], "haas": ["G17 G40 G49 G54 G80 G90 G94"],
                      "mazak": ["G17 G40 G49 G54 G80 G90 G94"],
                      "okuma": ["G17 G40 G80 G90 G94", "G15 H1"],
                      "siemens": ["G17 G40 G54 G90 G94"]}.get(
                          d, ["G17 G40 G49 G54 G80 G90 G91.1 G94"])
        self.path = {"grbl": [], "grblhal": [], "marlin": [], "siemens": ["G60"],
                     "heidenhain": ["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T0.0005"]}.get(d, ["G61"])
        self.home = {"fanuc": ["G91 G28 Z0.", "G90"], "mazak": ["G91 G28 Z0.", "G90"], "haas": ["G53 G0 Z0."], "siemens": ["SUPA G0 Z0 D0"]}.get(d, [])
        self.tool = {"grbl": ["T1"], "marlin": [], "heidenhain": ["TOOL CALL 1 Z S8000"]}.get(d, ["T1 M6"])
        self.length = {"linuxcnc": ["G43"], "mach3": ["G43 H1"], "mach4": ["G43 H1"], "tormach": ["G43 H1"]}.get(d, [])
        self.spindle = ["M3"] if klartext else ["M3 S8000"]
        self.dwell = t.dwell(2)
        self.approach = [t.rapid(x=10, y=10), t.rapid(z=5)]
        if d in POINTED:
            self.approach = [t.rapid(x=10, y=10), ("G56" if d == "okuma" else "G43") + " H1 Z5."]
        if d == "siemens":
            self.approach = [t.rapid(x=10, y=10), "D1 Z5"]
        self.cut = rings(t, [1, 4, 7])
        self.after = []
        self.retract = [t.rapid(z=5)]
        self.stop = ["M5"]
        self.tail = {"linuxcnc": ["M2"], "okuma": ["M2"], "marlin": [], "heidenhain": ["M30"]}.get(d, ["M30"])

    def text(self):
        blocks = (self.head + self.units + self.modes + self.path + self.home + self.tool + self.length + self.spindle +
                  self.dwell + self.approach + self.cut + self.after + self.retract + self.stop + self.home + self.tail)
        if self.d in ("fanuc", "mazak"):
            blocks = ["%", "O1234"] + blocks + ["%"]
        if self.d == "okuma":
            blocks = blocks + ["%"]
        if self.d == "haas":
            blocks = ["%", "O01234"] + blocks + ["%"]
        if self.d == "heidenhain":
            blocks = ["BEGIN PGM POCKET MM"] + blocks + ["END PGM POCKET MM"]
            blocks = [f"{i} {block}" for i, block in enumerate(blocks)]
        return "\n".join(blocks) + "\n"


class Class:
    """One folder: programs and the list of what is to be said about them."""

    def __init__(self, name):
        self.folder = OUT / name
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        self.cases = []

    def add(self, name, dialects, change, verdict, reason, does, part="pocket.json", tools=None, stated=True,
            accepted=(), asked=None):
        """asked: what else is asked of the program: library, machine (files of parts/), engagement (degrees)."""
        for dialect in dialects:
            program = Program(dialect)
            change(program)
            file = f"{name}-{dialect}{ENDING[dialect]}"
            (self.folder / file).write_text(program.text())
            case = {"file": file, "part": part, "tools": tools or TOOL, "dialect": dialect if stated else "",
                    "does": does, "accept": [], "verdict": verdict, "reason": reason, **(asked or {})}
            self.cases.append(case)
            if verdict == "CONDITIONAL" and accepted:
                self.cases.append({**case, "does": "the same, where that is so", "accept": list(accepted),
                                   "verdict": "CLEAN", "reason": ""})

    def right(self, name, dialects, change, does, **more):
        self.add(name, dialects, change, "CLEAN", "", does, **more)

    def done(self):
        (self.folder / "cases.json").write_text(json.dumps(self.cases, indent=1) + "\n")
        return len(self.cases)
