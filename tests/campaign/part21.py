"""Random STEP-NC programs (ISO 14649 in Part 21 files) with what they mean: how deep each place of each set-up is to be cut.

The description of a set-up is that of tests/support/independent/made_part.h. It is made beside the entities, from the numbers that were
drawn, and shares nothing with a reader of STEP-NC.
"""
import math
import random

from parts import CELL, DEEP, POINT, box, disc, flat_pocket, number, numbers, path

EDGE = 2             # mm of the block beside the cells
DRILL_ANGLE = math.radians(118)


def chance(r, share):
    return r.random() < share


class Unit:
    """What lengths and angles of the file are multiplied by, and the entities that say so."""

    def __init__(self, r):
        self.name = r.choice(["none", "none", "milli", "inch", "centi", "metre", "micro"])
        self.length = {"none": 1, "milli": 1, "inch": 1 / 25.4, "centi": 0.1, "metre": 0.001, "micro": 1000}[self.name]
        self.degrees = self.name != "none" and chance(r, 0.4)
        self.angle = 180 / math.pi if self.degrees else 1


class File:
    """Entities of a Part 21 file."""

    def __init__(self, r):
        self.r, self.unit, self.lines, self.tools, self.last = r, Unit(r), [], {}, 0

    def add(self, entity):
        self.last += 1
        self.lines.append(f"#{self.last}={entity};")
        return f"#{self.last}"

    @staticmethod
    def real(value):
        text = f"{value:.12f}".rstrip("0")
        return "0." if text in ("-0.", "0.") else text

    def length(self, mm):
        return self.real(mm * self.unit.length)

    def angle(self, radians):
        return self.real(radians * self.unit.angle)

    def measure(self, mm):
        """Now and then with a field about it, in whose middle it lies."""
        if chance(self.r, 0.85):
            return self.add(f"TOLERANCED_LENGTH_MEASURE({self.length(mm)},$)")
        off, width = self.r.choice([0, 0.02, -0.03]), 0.05
        field = self.add(f"PLUS_MINUS_VALUE({self.length(width + off)},{self.length(width - off)},3)")
        return self.add(f"TOLERANCED_LENGTH_MEASURE({self.length(mm - off)},{field})")

    def point(self, *place):
        return self.add("CARTESIAN_POINT(''," + "(" + ",".join(self.length(v) for v in place) + "))")

    def direction(self, *ratios):
        return self.add("DIRECTION('',(" + ",".join(self.real(v) for v in ratios) + "))")

    def placement(self, place=(0, 0, 0), axis=None, ref=None):
        location = self.point(*place)
        axis = self.direction(*axis) if axis else "$"
        ref = self.direction(*ref) if ref else "$"
        return self.add(f"AXIS2_PLACEMENT_3D('',{location},{axis},{ref})")

    def plane(self, z):
        return self.add(f"PLANE('',{self.placement((0, 0, z))})")

    def polyline(self, points, z=0):
        return self.add("POLYLINE('',(" + ",".join(self.point(x, y, z) for x, y in points) + "))")

    def arc(self, centre, radius, begin, end, z=0):
        """Counter-clockwise; angles in radians."""
        circle = self.add(f"CIRCLE('',{self.placement((*centre, z))},{self.length(radius)})")
        ends = [self.point(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a), z) for a in (begin, end)]
        return self.add(f"TRIMMED_CURVE('',{circle},({ends[0]}),({ends[1]}),.T.,.CARTESIAN.)")

    def composite(self, curves):
        parts = ",".join(self.add(f"COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{c})") for c in curves)
        return self.add(f"COMPOSITE_CURVE('',({parts}),.F.)")

    # Cutters: entities by the words of the description.
    def tool(self, words, body, diameter, top_angle=None, edge=None, more=""):
        if words not in self.tools:
            angle, corner = self.angle(top_angle) if top_angle else "$", "$" if edge is None else self.length(edge)
            size = self.add(f"MILLING_TOOL_DIMENSION({self.length(diameter)},{angle},$,{self.length(40)},{corner},$,$)")
            cutter = self.add(f"{body}({size},{self.r.choice([2, 3, 4])},.RIGHT.,$,${more})")
            self.tools[words] = self.add(f"MILLING_CUTTING_TOOL('T{len(self.tools) + 1}',{cutter},(),$,$,$)")
        return self.tools[words]

    def endmill(self, d):
        return self.tool("endmill flat " + numbers(d, 0, 0, 0, 0, 0, 0, 0, 1), "ENDMILL", d, edge=0)

    def bullnose(self, d, corner):
        return self.tool("bullnose round " + numbers(d, corner, 0, 0, 0, 0, 0, 0, 1), "BULLNOSE_ENDMILL", d, edge=corner)

    def ball(self, d):
        return self.tool("ball round " + numbers(d, d / 2, 0, 0, 0, 0, 0, 0, 1), "BALL_ENDMILL", d, edge=d / 2)

    def drill(self, d):
        return self.tool("drill cone " + numbers(d, 0, 118, 0, 0, 0, 0, 0, 1), "TWIST_DRILL", d, top_angle=DRILL_ANGLE)

    def cone(self, d, degrees):
        return self.tool("vbit cone " + numbers(d, 0, degrees, 0, 0, 0, 0, 0, 1), "COUNTERSINK", d, top_angle=math.radians(degrees), more=",$")

    def of_hole(self, kind, body, d, pitch=0):
        return self.tool(f"{kind} flat " + numbers(d, 0, 0, 0, 0, 0, pitch, 0, 1), body, d)

    def disc(self, d, height):
        return self.tool("tslot disc " + numbers(d, 0, 0, 0, height, d / 2, 0, 0, 1), "T_SLOT_MILL", d, more="," + self.length(height))

    # Operations.
    def conditions(self, feed, turns):
        technology = self.add(f"MILLING_TECHNOLOGY({self.real(feed)},.TCP.,$,{self.real(-turns)},$,$,$,$,$)")
        functions = self.add(f"MILLING_MACHINE_FUNCTIONS({self.r.choice(['.T.', '.F.'])},$,$,.F.,$,(),.F.,$,$,())")
        return f"{technology},{functions}"

    def strategy(self):
        r, along = self.r, "$"
        if chance(r, 0.5):
            return "$"
        if chance(r, 0.4):
            a = r.uniform(0, 3)
            along = self.direction(math.cos(a), math.sin(a), 0)
        over = r.choice(["$", "0.3", "0.5", "0.65"])
        return self.add(r.choice([f"CONTOUR_PARALLEL({over},.T.,.CCW.,.CLIMB.)", f"CONTOUR_PARALLEL({over},.T.,.CW.,.CONVENTIONAL.)",
                                  f"BIDIRECTIONAL_MILLING({over},.T.,{along},$,$)", f"CONTOUR_SPIRAL({over},.T.,.CCW.,$)",
                                  f"BIDIRECTIONAL_CONTOUR({over},.T.,{along},$,$,$)"]))

    def approach(self):
        r = self.r
        return r.choice(["$", "$", lambda: self.add(f"PLUNGE_RAMP($,{self.angle(r.uniform(0.05, 0.2))})"),
                         lambda: self.add(f"PLUNGE_HELIX($,{self.length(r.uniform(0.5, 1.5))},{self.angle(r.uniform(0.03, 0.15))})"),
                         lambda: self.add(f"PLUNGE_ZIGZAG($,{self.angle(r.uniform(0.05, 0.2))},{self.length(r.uniform(1, 3))})"),
                         lambda: self.add("PLUNGE_TOOLAXIS($)")])

    def milling(self, tool, depth, kind="BOTTOM_AND_SIDE_ROUGH_MILLING", allowances=(0, 0), strategy=True, toolpath="$", layers=None):
        """`strategy`: an entity, any (True) or none. `layers`: of a toolpath."""
        r = self.r
        approach, plan = self.approach() if strategy else "$", self.strategy() if strategy is True else strategy or "$"
        approach = approach() if callable(approach) else approach
        down = self.length(depth / (layers or r.choice([1, 2, 3]))) if chance(r, 0.5) else "$"
        over = self.length(r.uniform(1, 2.4)) if strategy is True and chance(r, 0.2) else "$"
        side, floor = (self.length(a) if a else "$" for a in allowances)
        last = {"P": f"{down},{floor}", "S": f"{down},{over},{side}", "B": f"{down},{over},{side},{floor}"}[kind[0]]
        retract = self.length(r.uniform(2, 8)) if chance(r, 0.3) else "$"
        return self.add(f"{kind}({toolpath},$,'OP',{retract},$,{tool},{self.conditions(r.uniform(0.005, 0.02), r.uniform(50, 200))},$,"
                        f"{approach},$,{plan},{last})")

    def drilling(self, tool, kind="DRILLING", depth="$", more="", turns=20, feed=0.003):
        r = self.r
        dwell, slower = "$", "$"
        if kind == "DRILLING" and chance(r, 0.3):
            dwell = self.real(r.choice([0.5, 1]))
        if kind == "DRILLING" and chance(r, 0.3):
            slower = self.add(f"DRILLING_TYPE_STRATEGY($,0.5,{self.length(1)},$,0.6,{self.length(1.5)})")
        return self.add(f"{kind}($,$,'OP',$,$,{tool},{self.conditions(feed, turns)},$,{depth},$,{dwell},$,{slower}{more})")


