"""Programs for an Okuma, in the words of OSP: what those words do wrong, and the right programs beside them."""
from writer import Class, nothing

ONE = ["okuma"]


def okuma():
    c = Class("okuma")
    c.right("right", ONE, nothing, "mills the pocket")

    def named(p):
        p.head = ["$POCKET.MIN%", "OPOCK"] + p.head
    c.right("right-named", ONE, named, "has names of letters and is told by its words", stated=False)

    def wall(p):
        p.after = [p.t.feed(x=17.05, y=3)]
    c.add("wall", ONE, wall, "FAULTY", "gouge", "cuts 0.05 mm into the wall")

    def rapid(p):
        p.cut = [p.t.rapid(z=-1)] + p.cut[1:]
    c.add("rapid", ONE, rapid, "FAULTY", "rapid-in-material", "goes down into the stock at the rapid")

    def ring(p):
        p.cut = p.cut[:2] + p.cut[-5:]
    c.add("ring", ONE, ring, "FAULTY", "uncut", "leaves the material between two rings")

    def standing(p):
        p.cut = ["M5"] + p.cut
    c.add("standing", ONE, standing, "FAULTY", "spindle-off", "cuts with a spindle that stands")

    def inch(p):
        p.units = ["G20"]
    c.add("inch", ONE, inch, "FAULTY", "", "takes its millimetres for inches")

    def offset(words):
        def change(p):
            p.modes = [block.replace("G15 H1", words) for block in p.modes]
        return change
    c.add("offset", ONE, offset("G15 H7"), "CONDITIONAL", "g15-h7", "cuts where another offset lies", accepted=["g15-h7"])
    c.add("machine", ONE, offset("G15 H0"), "REFUSED", "", "cuts in the frame of the machine")
    c.add("no-number", ONE, offset("G15"), "REFUSED", "", "names no offset")
    c.add("of-others", ONE, offset("G54"), "REFUSED", "", "takes the offset of other controls for its own")

    def length(words):
        def change(p):
            p.approach = [block.replace("G56 H1", words) for block in p.approach]
        return change
    c.add("other-length", ONE, length("G56 H2"), "FAULTY", "tool-length", "takes the length of another tool")
    c.add("length-of-others", ONE, length("G43 H1"), "REFUSED", "", "takes the length by a word of other controls")
    c.add("ended-length", ONE, length("G56 H1 Z5.\nG53\nG0"), "FAULTY", "tool-length", "cuts without the length of its tool")

    def path(word):
        def change(p):
            p.path = [word] if word else []
        return change
    c.add("corners", ONE, path("G64"), "CONDITIONAL", "blending", "rounds corners by nothing stated", accepted=["blending"])
    c.add("smooth", ONE, path("G131 F400. E0.02"), "REFUSED", "", "lets the control choose its path")

    def before(*blocks):
        def change(p):
            p.cut = list(blocks) + p.cut
        return change
    for name, block in (("call", "CALL O1000"), ("variable", "VC1=5"), ("jump", "IF [VC1 EQ 1] N10"), ("no-execution", "NOEX"),
                        ("shift", "G11 X5. Y5."), ("compensation", "G41 D1"), ("feed-by-name", "G1 F=PF1"), ("sign", "$")):
        c.add(name, ONE, before(block), "REFUSED", "", "has words that are not read: " + block)

    def dwell(words):
        def change(p):
            p.dwell = [words]
        return change
    c.right("right-dwell", ONE, dwell("G4 F1.5"), "waits a second and a half")
    c.add("dwell", ONE, dwell("G4 F2"), "CONDITIONAL", "decimal-point", "waits two seconds or hundredths of them", accepted=["decimal-point"])
    c.add("dwell-of-others", ONE, dwell("G4 P2."), "REFUSED", "", "waits by a word of other controls")

    def cycle(*blocks):
        def change(p):
            p.after = [p.t.rapid(z=5)] + list(blocks)
        return change
    hole = "G81 X10. Y10. Z-{} R1. F100.{}"
    c.right("right-cycle", ONE, cycle("G71 Z5.", hole.format("2.", " M53"), "X12.", "G0 Z5."), "drills within what is cleared")
    c.add("cycle", ONE, cycle("G71 Z5.", hole.format("2.05", " M53")), "FAULTY", "gouge", "drills 0.05 mm below the floor")
    c.add("cycle-moved", ONE, cycle("G71 Z5.", hole.format("2.", " M53"), "X19."), "FAULTY", "gouge", "drills into the wall by the cycle above")
    c.add("level", ONE, cycle("G71 Z9.", hole.format("2.", " M53")), "REFUSED", "", "begins its cycle elsewhere than at its level")
    c.add("no-level", ONE, cycle(hole.format("2.", " M53")), "REFUSED", "", "states no level")
    c.add("no-return", ONE, cycle("G71 Z5.", hole.format("2.", "")), "REFUSED", "", "does not say to which height it returns")
    c.add("upper-limit", ONE, cycle("G71 Z5.", hole.format("2.", " M52")), "REFUSED", "", "returns to the limit of the travel")
    c.add("stopped", ONE, cycle("G71 Z5.", hole.format("2.", " M53"), "G80", "G0 Z1.", "G1 Z-2. F100."), "CONDITIONAL", "g80-spindle",
          "ends its cycle by a word that may stop the spindle", accepted=["g80-spindle"])
    return c.done()
