"""What is above the cutter and beside the work: holders, shanks, clamps."""
from writer import ALL, Class, nothing


def holder():
    """The cutter goes 2 mm deep into a pocket of 20 mm."""
    c = Class("holder")

    def tool(words):
        return ["endmill:6:T1:" + words]
    for part, asked in (("pocket.json", {}), ("", {"stock": "-20:60,-20:60,-10:0"})):
        mark = "" if part else "-alone"
        c.add("short" + mark, ALL, nothing, "FAULTY", "holder-in-material", "stands out so little that its holder dives into the material",
              part=part, tools=tool("stickout=1.5:holder=30"), asked=asked)
        c.right("right-long" + mark, ALL, nothing, "stands out far enough", part=part, tools=tool("stickout=2.5:holder=30"), asked=asked)
        c.add("shank" + mark, ALL, nothing, "FAULTY", "holder-in-material", "has a shank wider than its flutes, which are too short",
              part=part, tools=tool("length=1.5:shank=8"), asked=asked)
        c.right("right-shank" + mark, ALL, nothing, "has a wider shank above the work", part=part, tools=tool("length=3:shank=8"),
                asked=asked)

    def aside(p):
        p.after = [p.t.rapid(z=5), p.t.rapid(x=-20)]
    clamp = {"stock": "-20:60,-20:60,-10:0", "keep_out": ["-30:-10,0:20,-10:12"]}
    c.add("clamp", ALL, aside, "FAULTY", "keep-out", "runs into a clamp beside the pocket", part="", asked=clamp)
    c.right("right-clamp", ALL, nothing, "stays away from the clamp", part="", asked=clamp)
    low = {**clamp, "keep_out": ["-30:-10,0:20,-10:4.5"]}
    c.right("right-low-clamp", ALL, aside, "runs over a clamp that is lower", part="", asked=low)
    c.add("clamp-holder", ALL, nothing, "FAULTY", "keep-out", "passes a clamp with its cutter, and not with its holder", part="",
          tools=tool("stickout=4:holder=30"), asked={**clamp, "keep_out": ["-10:-2,0:20,-10:5"]})
    c.right("right-clamp-holder", ALL, nothing, "passes a clamp with a holder that is narrower", part="",
            tools=tool("stickout=4:holder=9"), asked={**clamp, "keep_out": ["-10:-2,0:20,-10:5"]})
    return c.done()