class Mill:
    """What is certain of all cutters of a feature, as flat_pocket() asks it."""

    def __init__(self, d, corner=0):
        self.d, self.round = d, corner

    def reach(self):
        return (self.d / 2 + 0.03, max(0, self.d / 2 - self.round - 0.03), 0)


class Setup:
    """One side of the block: its features in a frame with the corner of the block at x 0, y 0 and its top at z 0."""

    def __init__(self, file, number_of, rotation, block):
        """`rotation`: rows are the axes of the set-up in those of the workpiece. `block`: its least and greatest corners there."""
        self.file, self.number, self.rotation = file, number_of, rotation
        corners = [self.turned(p) for p in block]
        low, high = ([f(a, b) for a, b in zip(*corners)] for f in (min, max))
        self.zero = (low[0], low[1], high[2])
        self.width, self.height, self.thickness = (b - a for a, b in zip(low, high))
        self.base, self.lines, self.kinds, self.steps = 0, [], [], []

    def turned(self, p):
        return [sum(row[i] * p[i] for i in range(3)) for row in self.rotation]

    def back(self, p):
        return [sum(self.rotation[i][j] * p[i] for i in range(3)) for j in range(3)]

    def upright(self):
        return self.rotation == ((1, 0, 0), (0, 1, 0), (0, 0, 1))

    def placement(self, x, y, turn=0, z=0):
        place = self.back([a + b for a, b in zip((x, y, self.base + z), self.zero)])
        if self.upright() and turn == 0:
            return self.file.placement(place)
        return self.file.placement(place, self.back((0, 0, 1)), self.back((math.cos(turn), math.sin(turn), 0)))

    def element(self, name, shape, low=None, high=None, islands=(), **more):
        self.lines += [f"element {name}", "shape " + shape] + ["island " + i for i in islands]
        for word, points in (("low", low), ("high", high)):
            if points is not None:
                self.lines.append(word + " " + " ".join(numbers(a, z + self.base) for a, z in points))
        if "roof" in more:
            more["roof"] = (more["roof"][0] + self.base,)
        self.lines += [f"{word} {numbers(*value)}" for word, value in more.items()]

    def description(self):
        cutters = [f"cutter {i + 1} {words}" for i, words in enumerate(self.file.tools)]
        head = [f"block {numbers(0, 0, self.width, self.height, -self.thickness)}", f"zero {numbers(*self.zero)}"]
        return "\n".join(head + cutters + self.lines) + "\n"

    def work(self, feature, *operations):
        for operation in operations:
            self.steps.append(self.file.add(f"MACHINING_WORKINGSTEP('WS{len(self.steps) + 1}',#SECURITY{self.number},{feature},{operation},$)"))

    def head(self, operations):
        return "'FEATURE',#WORKPIECE,(" + ",".join(operations) + ")"


# Profiles: the entity, the shape of the description in the set-up's frame, and the radius of corners within.
def rectangle(s, x, y, w, h, corner, turn):
    f, r = s.file, s.file.r
    shape = box(x, y, w, h, corner, turn)
    form = r.choice(["rectangle", "polyline"]) if corner == 0 else r.choice(["rectangle", "composite"])
    if form == "rectangle":
        return f.add(f"RECTANGULAR_CLOSED_PROFILE($,{f.measure(h)},{f.measure(w)})"), shape, corner
    a, b = w / 2, h / 2
    if form == "polyline":
        points = [(-a, -b), (a, -b), (a, b), (-a, b), (-a, -b)]
        curve = f.polyline(points[::-1] if chance(r, 0.3) else points)
    else:
        c, quarter = corner, math.pi / 2
        curve = f.composite([f.polyline([(c - a, -b), (a - c, -b)]), f.arc((a - c, c - b), c, -quarter, 0),
                             f.polyline([(a, c - b), (a, b - c)]), f.arc((a - c, b - c), c, 0, quarter),
                             f.polyline([(a - c, b), (c - a, b)]), f.arc((c - a, b - c), c, quarter, 2 * quarter),
                             f.polyline([(-a, b - c), (-a, c - b)]), f.arc((c - a, c - b), c, 2 * quarter, 3 * quarter)])
    return f.add(f"GENERAL_CLOSED_PROFILE($,{curve})"), shape, 0


