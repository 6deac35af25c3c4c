#!/usr/bin/env python3
"""Writes wrong programs, their right twins, parts and the cases.json of each class into a folder: `make.py FOLDER`.

Each case says what a real controller does with the program and which verdict that deserves. A program that is wrong has
a right twin beside it. The build of the tests runs it; tests/verify/wrong_programs_test.cpp reads what it has written.
"""
import json

from alone import alone
from clearances import holder
from cutters import cutters, write_cutters
from habits import habits
from holes import holes, write_holes
from limits import cycles, limits, worst, write_limits
from okuma import okuma
from sinumerik import sinumerik
from takes import entries, leaves, takes, taps, write_takes
from writer import ALL, CHANGER, OUT, WORD, Class, nothing, rings


def square(x0, y0, x1, y1):
    return [[x0, y0, 0], [x1, y0, 0], [x1, y1, 0], [x0, y1, 0]]


PARTS = {
    "pocket.json": {"name": "POCKET", "units": "mm", "outer": square(0, 0, 20, 20), "islands": [], "top": 0,
                    "depth": 2},
    "pair.json": {"units": "mm", "pockets": [
        {"name": "A", "outer": square(0, 0, 20, 20), "islands": [], "top": 0, "depth": 2},
        {"name": "B", "outer": square(30, 0, 50, 20), "islands": [], "top": 0, "depth": 2}]},
    "round.json": {"name": "ROUND", "units": "mm", "outer": [[0, 10, 1], [20, 10, 1]], "islands": [], "top": 0, "depth": 2},
}


def motion():
    c = Class("motion")
    c.right("right", ALL, nothing, "clears the pocket")

    def gouge(p):
        p.after = [p.t.feed(x=17.05, y=3)]
    c.add("wall", ALL, gouge, "FAULTY", "gouge", "cuts 0.05 mm into the wall")

    def floor(p):
        p.after = [p.t.feed(120, z=-2.02)]
    c.add("floor", ALL, floor, "FAULTY", "gouge", "plunges 0.02 mm below the floor")

    def ring(p):
        p.cut = rings(p.t, [1, 7])
    c.add("ring", ALL, ring, "FAULTY", "uncut", "leaves the material between two rings")

    def rapid(p):
        p.cut = [p.t.rapid(z=-1)] + p.cut[1:]
    c.add("rapid", ALL, rapid, "FAULTY", "rapid-in-material", "goes down into the stock at the rapid")
    return c.done()


def comments():
    c = Class("comments")

    def end(p):
        p.after = [p.t.comment("END OF PROGRAM"), p.t.feed(x=3, y=22)]
    c.add("end", ALL, end, "FAULTY", "gouge", "goes on after the comment and cuts through the wall")

    def right_end(p):
        p.cut.insert(4, p.t.comment("END OF PROGRAM"))
    c.right("right-end", ALL, right_end, "goes on after the comment and clears the pocket")

    def tool(p):
        p.head.append(p.t.comment("TOOL CHANGE T1: ENDMILL D6"))
        p.tool = [block.replace("T1", "T2").replace("CALL 1", "CALL 2") for block in p.tool]
        p.tool.append(p.t.comment("TOOL CHANGE T1: ENDMILL D6"))
        p.length = [block.replace("H1", "H2") for block in p.length]
        p.approach = [block.replace("H1", "H2") for block in p.approach]
    two = ["endmill:6:T1", "endmill:10:T2"]
    c.add("tool", CHANGER + ["grbl", "heidenhain"], tool, "FAULTY", "gouge", "cuts with T2, 10 mm wide", tools=two)

    def label(p):
        p.approach.append(p.t.comment("OPERATION 2: B"))
    c.add("label", ALL, label, "FAULTY", "nothing-cut", "cuts A alone, whatever it is called", part="pair.json")

    def both(p):
        p.approach.append(p.t.comment("OPERATION 2: B"))
        p.after = [p.t.rapid(z=5), p.t.comment("OPERATION 1: A"), p.t.rapid(x=40, y=10)] + rings(p.t, [1, 4, 7], 40)
    c.right("right-label", ALL, both, "clears both pockets, called by each other's names", part="pair.json")
    return c.done()


