"""What is left on purpose, what leaning walls keep, how cutters get into the material, and what each kind of tool can take."""
import math

from holes import CYCLES, cycle, drawing, second_tool, tap, thread, two_tools
from writer import ALL, OUT, Class, rings


PARTS = {
    "reamed.dxf": drawing(12, ("REAM_DIA6_D8", 6)),
    "bored.dxf": drawing(12, ("BORE_DIA20_D8", 20)),
    "pecked.dxf": drawing(16, ("DRILL_D12_PECK2", 6)),
    "drilled-pocket.dxf": drawing(12, ("POCKET_D4", 20), ("DRILL_D9", 5)),
    "chipped.dxf": drawing(16, ("DRILL_D12_CHIP2", 6)),
    "seat.dxf": drawing(12, ("CBORE_D4", 11), ("DRILL_D9", 6.6)),
}


def write_takes():
    """The drawings, beside the other parts."""
    for name, text in PARTS.items():
        (OUT / "parts" / name).write_text(text)


def leaves():
    """Stock to leave that is cut away."""
    c = Class("leaves")
    side, floor = {"allowance": 0.3}, {"allowance_floor": 0.3}

    def cut(halves, z):
        def change(p):
            p.cut = rings(p.t, halves, z=z)
        return change
    c.add("wall", ALL, cut([1, 4, 7], -2), "FAULTY", "stock-to-leave", "cuts to the wall where 0.3 mm is to stay", asked=side)
    c.add("wall-thin", ALL, cut([1, 4, 6.75], -2), "FAULTY", "stock-to-leave", "leaves 0.25 mm of 0.3", asked=side)
    c.right("right-wall", ALL, cut([1, 4, 6.7], -2), "leaves 0.3 mm on the walls", asked=side)
    c.add("floor", ALL, cut([1, 4, 7], -2), "FAULTY", "stock-to-leave", "cuts to the floor where 0.3 mm is to stay", asked=floor)
    c.right("right-floor", ALL, cut([1, 4, 7], -1.7), "leaves 0.3 mm on the floor", asked=floor)
    return c.done()