def polygon(*corners):
    return "polygon " + numbers(*(v for corner in corners for v in corner))


def ngon(s, x, y, radius, turn):
    """By the circle through its corners or the one that its sides touch; a side lies parallel to X at negative Y."""
    f, r = s.file, s.file.r
    # No mill fits a small triangle.
    n, flats = r.choice([3 if radius > 8 else 5, 5, 6, 8]), chance(r, 0.5)
    outer = radius / math.cos(math.pi / n) if flats else radius
    corners = [(x + outer * math.cos(a), y + outer * math.sin(a))
               for a in (turn - math.pi / 2 + (2 * i + 1) * math.pi / n for i in range(n))]
    flag = ".T." if flats else ".F."
    return f.add(f"NGON_PROFILE($,{f.measure(2 * radius)},{n},{flag})"), polygon(*corners), 0


def outline(s, x, y, turn, mill, least=12, most=25):
    f, r = s.file, s.file.r
    kind = r.choice(["circle", "rectangle", "rounded", "ngon"])
    if kind == "circle":
        radius = r.uniform(least / 2, most / 2)
        return f.add(f"CIRCULAR_CLOSED_PROFILE($,{f.measure(2 * radius)})"), disc(x, y, radius), 0
    if kind == "ngon":
        return ngon(s, x, y, r.uniform(0.8 * least, most) / 2, turn)
    corner = 0 if kind == "rectangle" else mill / 2 + r.uniform(0.2, 1.5)
    return rectangle(s, x, y, r.uniform(least, most), r.uniform(least, most), corner, turn)


def turn_of(r):
    return r.choice([0, 0, 0.3, 1.1, -0.7])


def depth_of(s, most=6):
    return round(s.file.r.uniform(1, most), 3)


# Features: each draws one thing around a place of the set-up and describes it.
def closed_pocket(s, x, y, chamfered=False):
    f, r = s.file, s.file.r
    turn, depth, d = turn_of(r), depth_of(s), r.choice([4, 5, 6])
    mill = f.endmill(d)
    profile, shape, corner = outline(s, x, y, turn, d, most=22 if turn else 25)
    bosses, islands, low_boss = [], [], None
    if not chamfered and chance(r, 0.35):
        radius, down = r.uniform(1, 2.2), r.choice([0, 0, r.uniform(0.3, 0.8) * depth])
        bosses.append(f.add(f"BOSS('BOSS',#WORKPIECE,(),{f.placement((0, 0, -down))},{f.plane(down - depth)},"
                            f"{f.add(f'CIRCULAR_CLOSED_PROFILE($,{f.measure(2 * radius)})')},$)"))
        if down:
            low_boss = (radius, down)
        islands = [disc(x, y, radius)]
    operations = []
    if chance(r, 0.3):
        side, floor = r.choice([(0.3, 0.2), (0.4, 0), (0, 0.3)])
        operations.append(f.milling(mill, depth, allowances=(side, floor)))
        operations.append(f.milling(mill, depth, "BOTTOM_AND_SIDE_FINISH_MILLING"))
    else:
        operations.append(f.milling(mill, depth))
    bottom = f.add("PLANAR_POCKET_BOTTOM_CONDITION()")
    pocket = f.add(f"CLOSED_POCKET({s.head(operations)},{s.placement(x, y, turn)},{f.plane(-depth)},({','.join(bosses)}),"
                   f"{r.choice(['$', '0.'])},{bottom},$,{f.measure(corner) if corner else '$'},{profile})")
    s.work(pocket, *operations)
    flat_pocket(s, Mill(d), "pocket", shape, depth, islands)
    if low_boss:
        s.element("low_boss", disc(x, y, low_boss[0]), [(0, -low_boss[1])], [(0, -low_boss[1])])
    return pocket, shape, depth


def chamfer(s, x, y):
    """The edge of a pocket in the face of the block, which is there before."""
    f, r = s.file, s.file.r
    pocket, shape, depth = closed_pocket(s, x, y, chamfered=True)
    wide = round(r.uniform(0.3, 0.9), 2)
    cone = f.cone(8, 90)
    # Above the tip, the cone must not reach down to the floor.
    if wide > depth - 0.1:
        return
    face = f.add(f"PLANAR_FACE('FACE',#WORKPIECE,(),{s.placement(0, 0, 0, 2)},{f.plane(-2)},$,$,$,())")
    operation = f.milling(cone, depth, "BOTTOM_AND_SIDE_FINISH_MILLING", strategy=None)
    both = r.choice([f"{face},{pocket}", f"{pocket},{face}"])
    s.work(f.add(f"CHAMFER({s.head([operation])},{both},{f.angle(math.pi / 4)},{f.measure(wide)})"), operation)
    edge = [(-wide, 0), (0, -wide)]
    s.element("chamfer", shape, edge, edge if shape.startswith("disc") else None)


def leaning_pocket(s, x, y):
    f, r = s.file, s.file.r
    depth, d, lean = depth_of(s), r.choice([4, 5]), r.uniform(0.03, 0.35)
    mill = f.endmill(d)
    radius, w, h = r.uniform(8, 12.5), r.uniform(16, 25), r.uniform(16, 25)
    corner = d / 2 + 3
    if chance(r, 0.5):
        profile, shape = f.add(f"CIRCULAR_CLOSED_PROFILE($,{f.measure(2 * radius)})"), disc(x, y, radius)
    else:
        profile, shape, _ = rectangle(s, x, y, w, h, corner, 0)
    operation = f.milling(mill, depth)
    bottom = f.add("PLANAR_POCKET_BOTTOM_CONDITION()")
    radii = f.measure(corner) if profile and shape.startswith("box") else "$"
    s.work(f.add(f"CLOSED_POCKET({s.head([operation])},{s.placement(x, y)},{f.plane(-depth)},(),{f.angle(lean)},{bottom},$,{radii},{profile})"),
           operation)
    foot = depth * math.tan(lean)
    s.element("leaning", shape, [(0, 0), (foot, -depth)], [(0, 0), (foot + 0.01, 0), (foot + 0.02, -depth)], reach=(d / 2 + 0.03, d / 2 - 0.03, foot))