def dialects():
    c = Class("dialects")

    def dwell(p):
        p.after = ["G1", "G4 P0.1 X" + p.t.n(25)]
    c.add("dwell-and-move", ["linuxcnc", "grbl", "mach3", "mach4"], dwell, "FAULTY", "gouge",
          "waits, then goes on to X25 at the feed")

    def dwell_x(p):
        p.after = ["G4 X25."]
    c.right("dwell-by-x", ["fanuc"], dwell_x, "waits 25 seconds")

    def plane(p):
        p.after = ["G18 G98 G81 X" + p.t.n(10) + " Y" + p.t.n(-2) + " R" + p.t.n(17) + " F" + p.t.n(100), "G80",
                   "G17"]
    c.add("drill-in-g18", CHANGER, plane, "FAULTY", "gouge", "drills along Y through the wall")

    def holes(word):
        def change(p):
            n = p.t.n
            p.after = [p.t.rapid(z=5), p.t.rapid(x=40, y=10)] + rings(p.t, [1, 4, 7], 40) + [p.t.rapid(z=5)]
            p.after += [(word + "G81 X" + n(10) + " Y" + n(10) + " Z" + n(-2) + " R" + n(-1) + " F" + n(100)),
                        "X" + n(40), "G80"]
        return change
    c.add("no-g98", ["linuxcnc"], holes(""), "FAULTY", "gouge",
          "retracts to R, below the top, and goes over at the rapid", part="pair.json")
    c.add("no-g98", ["fanuc", "haas", "mach3", "mach4"], holes(""), "CONDITIONAL", "g98",
          "retracts as it was left, to R or above the work", part="pair.json", accepted=["g98"])
    c.add("g99", CHANGER, holes("G99 "), "FAULTY", "gouge", "goes over at R, through the wall", part="pair.json")
    c.right("right-g98", CHANGER, holes("G98 "), "goes over above the work", part="pair.json")
    c.add("unnamed", ["linuxcnc"], holes(""), "FAULTY", "gouge", "retracts to R on one control", part="pair.json",
          stated=False)

    def longer(z):
        def change(p):
            p.length = ["G43.1 Z" + p.t.n(z)]
        return change
    c.add("length-too-short", ["linuxcnc"], longer(-0.5), "FAULTY", "gouge", "goes 0.5 mm deeper")
    c.add("length-too-long", ["linuxcnc", "grbl"], longer(1), "FAULTY", "nothing-cut", "stays 1 mm higher")

    def saved(good):
        def change(p):
            p.after = ["G91", "M70", "G90", "M72", "G1 X" + p.t.n(3 if good else 18) + " F400", "G90"]
        return change
    c.add("modes-restored", ["linuxcnc"], saved(False), "FAULTY", "gouge", "counts X18 from where it is")
    c.right("right-modes-restored", ["linuxcnc"], saved(True), "counts X3 from where it is")

    def delta(p):
        p.tool = ["TOOL CALL 1 Z S8000 DL-1.0"]
    c.add("delta-length", ["heidenhain"], delta, "FAULTY", "gouge", "takes the tool as 1 mm shorter: goes deeper")

    def jump(p):
        p.after = ["M99 P10"]
    c.add("jump", ["fanuc", "haas"], jump, "REFUSED", "", "jumps to another block")

    def inch(p):
        p.units = ["G20"]
    c.add("inch", [d for d in WORD], inch, "FAULTY", "gouge", "runs 25.4 times as far")

    def absolute(p):
        p.modes = p.modes + ["G90.1"]
        p.after = [p.t.feed(x=10, y=10), "G3 X10 Y10 I10.5 J10 F100"]
    c.right("right-absolute-centres", ["linuxcnc", "mach3", "mach4"], absolute, "a small circle inside the pocket")

    def relative(p):
        absolute(p)
        p.modes = p.modes[:-1]
    c.add("relative-centres", ["linuxcnc", "mach3", "mach4"], relative, "FAULTY", "gouge",
          "a circle of 14.5 mm radius")
    return c.done()


