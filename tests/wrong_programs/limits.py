"""Canned cycles, what tools and machines may do, and what controls differ in: the libraries, machines and cases of these."""
import math

from writer import ALL, CHANGER, OUT, WORD, Class, nothing, rings

TOOLS = {
    "short.toml": "flute_length = 1.5\n",
    "long.toml": "flute_length = 2.5\n",
    "slow-cutter.toml": "max_spindle = 6000\n",
    "fast-cutter.toml": "max_spindle = 24000\n",
    "gentle.toml": "plunge_feed = 60\n",
    "brisk.toml": "plunge_feed = 120\n",
    "shallow.toml": "stepdown = 1\n",
    "deep.toml": "stepdown = 2\n",
}

#: A library of two tools: the second one is the larger, the one that the work would be planned with.
PAIRS = {
    "shallow-small.toml": "stepdown = 1\n",
    "deep-small.toml": "stepdown = 2\n",
}

DRIVES = {
    "hasty.toml": "spindle = 8000\nfeed = 200\n",
    "calm.toml": "spindle = 8000\nfeed = 400\n",
    "slow-turning.toml": "spindle = 4000\nfeed = 400\n",
    "fast-turning.toml": "spindle = 18000\nfeed = 400\n",
}

MACHINES = {
    "slow.toml": "max_spindle = 6000\n",
    "fast.toml": "max_spindle = 24000\n",
    "patient.toml": "spindle_wait = 5\n",
    "prompt.toml": "spindle_wait = 2\n",
}


def write_limits():
    """Libraries and machine files, beside the parts."""
    for name, line in {**TOOLS, **DRIVES}.items():
        (OUT / "parts" / name).write_text('[[tool]]\nkind = "endmill"\nnumber = 1\ndiameter = 6\n' + line)
    for name, line in PAIRS.items():
        larger = '[[tool]]\nkind = "endmill"\nnumber = 2\ndiameter = 6.1\nstepdown = 5\n'
        (OUT / "parts" / name).write_text('[[tool]]\nkind = "endmill"\nnumber = 1\ndiameter = 6\n' + line + "\n" + larger)
    for name, line in MACHINES.items():
        (OUT / "parts" / name).write_text(line)


def cycles():
    """Canned cycles whose depth goes with their retract plane, and those that feed out."""
    c = Class("cycles")

    def relative(plane):
        def change(p):
            n = p.t.n
            p.after = [p.t.rapid(z=1), "G91", f"G98 G81 X{n(0)} Y{n(0)} R{n(0)} Z{n(-3)} F{n(100)}",
                       f"X{n(3)} Y{n(0)} R{n(plane)}", "G80", "G90"]
        return change
    c.add("relative-cycle", CHANGER, relative(-1), "FAULTY", "gouge",
          "counts its depth from the lower plane: drills 1 mm below the floor")
    c.right("right-relative-cycle", CHANGER, relative(0), "counts its depth from the plane as before")

    def bore(word):
        def change(p):
            n = p.t.n
            p.after = [p.t.rapid(z=5), f"G98 {word} X{n(10)} Y{n(10)} R{n(1)} Z{n(-2)} F{n(100)}", "G80"]
        return change
    c.right("right-bore", CHANGER, bore("G85"), "feeds in and out of what is cleared")

    def wrong_bore(p):
        bore("G85")(p)
        p.after[1] = p.after[1].replace("Z" + p.t.n(-2), "Z" + p.t.n(-2.05))
    c.add("dwell-unsaid", ["linuxcnc"], bore("G82"), "REFUSED", "", "stops, as it asks for the time of the dwell")
    c.right("right-dwell-unsaid", [d for d in CHANGER if d != "linuxcnc"], bore("G82"), "drills without a dwell")

    def home_within(p):
        bore("G81")(p)
        p.after[-1:] = ["M5"]
        p.retract = p.stop = []
    c.add("home-within", ["fanuc"], home_within, "REFUSED", "", "stops by an alarm at G28, as the cycle is in force")
    c.right("right-home-within", ["haas"], home_within, "goes home by G53")

    c.add("bore", CHANGER, wrong_bore, "FAULTY", "gouge", "feeds 0.05 mm below the floor and out")
    return c.done()