def entries():
    """Passes that sink a little are passes; entries are one way down."""
    c = Class("entries")
    limit = {"engagement": 60}

    def passes(sink, back, first):
        """Strokes through the pocket that go down by `sink` mm, the way back level; `first`: how it comes down at first."""
        def change(p):
            t = p.t
            p.cut = [t.rapid(x=3, y=3), t.rapid(z=1)] + first(t)
            for k, y in enumerate([3, 5.8, 8.6, 11.4, 14.2, 17]):
                if k:
                    p.cut += [t.feed(x=3, y=y, z=-2 + sink)]
                p.cut += [t.feed(x=17, y=y, z=-2)]
                if back:
                    p.cut += [t.feed(x=3, y=y, z=-2)]
            p.cut += [t.feed(x=3, y=17), t.feed(x=3, y=3), t.feed(x=17, y=3), t.feed(x=17, y=17), t.feed(x=3, y=17)]
        return change

    def straight(sink):
        return lambda t: [t.feed(120, z=-2 + sink)]
    for degrees in (0.18, 0.21, 0.6, 2):
        sink = round(14 * math.tan(math.radians(degrees)), 4)
        c.add(f"sinking-{degrees}", ALL, passes(sink, True, straight(sink)), "FAULTY", "over-engagement",
              f"cuts slots that sink by {degrees} degrees, and back", asked=limit)
    c.right("right-sinking", ALL, passes(0.0513, True, straight(0.0513)), "may cut slots", asked={"engagement": 180})

    def slow_descent(p):
        """All of the way down on one path that clears the pocket, at 0.21 degrees, and once more over it, level."""
        t = p.t
        path = [(x, y) for k, y in enumerate([3, 5.8, 8.6, 11.4, 14.2, 17]) for x in ((3, 17) if k % 2 == 0 else (17, 3))]
        lengths = [math.dist(a, b) for a, b in zip(path, path[1:])]
        turns, z = 0, 0.0
        slope = math.tan(math.radians(0.21))
        p.cut = [t.rapid(x=3, y=3), t.rapid(z=1), t.feed(120, z=0)]
        while z > -2:
            way = path if turns % 2 == 0 else path[::-1]
            for (x, y), length in zip(way[1:], lengths if turns % 2 == 0 else lengths[::-1]):
                z = max(-2, z - length * slope)
                p.cut.append(t.feed(x=x, y=y, z=z))
            turns += 1
        way = path if turns % 2 == 0 else path[::-1]
        p.cut += [t.feed(x=x, y=y) for x, y in way[1:]]
        p.cut += [t.feed(x=3, y=17), t.feed(x=3, y=3), t.feed(x=17, y=3), t.feed(x=17, y=17), t.feed(x=3, y=17)]
    c.add("slow-descent", ALL, slow_descent, "FAULTY", "over-engagement", "clears the pocket on one long way down", asked=limit)

    def helix(p):
        """A helix of 3 mm about the middle, its floor, then rings so near to each other that a third of the cutter is engaged."""
        t, n = p.t, p.t.n
        if p.d == "heidenhain":
            return
        p.cut = [t.rapid(x=12.5, y=10), t.rapid(z=1), t.feed(120, z=0.2)]
        z = 0.2
        for _ in range(4):
            z -= 0.55
            p.cut.append(f"G3 X{n(12.5)} Y{n(10)} Z{n(z)} I{n(-2.5)} J{n(0)} F{n(200)}")
        p.cut.append(f"G3 X{n(12.5)} Y{n(10)} I{n(-2.5)} J{n(0)} F{n(200)}")
        radius = 2.5
        while radius < 7:
            radius = round(min(7, radius + 0.4), 4)
            p.cut += [t.feed(x=10 + radius, y=10),
                      f"G3 X{n(10 + radius)} Y{n(10)} I{n(-radius)} J{n(0)} F{n(400)}"]
    c.right("right-helix", ["linuxcnc", "fanuc", "mach3", "grbl"], helix, "goes down on a helix and then keeps to the limit",
            part="round.json", asked={"engagement": 100})

    def ramp(feed):
        def change(p):
            t = p.t
            p.cut = [t.rapid(x=10, y=10), t.rapid(z=1), t.feed(60, z=0)]
            x, z, way = 10, 0.0, 1
            while z > -2:
                z = max(-2, z - 0.5)
                x += way
                way = -way
                p.cut.append(t.feed(feed, x=x, y=10, z=z))
            p.cut += rings(t, [1, 4, 7])[2:]
        return change
    c.add("steep-ramp", ALL, ramp(500), "FAULTY", "plunge-too-fast", "sinks at 223 mm/min on 26 degrees where 60 is stated",
          asked={"library": "gentle.toml"})
    c.right("right-steep-ramp", ALL, ramp(130), "sinks at 58 mm/min", asked={"library": "gentle.toml"})
    return c.done()


