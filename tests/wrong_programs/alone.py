"""Programs that are checked without a part: against a stock alone, in the words of every controller."""
import re

from holes import CYCLES, tap
from writer import ALL, CHANGER, OUT, WORD, Class, nothing, rings

#: Wider than the pocket that the right program clears.
STOCK = {"part": "", "asked": {"stock": "-20:60,-20:60,-10:0"}}

def places_of(x):
    return "[places]\nstart = [0, 0, 0]\ng28 = [0, 0, 0]\ng30 = [0, 0, 0]\n" + "".join(
        f"g{n} = [{x}, -50, -120]\n" for n in range(54, 60))


#: The work's zero lies at X -10 or X 90 of a travel in which the program needs X 3 to 17, and at Z -120 below its upper end.
TRAVEL = "[travel]\nx = [80, 110]\ny = [-60, 100]\nz = [-150, 0]\n"
MACHINES = {
    "shifted-out.toml": TRAVEL + places_of(-10),
    "shifted-in.toml": TRAVEL.replace("x = [80, 110]", "x = [0, 110]") + places_of(90),
    "narrow.toml": '[travel]\nx = [-5, 15]\ny = [-50, 100]\nz = [-60, 110]\n',
    "unhurried.toml": 'max_feed = 300\n',
    "hurried.toml": 'max_feed = 400\n',
    "broad.toml": '[travel]\nx = [-50, 100]\ny = [-50, 100]\nz = [-60, 110]\n',
}


def write_machines():
    for name, text in MACHINES.items():
        (OUT / "parts" / name).write_text(text)


def asked(**more):
    return {"part": "", "asked": {**STOCK["asked"], **more}}


def drop_feeds(p):
    p.cut = [re.sub(r" F[\d.]+", "", block) for block in p.cut]


def motion(c):
    c.right("right", ALL, nothing, "clears a pocket in the block", **STOCK)
    c.right("right-wall", ALL, wall, "cuts where nobody has said that a wall stands", **STOCK)

    def down(p):
        p.cut = [p.t.rapid(z=-1)] + p.cut[1:]
    c.add("rapid-down", ALL, down, "FAULTY", "rapid-in-material", "goes down into the block at the rapid", **STOCK)

    def across(p):
        p.after = [p.t.rapid(x=40)]
    c.add("rapid-across", ALL, across, "FAULTY", "rapid-in-material", "leaves the pocket through its side at the rapid", **STOCK)

    pair = {"tools": ["drill:5:T1", "tap:M6:floating:T2"]}
    c.right("right-tap", CYCLES, tap(drill=-9.9, z=-8), "drills and taps a hole", **pair, **STOCK)
    pair = {"tools": ["drill:5:T1", "drill:6:T2"]}
    c.add("tap-drill", CYCLES, tap(drill=-9.9, z=-8), "FAULTY", "tapping", "turns a drill back as if it were a tap", **pair, **STOCK)

    def over(p):
        p.after = [p.t.rapid(z=1), p.t.rapid(x=40)]
    c.right("right-over", ALL, over, "leaves the pocket above its side", **STOCK)

    def within(p):
        p.after = [p.t.rapid(x=12)]
    c.right("right-within", ALL, within, "runs at the rapid where it has cut", **STOCK)

    def low(p):
        p.after = [p.t.rapid(z=5), p.t.rapid(x=70), p.t.rapid(z=-12)]
    c.add("rapid-low", ALL, low, "FAULTY", "beyond-stock", "goes down beside the block into the table", **STOCK)

    def through(depth):
        def change(p):
            p.after = [p.t.feed(120, z=depth)]
        return change
    c.add("through", ALL, through(-10.5), "CONDITIONAL", "below-stock", "cuts half a millimetre into what the block lies on",
          accepted=["below-stock"], **STOCK)
    c.add("too-low", ALL, through(-12), "FAULTY", "beyond-stock", "cuts two millimetres into what the block lies on", **STOCK)