def filleted_pocket(s, x, y):
    f, r = s.file, s.file.r
    d, corner = r.choice([(6, 1.5), (6, 1), (5, 0.8)])
    mill, depth = f.bullnose(d, corner), round(corner + r.uniform(0.5, 4), 3)
    radius = r.uniform(7, 13)
    profile = f.add(f"CIRCULAR_CLOSED_PROFILE($,{f.measure(2 * radius)})")
    operation = f.milling(mill, depth)
    bottom = f.add("PLANAR_POCKET_BOTTOM_CONDITION()")
    s.work(f.add(f"CLOSED_POCKET({s.head([operation])},{s.placement(x, y)},{f.plane(-depth)},(),$,{bottom},{f.measure(corner)},$,{profile})"),
           operation)
    arc = [(corner * (1 - math.cos(a)), -depth + corner * (1 - math.sin(a))) for a in (math.pi / 2 * i / 12 for i in range(13))]
    s.element("filleted", disc(x, y, radius), arc, arc)


def slot_along(s, corners, path_entity, placement, shape, width, d, depth, ends, name="slot"):
    f = s.file
    operation = f.milling(f.endmill(d), depth)
    section = f.add(f"SQUARE_U_PROFILE($,{f.measure(width)},$,$,$,$)")
    s.work(f.add(f"SLOT({s.head([operation])},{placement},{f.plane(-depth)},{path_entity},{section},({','.join(ends)}))"), operation)
    flat_pocket(s, Mill(d), name, shape, depth)


def linear_path(f, distance, turned=None):
    along = f.direction(*(turned or (1, 0, 0)))
    return f.add(f"LINEAR_PATH($,{f.measure(distance)},{along})")


def slot(s, x, y):
    f, r = s.file, s.file.r
    d, depth, turn = r.choice([4, 5, 6]), depth_of(s), turn_of(r)
    width, half = d + r.choice([0, 0.6, 2]), r.uniform(3, 8)
    c, sn = math.cos(turn), math.sin(turn)
    ends = [(x - half * c, y - half * sn), (x + half * c, y + half * sn)]
    if chance(r, 0.3):
        end = f.add(f"FLAT_SLOT_END_TYPE({f.measure(0) if chance(r, 0.5) else '$'},$)")
        shape = box(x, y, 2 * half, width, 0, turn)
    else:
        end = f.add("RADIUSED_SLOT_END_TYPE()")
        shape = path(width / 2, *ends)
    if width == d and shape.startswith("box"):
        width += 0.6
        shape = box(x, y, 2 * half, width, 0, turn)
    slot_along(s, ends, linear_path(f, 2 * half), s.placement(*ends[0], turn), shape, width, d, depth, (end, end))


def bent_slot(s, x, y):
    f, r = s.file, s.file.r
    d, depth = r.choice([4, 5]), depth_of(s)
    width = d + r.choice([0.4, 1.5])
    end = f.add("RADIUSED_SLOT_END_TYPE()")
    kind = r.choice(["polyline", "arc", "circle"])
    if kind == "polyline":
        corners = [(-9, r.uniform(-8, 0)), (r.uniform(-2, 3), r.uniform(0, 7)), (9, r.uniform(-8, 0))]
        entity = f.add(f"GENERAL_PATH($,{f.polyline(corners)})")
    else:
        radius, sweep = r.uniform(7, 9.5), 2 * math.pi if kind == "circle" else r.uniform(1.2, 4)
        corners = [(radius * math.cos(a), radius * math.sin(a)) for a in (sweep * i / 90 for i in range(91))]
        if kind == "circle":
            entity, end = f.add(f"COMPLETE_CIRCULAR_PATH($,{f.measure(radius)})"), f.add("LOOP_SLOT_END_TYPE()")
        else:
            entity = f.add(f"PARTIAL_CIRCULAR_PATH($,{f.measure(radius)},{f.angle(sweep)})")
    turn = turn_of(r)
    c, sn = math.cos(turn), math.sin(turn)
    shape = path(width / 2, *((x + c * u - sn * v, y + sn * u + c * v) for u, v in corners))
    slot_along(s, corners, entity, s.placement(x, y, turn), shape, width, d, depth, (end,) if kind == "circle" else (end, end), "bent_slot")


def open_slot(s, x, y):
    """From the left edge of the block; elsewhere a slot."""
    f, r = s.file, s.file.r
    if x > CELL:
        return slot(s, x, y)
    d, depth = r.choice([4, 5, 6]), depth_of(s)
    width = d + r.choice([0, 0.6, 2])
    ends = [f.add("OPEN_SLOT_END_TYPE()"), f.add("RADIUSED_SLOT_END_TYPE()")]
    shape = path(width / 2, (-20, y), (x, y))
    if chance(r, 0.3):
        reversed_path = linear_path(f, x, (-1, 0, 0))
        return slot_along(s, None, reversed_path, s.placement(x, y), shape, width, d, depth, ends[::-1], "open_slot")
    return slot_along(s, None, linear_path(f, x), s.placement(0, y), shape, width, d, depth, ends, "open_slot")


def groove(s, x, y):
    """A vee, or a slot with a half round bottom by a ball of its width."""
    f, r = s.file, s.file.r
    half, turn = r.uniform(3, 9), turn_of(r)
    c, sn = math.cos(turn), math.sin(turn)
    ends = [(x - half * c, y - half * sn), (x + half * c, y + half * sn)]
    end = f.add("RADIUSED_SLOT_END_TYPE()")
    if chance(r, 0.5):
        depth, degrees = round(r.uniform(0.5, 3), 3), r.choice([90, 60])
        tool, wide = f.cone(8, degrees), depth * math.tan(math.radians(degrees / 2))
        section = f.add(f"VEE_PROFILE($,$,{f.angle(math.radians(degrees))},$)")
        curve, high = [(0, 0), (wide, -depth)], [(0, 0), (wide, -depth)]
    else:
        wide = r.choice([2, 2.5, 3])
        straight = r.choice([0, r.uniform(0.3, 3)])
        depth, tool = wide + straight, f.ball(2 * wide)
        section = f.add(f"ROUNDED_U_PROFILE($,{f.measure(2 * wide)})")
        curve = high = [(wide * (1 - math.cos(a)), -straight - wide * math.sin(a)) for a in (math.pi / 2 * i / 14 for i in range(15))]
    operation = f.milling(tool, depth, "BOTTOM_AND_SIDE_FINISH_MILLING", strategy=None)
    s.work(f.add(f"SLOT({s.head([operation])},{s.placement(*ends[0], turn)},{f.plane(-depth)},{linear_path(f, 2 * half)},{section},({end},{end}))"),
           operation)
    s.element("groove", path(wide, *ends), curve, high)


