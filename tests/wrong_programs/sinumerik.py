"""Programs for a Sinumerik, in its own words: what those words do wrong, and the right programs beside them."""
from holes import two_tools
from writer import Class, nothing, rings

ONE = ["siemens"]


def sinumerik():
    c = Class("sinumerik")
    c.right("right", ONE, nothing, "mills the pocket")

    def by_name(p):
        p.tool = ['T="MILL 6" M6']
    c.add("name", ONE, by_name, "CONDITIONAL", "tool-name-1", "calls its tool by a name", accepted=["tool-name-1"])

    def no_edge(p):
        p.approach = [block.replace("D1 ", "G0 ") for block in p.approach]
    c.add("edge", ONE, no_edge, "CONDITIONAL", "d1", "leaves it to the control which edge counts", accepted=["d1"])

    def no_length(p):
        p.approach = [block.replace("D1 ", "D0 ") for block in p.approach]
    c.add("no-length", ONE, no_length, "CONDITIONAL", "tool-length-off", "cuts without the length of its tool")

    def nose(p):
        p.home = ["SUPA G0 Z0"]
    c.add("nose", ONE, nose, "CONDITIONAL", "d0", "goes home with the tip and not with the nose", accepted=["d0"])

    def words(old, new):
        def change(p):
            at = next(k for k, block in enumerate(p.cut) if old in block)
            p.cut[at] = p.cut[at].replace(old, new)
        return change
    c.add("incremental", ONE, words("X17 ", "X=IC(12) "), "FAULTY", "uncut", "counts on from where it stands")
    c.right("right-absolute", ONE, words("X17 ", "X=AC(17) "), "says that it does not count on")
    c.add("parameter", ONE, words("X17 ", "X=R1 "), "REFUSED", "", "computes")

    def shift(p):
        p.cut = ["TRANS X1.5"] + p.cut
    c.add("shift", ONE, shift, "FAULTY", "gouge", "moves its zero")

    def shifted_back(p):
        p.cut = ["TRANS X1.5", "ATRANS X-1.5"] + p.cut
    c.right("right-shift", ONE, shifted_back, "moves its zero there and back")

    def arc(radius):
        def change(p):
            p.cut += [p.t.feed(x=10, y=7), f"G3 X13 Y10 CR={radius}", p.t.feed(x=10, y=10)]
        return change
    c.right("right-arc", ONE, arc("3"), "goes the short way round")
    c.add("arc", ONE, arc("-6"), "FAULTY", "gouge", "goes the long way round")

    def turns(p):
        p.cut = [p.t.rapid(x=12, y=10), p.t.rapid(z=0.5), "G3 X12 Y10 Z-2 I-2 J0 TURN=2 F120"] + rings(p.t, [1, 4, 7])[2:]
    c.right("right-turns", ONE, turns, "goes in along three turns")

    def cycle(end):
        def change(p):
            p.after = [p.t.rapid(z=1), "MCALL CYCLE81(5,1,0,-2)", "X10 Y10"] + end
        return change
    c.right("right-cycle", ONE, cycle(["MCALL", "G0 X30 Y10"]), "calls a cycle once and ends it", tools=["endmill:6:T1"])
    c.add("cycle", ONE, cycle(["G0 X30 Y10"]), "FAULTY", "gouge", "forgets to end its cycle", tools=["endmill:6:T1"])

    def path(*blocks):
        def change(p):
            p.path = list(blocks)
        return change
    c.add("corners", ONE, path("G64"), "CONDITIONAL", "blending", "rounds corners by nothing stated", accepted=["blending"])
    c.add("wide", ONE, path("G642 CTOL=0.5"), "FAULTY", "uncut", "rounds corners by 0.5 mm")
    c.add("wide-cycle", ONE, path("CYCLE832(0.5,3,1)"), "FAULTY", "uncut", "rounds corners by 0.5 mm")
    c.right("right-corners", ONE, path("G645 CTOL=0.0005"), "keeps to the path within half a micrometre")

    def offset(p):
        p.modes = [block.replace("G54", "G507") for block in p.modes]
    c.add("offset", ONE, offset, "CONDITIONAL", "g507", "cuts where another offset lies", accepted=["g507"])

    def tap(back):
        return two_tools(-11.502, "M3 S400", lambda p: ["F400", f"MCALL CYCLE840(5,3,0,-9.5,,,{back},3,1)", "X10 Y10", "MCALL"])
    tapped = {"part": "tapped.dxf", "tools": ["drill:5:T1", "tap:M6:floating:T2"]}
    c.right("right-tap", ONE, tap(4), "turns its tap back out of the thread", **tapped)
    c.right("right-tap-reversed", ONE, tap(0), "leaves it to the control to reverse the tap", **tapped)
    c.add("tap-pulled", ONE, tap(3), "FAULTY", "tapping", "pulls its tap out with the turn of the way in", **tapped)

    def swivel(p):
        p.modes += ['CYCLE800(1,"TC1",0,57,0,0,0,0,30,0,0,0,0,-1)']
    c.add("swivel", ONE, swivel, "REFUSED", "", "turns the plane of machining")

    def inch(p):
        p.units = ["G700"]
    c.add("inch", ONE, inch, "FAULTY", "", "takes its millimetres for inches")

    def standing(p):
        p.spindle = []
    c.add("standing", ONE, standing, "CONDITIONAL", "spindle-by-hand", "never turns its spindle")
    return c.done()