def wall(p):
    p.after = [p.t.feed(x=25, y=3)]


def state(c):
    def by_hand(p):
        p.spindle = []
    c.add("spindle-by-hand", ALL, by_hand, "CONDITIONAL", "spindle-by-hand", "leaves the spindle to hands",
          accepted=["spindle-by-hand"], **STOCK)

    def off(p):
        p.retract, p.spindle = p.retract + p.spindle, []
    c.add("spindle-off", [d for d in ALL if d != "heidenhain"], off, "FAULTY", "spindle-off", "cuts with a spindle that stands",
          **STOCK)

    def backwards(p):
        p.spindle = [block.replace("M3", "M4") for block in p.spindle]
    c.add("backwards", ALL, backwards, "FAULTY", "spindle-direction", "turns the cutter the wrong way", **STOCK)
    c.add("other-tool", [d for d in ALL if d != "marlin"], nothing, "FAULTY", "wrong-tool", "calls a tool that nobody has given",
          tools=["endmill:6:T7", "endmill:8:T8"], **STOCK)
    c.add("steep", ALL, nothing, "FAULTY", "plunge-too-fast", "plunges with a cutter that may not",
          tools=["endmill:6:T1:noplunge"], **STOCK)
    c.add("no-feed", ["grbl", "mach3", "mach4"], drop_feeds, "FAULTY", "no-feed", "cuts at no feed that is said", **STOCK)


def second(p, pause, stops=True):
    """A second tool that is put in, without any tool length."""
    t = p.t
    between = ["M5"] if stops else []
    p.length = []
    p.approach = [block.replace("G43 H1", "G0") for block in p.approach]
    p.after = [t.rapid(z=40)] + between + ["T2 M6"] + pause + p.spindle + [t.rapid(x=10, y=10), t.rapid(z=1), t.feed(120, z=-3)]


def by_hand(c):
    """What is done by hand is a condition; what no hand can do between two blocks stays a fault."""
    pair = {"tools": ["endmill:6:T1", "endmill:3:T2"]}
    c.add("touched-off", CHANGER, lambda p: second(p, ["M0"]), "CONDITIONAL", "tool-by-hand",
          "pauses for each tool to be touched off", accepted=["tool-by-hand"], **pair, **STOCK)
    c.add("touched-off-at-change", ["linuxcnc", "mach3", "mach4"], lambda p: second(p, []), "CONDITIONAL", "tool-by-hand",
          "waits at M6 for each tool to be put in and touched off", accepted=["tool-by-hand"], **pair, **STOCK)
    c.add("touched-off-by-nobody", ["fanuc", "haas"], lambda p: second(p, []), "FAULTY", "tool-length",
          "changes its tool by itself and goes down without its length", **pair, **STOCK)


def taps(c):
    pair = {"tools": ["drill:5:T1", "tap:M6:floating:T2"]}
    far = [d for d in CYCLES]
    c.add("tap-feed", far, tap(drill=-9.9, z=-8, f=300), "FAULTY", "tapping", "feeds its tap at less than the pitch", **pair, **STOCK)
    c.add("tap-speed", far, tap(drill=-9.9, z=-8, spindle="M3 S500"), "FAULTY", "tapping", "turns its tap faster than it feeds",
          **pair, **STOCK)
    c.add("tap-backwards", far, tap(drill=-9.9, z=-8, spindle="M4 S400"), "FAULTY", "tapping", "turns its tap out on the way in",
          **pair, **STOCK)
    c.add("tap-drilled", far, tap(drill=-9.9, z=-8, word="G81"), "FAULTY", "tapping", "pulls its tap out at the rapid", **pair, **STOCK)
    c.add("tap-solid", far, tap(drill=-0.5, z=-8), "FAULTY", "more-than-it-cuts", "taps where no hole is", **pair, **STOCK)
    narrow = {"tools": ["drill:4:T1", "tap:M6:floating:T2"]}
    c.add("tap-narrow", far, tap(drill=-9.9, z=-8), "FAULTY", "more-than-it-cuts", "taps a hole that is narrower than the core", **narrow, **STOCK)