def t_slot(s, x, y):
    f, r = s.file, s.file.r
    if x > CELL:
        return groove(s, x, y)
    depth, width, bar = round(r.uniform(5, 7), 2), 7.5, (12, 2.5)
    section = f.add(f"TEE_PROFILE($,0.,0.,{f.measure(bar[0])},{f.measure(bar[1])},$,{f.measure(width)},$,$)")
    ends = f.add("OPEN_SLOT_END_TYPE()") + "," + f.add("RADIUSED_SLOT_END_TYPE()")
    neck = f.milling(f.endmill(6), depth)
    below = f.milling(f.disc(*bar), depth, "BOTTOM_AND_SIDE_FINISH_MILLING", strategy=None)
    slot_ = f.add(f"SLOT({s.head([neck, below])},{s.placement(0, y)},{f.plane(-depth)},{linear_path(f, x)},{section},({ends}))")
    s.work(slot_, neck, below)
    s.element("neck", path(width / 2, (-20, y), (x, y)), [(0, -depth)], [(0, -depth)], reach=(3.03, 2.97, 0))
    s.element("undercut", path(bar[0] / 2, (-20, y), (x, y)), [(0, -depth)], None, roof=(bar[1] - depth,))


def step(s, x, y):
    """Along the whole front; one a set-up."""
    f, r = s.file, s.file.r
    if "step" in s.kinds[:-1] or s.height < 30:
        return slot(s, x, y)
    wide, depth = 1.6, round(r.uniform(1, 3), 3)
    lean = r.choice([0, r.uniform(0.1, 0.35)])
    section = f.add(f"VEE_PROFILE($,$,{f.angle(math.pi / 2 + lean)},{f.angle(math.pi / 2 + lean)})") if lean or chance(r, 0.5) else "$"
    operation = f.milling(f.endmill(6), depth, strategy=None)
    s.work(f.add(f"STEP({s.head([operation])},{s.placement(0, wide)},{f.plane(-depth)},{linear_path(f, s.width)},{section},())"), operation)
    foot = depth * math.tan(lean)
    shape = box(s.width / 2, wide - 50, 400, 100)
    s.element("step", shape, [(0, 0 if lean else -depth), (foot, -depth)] if lean else [(0, -depth)], [(0, 0), (foot + 0.02, 0), (foot + 0.03, -depth)])


def open_pocket(s, x, y):
    """At the left edge of the block; elsewhere a pocket."""
    f, r = s.file, s.file.r
    if x > CELL:
        return closed_pocket(s, x, y)
    depth, d = depth_of(s), r.choice([4, 5, 6])
    far, half = r.uniform(10, x + 10), r.uniform(6, 12)
    corners = [(0, half), (far, half), (far, -half), (0, -half)]
    if chance(r, 0.4):
        corners.insert(2, (far + 3, 0))
    operation = f.milling(f.endmill(d), depth)
    bottom = f.add("PLANAR_POCKET_BOTTOM_CONDITION()")
    open_profile = f.add(f"GENERAL_PROFILE($,{f.polyline(corners)})")
    s.work(f.add(f"OPEN_POCKET({s.head([operation])},{s.placement(0, y)},{f.plane(-depth)},(),$,{bottom},$,$,{open_profile},$)"), operation)
    flat_pocket(s, Mill(d), "open_pocket", polygon((-30, y - half), (-30, y + half), *((u, y + v) for u, v in corners)), depth)


def explicit_slot(s, x, y):
    """A slot as wide as its mill, along a path that the file gives."""
    f, r = s.file, s.file.r
    d, depth, half, turn = r.choice([4, 5, 6]), depth_of(s, 4), r.uniform(3, 9), turn_of(r)
    levels = r.choice([1, 2])
    legs = []
    for i in range(levels):
        z = -depth * (i + 1) / levels
        ends = [(0, 0), (2 * half, 0)][::1 if i % 2 == 0 else -1]
        legs.append(f.add(f"CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,{f.polyline(ends, z)},$,$)"))
        if chance(r, 0.3):
            legs.append(f.add("FEEDSTOP(.T.,.CONTACT.,$,$,$,0.5)"))
    paths = f.add(f"TOOLPATH_LIST(({','.join(legs)}))")
    operation = f.milling(f.endmill(d), depth, strategy=f.add("EXPLICIT_STRATEGY($,$)"), toolpath=paths, layers=levels)
    section = f.add(f"SQUARE_U_PROFILE($,{f.measure(d)},$,$,$,$)")
    end = f.add("RADIUSED_SLOT_END_TYPE()")
    c, sn = math.cos(turn), math.sin(turn)
    ends = [(x - half * c, y - half * sn), (x + half * c, y + half * sn)]
    s.work(f.add(f"SLOT({s.head([operation])},{s.placement(*ends[0], turn)},{f.plane(-depth)},{linear_path(f, 2 * half)},{section},({end},{end}))"),
           operation)
    s.element("explicit", path(d / 2, *ends), [(0, -depth)], [(0, -depth)])


def explicit_pocket(s, x, y):
    """A round pocket by rings that the file gives."""
    f, r = s.file, s.file.r
    d, depth = r.choice([5, 6]), depth_of(s, 4)
    rings = r.choice([1, 2, 3])
    radius = d / 2 + rings * 0.4 * d
    placed = []
    for i in range(rings):
        ring = (i + 1) * 0.4 * d
        if chance(r, 0.5):
            curve = f.composite([f.arc((0, 0), ring, a, a + math.pi, -depth) for a in (0, math.pi)])
        else:
            steps = [2 * math.pi * i / 240 for i in range(241)]
            curve = f.polyline([(ring * math.cos(a), ring * math.sin(a)) for a in steps], -depth)
        placed.append(f.add(f"CUTTER_LOCATION_TRAJECTORY(.T.,.CONTACT.,$,$,$,$,{curve},$,$)"))
        if i + 1 < rings:
            placed.append(f.add("CONNECT_DIRECT(.T.,.CONNECT.,$,$,$)"))
    paths = f.add(f"TOOLPATH_LIST(({','.join(placed)}))")
    operation = f.milling(f.endmill(d), depth, strategy=f.add("EXPLICIT_STRATEGY($,$)"), toolpath=paths, layers=1)
    bottom = f.add("PLANAR_POCKET_BOTTOM_CONDITION()")
    profile = f.add(f"CIRCULAR_CLOSED_PROFILE($,{f.measure(2 * radius)})")
    s.work(f.add(f"CLOSED_POCKET({s.head([operation])},{s.placement(x, y)},{f.plane(-depth)},(),$,{bottom},$,$,{profile})"), operation)
    s.element("explicit_pocket", disc(x, y, radius), [(0, -depth)], [(0, -depth)])


# Holes.
def drilled(s, name, x, y, radius, depth, through, deeper=0):
    """A drilled hole; the point may end at its depth, or begin there where the bottom says so (`deeper`)."""
    low, high = (DEEP, -s.thickness - s.base) if through else (-depth - deeper, -depth)
    top = min(0, high + radius / POINT)
    s.element(name, disc(x, y, radius), [(-0.05, low)], [(0.05, top), (radius, high)])


