"""Random parts with the cutters that they need, of all kinds: the drawing, the command line, and how deep each place is to be cut.

The description of a part is read by tests/support/independent/made_part.h. Heights are given over how far a place lies inside of a shape:
`low` is how deep cutters may come, `high` how deep they have to.
"""
import json
import math
import random

THICKNESS = 12
CELL = 34        # one thing to cut in each square of this width
DEEP = -99       # below all material
POINT = math.tan(math.radians(59))
SCALLOP = 0.2    # what layers may leave on leaning walls, square to them
RIDGE = 0.05     # what bits may leave between their passes on floors


def number(value):
    return f"{value:.6f}".rstrip("0").rstrip(".")


def numbers(*values):
    return " ".join(number(v) for v in values)


class Part:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.stock = (0, 0, width, height)
        self.cutters = {}      # by the words of the command line, in order: words of the description
        self.kinds = []        # of the things cut
        self.options = []
        self.drawing = []      # DXF entities
        self.pockets = []      # or outline JSON
        self.lines = []        # of the description

    # Cutters.
    def cutter(self, words, kind, end, diameter, round=0, angle=0, tip=0, height=0, neck=0, pitch=0, length=0, plunges=True):
        self.cutters.setdefault(words, f"{kind} {end} " + numbers(diameter, round, angle, tip, height, neck, pitch, length,
                                                                  int(plunges)))

    def endmill(self, d, plunges=True, length=0):
        self.cutter(f"endmill:{number(d)}" + (f":length={length}" if length else "") + ("" if plunges else ":noplunge"),
                    "endmill", "flat", d, plunges=plunges)

    def bullnose(self, d, corner, plunges=True):
        self.cutter(f"bullnose:{number(d)}:corner={number(corner)}" + ("" if plunges else ":noplunge"), "bullnose", "round", d,
                    round=corner, plunges=plunges)

    def ball(self, d):
        self.cutter(f"ball:{number(d)}", "ball", "round", d, round=d / 2)

    def drill(self, d):
        self.cutter(f"drill:{number(d)}", "drill", "cone", d, angle=118)

    def cone(self, words, kind, d, angle, tip=0):
        self.cutter(words, kind, "cone", d, angle=angle, tip=tip)

    # The drawing.
    def circle(self, layer, x, y, r):
        self.drawing += [0, "CIRCLE", 8, layer, 10, number(x), 20, number(y), 40, number(r)]

    def polyline(self, layer, corners, closed=True):
        self.drawing += [0, "LWPOLYLINE", 8, layer, 90, len(corners), 70, int(closed)]
        for x, y, *bulge in corners:
            self.drawing += [10, number(x), 20, number(y)] + ([42, number(bulge[0])] if bulge else [])

    def box(self, layer, x, y, w, h, r=0, turned=0):
        c, s = math.cos(turned), math.sin(turned)
        self.polyline(layer, [(x + c * u - s * v, y + s * u + c * v, *bulge) for u, v, *bulge in box_corners(w, h, r)])

    # The description.
    def element(self, name, shape, low=None, high=None, islands=(), **more):
        self.lines += [f"element {name}", "shape " + shape] + ["island " + i for i in islands]
        for word, points in (("low", low), ("high", high)):
            if points is not None:
                self.lines.append(word + " " + " ".join(numbers(*p) for p in points))
        self.lines += [f"{word} {numbers(*value)}" for word, value in more.items()]

    def description(self):
        x0, y0, x1, y1 = self.stock
        lines = [f"block {numbers(x0, y0, x1, y1, -THICKNESS)}"]
        lines += [f"cutter {i + 1} {words}" for i, words in enumerate(self.cutters.values())]
        return "\n".join(lines + self.lines) + "\n"

    def text(self):
        """The name's ending and the text of the part's file."""
        x0, y0, x1, y1 = self.stock
        if self.pockets:
            stock = {"x": [x0, x1], "y": [y0, y1], "z": [-THICKNESS, 0]}
            return "json", json.dumps({"units": "mm", "stock": stock, "pockets": self.pockets})
        stock = Part(0, 0)
        stock.polyline(f"STOCK_D{THICKNESS}", [(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
        head = [0, "SECTION", 2, "HEADER", 9, "$INSUNITS", 70, 4, 0, "ENDSEC", 0, "SECTION", 2, "ENTITIES"]
        return "dxf", "\n".join(str(v) for v in head + stock.drawing + self.drawing + [0, "ENDSEC", 0, "EOF"]) + "\n"

    def tools(self):
        return [word for tool in self.cutters for word in ("--tool", tool)]


def box_corners(w, h, r):
    if r == 0:
        return [(-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2)]
    b = math.tan(math.pi / 8)
    return [(r - w / 2, -h / 2), (w / 2 - r, -h / 2, b), (w / 2, r - h / 2), (w / 2, h / 2 - r, b),
            (w / 2 - r, h / 2), (r - w / 2, h / 2, b), (-w / 2, h / 2 - r), (-w / 2, r - h / 2, b)]


def box(x, y, w, h, r=0, turned=0):
    return "box " + numbers(x, y, w, h, r, turned)


def disc(x, y, r):
    return "disc " + numbers(x, y, r)


def path(half, *corners):
    return "path " + numbers(half, *(v for corner in corners for v in corner))


class Mills:
    """The mills of pockets: what is certain of all of them."""

    def __init__(self, part, r, kind):
        self.diameters, self.round = [], 0
        d = r.choice([4, 5, 6, 8])
        if kind == "bullnose":
            self.add(d)
            self.round = r.choice([0.5, 1])
            part.bullnose(d, self.round, plunges=r.random() < 0.7)
        if kind == "ball":
            self.add(d)
            self.round = d / 2
            part.ball(d)
        self.add(d)
        part.endmill(d, plunges=kind != "noplunge")
        if kind == "two":
            self.add(r.choice([2.5, 3]))
            part.endmill(self.diameters[-1])
            if r.random() < 0.6:
                part.options += ["--rest"]
        self.main = d

    def add(self, d):
        self.diameters.append(d)

    @property
    def widest(self):
        return max(self.diameters)

    def reach(self):
        """Of the widest, with the rounding of the roundest."""
        return (self.widest / 2 + 0.03, max(0, self.widest / 2 - self.round - 0.03), 0)


def flat_pocket(part, mills, name, shape, depth, islands=()):
    part.element(name, shape, [(0, -depth)], [(0, min(0, mills.round - depth)), (max(mills.round, 0.001), -depth)], islands,
                 reach=mills.reach())


def drilled(part, name, x, y, r, low, high, may_be_milled=True):
    """A hole that may end in the point of a drill."""
    top = min(0, high + r / POINT)
    part.element(name, disc(x, y, r), [(-0.05, low)], [(0.05, top), (r, high)])


def hole_bottom(depth, r):
    """How deep a drill may come that leaves the full width down to a depth."""
    return -depth - r / POINT - 0.6


# Each draws one thing around a place and describes it. They get the part, its mills, a source of random numbers and the place.
def pocket(part, mills, r, x, y):
    depth, w, h = r.choice([1.5, 2.5, 4, 6, 8]), round(r.uniform(12, 24), 2), round(r.uniform(12, 24), 2)
    turned = r.choice([0, 0.3, 0.7]) if w + h < 36 else 0
    part.box(f"POCKET_D{depth}", x, y, w, h, 0, turned)
    flat_pocket(part, mills, "pocket", box(x, y, w, h, 0, turned), depth)


def round_pocket(part, mills, r, x, y):
    depth, w, h, corner = r.choice([1.5, 2.5, 4, 6, 8]), r.uniform(12, 26), r.uniform(12, 26), r.choice([2, 4.2, 5])
    part.box(f"POCKET_D{depth}", x, y, w, h, corner)
    flat_pocket(part, mills, "round_pocket", box(x, y, w, h, corner), depth)


def disc_pocket(part, mills, r, x, y):
    depth, radius = r.choice([1.5, 2.5, 4, 6, 8]), r.uniform(6, 13)
    part.circle(f"POCKET_D{depth}", x, y, radius)
    flat_pocket(part, mills, "disc_pocket", disc(x, y, radius), depth)


def island(part, mills, r, x, y):
    depth, ix, radius = r.choice([1.5, 2.5, 4, 6]), x + r.uniform(-2, 2), r.uniform(2, 4.5)
    part.box(f"POCKET_D{depth}", x, y, 26, 26, 4.5)
    part.circle("ISLAND", ix, y, radius)
    flat_pocket(part, mills, "island", box(x, y, 26, 26, 4.5), depth, [disc(ix, y, radius)])


def nested(part, mills, r, x, y):
    depth = r.choice([1.5, 2.5, 4, 6])
    part.box(f"POCKET_D{depth}", x, y, 26, 24, 4.5)
    part.box(f"POCKET_D{depth + 2}", x + 1, y, 14, 12, 4.5)
    flat_pocket(part, mills, "outer", box(x, y, 26, 24, 4.5), depth)
    flat_pocket(part, mills, "inner", box(x + 1, y, 14, 12, 4.5), depth + 2)


def slot(part, mills, r, x, y):
    depth, width = r.choice([1.5, 2.5, 4]), mills.main + r.choice([0, 0.5, 2])
    part.box(f"POCKET_D{depth}", x, y, width, 20, mills.main / 2 - 0.01)
    flat_pocket(part, mills, "slot", box(x, y, width, 20, mills.main / 2 - 0.01), depth)


def drill(part, mills, r, x, y):
    d, through = round(r.uniform(4, 12), 2), r.random() < 0.5
    depth = round(0.6 * d / 2 + r.choice([1, 3, 5]), 1)
    part.drill(d)
    part.circle("DRILL_THRU" if through else f"DRILL_D{depth}", x, y, d / 2)
    if through:
        drilled(part, "drill", x, y, d / 2, DEEP, -THICKNESS)
    else:
        drilled(part, "drill", x, y, d / 2, -depth, -depth)


def spotted(part, mills, r, x, y):
    d = round(r.uniform(4, 9), 2)
    part.drill(d)
    if r.random() < 0.5:
        part.cone("spotdrill:90deg:12", "spotdrill", 12, 90)
    for i in range(3):
        px, py = x + r.uniform(-10, 10), y - 11 + 11 * i
        part.circle("DRILL_THRU", px, py, d / 2)
        drilled(part, "spotted", px, py, d / 2, DEEP, -THICKNESS)


def peck(part, mills, r, x, y):
    d = round(r.uniform(4, 11), 2)
    part.drill(d)
    part.circle(f"DRILL_D9_{r.choice(['PECK', 'CHIP'])}{r.choice([2, 3])}", x, y, d / 2)
    drilled(part, "peck", x, y, d / 2, -9, -9)


def tap(part, mills, r, x, y):
    size, d, pitch = r.choice([(5, 4.2, 0.8), (6, 5, 1), (8, 6.8, 1.25), (10, 8.5, 1.5)])
    through = r.random() < 0.5
    part.drill(d)
    part.cutter(f"tap:M{size}", "tap", "flat", size, pitch=pitch)
    part.circle(f"TAP_M{size}_" + ("THRU" if through else "D5"), x, y, d / 2)
    deep = THICKNESS if through else 5
    drilled(part, "tap", x, y, d / 2, DEEP if through else hole_bottom(deep + 3 * pitch, d / 2), -deep)
    part.lines.append(f"visit tap {numbers(x, y, -deep)}")


def ream(part, mills, r, x, y):
    d, through = r.choice([6, 8, 10]), r.random() < 0.5
    part.drill(d - 0.2)
    part.cutter(f"reamer:{d}", "reamer", "flat", d)
    part.circle("REAM_THRU" if through else "REAM_D6", x, y, d / 2)
    deep = THICKNESS if through else 6
    drilled(part, "ream", x, y, d / 2, DEEP if through else hole_bottom(deep, d / 2), -deep)
    part.lines.append(f"visit reamer {numbers(x, y, -deep)}")


def bore(part, mills, r, x, y):
    d, depth = r.choice([10, 12, 16]), r.choice([1.5, 2.5, 4, 6, 8])
    part.cutter(f"boringbar:{d}", "boringbar", "flat", d)
    part.circle(f"BORE_D{depth}", x, y, d / 2)
    drilled(part, "bore", x, y, d / 2, hole_bottom(depth, d / 2), -depth)


def counterbore(part, mills, r, x, y):
    part.drill(5.5)
    part.circle("DRILL_THRU", x, y, 2.75)
    part.circle("CBORE_D4", x, y, 5)
    if r.random() < 0.6:
        part.cutter("counterbore:10", "counterbore", "flat", 10)
    drilled(part, "hole", x, y, 2.75, DEEP, -THICKNESS)
    part.element("seat", disc(x, y, 5), [(0, -4)], [(0, min(0, mills.round - 4)), (max(0.001, mills.round), -4)],
                 reach=(mills.widest / 2, max(0, mills.widest / 2 - mills.round - 0.03), 0))


def countersink(part, mills, r, x, y):
    angle, tip = r.choice([90, 60, 82]), r.choice([0, 0.4])
    steep = math.tan(math.radians(angle / 2))
    part.drill(5.5)
    part.cone(f"chamfer:{angle}deg:12:tip={tip}" if tip else f"vbit:{angle}deg:12", "chamfer" if tip else "vbit", 12, angle, tip)
    part.circle("DRILL_THRU", x, y, 2.75)
    part.circle("CSK", x, y, 5)
    drilled(part, "hole", x, y, 2.75, DEEP, -THICKNESS)
    cone = [(0, 0), (2.25, -2.25 / steep)]
    part.element("cone", disc(x, y, 5), cone, cone)


def thread(part, mills, r, x, y):
    size, pitch = r.choice([(16, 2), (20, 2.5), (12, 1.75)])
    through, mill = r.random() < 0.5, 8 if size == 12 else 10
    part.circle(f"THREAD_M{size}_" + ("THRU" if through else "D6"), x, y, size / 2)
    if r.random() < 0.5:
        part.cutter(f"threadmill:{mill}", "threadmill", "flat", mill, pitch=pitch)
    else:
        rows = 3 * pitch
        part.cutter(f"threadmill:{mill}:pitch={pitch}:length={number(rows)}", "threadmill", "flat", mill, pitch=pitch, length=rows)
    deep, crest = THICKNESS if through else 6, size / 2 - 0.54125 * pitch
    part.element("thread", disc(x, y, crest), [(-0.35, DEEP if through else hole_bottom(deep + 1.25 * pitch, crest))],
                 [(0, -deep)], reach=mills.reach())
    part.lines.append(f"thread {numbers(x, y, crest + 0.35, size / 2, pitch, 0, -deep, 1)}")


def outer_thread(part, mills, r, x, y):
    part.box("POCKET_D8", x, y, 31, 31)
    part.circle("THREAD_M12_EXTERNAL_D4", x, y, 6)
    part.circle("ISLAND", x, y, 6)
    part.cutter("threadmill:6", "threadmill", "flat", 6, pitch=1.75)
    flat_pocket(part, mills, "around", box(x, y, 31, 31), 8, [disc(x, y, 6)])
    part.lines.append(f"thread {numbers(x, y, 5.95, 6 - 0.61345 * 1.75, 1.75, 0, -4, 1)}")


def engraving(part, mills, r, x, y):
    corners, closed = [(x - 10, y - 5), (x + 8, y - 8), (x + 10, y + 7)], r.random() < 0.5
    part.polyline("ENGRAVE_D0.6", corners, closed)
    if r.random() < 0.7:
        part.cone("vbit:60deg:6", "vbit", 6, 60)
    line = corners + corners[:1] if closed else corners
    part.element("engraving", path(mills.widest / 2, *line), [(0, -0.6)])
    half = 0.6 * math.tan(math.radians(30))
    part.element("engraved", path(half, *line), None, [(0, 0), (half, -0.6)])


def chamfer(part, mills, r, x, y):
    depth, w, h = r.choice([1.5, 2.5, 4, 6]), r.uniform(14, 24), r.uniform(14, 24)
    part.box(f"POCKET_D{depth}", x, y, w, h, 5)
    part.box("CHAMFER_D0.6", x, y, w, h, 5)
    part.cone("chamfer:90deg:8:tip=0.4", "chamfer", 8, 90, 0.4)
    flat_pocket(part, mills, "chamfered", box(x, y, w, h, 5), depth)
    edge = [(-0.6, 0), (0, -0.6)]
    part.element("chamfer", box(x, y, w, h, 5), edge, edge)


def carving(part, mills, r, x, y):
    w, h, limit = r.uniform(3, 7), r.uniform(12, 26), r.choice([None, 1.5])
    part.box(f"VCARVE_D{limit}" if limit else "VCARVE", x, y, w, h)
    part.cone("vbit:90deg:10", "vbit", 10, 90)
    deep = limit or 5
    part.element("carving", box(x, y, w, h), [(0, 0), (deep, -deep)], [(0, 0), (deep, RIDGE - deep)])


def t_slot(part, mills, r, x, y):
    part.cutter("tslot:14:length=4:shank=6", "tslot", "disc", 14, height=4, neck=6)
    part.endmill(8, length=20)
    at_side = y < CELL
    first = (x, -0.01 if at_side else y - 12)
    part.polyline("TSLOT_D9", [first, (x, y + 4)], closed=False)
    begin = (x, -20) if at_side else first
    part.element("neck", path(4, begin, (x, y + 4)), [(0, -9)], [(0, -9)])
    part.element("undercut", path(7, begin, (x, y + 4)), [(0, -9)], [(0, -9)], roof=(-5,))
    if not at_side:
        part.circle("POCKET_D9", x, y - 12, 7.5)
        flat_pocket(part, mills, "way_in", disc(x, y - 12, 7.5), 9)


def cut_out(part, mills, r, x, y):
    w, h = r.uniform(14, 24), r.uniform(14, 24)
    part.box(f"INSIDE_D{THICKNESS}", x, y, w, h, 5)
    part.element("waste", box(x, y, w, h, 5), [(0, DEEP)])
    part.element("kerf", box(x, y, w, h, 5), None, [(0, 2.2 - THICKNESS)], band=(min(mills.diameters) - 0.05,))
    hold(part)


THINGS = [pocket, round_pocket, disc_pocket, island, nested, slot, drill, spotted, peck, tap, ream, bore, counterbore, countersink, thread,
          outer_thread, engraving, chamfer, carving, t_slot, cut_out]


def hold(part):
    if "--tabs" not in part.options:
        part.options += ["--tabs", "2"]


def with_top(line, top):
    """The line of the description of a thread, which begins at the faced top."""
    words = line.split()
    return " ".join(words[:6] + [number(top)] + words[7:]) if words[0] == "thread" else line


def around(part, mills, r):
    """Now and then the whole is faced, or cut out of a wider block. Widths that are stated at the top would be those of the faced top."""
    w, h = part.width, part.height
    if r.random() < 0.12 and not {"carving", "chamfer", "countersink"} & set(part.kinds):
        part.kinds.append("face")
        part.lines = [with_top(line, -0.7) for line in part.lines]
        part.box("FACE_D0.7", w / 2, h / 2, w, h)
        part.element("face", "all", [(0, -0.7)], [(0, -0.7)])
    elif "t_slot" not in part.kinds and r.random() < 0.2:
        part.kinds.append("profile")
        part.box(f"PROFILE_D{THICKNESS}", w / 2, h / 2, w - 1, h - 1, 4.5)
        part.stock = (-9, -9, w + 9, h + 9)
        whole = box(w / 2, h / 2, w - 1, h - 1, 4.5)
        part.element("beside", "all", [(0, DEEP)], None, [whole])
        kerf = min(mills.diameters) - 0.05
        part.element("kerf", box(w / 2, h / 2, w - 1 + 2 * kerf, h - 1 + 2 * kerf, 4.5 + kerf), None, [(0, 2.2 - THICKNESS)],
                     [whole])
        hold(part)


def drawn_part(r):
    across, up = r.choice([(1, 1), (1, 1), (2, 1)])
    part = Part(across * CELL + 4, up * CELL + 4)
    mills = Mills(part, r, r.choice(["flat", "flat", "bullnose", "ball", "noplunge", "two"]))
    for i in range(across):
        for j in range(up):
            thing = r.choice(THINGS)
            part.kinds.append(thing.__name__)
            thing(part, mills, r, 2 + CELL * i + CELL / 2, 2 + CELL * j + CELL / 2)
    around(part, mills, r)
    return part


def wall(depth, lean, fillet, more=0):
    """Heights from the edge to the floor: a leaning wall, a fillet at its foot, and the floor."""
    foot, sine = depth * math.tan(lean), math.sin(lean)
    begin = fillet * (1 - sine) if fillet else 0    # over the floor
    points = [(0, 0 if lean else begin - depth)]
    if lean and fillet:
        points.append((max(0, (depth - begin) * math.tan(lean)), begin - depth))
    if fillet:
        centre = foot + fillet * math.tan(math.pi / 4 - lean / 2)
        for i in range(13):
            angle = (math.pi / 2 - lean) * (1 - i / 12)
            points.append((centre - fillet * math.sin(angle), fillet * (1 - math.cos(angle)) - depth))
    else:
        points.append((foot, -depth))
    raised = [(a, min(0, z + more)) for a, z in points]
    if more > 0 and lean and more < depth:
        raised.insert(1, (more * math.tan(lean), 0))    # below the edge the wall stands as high as its edge
    return raised


def leaning_part(r):
    """Pockets with leaning walls and fillets at their feet, one or two."""
    count = r.choice([1, 1, 2])
    part = Part(44 + 42 * (count - 1), 44)
    kind, d = r.choice(["flat", "flat+ball", "flat+bull", "ball", "bull", "two", "tapered"]), r.choice([4, 5, 6])
    widest, rounding, taper = d, 0, None
    corner = r.choice([0.5, 1, 2])
    if kind in ("flat", "flat+ball", "flat+bull", "two"):
        part.endmill(d)
    if "ball" in kind:
        corner = rounding = d / 2
        part.ball(d)
    if "bull" in kind:
        widest, rounding = d + 2, corner
        part.bullnose(d + 2, corner)
    if kind == "two":
        part.endmill(3)
        part.options += ["--rest"] if r.random() < 0.6 else []
    if kind == "tapered":
        taper, flutes = r.choice([3, 5, 10]), 12
        widest = 3 + 2 * flutes * math.tan(math.radians(taper))
        part.cutter(f"tapered:3:taper={taper}deg:length={flutes}", "tapered", "cone", widest, angle=2 * taper, tip=3)
    for i in range(count):
        x, y = 22 + 42 * i, 22
        lean = r.choice([0, 0, 0.05, 0.0873, 0.35, 0.6]) if taper is None else r.choice([math.radians(taper), 0.35])
        depth = r.choice([1, 2, 3, 5, 7])
        least = max(14, widest + 2 * depth * math.tan(lean) + 1)    # the mills fit the floor
        w, h = round(r.uniform(least, least + 10), 2), round(r.uniform(least, least + 10), 2)
        radius = r.choice([4.2, 5, 6])
        shape, islands = box(x, y, w, h, radius), []
        outline = {"name": f"P{i}", "top": 0, "depth": depth, "slope_rad": lean,
                   "outer": [[x + u, y + v, *(bulge or [0])] for u, v, *bulge in box_corners(w, h, radius)]}
        fillet = 0
        # Walls that lean far would meet before the floor.
        is_wide = min(w, h) / 2 - 3 - 2 * depth * math.tan(lean) > widest    # between an island and the walls
        if depth * math.tan(lean) < 2 and r.random() < 0.3 and is_wide:
            outline["islands"] = [[[x + 3, y, 1], [x - 3, y, 1]]]
            islands = [disc(x, y, 3)]
        if rounding and rounding < depth and r.random() < 0.5:
            fillet = outline["floor_fillet"] = rounding
        part.pockets.append(outline)
        part.kinds.append("leaning" if lean else "upright")
        foot, left = depth * math.tan(lean), SCALLOP / math.sin(lean) if lean else 0
        low, high = wall(depth, lean, fillet), wall(depth, lean, 0, left) + [(depth * math.tan(lean) + 0.001, -depth)]
        # A ball alone leaves cusps.
        cusps = rounding if kind == "ball" or (kind == "flat+ball" and fillet) else 0
        over = [(a, max(z, min(0, rounding - depth))) for a, z in high if a <= foot] + \
               [(foot + 2 * rounding + 0.01, min(0, max(rounding, cusps) - depth)), (foot + 2 * rounding + 0.02, cusps - depth)]
        part.element(f"P{i}", shape, low, over if rounding else high, islands,
                     reach=(widest / 2 + 0.03, max(0, widest / 2 - rounding - 0.03), foot))
        if not islands and r.random() < 0.15:
            deeper = min(depth + 2, THICKNESS - 1)
            part.pockets.append({"name": f"N{i}", "top": 0, "depth": deeper, "slope_rad": 0,
                                 "outer": [[x + u, y + v, *(bulge or [0])] for u, v, *bulge in box_corners(12, 11, 3.2)]})
            part.kinds.append("nested")
            part.element(f"N{i}", box(x, y, 12, 11, 3.2), [(0, -deeper)], None)
    return part


def asked_besides(part, r):
    if r.random() < 0.3:
        part.options += ["--stepdown", r.choice(["1", "1.7"])]
    if r.random() < 0.25:
        part.options += ["--entry", r.choice(["helix", "ramp", "zigzag"])]
    if r.random() < 0.15:
        part.options += ["--lead", "1"]
    if r.random() < 0.6:
        part.options += ["--strategy", r.choice(["contour", "zigzag", "spiral", "adaptive"])]
    if r.random() < 0.1:
        part.options += ["--finish", r.choice(["walls", "floor", "all"])]


def make(seed):
    r = random.Random(seed)
    part = leaning_part(r) if r.random() < 0.3 else drawn_part(r)
    asked_besides(part, r)
    return part