def takes():
    """What a tool cannot take, sideways and down."""
    c = Class("takes")
    for kind in ("drill:6", "reamer:6", "boringbar:6", "counterbore:6", "tap:6:pitch=1", "threadmill:6"):
        name = kind.split(":")[0]
        c.add(f"sideways-{name}", ["linuxcnc", "fanuc"], lambda p: None, "FAULTY", "more-than-it-cuts",
              f"clears a pocket with a {name}", part="", tools=[kind + ":T1"], asked={"stock": "-10:30,-10:30,-5:0"})

    spot = {"part": "", "tools": ["spotdrill:90deg:10:T1"], "asked": {"stock": "-10:30,-10:30,-12:0"}}

    def along(y, z):
        def change(p):
            t = p.t
            p.cut = [t.rapid(x=-20, y=y), t.rapid(z=z), t.feed(200, x=40, y=y), t.rapid(z=5)]
        return change
    c.add("sideways-spotdrill", ["linuxcnc", "fanuc"], along(10, -1.2), "FAULTY", "more-than-it-cuts",
          "cuts a groove with a spot drill", **spot)

    def broken_edge(p):
        t = p.t
        p.cut = rings(t, [1, 4, 7], z=-2)
        p.after = second_tool(p, "M3 S3000") + [t.rapid(x=10, y=10), t.rapid(z=-1.2), t.feed(200, x=10, y=0.6), t.feed(x=17, y=0.6),
                                                t.feed(x=17, y=10), t.rapid(z=5)]
    c.right("right-spotdrill", ["linuxcnc", "fanuc"], broken_edge, "breaks an edge with the flank of a spot drill", part="",
            tools=["endmill:6:T1", "spotdrill:90deg:10:T2"], asked={"stock": "-10:30,-10:30,-12:0"})

    def down(kind, drilled):
        tools = [f"drill:{drilled or 3}:T1", kind + ":T2"]

        def change(p):
            p.cut = cycle(p, "G81", -8, 1, 200) if drilled else []
            p.after = second_tool(p, "M3 S400") + cycle(p, "G84" if kind.startswith("tap") else "G85", -6, 3, 400)
            if not drilled:
                p.cut = [p.t.rapid(x=-3, y=-3)] + [p.t.rapid(z=5)]
        return tools, change
    for name, kind, right in (("reamer", "reamer:6", 5.7), ("boring-bar", "boringbar:6", 5.4), ("tap", "tap:M6:floating", 5),
                              ("counterbore", "counterbore:6", 3)):
        for what, drilled in (("solid", 0), ("narrow", 1 if name == "counterbore" else right - 1.5)):
            tools, change = down(kind, drilled)
            c.add(f"{what}-{name}", ["linuxcnc", "haas"], change, "FAULTY", "more-than-it-cuts",
                  f"puts a {name} into {'solid stock' if not drilled else 'a hole that is too narrow'}", part="", tools=tools,
                  asked={"stock": "-10:30,-10:30,-12:0"})
        tools, change = down(kind, right)
        c.right(f"right-{name}", ["linuxcnc", "haas"], change, f"puts a {name} into its hole", part="", tools=tools,
                asked={"stock": "-10:30,-10:30,-12:0"})

    def pressed(kind, hole):
        def change(p):
            p.cut = cycle(p, "G81", -5, 1, 200) if hole else []
            p.after = second_tool(p, "M3 S3000") + cycle(p, "G81", -3.5, 1, 100)
        return change
    for kind in ("chamfer:90deg:10:tip=2", "vbit:90deg:10:tip=2"):
        name = kind.split(":")[0]
        more = {"part": "", "tools": ["drill:3:T1", kind + ":T2"], "asked": {"stock": "-10:30,-10:30,-12:0"}}
        c.add(f"pressed-{name}", ["linuxcnc", "haas"], pressed(kind, False), "FAULTY", "more-than-it-cuts",
              "presses a flat tip of 2 mm into solid stock", **more)
        c.right(f"right-{name}", ["linuxcnc", "haas"], pressed(kind, True), "sinks about a hole", **more)

    def bore(radius, barred=None):
        """The hole of 20 by a mill of 8 from its middle out, then the boring bar down to `barred`."""
        def change(p):
            t, n = p.t, p.t.n
            p.cut = []
            for z in (-2, -4, -6, -8):
                p.cut += [t.rapid(x=10, y=10), t.rapid(z=z + 2.5), t.feed(100, z=z)]
                for r in (3, radius):
                    p.cut += [t.feed(x=10 + r, y=10), f"G3 X{n(10 + r)} Y{n(10)} I{n(-r)} J{n(0)} F{n(400)}"]
                p.cut += [t.feed(x=10, y=10)]
            p.after = second_tool(p, "M3 S500") + cycle(p, "G85", barred, 3, 60) if barred else []
        return change

    def ream(word):
        return two_tools(-9.742, "M3 S800", lambda p: cycle(p, word, -8, 3, 100))
    reamed = {"part": "reamed.dxf", "tools": ["drill:5.8:T1", "reamer:6:T2"]}
    c.right("right-ream", CYCLES, ream("G85"), "feeds the reamer out", **reamed)
    c.add("ream-rapid", CYCLES, ream("G81"), "FAULTY", "more-than-it-cuts", "pulls the reamer out at the rapid", **reamed)

    c.add("ream-wide", CYCLES, ream("G85"), "FAULTY", "nothing-cut", "drills the hole to size: the reamer turns in the air", part="reamed.dxf",
          tools=["drill:6:T1", "reamer:6:T2", "drill:5.8:T3"])

    def orbit(radius, z=-8):
        """A mill that widens a hole about 10, 10 down to z, two millimetres a turn."""
        def blocks(p):
            t, n = p.t, p.t.n
            out = [t.rapid(x=10 + radius, y=10), t.rapid(z=1)]
            for k in range(int(-z / 2)):
                out += [t.feed(100, z=-2 * (k + 1)), f"G3 X{n(10 + radius)} Y{n(10)} I{n(-radius)} J{n(0)} F{n(300)}"]
            return out + [t.feed(x=10, y=10), t.rapid(z=5)]
        return blocks

    def third_tool(p, spindle):
        return [block.replace("T2", "T3").replace("H2", "H3") for block in second_tool(p, spindle)]
    c.add("ream-milled", CYCLES, two_tools(-9.742, "M3 S4000", orbit(1)), "FAULTY", "nothing-cut",
          "mills the hole to size and never reams it", part="reamed.dxf",
          tools=["drill:5.8:T1", "endmill:4:T2", "reamer:6:T3"])
    c.add("ream-shallow", CYCLES, two_tools(-9.742, "M3 S800", lambda p: cycle(p, "G85", -6, 3, 100) + [p.t.rapid(z=5)] + third_tool(p, "M3 S4000") +
                                            orbit(1)(p)),
          "FAULTY", "uncut", "reams the upper part and mills the rest", part="reamed.dxf",
          tools=["drill:5.8:T1", "reamer:6:T2", "endmill:4:T3"])
    c.add("bore-shallow", CYCLES, bore(6, -5), "FAULTY", "uncut", "mills the hole to size and bores its upper part",
          part="bored.dxf", tools=["endmill:8:T1", "boringbar:20:T2"])
    c.right("right-bore", CYCLES, bore(5.8, -8), "mills the hole narrower, and bores it", part="bored.dxf",
            tools=["endmill:8:T1", "boringbar:20:T2"])
    c.right("right-bore-milled", CYCLES, bore(6), "mills the hole to size, without a boring bar", part="bored.dxf",
            tools=["endmill:8:T1"])

    def pocket(then):
        """The round pocket of 20 by a mill of 8, 4 mm deep, and what the second tool does in it."""
        def change(p):
            bore(6)(p)
            p.cut = p.cut[:len(p.cut) // 2]
            p.after = then(p)
        return change
    holed = {"part": "drilled-pocket.dxf", "tools": ["endmill:8:T1", "drill:5:T2"], "asked": {"accept": ["out-of-reach"]}}
    c.add("hole-left-out", CYCLES, pocket(lambda p: []), "FAULTY", "nothing-cut",
          "leaves out the hole in the pocket, whose drill is given and never called", **holed)
    c.right("right-hole", CYCLES, pocket(lambda p: second_tool(p, "M3 S3000") + cycle(p, "G81", -9, -3, 100)),
            "drills the hole in the pocket", **holed)

    def pecks(word, q):
        def change(p):
            block, end = cycle(p, word, -12, 1, 200)
            p.cut = [block + (f" Q{p.t.n(q)}" if q else ""), end]
        return change
    six = {"tools": ["drill:6:T1"], "accepted": ["stated-peck"]}
    for name, word, q, part, does in (
            ("at-once", "G81", 0, "pecked.dxf", "drills at once where pecks are stated"),
            ("long-pecks", "G83", 3, "pecked.dxf", "takes pecks of 3 mm where 2 are stated"),
            ("chips-kept", "G73", 2, "pecked.dxf", "breaks the chip where it is to be cleared"),
            ("chips-unbroken", "G81", 0, "chipped.dxf", "drills at once where the chip is to be broken")):
        c.add(name, CYCLES, pecks(word, q), "CONDITIONAL", "stated-peck", does, part=part, **six)
    c.right("right-pecks", CYCLES, pecks("G83", 2), "clears the chips every 2 mm", part="pecked.dxf", tools=["drill:6:T1"])
    c.right("right-chips", CYCLES, pecks("G73", 2), "breaks the chip every 2 mm", part="chipped.dxf", tools=["drill:6:T1"])

    def groove(z):
        def change(p):
            t = p.t
            p.cut = [t.rapid(x=-20, y=10), t.rapid(z=z), t.feed(300, x=40, y=10)]
        return change
    for kind, end in (("vbit:6:60deg", 5.19), ("chamfer:8:90deg:tip=1", 3.5)):
        more = {"part": "", "tools": [kind + ":T1"], "asked": {"stock": "-10:30,-10:30,-12:0"}}
        name = kind.split(":")[0]
        c.add(f"shank-of-{name}", ["linuxcnc", "fanuc"], groove(-end - 2), "FAULTY", "beyond-flutes",
              "cuts 2 mm deeper than the flanks reach, with the shank", **more)
        c.right(f"right-flank-of-{name}", ["linuxcnc", "fanuc"], groove(-end), "cuts as deep as the flanks reach", **more)

    def seat(first):
        def change(p):
            steps = {"drill": cycle(p, "G81", -9, 1, 200), "seat": cycle(p, "G81", -4, 1, 100)}
            p.cut = steps[first]
            p.after = second_tool(p, "M3 S800") + steps["seat" if first == "drill" else "drill"]
        return change
    c.right("right-seat", ["linuxcnc", "haas"], seat("drill"), "drills, then cuts the seat", part="seat.dxf",
            tools=["drill:6.6:T1", "counterbore:11:T2:noplunge"])
    c.add("seat-first", ["linuxcnc", "haas"], seat("seat"), "FAULTY", "more-than-it-cuts", "cuts the seat into solid stock",
          part="seat.dxf", tools=["drill:6.6:T2", "counterbore:11:T1"])

    def rows(out):
        """One turn of a mill with seven rows of teeth; without its way out it goes straight up."""
        def change(p):
            thread(turns=1)(p)
            if not out:
                del p.after[max(k for k, block in enumerate(p.after) if block.startswith("G3"))]
        return change
    threaded = {"part": "threaded.dxf", "tools": ["drill:18.5:T1", "threadmill:12:pitch=1.5:length=10.5:T2"]}
    c.right("right-thread-out", CYCLES, rows(True), "leaves the thread along its helix", **threaded)
    c.add("thread-ends-below", CYCLES, rows(True), "FAULTY", "uncut", "ends the thread half a millimetre below the top",
          part="threaded.dxf", tools=["drill:18.5:T1", "threadmill:12:pitch=1.5:length=9:T2"])
    c.add("thread-out", CYCLES, rows(False), "FAULTY", "thread", "goes up at the rapid through all turns of the thread", **threaded)
    return c.done()


def taps():
    """Taps against the cycles of their controls, with a part and without one."""
    c = Class("taps")
    tapped = {"part": "tapped.dxf", "tools": ["drill:5:T1", "tap:M6:floating:T2"]}
    c.add("left-cycle", CYCLES, tap(word="G74"), "FAULTY", "tapping", "turns a right-hand tap the wrong way by G74", **tapped)
    c.add("left-cycle-m4", CYCLES, tap(word="G74", spindle="M4 S400"), "FAULTY", "tapping",
          "turns a right-hand tap to the left", **tapped)
    left = {"part": "", "tools": ["drill:5:T1", "tap:M6:left:floating:T2"], "asked": {"stock": "-20:40,-20:40,-12:0"}}
    c.add("right-cycle-m4", CYCLES, tap(spindle="M4 S400"), "FAULTY", "tapping", "gives a left-hand tap to G84", **left)
    c.right("right-left-hand", CYCLES, tap(word="G74", spindle="M4 S400"), "gives a left-hand tap to G74", **left)
    rigid = {"part": "tapped.dxf", "tools": ["drill:5:T1", "tap:M6:T2"]}
    c.add("untied", ["linuxcnc", "fanuc", "mach3", "mach4"], tap(), "CONDITIONAL", "rigid-tap",
          "taps rigidly by a cycle that is not tied to the spindle", accepted=["rigid-tap"], **rigid)
    c.right("right-tied", ["haas"], tap(), "ties the feed to the spindle", **rigid)

    def m29(p):
        tap()(p)
        at = next(k for k, block in enumerate(p.after) if "G84" in block)
        p.after.insert(at, "M29 S400")
    c.right("right-m29", ["fanuc"], m29, "ties the feed to the spindle by M29", **rigid)
    alone = {"part": "", "tools": ["drill:5:T1", "tap:M6:floating:T2"], "asked": {"stock": "-20:40,-20:40,-12:0"}}
    c.right("right-alone", CYCLES, tap(), "feeds the pitch at every turn", **alone)
    c.add("alone-pitch", CYCLES, tap(f=500), "FAULTY", "tapping", "feeds 1.25 mm a turn with a pitch of 1", **alone)
    c.add("alone-out", CYCLES, tap(word="G81"), "FAULTY", "tapping", "pulls the tap out at the rapid", **alone)
    c.add("alone-solid", CYCLES, tap(drill=-3), "FAULTY", "more-than-it-cuts", "taps below its hole", **alone)
    return c.done()