def hole_entity(s, operations, placement, radius, depth, bottom="FLAT_HOLE_BOTTOM()", taper="$"):
    f = s.file
    return f.add(f"ROUND_HOLE({s.head(operations)},{placement},{f.plane(-depth)},{f.measure(2 * radius)},{taper},{f.add(bottom)})")


def hole_depth(s):
    """And whether the hole goes through, which no hole of a block with two sides does."""
    through = s.may_go_through and chance(s.file.r, 0.4)
    return (s.thickness + s.base if through else round(s.file.r.uniform(3, 8), 3)), through


def bottom_of(through):
    return "THROUGH_BOTTOM_CONDITION()" if through else "FLAT_HOLE_BOTTOM()"


def round_hole(s, x, y):
    f, r = s.file, s.file.r
    radius = r.choice([1.5, 2, 2.5, 3, 4, 5])
    depth, through = hole_depth(s)
    kind = r.choice(["DRILLING", "MULTISTEP_DRILLING", "CENTERED", "REAMING", "BORING", "CONICAL"])
    first = f.drill(2 * radius if kind not in ("REAMING", "BORING") else 2 * radius - 0.2)
    more = f",{f.length(1)},{f.length(2)},{f.length(2)},$" if kind == "MULTISTEP_DRILLING" else ""
    operations = [f.drilling(first, "MULTISTEP_DRILLING" if more else "DRILLING", more=more)]
    bottom = bottom_of(through)
    if kind == "CENTERED":
        centre = f.tool("drill cone " + numbers(radius, 0, 90, 0, 0, 0, 0, 0, 1), "CENTER_DRILL", radius, top_angle=math.pi / 2)
        operations.insert(0, f.drilling(centre, "CENTER_DRILLING", depth=f.length(1)))
    if kind == "REAMING":
        operations.append(f.drilling(f.of_hole("reamer", "REAMER", 2 * radius), "REAMING", more=",.F.,$,$"))
    if kind == "BORING":
        operations.append(f.drilling(f.of_hole("boringbar", "BORING_TOOL", 2 * radius), "BORING", more=",.F.,$,$"))
    if kind == "CONICAL" and not through:
        bottom = f"CONICAL_HOLE_BOTTOM({f.angle(DRILL_ANGLE)},$)"
    s.work(hole_entity(s, operations, s.placement(x, y), radius, depth, bottom), *operations)
    if kind in ("REAMING", "BORING"):
        drilled(s, "hole", x, y, radius, depth, through, deeper=radius / POINT + 0.1)
        s.lines.append(f"visit {'reamer' if kind == 'REAMING' else 'boringbar'} {numbers(x, y, s.base - depth)}")
    else:
        drilled(s, "hole", x, y, radius, depth, through, deeper=radius / POINT if "CONICAL" in bottom else 0)


def tapped_hole(s, x, y):
    f, r = s.file, s.file.r
    size, radius, pitch = r.choice([(5, 2.1, 0.8), (6, 2.5, 1), (8, 3.4, 1.25)])
    depth, through = hole_depth(s)
    depth += 0 if through else 3.2 * pitch    # room for the lead of the tap
    tapped = depth if through else depth - 3.2 * pitch
    drilling, turns = f.drilling(f.drill(2 * radius)), 8
    # The point lies below the depth of a conical bottom.
    bottom = bottom_of(True) if through else f"CONICAL_HOLE_BOTTOM({f.angle(DRILL_ANGLE)},$)"
    hole = hole_entity(s, [drilling], s.placement(x, y), radius, depth, bottom)
    tapping = f.drilling(f.of_hole("tap", "TAP", size, pitch), "TAPPING", more=",.F.", turns=turns, feed=turns * pitch / 1000)
    area = f.add(f"PARTIAL_AREA_DEFINITION({f.length(tapped)},{s.placement(x, y)},$)")
    words = [f.add(f"DESCRIPTIVE_PARAMETER('{name}','{value}')") for name, value in (("fit class", "6H"), ("form", "METRIC"), ("hand", "RIGHT"))]
    pitched = f.add(f"NUMERIC_PARAMETER('pitch',{f.real(pitch)},'MM')")
    thread = f.add(f"CATALOGUE_THREAD({s.head([tapping])},{s.placement(x, y)},{f.plane(-tapped)},{area},({hole}),.T.,$,{words[0]},{words[1]},"
                   f"{f.length(size)},{pitched},{words[2]},$)")
    s.work(hole, drilling)
    s.work(thread, tapping)
    drilled(s, "tapped", x, y, radius, depth, through, deeper=radius / POINT + 0.05)
    s.lines.append(f"visit tap {numbers(x, y, s.base - tapped + 0.02)}")


def milled_hole(s, x, y):
    """With a bottom that is flat, a ball's or a bull-nose's; or tapered."""
    f, r = s.file, s.file.r
    kind, depth = r.choice(["flat", "taper", "ball", "round"]), round(r.uniform(3.2, 6), 3)
    radius, taper, bottom = r.uniform(3.5, 9), "$", "FLAT_HOLE_BOTTOM()"
    tool, corner = f.endmill(4), 0
    if kind == "ball":
        radius = 3
        tool, bottom = f.ball(2 * radius), f"SPHERICAL_HOLE_BOTTOM({f.measure(radius)})"
        curve = [(radius * (1 - math.cos(a)), -depth + radius * (1 - math.sin(a))) for a in (math.pi / 2 * i / 14 for i in range(15))]
    elif kind == "round":
        corner, tool = 1, f.bullnose(6, 1)
        radius = max(radius, 4)
        bottom = f"FLAT_WITH_RADIUS_HOLE_BOTTOM({f.measure(corner)})"
        curve = [(corner * (1 - math.cos(a)), -depth + corner * (1 - math.sin(a))) for a in (math.pi / 2 * i / 12 for i in range(13))]
    elif kind == "taper":
        lean, radius = r.uniform(0.05, 0.3), max(radius, 6)
        foot = depth * math.tan(lean)
        entity = f"ANGLE_TAPER({f.angle(lean)})" if chance(r, 0.5) else f"DIAMETER_TAPER({f.measure(2 * (radius - foot))})"
        taper, curve = f.add(entity), None
    else:
        curve = [(0, -depth)]
    operation = f.milling(tool, depth, strategy=kind == "flat")
    s.work(hole_entity(s, [operation], s.placement(x, y), radius, depth, bottom, taper), operation)
    if kind == "taper":
        s.element("tapered", disc(x, y, radius), [(0, 0), (foot, -depth)], [(0, 0), (foot + 0.01, 0), (foot + 0.02, -depth)], reach=(2.03, 1.97, foot))
    else:
        s.element("milled_hole", disc(x, y, radius), curve, curve)