def places(c):
    """Machine files: where the work lies in the travel."""
    c.add("travel-of-machine", ALL, nothing, "FAULTY", "outside-travel", "leaves the travel where its zero lies",
          **asked(machine="shifted-out.toml"))
    c.right("right-travel-of-machine", ALL, nothing, "stays in the travel where its zero lies", **asked(machine="shifted-in.toml"))

    def restored(p):
        p.units = p.units + ["G92.3"]
    for name, more in (("restored", STOCK), ("restored-on-machine", asked(machine="shifted-in.toml"))):
        c.add(name, ["linuxcnc", "mach3", "mach4"], restored, "REFUSED", "", "takes up a shift that nobody states", **more)


def limits(c):
    def both(name, reason, key, wrong, right, does, twin):
        c.add(name, ALL, nothing, "FAULTY", reason, does, **asked(**{key: wrong}))
        c.right("right-" + name, ALL, nothing, twin, **asked(**{key: right}))
    both("travel", "outside-travel", "machine", "narrow.toml", "broad.toml", "leaves the machine's travel", "stays within it")
    both("flutes", "beyond-flutes", "library", "short.toml", "long.toml", "rubs with its shank", "cuts with its flutes alone")
    both("plunge-feed", "plunge-too-fast", "library", "gentle.toml", "brisk.toml", "plunges twice as fast as the tool may",
         "plunges as fast as the tool may")
    both("stepdown", "too-deep", "library", "shallow.toml", "deep.toml", "takes 2 mm at once where the tool takes 1",
         "takes what the tool takes")
    both("speed", "spindle-speed", "machine", "slow.toml", "fast.toml", "asks for more turns than there are", "turns as fast as it can")
    both("feed", "feed-too-fast", "machine", "unhurried.toml", "hurried.toml", "feeds faster than the machine can",
         "feeds as fast as the machine can")
    both("engagement", "over-engagement", "engagement", 100, 180, "cuts a slot where the limit is 100 degrees",
         "cuts a slot where it may")


def changes(c):
    """Tools that are selected and not put in, or put in where the cutter is in the work; a drill, which has no layers."""
    def selected(p):
        p.tool = ["T1"]
        p.retract = p.retract + ["T1 M6"]
    c.add("no-change", CHANGER, selected, "CONDITIONAL", "tool-in-spindle", "selects its tool and never puts it in",
          accepted=["tool-in-spindle"], **STOCK)

    def low(p):
        p.after = ["T1 M6"] + p.length
    c.add("low-change", ["linuxcnc", "mach3", "mach4"], low, "CONDITIONAL", "tool-change-height", "changes its tool in the pocket",
          accepted=["tool-change-height"], **STOCK)

    def high(p):
        p.after = [p.t.rapid(z=5), "T1 M6"] + p.length
    c.right("right-high-change", ["linuxcnc", "mach3", "mach4"], high, "changes its tool above the block", **STOCK)

    def drilled(p):
        p.cut = [p.t.feed(120, z=-8)]
    c.right("right-drill", ["linuxcnc", "grbl", "fanuc", "haas"], drilled, "drills deeper than the mills' stepdown",
            tools=["drill:6:T1"], **asked(stepdown=2))
    c.add("deep-mill", ["linuxcnc", "grbl", "fanuc", "haas"], drilled, "FAULTY", "too-deep", "plunges a mill 8 mm deep at once",
          **asked(stepdown=2))