def limits():
    """What tool and machine state: flutes, feeds, depth, engagement, speed, the spindle's start."""
    c = Class("limits")

    def both(name, reason, key, wrong, right, does, twin):
        c.add(name, ALL, nothing, "FAULTY", reason, does, asked={key: wrong})
        c.right("right-" + name, ALL, nothing, twin, asked={key: right})
    both("flutes", "beyond-flutes", "library", "short.toml", "long.toml", "rubs with its shank: its flutes are 1.5 mm long",
         "cuts with its flutes alone")
    both("plunge-feed", "plunge-too-fast", "library", "gentle.toml", "brisk.toml", "plunges twice as fast as the tool may",
         "plunges as fast as the tool may")
    both("stepdown", "too-deep", "library", "shallow.toml", "deep.toml", "takes 2 mm at once where the tool takes 1",
         "takes what the tool takes")
    called = [dialect for dialect in ALL if dialect != "marlin"]
    c.add("stepdown-of-smaller", called, nothing, "FAULTY", "too-deep",
          "takes 2 mm at once with a tool that takes 1, where a larger would be planned", asked={"library": "shallow-small.toml"})
    c.right("right-stepdown-of-smaller", called, nothing, "takes what the tool takes",
            asked={"library": "deep-small.toml"})
    def two(p):
        p.after = [p.t.rapid(z=5), "M5", "T2 M6", "G43", "M3 S8000", "G4 P2", p.t.rapid(x=10, y=10), p.t.feed(x=12, y=10)]
    c.add("stepdown-of-first", ["linuxcnc"], two, "FAULTY", "too-deep",
          "takes 2 mm at once with the smaller of its tools, which takes 1", asked={"library": "shallow-small.toml"})
    c.right("right-stepdown-of-first", ["linuxcnc"], two, "takes what its tools take",
            asked={"library": "deep-small.toml"})
    both("engagement", "over-engagement", "engagement", 90, 180, "cuts a slot where 90 degrees are asked for",
         "may cut slots")
    both("speed", "spindle-speed", "machine", "slow.toml", "fast.toml", "asks for more than the spindle turns",
         "asks for what the spindle turns")
    both("cutter-speed", "spindle-speed", "library", "slow-cutter.toml", "fast-cutter.toml",
         "asks for more than the cutter may turn", "asks for what the cutter may turn")
    both("wait", "spindle-off", "machine", "patient.toml", "prompt.toml", "cuts 2 s after the start of a spindle that needs 5",
         "waits until the spindle turns")

    for name, reason, library, does in [("stated-feed", "stated-feed", "hasty.toml", "feeds twice as fast as is stated for the tool"),
                                        ("stated-speed", "stated-speed", "slow-turning.toml", "turns twice as fast as is stated"),
                                        ("stated-more", "stated-speed", "fast-turning.toml", "turns less than half as fast")]:
        c.add(name, ALL, nothing, "CONDITIONAL", reason, does, accepted=[reason], asked={"library": library})
    c.right("right-stated", ALL, nothing, "is driven as is stated", asked={"library": "calm.toml"})

    def wave(p):
        heights = [-1.9995, -2]
        p.cut = p.cut[:2] + [block.replace(" F", f" Z{p.t.n(heights[k % 2])} F") for k, block in enumerate(p.cut[2:])]
    c.add("wave", ALL, wave, "FAULTY", "over-engagement", "cuts a slot while it goes up and down by 0.5 um",
          asked={"engagement": 90})
    c.right("right-wave", ALL, wave, "may cut slots", asked={"engagement": 180})
    return c.done()


def worst():
    """Where controls differ within their tolerance, the worst counts."""
    c = Class("worst")

    def arc(start, end):
        def change(p):
            t, d = p.t, math.radians(60)
            x0, y0 = 10 + start * math.cos(d), 10 - start * math.sin(d)
            x1, y1 = 10 + end * math.cos(d), 10 + end * math.sin(d)
            p.after = [t.feed(x=x0, y=y0),
                       f"G3 X{t.n(x1)} Y{t.n(y1)} I{t.n(10 - x0)} J{t.n(10 - y0)} F{t.n(400)}"]
        return change
    c.add("two-radii", WORD, arc(6.998, 7.004), "FAULTY", "gouge", "ends 4 um outside of the wall's circle")
    c.right("right-two-radii", WORD, arc(6.996, 7), "stays within the wall whichever radius counts")

    def film(z):
        def change(p):
            p.cut = rings(p.t, [1, 4, 7], z=z)
        return change
    c.add("film", ALL, film(-1.98), "FAULTY", "nothing-cut", "leaves 0.02 mm on the floor")
    c.right("right-film", ALL, film(-1.9995), "leaves half a micrometre")
    return c.done()
