"""Taps, milled threads and countersinks: programs of two tools, each about one hole."""
from writer import OUT, Class

#: Controls with tool changers and cycles.
CYCLES = ["linuxcnc", "fanuc", "haas", "mach3", "mach4"]
CHANGE = {"linuxcnc": ["G43"], "mach3": ["G43 H2"], "mach4": ["G43 H2"]}


def drawing(depth, *circles):
    """A block about the origin and circles, each a layer, a diameter and a place on x (10 where none is said), y 10."""
    lines = ["0", "SECTION", "2", "HEADER", "9", "$INSUNITS", "70", "4", "0", "ENDSEC", "0", "SECTION", "2", "ENTITIES",
             "0", "LWPOLYLINE", "8", f"STOCK_D{depth}", "90", "4", "70", "1"]
    for x, y in [(-20, -20), (40, -20), (40, 40), (-20, 40)]:
        lines += ["10", str(x), "20", str(y)]
    for layer, diameter, *x in circles:
        lines += ["0", "CIRCLE", "8", layer, "10", str(x[0] if x else 10), "20", "10", "40", str(diameter / 2)]
    return "\n".join(lines + ["0", "ENDSEC", "0", "EOF"]) + "\n"


PARTS = {
    "tapped.dxf": drawing(12, ("TAP_M6_D7", 6)),
    "tapped_through.dxf": drawing(12, ("TAP_M6_THRU", 6)),
    "threaded.dxf": drawing(20, ("THREAD_M20x1.5_D8", 20)),
    "places.dxf": drawing(12, ("DRILL_D6", 5, 10), ("DRILL_D6", 5, 20), ("DRILL_D6", 5, 30)),
    "sunk.dxf": drawing(12, ("DRILL_THRU", 4.5), ("CSK_DIA9", 9)),
}


def write_holes():
    """The drawings, beside the other parts."""
    for name, text in PARTS.items():
        (OUT / "parts" / name).write_text(text)


def cycle(p, word, z, r, f):
    """One hole at 10, 10."""
    n = p.t.n
    if p.d == "siemens":
        return [f"F{n(f)}", f"MCALL {word.replace('G', 'CYCLE')}(5,{n(r)},0,{n(z)})", "X10 Y10", "MCALL"]
    return [f"G98 {word} X{n(10)} Y{n(10)} Z{n(z)} R{n(r)} F{n(f)}", "G80"]


def second_tool(p, spindle):
    """What stands between the tools."""
    t = p.t
    blocks = [t.rapid(z=5), "M5"] + p.home + ["T2 M6"] + CHANGE.get(p.d, []) + [spindle] + t.dwell(2)
    if p.d in ("fanuc", "haas"):
        return blocks + [t.rapid(x=10, y=10), "G43 H2 Z5."]
    if p.d == "siemens":
        return blocks + [t.rapid(x=10, y=10), "D1 Z5"]
    return blocks + [t.rapid(x=10, y=10), t.rapid(z=5)]


def two_tools(drill_z, spindle, blocks):
    """A program that drills down to drill_z and then does `blocks` with the second tool."""
    def change(p):
        p.cut = cycle(p, "G81", drill_z, 1, 200)
        p.after = second_tool(p, spindle) + blocks(p)
    return change


def tap(drill=-11.502, spindle="M3 S400", word="G84", z=-9.5, f=400):
    """A hole for M6, and its tap."""
    return two_tools(drill, spindle, lambda p: cycle(p, word, z, 3, f) if word else [])


def helix(pitch=1.5, radius=4.0, turn="G3", low=-9.5, lead=None, turns=7, stops=None):
    """A thread milled upwards, round and round; `lead`: how far its ways in and out climb; `stops`: the turn before which the spindle
    is stopped."""
    def blocks(p):
        t, n = p.t, p.t.n
        climb = pitch / 4 if lead is None else lead
        out = [t.rapid(z=1), t.feed(300, z=low - climb)]

        def half(x, i, z):
            out.append(f"{turn} X{n(x)} Y{n(10)} Z{n(z)} I{n(i)} J{n(0)} F{n(300)}")
        half(10 + radius, radius / 2, low)
        z = low
        for k in range(turns):
            if k == stops:
                out.append("M5")
            half(10 - radius, -radius, z + pitch / 2)
            half(10 + radius, radius, z + pitch)
            z += pitch
        half(10, -radius / 2, z + climb)
        return out
    return blocks


def thread(**how):
    """A hole for M20 x 1.5, and its thread."""
    return two_tools(-15.43, "M3 S2000", helix(**how))


def sink(z=-4.3):
    """A hole through, and its countersink."""
    return two_tools(-13.852, "M3 S3000", lambda p: cycle(p, "G81", z, 1, 100) if z else [])


def round_sink(z, whole=True):
    """A hole through, and its countersink by a cone that goes round 1 mm off the axis."""
    def blocks(p):
        t, n = p.t, p.t.n
        arcs = [f"G3 X{n(9)} Y{n(10)} I{n(-1)} J{n(0)} F{n(200)}"] + ([f"G3 X{n(11)} Y{n(10)} I{n(1)} J{n(0)} F{n(200)}"] if whole else [])
        return [t.rapid(z=1), t.feed(100, z=z), t.feed(100, x=11, y=10)] + arcs + [t.feed(100, x=10, y=10), t.rapid(z=5)]
    return two_tools(-13.852, "M3 S3000", blocks)