def compound_hole(s, x, y):
    """A counterbore or countersink over a drilled hole."""
    f, r = s.file, s.file.r
    radius, wide = r.choice([(2.5, 4.5), (3, 5.5)])
    depth, through = hole_depth(s)
    if not through:
        depth = wide + radius / POINT + 1    # the cone of a countersink ends in the drilled hole
    drilling = f.drilling(f.drill(2 * radius))
    place = s.placement(x, y)
    hole = hole_entity(s, [drilling], f.placement(), radius, depth, bottom_of(through))
    if chance(r, 0.5):
        seat = round(r.uniform(1, 2.5), 2)
        milling = f.milling(f.endmill(4), seat)
        upper, kind, last = hole_entity(s, [milling], f.placement(), wide, seat, "THROUGH_BOTTOM_CONDITION()"), "COUNTERBORE_HOLE", milling
        flat_pocket(s, Mill(4), "seat", disc(x, y, wide), seat)
    else:
        seat = wide - radius
        cone = f.add(f"DIAMETER_TAPER({f.measure(2 * radius)})")
        last = f.drilling(f.cone(12, 90), "COUNTER_SINKING")
        upper, kind = hole_entity(s, [last], f.placement(), wide, seat, "THROUGH_BOTTOM_CONDITION()", cone), "COUNTERSUNK_HOLE"
        s.element("sink", disc(x, y, wide), [(0, 0), (seat, -seat)], [(0, 0), (seat, -seat)])
    both = ",".join((upper, hole))
    compound = f.add(f"{kind}({s.head([drilling, last])},{place},({both}))")
    s.work(compound, drilling, last)
    drilled(s, "hole", x, y, radius, depth, through)


def pattern(s, x, y):
    f, r = s.file, s.file.r
    radius, (depth, through) = r.choice([1.5, 2, 2.5]), hole_depth(s)
    operation = f.drilling(f.drill(2 * radius))
    kind = r.choice(["circular", "rectangular", "general"])
    turn = turn_of(r)
    c, sn = math.cos(turn), math.sin(turn)
    at = lambda u, v: (x + c * u - sn * v, y + sn * u + c * v)    # noqa: E731
    missing = ()
    if kind == "circular":
        count, ring = r.choice([3, 4, 5, 6]), r.uniform(8, 11)
        places = [at(ring * math.cos(a), ring * math.sin(a)) for a in (2 * math.pi * i / count for i in range(count))]
        base = hole_entity(s, [operation], s.placement(*places[0]), radius, depth, bottom_of(through))
        if chance(r, 0.4):
            missing = (r.randrange(2, count + 1),)
        omit = ",".join(f.add(f"CIRCULAR_OMIT({i})") for i in missing)
        entity = f.add(f"CIRCULAR_PATTERN({s.head([operation])},{s.placement(x, y, turn)},{base},{f.angle(2 * math.pi / count)},{count},(),({omit}),"
                       f"{f.measure(2 * ring)},0.)")
        places = [p for i, p in enumerate(places) if i + 1 not in missing]
    elif kind == "rectangular":
        columns, rows, spacing = r.choice([2, 3]), r.choice([1, 2]), r.uniform(6.5, 9)
        places = [at(spacing * (i - 1), spacing * j) for j in range(rows) for i in range(columns)]
        base = hole_entity(s, [operation], s.placement(*places[0], turn), radius, depth, bottom_of(through))
        along, layout = f.direction(1, 0, 0), f.direction(0, 1, 0)
        entity = f.add(f"RECTANGULAR_PATTERN({s.head([operation])},{s.placement(*places[0], turn)},{base},{f.measure(spacing)},{along},{rows},{columns},"
                       f"{f.measure(spacing)},{layout},(),())")
    else:
        others = [(r.uniform(5, 10) * r.choice([1, -1]), r.uniform(-10, 10)) for _ in range(1)]
        places = [at(0, 0)] + [at(u, v) for u, v in others]
        base = hole_entity(s, [operation], s.placement(*places[0], turn), radius, depth, bottom_of(through))
        there = ",".join(f.placement((u, v, 0)) for u, v in others)
        entity = f.add(f"GENERAL_PATTERN({s.head([operation])},{s.placement(x, y, turn)},{base},({there}))")
    s.work(entity, operation)
    for place in places:
        drilled(s, "member", *place, radius, depth, through)


def projection(s, x, y):
    f, r = s.file, s.file.r
    if s.base or not s.upright():    # it hits the raw piece's level top
        return closed_pocket(s, x, y)
    depth, d = depth_of(s), r.choice([4, 5])
    corners = [(-10, -8), (9, -9), (10, 8), (0, r.uniform(3, 10)), (-9, 7)]
    operation = f.milling(f.endmill(d), depth)
    s.work(f.add(f"REGION_PROJECTION({s.head([operation])},{s.placement(x, y)},{f.polyline(corners + corners[:1])},{f.direction(0, 0, -1)},{f.measure(depth)})"),
           operation)
    flat_pocket(s, Mill(d), "projection", polygon(*((x + u, y + v) for u, v in corners)), depth)


THINGS = [closed_pocket, closed_pocket, chamfer, leaning_pocket, filleted_pocket, slot, bent_slot, open_slot, groove, t_slot, step, open_pocket,
          explicit_slot, explicit_pocket, round_hole, round_hole, tapped_hole, milled_hole, compound_hole, pattern, pattern, projection]


def face(s):
    """Over the whole top, before all else."""
    f, r = s.file, s.file.r
    depth = r.choice([0.5, 1, 1.5])
    body, d = ("FACEMILL", 20)
    mill = f.tool("facemill flat " + numbers(d, 0, 0, 0, 0, 0, 0, 0, 0), body, d, edge=0)
    operation = f.milling(mill, depth, "PLANE_ROUGH_MILLING", strategy=None)
    course = boundary = "$"
    if chance(r, 0.5):
        course = linear_path(f, s.width)
        boundary = f.add(f"LINEAR_PROFILE($,{f.measure(s.height)})")
    s.work(f.add(f"PLANAR_FACE({s.head([operation])},{s.placement(0, 0)},{f.plane(-depth)},{course},{boundary},$,())"), operation)
    s.element("face", "all", [(0, -depth)], [(0, -depth)])
    s.kinds.append("face")
    s.base = -depth


