"""Programs of two cutters: the second meets what the end of the first has left, and its right twin does not."""
import json
import math

from alone import STOCK
from holes import CYCLES, cycle, drawing, second_tool, two_tools
from writer import OUT, Class, rings

PARTS = {
    "round-floor.json": {"name": "ROUND", "units": "mm", "pockets": [
        {"name": "ROUND", "outer": [[13, 10, 1], [7, 10, 1]], "islands": [], "top": 0, "depth": 3}]},
    "filleted.json": {"name": "FILLET", "units": "mm", "outer": [[0, 0, 0], [20, 0, 0], [20, 20, 0], [0, 20, 0]], "islands": [],
                      "top": 0, "depth": 2, "floor_fillet": 1},
    "leaning.json": {"name": "LEANING", "units": "mm", "outer": [[0, 0, 0], [20, 0, 0], [20, 20, 0], [0, 20, 0]], "islands": [],
                     "top": 0, "depth": 2, "floor_fillet": 1, "slope_rad": math.radians(5)},
}


def write_cutters():
    """The parts, beside the others."""
    for name, part in PARTS.items():
        (OUT / "parts" / name).write_text(json.dumps(part, indent=1) + "\n")
    (OUT / "parts" / "through.dxf").write_text(drawing(12, ("DRILL_THRU", 6)))


def down(z, feed=None):
    """The second tool goes down at 10, 10 at the rapid to z, and on to `feed` at the feed."""
    def blocks(p):
        return [p.t.rapid(z=z)] + ([p.t.feed(100, z=feed)] if feed is not None else [])
    return blocks


def after_groove(blocks, z=-2):
    """The first tool cuts a groove along X from 10, 10."""
    def change(p):
        t = p.t
        p.cut = [t.rapid(z=1), t.feed(100, z=z), t.feed(300, x=30)]
        p.after = second_tool(p, "M3 S2000") + blocks(p)
    return change


def after_hole(blocks, z=-3):
    return two_tools(z, "M3 S2000", blocks)


def cleared(halves, z=-2):
    def change(p):
        p.cut = rings(p.t, halves, z=z)
    return change


def drilled(z):
    def change(p):
        p.cut = cycle(p, "G81", z, 1, 200)
    return change


def leaning(fillet):
    """Layers of a flat mill of 6 mm between walls that lean by 5 degrees, off a fillet at their foot."""
    sine, cosine = math.sin(math.radians(5)), math.cos(math.radians(5))

    def half(z):
        above = 2 + z
        off = 0
        if above < fillet * (1 - sine):
            off = (fillet * (1 - sine) + above * sine) / cosine - math.sqrt(fillet ** 2 - (fillet - above) ** 2)
        return 7 + z * sine / cosine - off - 0.0005

    def change(p):
        p.cut = []
        for z in (-0.5, -1, -1.5, -2):
            p.cut += [p.t.rapid(z=5), p.t.rapid(x=10, y=10)] + rings(p.t, [1, 4, half(z)], z=z)
    return change


def thread_downwards(leads_out, pitch=1.5, radius=4.0, top=1.0, turns=7):
    """A thread milled from above, round and round, and left at its lower end."""
    def blocks(p):
        n, z = p.t.n, top
        out = [p.t.rapid(z=5), p.t.feed(300, z=top + pitch / 4)]

        def half(x, i, to):
            out.append(f"G2 X{n(x)} Y{n(10)} Z{n(to)} I{n(i)} J{n(0)} F{n(300)}")
        half(10 + radius, radius / 2, top)
        for _ in range(turns):
            half(10 - radius, -radius, z - pitch / 2)
            half(10 + radius, radius, z - pitch)
            z -= pitch
        if leads_out:
            half(10, -radius / 2, z - pitch / 4)
        return out
    return blocks