def places(*blocks):
    """One cycle at 10, 10, and the words of the blocks after it, which repeat it."""
    def change(p):
        first = cycle(p, "G81", -6, 1, 200)
        p.cut = [first[0]] + [" ".join(word[0] + p.t.n(float(word[1:])) for word in block.split()) for block in blocks] + [first[1]]
    return change


def holes():
    """Taps against their speed, threads against their helix, cones against their width."""
    c = Class("holes")
    tapped = {"part": "tapped.dxf", "tools": ["drill:5:T1", "tap:M6:floating:T2"]}
    c.right("right-tap", CYCLES, tap(), "feeds the pitch at every turn", **tapped)
    c.add("tap-pitch", CYCLES, tap(f=500), "FAULTY", "tapping", "feeds 1.25 mm a turn with a pitch of 1", **tapped)
    c.add("tap-speed", CYCLES, tap(spindle="M3 S500"), "FAULTY", "tapping", "turns faster than its feed asks for", **tapped)
    c.add("tap-turn", CYCLES, tap(spindle="M4 S400"), "FAULTY", "tapping", "turns a right-hand tap to the left", **tapped)
    c.add("tap-out", CYCLES, tap(word="G85"), "FAULTY", "tapping", "pulls the tap out without turning it back", **tapped)
    c.add("tap-shallow", CYCLES, tap(z=-8.5), "FAULTY", "uncut", "ends the thread a millimetre early", **tapped)
    c.add("tap-missing", CYCLES, tap(word=""), "FAULTY", "nothing-cut", "leaves the thread out", **tapped)
    c.add("hole-shallow", CYCLES, tap(drill=-10.5), "FAULTY", "uncut", "drills a millimetre less than the tap needs", **tapped)
    c.add("tap-wide", CYCLES, tap(drill=-14.8, z=-13), "FAULTY", "thread", "drills at the diameter of the thread: nothing is left of it",
          part="tapped_through.dxf", tools=["drill:6:T1", "tap:M6:floating:T2", "drill:5:T3"])
    c.right("right-tap-wide", CYCLES, tap(drill=-11.548), "drills as wide as the tolerance of the core allows", part="tapped.dxf",
            tools=["drill:5.15:T1", "tap:M6:floating:T2", "drill:5:T3"])
    milled = {"part": "threaded.dxf", "tools": ["drill:18.5:T1", "threadmill:12:T2"]}
    c.right("right-thread", CYCLES, thread(), "mills the thread on its helix", **milled)
    c.add("thread-pitch", CYCLES, thread(pitch=1.25, low=-9.25, turns=9), "FAULTY", "thread", "climbs 1.25 mm a turn", **milled)
    c.add("thread-hand", CYCLES, thread(turn="G2"), "FAULTY", "thread", "mills it left-handed", **milled)
    c.add("thread-narrow", CYCLES, thread(radius=3.9), "FAULTY", "uncut", "stays 0.1 mm short of the diameter", **milled)
    c.add("thread-wide", CYCLES, thread(radius=4.05), "FAULTY", "gouge", "goes 0.05 mm beyond the diameter", **milled)
    c.add("thread-lead", CYCLES, thread(lead=0), "FAULTY", "thread", "comes in level, across the thread", **milled)
    c.add("thread-low", CYCLES, thread(turns=6), "FAULTY", "uncut", "ends the thread half a millimetre below the top", **milled)
    c.add("thread-shallow", CYCLES, thread(low=-6.5, turns=5), "FAULTY", "uncut", "ends the thread early", **milled)
    c.add("thread-wide-core", CYCLES, thread(), "FAULTY", "thread", "drills into the thread before it is milled",
          part="threaded.dxf", tools=["drill:19:T1", "threadmill:12:T2", "drill:18.5:T3"])
    for stops in (0, 1, 4):
        c.add(f"thread-stopped-{stops}", CYCLES, thread(stops=stops), "FAULTY", "spindle-off", "stops the spindle within the thread", **milled)
    sunk = {"part": "sunk.dxf", "tools": ["drill:4.5:T1", "chamfer:90deg:10:tip=0.4:T2"]}
    c.right("right-sink", CYCLES, sink(), "sinks to the diameter", **sunk)
    c.add("sink-deep", CYCLES, sink(-4.32), "FAULTY", "gouge", "sinks 20 um too deep", **sunk)
    c.add("sink-shallow", CYCLES, sink(-4.25), "FAULTY", "uncut", "sinks 50 um too little", **sunk)
    c.add("sink-missing", CYCLES, sink(None), "FAULTY", "nothing-cut", "leaves the countersink out", **sunk)
    c.right("right-sink-round", CYCLES, round_sink(-3.3), "goes round with the cone, a millimetre off the axis", **sunk)
    c.add("sink-round-shallow", CYCLES, round_sink(-3.25), "FAULTY", "uncut", "goes round 50 um too high", **sunk)
    c.add("sink-half-round", CYCLES, round_sink(-3.3, whole=False), "FAULTY", "uncut", "goes round by half a turn", **sunk)
    alike = {"part": "places.dxf", "tools": ["drill:5:T1"]}
    modal = CYCLES + ["mazak", "tormach", "grblhal"]
    c.right("right-places", modal, places("X20", "X30"), "drills three holes by one cycle", **alike)
    c.add("place-missed", modal, places("X20", "X30.2"), "FAULTY", "gouge", "drills the third 0.2 mm aside", **alike)
    c.add("place-missing", modal, places("X20"), "FAULTY", "nothing-cut", "leaves the third out", **alike)
    c.add("place-deep", modal, places("X20", "X30 Z-6.1"), "FAULTY", "gouge", "drills the third deeper", **alike)
    return c.done()