def outside(s):
    """The rim of the block, which is left out by the cells."""
    f, r = s.file, s.file.r
    depth, d = depth_of(s), 6
    w, h = s.width - 2, s.height - 2
    operation = f.milling(f.endmill(d), depth, strategy=None)
    entity = r.choice(["RECTANGULAR_CLOSED_SHAPE_PROFILE", "GENERAL_OUTSIDE_PROFILE"])
    profile = f.add(f"RECTANGULAR_CLOSED_PROFILE($,{f.measure(h)},{f.measure(w)})")
    if entity == "GENERAL_OUTSIDE_PROFILE":
        feature = f.add(f"{entity}({s.head([operation])},{s.placement(s.width / 2, s.height / 2)},{f.plane(-depth)},$,{profile})")
    else:
        feature = f.add(f"{entity}({s.head([operation])},{s.placement(s.width / 2, s.height / 2)},{f.plane(-depth)},$,$,$,{profile})")
    s.work(feature, operation)
    s.kinds.append("outside")
    s.element("outside", "all", [(0, -depth)], [(0, -depth)], [box(s.width / 2, s.height / 2, w, h)])


IDENTITY = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
TURNS = [IDENTITY, ((0, 1, 0), (-1, 0, 0), (0, 0, 1)), ((-1, 0, 0), (0, -1, 0), (0, 0, 1)), ((0, -1, 0), (1, 0, 0), (0, 0, 1))]
OVER = [((1, 0, 0), (0, -1, 0), (0, 0, -1)), ((-1, 0, 0), (0, 1, 0), (0, 0, -1)), ((0, 1, 0), (1, 0, 0), (0, 0, -1))]
SIDES = [((1, 0, 0), (0, 0, 1), (0, -1, 0)), ((0, -1, 0), (0, 0, 1), (-1, 0, 0))]


class Program:
    """A random program: its text, and its set-ups with their descriptions."""

    def __init__(self, seed):
        self.r = r = random.Random(seed)
        self.file = f = File(r)
        across, up = r.choice([(1, 1), (2, 1), (1, 2), (2, 2)])
        second = r.choice([None, None, None, "turned", "over", "side"])
        thickness = CELL + 4 if second == "side" else 20
        corner = r.choice([(0, 0, 0), (0, 0, -thickness), tuple(round(r.uniform(-60, 60), 2) for _ in range(3))])
        size = (across * CELL + 2 * EDGE, up * CELL + 2 * EDGE, thickness)
        self.block = (corner, tuple(c + v for c, v in zip(corner, size)))
        rotations = [IDENTITY]
        if second:
            rotations.append(r.choice({"turned": TURNS, "over": OVER, "side": SIDES}[second]))
        self.setups = [Setup(f, i + 1, rotation, self.block) for i, rotation in enumerate(rotations)]
        cells = [(i, j) for i in range(across) for j in range(up)]
        for s in self.setups:
            s.may_go_through = second is None
            self.fill(s, cells, second)

    def fill(self, s, cells, second):
        r = self.r
        if second in (None, "over") and chance(r, 0.25):
            face(s)
        if second == "turned":    # each cell is worked on in one of the set-ups
            half = (len(cells) + 1) // 2
            keep = cells[:half] if s.number == 1 else cells[half:] or cells[:0]
            centres = [self.seen_from(s, cell) for cell in keep] or []
        else:
            columns, rows = int((s.width - 2 * EDGE) / CELL + 0.5), int((s.height - 2 * EDGE) / CELL + 0.5)
            centres = [(EDGE + CELL * (i + 0.5), EDGE + CELL * (j + 0.5)) for i in range(columns) for j in range(rows)]
        for x, y in centres[:3]:
            thing = r.choice(THINGS)
            s.kinds.append(thing.__name__)
            thing(s, x, y)
        if second is None and "step" not in s.kinds and not {"open_slot", "t_slot", "open_pocket"} & set(s.kinds) and chance(r, 0.2):
            outside(s)

    def seen_from(self, s, cell):
        """The centre of a cell of the first set-up in the frame of another that looks at the same side."""
        low = self.block[0]
        at = s.turned([low[0] + EDGE + CELL * (cell[0] + 0.5), low[1] + EDGE + CELL * (cell[1] + 0.5), self.block[1][2]])
        return at[0] - s.zero[0], at[1] - s.zero[1]

    def text(self):
        f, names = self.file, {}
        setups = [s for s in self.setups if s.steps]
        self.setups = setups
        origin = f.placement(self.block[0])
        size = [b - a for a, b in zip(*self.block)]
        block = f.add("BLOCK('BLANK'," + origin + "," + ",".join(f.length(v) for v in size) + ")")
        names["#WORKPIECE"] = f.add(f"WORKPIECE('PART',$,$,$,$,{block},())")
        plans = []
        for s in setups:
            off = tuple(round(self.r.uniform(-50, 50), 1) for _ in range(3)) if chance(self.r, 0.3) else (0, 0, 0)
            columns = list(zip(*s.rotation))
            place = f.placement(off, columns[2], columns[0]) if not s.upright() or chance(self.r, 0.5) else f.placement(off)
            security = f.plane(s.zero[2] + off[2] + 25)
            names[f"#SECURITY{s.number}"] = security
            on = f.add(f"WORKPIECE_SETUP({names['#WORKPIECE']},{place},$,$,())")
            setup = f.add(f"SETUP('S{s.number}',$,{security},({on}))")
            plans.append(f.add(f"WORKPLAN('PLAN{s.number}',({','.join(s.steps)}),$,{setup},$)"))
        main = plans[0] if len(plans) == 1 else f.add(f"WORKPLAN('MAIN',({','.join(plans)}),$,$,$)")
        f.add(f"PROJECT('RANDOM',{main},({names['#WORKPIECE']}),$,$,$)")
        self.units()
        data = "\n".join(f.lines)
        for name in sorted(names, key=len, reverse=True):
            data = data.replace(name, names[name])
        return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('MACHINING_SCHEMA'));\nENDSEC;\nDATA;\n" + data + "\nENDSEC;\nEND-ISO-10303-21;\n"

    def units(self):
        f, unit = self.file, self.file.unit
        if unit.name == "none":
            return
        prefix = {"milli": ".MILLI.", "inch": ".MILLI.", "centi": ".CENTI.", "metre": "$", "micro": ".MICRO."}[unit.name]
        length = f.add(f"(LENGTH_UNIT()NAMED_UNIT($)SI_UNIT({prefix},.METRE.))")
        if unit.name == "inch":
            measure = f.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{length})")
            length = f.add(f"(CONVERSION_BASED_UNIT('INCH',{measure})LENGTH_UNIT()NAMED_UNIT($))")
        angle = f.add("(NAMED_UNIT($)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        if unit.degrees:
            measure = f.add(f"PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE({math.pi / 180!r}),{angle})")
            angle = f.add(f"(CONVERSION_BASED_UNIT('DEGREE',{measure})NAMED_UNIT($)PLANE_ANGLE_UNIT())")
        f.add(f"(GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle}))REPRESENTATION_CONTEXT('',''))")


if __name__ == "__main__":
    import sys
    program = Program(int(sys.argv[1]))
    print(program.text())
    for s in program.setups:
        print(s.kinds, number(s.base))
        print(s.description())