def conditions():
    c = Class("conditions")

    def system(p):
        p.modes = [block.replace("G54", "G55") for block in p.modes]
        if p.d == "marlin":
            p.modes.append("G55")
    c.add("g55", WORD, system, "CONDITIONAL", "g55", "cuts where G55 lies", accepted=["g55"])

    def extended(p):
        p.modes.append("G54.1 P2" if p.d == "fanuc" else "G154 P2")
    c.add("g54.1", ["fanuc"], extended, "CONDITIONAL", "g54.1-p2", "cuts where G54.1 P2 lies", accepted=["g54.1-p2"])
    c.add("g154", ["haas"], extended, "CONDITIONAL", "g154-p2", "cuts where G154 P2 lies", accepted=["g154-p2"])

    def datum(p):
        p.head.append("CYCL DEF 247 DATUM SETTING Q339=+2")
    c.add("datum", ["heidenhain"], datum, "CONDITIONAL", "datum-247", "cuts where preset 2 lies",
          accepted=["datum-247"])

    def g92(p):
        p.approach.append("G92 X" + p.t.n(10) + " Y" + p.t.n(10))
    c.add("g92", WORD, g92, "CONDITIONAL", "g92", "renames its place by the same numbers", accepted=["g92"])

    def g92_wrong(p):
        p.approach.append("G92 X" + p.t.n(9.9))
    c.add("g92-shift", WORD, g92_wrong, "FAULTY", "gouge", "cuts everything 0.1 mm farther")

    def g52(p):
        p.approach.append("G52 X" + p.t.n(0.1))
    c.add("g52-shift", CHANGER, g52, "FAULTY", "gouge", "cuts everything 0.1 mm farther")

    def g10(p):
        p.modes.append("G10 L2 P1 X" + p.t.n(0) + " Y" + p.t.n(0) + " Z" + p.t.n(0))
    c.add("g10", CHANGER + ["grbl"], g10, "CONDITIONAL", "g10", "writes the offset that it then uses",
          accepted=["g10"])

    def g10_late(p):
        p.cut.insert(6, "G10 L2 P1 X" + p.t.n(0.1))
    c.add("g10-under-way", CHANGER + ["grbl"], g10_late, "FAULTY", "gouge", "moves its zero between two cuts")

    def units(p):
        p.units = []
    c.add("units", ["linuxcnc", "grbl", "fanuc", "haas", "mach3", "mach4"], units, "CONDITIONAL", "units",
          "runs in the units that were left", accepted=["units"])
    c.right("right-units", ["marlin"], units, "runs in mm, as it begins")

    def block_delete(p):
        p.after = ["/" + p.t.feed(x=3, y=4)]
    c.add("block-delete", WORD, block_delete, "CONDITIONAL", "block-delete", "runs or leaves out one block",
          accepted=["block-delete"])

    def first(p):
        if p.d in ("fanuc", "haas"):
            p.length = ["G43 H1"]
        p.approach = [p.t.rapid(z=-2), p.t.rapid(x=10, y=10)]
        p.cut = p.cut[1:]
    c.add("first-rapid", ALL, first, "FAULTY", "rapid-in-material", "goes down first, then across at depth")

    def unstated(p):
        p.approach = [p.t.rapid(z=5)]
        if p.d in ("fanuc", "haas"):
            p.approach = ["G0 G43 H1 Z5."]
        p.cut = [p.t.feed(z=4)] + [p.t.rapid(x=10, y=10)] + p.cut
    c.add("start", ALL, unstated, "CONDITIONAL", "start-position", "feeds down where the machine happens to stand",
          accepted=["start-position"])

    def home(p):
        p.after = ["G91 G28 X0. Y0. Z0." if p.d in ("fanuc", "haas") else "G28"]
        p.retract = ["G90", p.t.rapid(x=10, y=10), p.t.rapid(z=5)]
    c.add("home-at-depth", WORD, home, "CONDITIONAL", "g28-home", "drags through the work on its way home")

    def park(p):
        p.after = ["L X+0 Y+0 R0 FMAX M91"]
        p.retract = [p.t.rapid(x=10, y=10), p.t.rapid(z=5)]
    c.add("park-at-depth", ["heidenhain"], park, "CONDITIONAL", "m91", "drags through the work to the machine's zero")

    def frame(p):
        p.retract.append("G53 G0 X" + p.t.n(-100) + " Y" + p.t.n(-50))
    c.add("g53", CHANGER + ["grbl"], frame, "CONDITIONAL", "g53", "parks at a place of the machine")

    def unknown(p):
        p.head.append("M207")
    c.add("macro", CHANGER + ["heidenhain"], unknown, "CONDITIONAL", "m207", "does what the builder wrote",
          accepted=["m207"])

    def clamps(p):
        p.head.append("M10")
    c.add("no-word-of-grbl", ["grbl"], clamps, "CONDITIONAL", "m10", "stops at a word that it does not have",
          accepted=["m10"])

    c.add("no-word-of-linuxcnc", ["linuxcnc"], clamps, "CONDITIONAL", "m10", "stops at a word that it does not have",
          accepted=["m10"])

    def long_dwell(p):
        p.dwell = ["G4 P5000"]
    c.add("long-dwell", ["linuxcnc", "grbl", "mach3", "mach4"], long_dwell, "CONDITIONAL", "dwell",
          "waits for 83 minutes: P is in seconds", accepted=["dwell"])
    c.right("right-long-dwell", ["fanuc", "haas", "marlin"], long_dwell, "waits for 5 s: P is in milliseconds")

    def short_dwell(p):
        p.dwell = ["G4 P2"]
    c.add("short-dwell", ["fanuc", "haas", "marlin"], short_dwell, "CONDITIONAL", "dwell",
          "waits for 2 ms: P is in milliseconds", accepted=["dwell"])

    def no_time(p):
        p.dwell = ["G4 X2"]
    c.add("dwell-without-time", ["linuxcnc", "grbl", "mach3", "mach4"], no_time, "REFUSED", "",
          "stops, as the time of the dwell is missing")

    def lost(p):
        p.cut = [block.replace("G1 X3 Y17", "X3 Y17") + (" J0" if "X3 Y17" in block else "") for block in p.cut]
    c.add("stray-word", ["linuxcnc", "grbl"], lost, "CONDITIONAL", "stray-word", "keeps the J of an arc that lost its G word",
          accepted=["stray-word"])

    def mode(p):
        p.modes = [block.replace(" G90 ", " ") for block in p.modes]
        p.home = [block for block in p.home if block != "G90" and "G91" not in block]
    c.add("distance", ["fanuc", "mach3", "mach4"], mode, "CONDITIONAL", "g90",
          "counts as the control was left", accepted=["g90"])
    c.right("right-distance", ["linuxcnc", "grbl", "haas"], mode, "begins in G90")

    def points(p):
        p.after = ["G1 X3 Y4 F400."]
    c.add("point", ["fanuc", "haas"], points, "CONDITIONAL", "decimal-point", "goes to X0.003 or X3",
          accepted=["decimal-point"])
    return c.done()