def open_questions(c):
    def cut_short(p):
        p.after, p.retract, p.stop, p.home, p.tail = [], [], [], [], []
    c.add("cut-short", ["linuxcnc", "mach3", "mach4"], cut_short, "CONDITIONAL", "program-end", "ends in the middle",
          accepted=["program-end", "ends-low"], **STOCK)

    def stays(p):
        p.after, p.retract, p.home = [], [], []
    c.add("ends-low", [d for d in ALL if d not in ("fanuc", "haas")], stays, "CONDITIONAL", "ends-low",
          "ends with its cutter in the pocket", accepted=["ends-low"], **STOCK)

    def far(where):
        def change(p):
            p.after = [p.t.feed(x=17, y=17), p.t.feed(x=17, y=where)]
        return change
    c.add("far", ALL, far(1705), "CONDITIONAL", "far-move", "lost a point: leaves the block by more than a metre",
          accepted=["far-move"], **STOCK)
    c.right("right-beside", ALL, far(70), "goes out of the block by the cutter's width", **STOCK)

    c.add("no-stock", ALL, nothing, "CONDITIONAL", "stock", "says nothing of its block: the box of its cuts is taken",
          accepted=["stock"], part="")

    def high(p):
        p.cut = [p.t.rapid(z=9)] + rings(p.t, [1, 4, 7], z=5)[1:] + [p.t.feed(120, z=-0.2)]
        p.approach = [block.replace("Z5", "Z15").replace("Z+5", "Z+15") for block in p.approach]
        p.retract = [p.t.rapid(z=15)]
    c.add("above-zero", ALL, high, "REFUSED", "", "has its zero at the underside, and nobody says where the top is", part="")
    c.right("right-above-zero", ALL, high, "has its zero at the underside", part="",
            asked={"stock": "-20:60,-20:60,-0.2:8"})

    def datum(p):
        p.modes = [block.replace("G54", "G55") for block in p.modes]
    c.add("g55", [d for d in WORD if d != "marlin"], datum, "CONDITIONAL", "g55", "works at another offset", accepted=["g55"], **STOCK)

    def units(p):
        p.units = []
    c.add("units", [d for d in WORD if d != "marlin"], units, "CONDITIONAL", "units", "says neither mm nor inch", accepted=["units"],
          **STOCK)

    def inch(p):
        p.units = ["G20"]
    c.add("inch", ["grbl"], inch, "FAULTY", "beyond-stock", "is in mm and says inch: its pocket is 51 mm deep", **STOCK)

    def blending(p):
        p.path = ["G64"]
    c.add("blending", ["linuxcnc", "mach3", "mach4"], blending, "CONDITIONAL", "blending", "may leave its path by any distance",
          accepted=["blending"], **STOCK)

    def radii(by):
        def change(p):
            n = p.t.n
            p.after = [p.t.rapid(z=5), p.t.feed(x=0, y=10), f"G2 X{n(40 + by)} Y{n(10)} I{n(20)} J{n(0)} F{n(400)}"]
        return change
    arcs = ["fanuc", "haas", "grbl", "mach3", "mach4"]
    c.add("two-radii", arcs, radii(0.015), "CONDITIONAL", "arc-radii", "ends an arc beside its circle", accepted=["arc-radii"], **STOCK)
    c.add("no-radius", arcs, radii(0.5), "REFUSED", "", "ends an arc so far beside its circle that controls stop", **STOCK)
    c.right("right-one-radius", WORD, radii(0), "ends its arc on its circle", **STOCK)


def idle(c):
    """Programs that cut nothing, or do not even move."""
    def above(p):
        p.cut = [p.t.feed(120, z=1), p.t.feed(x=17, y=17)]
    c.add("above", ALL, above, "CONDITIONAL", "cuts-nothing", "feeds above the block alone", accepted=["cuts-nothing"], **STOCK)
    c.add("beside", ALL, nothing, "CONDITIONAL", "cuts-nothing", "cuts beside the block, whose zero is another",
          accepted=["cuts-nothing", "far-move"], **asked(stock="100:160,100:160,-10:0"))

    def still(p):
        p.approach, p.cut, p.after, p.retract, p.home = [], [], [], [], []
    c.add("still", ALL, still, "REFUSED", "", "moves nothing", **STOCK)


def alone():
    write_machines()
    c = Class("alone")
    for write in (motion, state, by_hand, taps, places, limits, changes, open_questions, idle):
        write(c)
    return c.done()