def cutters():
    """Rapids and plunges into cones and fillets, floors that a point leaves, ways through."""
    c = Class("cutters")

    def tools(*names):
        return {"tools": [f"{name}:T{i + 1}" for i, name in enumerate(names)], **STOCK}
    cone = tools("drill:6", "endmill:6")
    c.add("rapid-into-cone", CYCLES, after_hole(down(-2.95, -3)), "FAULTY", "rapid-in-material",
          "a mill goes down at the rapid where the point of the drill has left its cone", **cone)
    c.right("right-rapid-over-cone", CYCLES, after_hole(down(-1.15, -3)),
            "a mill goes down at the rapid as far as the drill was as wide, and on at the feed", **cone)
    still = tools("drill:6", "endmill:6:noplunge")
    c.add("plunge-into-cone", CYCLES, after_hole(down(1, -2.5)), "FAULTY", "plunge-too-fast",
          "a mill that may not plunge is let down into the cone of a drill", **still)
    c.right("right-plunge-over-cone", CYCLES, after_hole(down(1, -1.15)),
            "a mill that may not plunge is let down as far as the drill was as wide", **still)
    c.add("rapid-into-ball-groove", CYCLES, after_groove(down(-1.9)), "FAULTY", "rapid-in-material",
          "a flat mill goes down at the rapid in the groove of a ball", **tools("ball:6", "endmill:6"))
    c.right("right-ball-in-ball-groove", CYCLES, after_groove(down(-1.9)),
            "a ball goes down at the rapid in the groove of its like", **tools("ball:6", "ball:6"))
    c.add("rapid-into-fillet", CYCLES, after_groove(down(-1.9)), "FAULTY", "rapid-in-material",
          "a flat mill goes down at the rapid where a bull-nose of its width has left fillets",
          **tools("bullnose:8:corner=2", "endmill:8"))
    c.right("right-between-fillets", CYCLES, after_groove(down(-1.9)),
            "a flat mill goes down at the rapid between the fillets of a bull-nose", **tools("bullnose:8:corner=2", "endmill:4"))
    c.add("rapid-into-v-groove", CYCLES, after_groove(down(-1.5)), "FAULTY", "rapid-in-material",
          "a flat mill goes down at the rapid in the groove of a V-bit", **tools("vbit:90deg:10", "endmill:3"))
    c.right("right-in-v-groove", CYCLES, after_groove(down(-0.4)),
            "a flat mill goes down at the rapid as far as the groove of a V-bit is as wide", **tools("vbit:90deg:10", "endmill:3"))

    c.add("floor-by-drill", CYCLES, drilled(-3), "CONDITIONAL", "out-of-reach", "leaves a cone on the floor of a round pocket",
          part="round-floor.json", tools=["drill:6:T1"])
    c.right("right-floor-by-mill", CYCLES, drilled(-3), "plunges a flat mill into a round pocket", part="round-floor.json",
            tools=["endmill:6:T1"])

    # The fillet at the foot of the walls belongs to an end of its radius: others leave more, or cusps on the floor beside it.
    def stepped(floor):
        def change(p):
            p.cut = rings(p.t, [1, 4, 7], z=-1) + [p.t.rapid(z=5), p.t.rapid(x=10, y=10)] + rings(p.t, [1, 4, floor])
        return change
    for name, mill, change in (("flat", "endmill:6", stepped(6)), ("sharp", "bullnose:6:corner=0.2", stepped(6.2)),
                               ("large", "ball:6", cleared([1, 2, 3, 4, 5, 6, 7])), ("ball", "ball:2", cleared([1, 2.5, 4, 5.5, 7, 8, 9]))):
        c.add(f"fillet-{name}", CYCLES, change, "CONDITIONAL", "out-of-reach", "leaves material above the fillet, or cusps beside it",
              part="filleted.json", tools=[f"{mill}:T1"])
    c.add("fillet-left-out", CYCLES, stepped(6), "FAULTY", "uncut", "leaves the fillet out, whose mill is given and never called",
          part="filleted.json", tools=["endmill:6:T1", "bullnose:6:corner=1:T2"], asked={"accept": ["out-of-reach"]})
    c.add("wall-over-fillet", CYCLES, cleared([1, 4, 7]), "FAULTY", "uncut",
          "follows the way of a bull-nose with a mill as narrow as its flat, 1 mm off the walls",
          part="filleted.json", tools=["endmill:4:T1", "bullnose:6:corner=1:T2"], asked={"accept": ["out-of-reach"]})
    for name, change, part in (("", cleared([1, 4, 7]), "filleted.json"), ("-leaning", leaning(0), "leaning.json")):
        c.add(f"fillet-gouged{name}", CYCLES, change, "FAULTY", "gouge", "cuts the fillet away", part=part, tools=["endmill:6:T1"],
              asked={"accept": ["out-of-reach"]})
    for name, change, part in (("", stepped(6), "filleted.json"), ("-leaning", leaning(1), "leaning.json")):
        c.right(f"right-fillet-kept{name}", CYCLES, change, "keeps off the fillet", part=part, tools=["endmill:6:T1"],
                asked={"accept": ["out-of-reach"]})
    c.right("right-fillet", CYCLES, cleared([1, 4, 7]), "makes the fillet by an end of its radius", part="filleted.json",
            tools=["bullnose:6:corner=1:T1"])

    # A ball leaves cusps on the floor, which is accepted; what it leaves above them is not.
    for name, mill in (("ball", "ball:6"), ("cone", "chamfer:110deg:6")):
        alone = {"tools": [f"{mill}:T1"], "asked": {"accept": ["out-of-reach"]}}
        c.right(f"right-{name}-alone", CYCLES, cleared([1, 4, 7]), "clears all above the cusps that its end leaves", **alone)
        c.add(f"{name}-ring", CYCLES, cleared([1, 7]), "FAULTY", "uncut", "leaves a ring between its passes", **alone)
        c.add(f"{name}-narrow", CYCLES, cleared([1, 4, 6.9]), "FAULTY", "uncut", "stays 0.1 mm off the walls", **alone)
        c.add(f"{name}-high", CYCLES, cleared([1, 4, 7], -1.5), "FAULTY", "uncut", "ends half a millimetre above the floor", **alone)

    through = {"part": "through.dxf", "tools": ["drill:6:T1"]}
    c.right("right-through", CYCLES, drilled(-14.31), "drills a little deeper through than our own plans do", **through)
    c.add("through-too-deep", CYCLES, drilled(-15.5), "FAULTY", "beyond-stock", "drills into what the block lies on", **through)

    milled = {"part": "threaded.dxf", "tools": ["drill:18.5:T1", "threadmill:12:T2"]}
    c.add("thread-straight-out", CYCLES, two_tools(-15.43, "M3 S2000", thread_downwards(False)), "FAULTY", "rapid-in-material",
          "leaves the thread straight up at the rapid, through its crests", **milled)
    c.right("right-thread-out", CYCLES, two_tools(-15.43, "M3 S2000", thread_downwards(True)), "leads out of the thread first",
            **milled)
    return c.done()