def state():
    c = Class("state")

    def other(p):
        p.length = ["G43 H5"] if p.length else []
        p.approach = [block.replace("H1", "H5") for block in p.approach]
    c.add("length-of-another", CHANGER, other, "FAULTY", "tool-length", "takes off the length of T5")

    def none(p):
        p.length = []
        p.approach = [block.replace("G43 H1", "G0") for block in p.approach]
    c.add("no-length", ["linuxcnc", "fanuc", "haas", "mach3", "mach4"], none, "CONDITIONAL", "tool-length-off",
          "rests on a zero that was touched off with the tool in the spindle", accepted=["tool-length-off"])

    def some(p):
        none(p)
        p.after = [p.t.rapid(z=5), p.t.rapid(x=40, y=10), "G43 H1 Z" + p.t.n(5)] + rings(p.t, [1, 4, 7], 40)
    c.add("length-of-some", ["fanuc", "haas", "mach3", "mach4"], some, "FAULTY", "tool-length",
          "takes the tool's length off after its first cuts", part="pair.json")

    def unnumbered(p):
        p.approach = ["G0 G43 H5 Z50."] + [block.replace("G43 H1", "G43") for block in p.approach]
    c.add("length-by-number", ["fanuc", "haas"], unnumbered, "FAULTY", "tool-length", "takes the length of H5, the last that it said")

    def again(p):
        p.approach = p.approach + ["G43 Z5."]
    c.right("right-length-by-number", ["fanuc", "haas"], again, "takes the length of H1 once more")

    def off(p):
        p.cut.insert(6, "G49")
    c.add("length-off", CHANGER, off, "FAULTY", "tool-length", "goes down by the tool's length under way")

    def still(p):
        p.spindle = []
    c.add("spindle-by-hand", ALL, still, "CONDITIONAL", "spindle-by-hand", "leaves the spindle's switch to a hand",
          accepted=["spindle-by-hand"])

    def late(p):
        p.retract, p.spindle = p.retract + p.spindle, []
    c.add("spindle-off", ALL, late, "FAULTY", "spindle-off", "pushes a standing cutter through the stock, and turns it afterwards")

    def stopped(p):
        p.cut.insert(6, "M5")
    c.add("spindle-stopped", ALL, stopped, "FAULTY", "spindle-off", "stops the spindle between two cuts")

    def before_change(p):
        p.spindle, p.tool, p.length, p.dwell = [], p.spindle + p.dwell + p.tool, p.length, []
    c.add("spindle-before-change", CHANGER + ["heidenhain"], before_change, "FAULTY", "spindle-off",
          "starts the spindle and then puts the tool in, which stops it")

    def oriented(p):
        p.cut.insert(6, "M19")
    c.add("spindle-oriented", CHANGER, oriented, "FAULTY", "spindle-off", "holds the spindle at an angle between two cuts")

    def turned_again(p):
        p.retract += ["M19"] + p.spindle + p.dwell + [p.t.rapid(x=10, y=10)] + p.cut + [p.t.rapid(z=5)]
    c.right("right-spindle-oriented", CHANGER, turned_again, "turns it again before it cuts")

    def backwards(p):
        p.spindle = [block.replace("M3", "M4") for block in p.spindle]
    c.add("spindle-backwards", ALL, backwards, "FAULTY", "spindle-direction", "turns a right-hand cutter to the left")

    def slow(p):
        p.spindle = [block.replace(" S8000", "") for block in p.spindle]
        p.tool = [block.replace(" S8000", "") for block in p.tool]
    c.add("no-speed", ALL, slow, "CONDITIONAL", "speed-by-hand", "starts the spindle at the speed that a hand sets",
          accepted=["speed-by-hand"])

    def speed_after(p):
        slow(p)
        p.retract = p.retract + (["TOOL CALL S8000"] if p.d == "heidenhain" else ["S8000"])
    c.add("speed-late", ALL, speed_after, "FAULTY", "spindle-off", "states its speed after the cuts")

    def no_turns(p):
        slow(p)
        p.spindle = ["TOOL CALL S0", "M3"] if p.d == "heidenhain" else ["M3 S0"]
    c.add("speed-of-none", ALL, no_turns, "FAULTY", "spindle-off", "starts the spindle at no turns")

    def at(spindle, feed=400):
        def change(p):
            p.spindle = [block.replace("S8000", f"S{spindle}") for block in p.spindle]
            p.tool = [block.replace("S8000", f"S{spindle}") for block in p.tool]
            p.cut = p.cut[:2] + [block.replace("F400", f"F{feed}") for block in p.cut[2:]]
        return change
    turned = [d for d in ALL if d != "marlin"]
    c.add("slow-spindle", turned, at(50), "CONDITIONAL", "chip-load", "takes 4 mm with each tooth", accepted=["chip-load"])
    c.add("fast-spindle", ALL, at(500000), "CONDITIONAL", "cutting-speed", "turns faster than any spindle",
          accepted=["cutting-speed"])
    c.add("fast-feed", ALL, at(8000, 60000), "CONDITIONAL", "chip-load", "takes 3.75 mm with each tooth",
          accepted=["chip-load"])
    c.add("slow-feed", ALL, at(8000, 1), "CONDITIONAL", "chip-load", "rubs and does not cut", accepted=["chip-load"])
    c.right("right-router", ALL, at(24000, 6000), "cuts wood at 0.125 mm a tooth")
    c.right("right-power", ["marlin"], at(200), "says with S how strongly its spindle is driven")

    def flood_too(p):
        p.spindle = [block.replace("M3", "M13") for block in p.spindle]
    c.add("spindle-and-flood", ["linuxcnc", "grbl", "haas", "mach3", "mach4", "marlin"], flood_too, "FAULTY", "spindle-off",
          "starts its spindle by a word that the control does not have")
    c.add("spindle-and-flood-of-builder", ["fanuc"], flood_too, "CONDITIONAL", "m13", "starts its spindle by a builder's word",
          accepted=["m13"])

    def steep(p):
        p.cut[1] = p.t.feed(120, x=10.0015, z=-2)
    c.add("steep", ALL, steep, "FAULTY", "plunge-too-fast", "enters at 89.97 degrees with a cutter that may not plunge",
          tools=["endmill:6:T1:noplunge"])

    def ramp(p):
        p.cut[1:2] = [p.t.feed(120, z=0)] + [p.t.feed(120, x=10 + (2 if k % 2 else 0), z=-0.1 * k) for k in
                                             range(1, 21)]
    c.right("right-ramp", ALL, ramp, "goes down at 3 degrees", tools=["endmill:6:T1:noplunge"])
    return c.done()


def blending():
    c = Class("blending")

    def unsaid(p):
        p.path = []
    c.add("unsaid", CHANGER + ["heidenhain"], unsaid, "CONDITIONAL", "blending", "rounds corners as it was left",
          accepted=["blending"])
    c.right("right-unsaid", ["grbl", "marlin"], unsaid, "keeps to the path always")

    def plain(p):
        p.path = ["G64"]
    c.add("g64", CHANGER, plain, "CONDITIONAL", "blending", "rounds corners by any amount", accepted=["blending"])

    def wide(p):
        p.path = {"linuxcnc": ["G64 P0.5"], "haas": ["G187 P1 E0.5"],
                  "heidenhain": ["CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32.1 T0.5"]}[p.d]
    c.add("wide", ["linuxcnc", "haas", "heidenhain"], wide, "FAULTY", "uncut", "rounds the corners by 0.5 mm")

    def smooth(p):
        p.path = ["G187 P1"]
    c.add("smoothness", ["haas"], smooth, "CONDITIONAL", "blending", "rounds corners by a setting",
          accepted=["blending"])

    def late(p):
        p.cut.insert(5, "G64")
    c.add("g64-under-way", CHANGER, late, "CONDITIONAL", "blending", "rounds corners from here on",
          accepted=["blending"])
    return c.done()


def small():
    """What is too small for samples: posts under a rapid, ribs."""
    c = Class("small")

    def post(move):
        def change(p):
            t = p.t
            p.cut = [t.rapid(x=13.2, y=10), t.rapid(z=1), t.feed(120, z=-2)]
            for h in (3.2, 5, 7):
                for x, y in [(h, -h), (-h, -h), (-h, h), (h, h), (h, -h), (h, 0)]:
                    p.cut.append(t.feed(x=10 + x, y=10 + y))
            p.cut += [t.feed(x=13.2, y=10), getattr(t, move)(x=6.8, y=10), t.feed(x=13.2, y=10)]
        return change
    c.add("post", ALL, post("rapid"), "FAULTY", "rapid-in-material", "runs a post of 0.4 mm down at the rapid")
    c.right("right-post", ALL, post("feed"), "cuts the post at the feed")

    def rib(p):
        p.cut = rings(p.t, [0.9845]) + rings(p.t, [7])[1:]
        p.cut = [block for block in p.cut]
    c.add("rib", ALL, rib, "FAULTY", "uncut", "leaves a rib 0.0155 mm wide all around")
    return c.done()


def main():
    (OUT / "parts").mkdir(parents=True, exist_ok=True)
    for name, part in PARTS.items():
        (OUT / "parts" / name).write_text(json.dumps(part, indent=1) + "\n")
    write_limits()
    write_holes()
    write_cutters()
    write_takes()
    classes = (motion, comments, dialects, conditions, state, blending, small, cycles, limits, worst, holes,
               alone, habits, holder, cutters, leaves, entries, takes, taps,
               sinumerik, okuma)
    count = sum(make() for make in classes)
    print(count, "cases")


if __name__ == "__main__":
    main()
