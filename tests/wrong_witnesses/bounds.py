#!/usr/bin/env python3
"""The checker's predicates at their bounds, give or take 10 nm, against exact rational arithmetic.

    bounds.py PREDICATES [COUNT]

PREDICATES is predicates.cpp, compiled. Distances from segments and between convex hulls must be decided exactly; what is said of arcs may be
too careful, but by little, and never too bold.
"""
import math
import random
import subprocess
import sys
from fractions import Fraction


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1])


def square(a):
    return a[0] * a[0] + a[1] * a[1]


def to_segment(p, a, b):
    """Squared distance, a Fraction."""
    d = minus(b, a)
    if square(d) == 0:
        return Fraction(square(minus(p, a)))
    t = Fraction((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1], square(d))
    t = min(max(t, 0), 1)
    return square((p[0] - a[0] - t * d[0], p[1] - a[1] - t * d[1]))


def meet(a, b, c, d):
    def side(p, q, r):
        return (cross(minus(q, p), minus(r, p)) > 0) - (cross(minus(q, p), minus(r, p)) < 0)
    if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0:
        return True
    return 0 in (to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b))


def between_segments(a, b, c, d):
    return 0 if meet(a, b, c, d) else min(to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b))


def hull_of(points):
    points = sorted(set(points))
    if len(points) < 3:
        return points
    out = []
    for run in (points, points[::-1]):
        base = len(out)
        for p in run:
            while len(out) >= base + 2 and cross(minus(out[-1], out[-2]), minus(p, out[-1])) <= 0:
                out.pop()
            out.append(p)
        out.pop()
    return out


def edges(hull):
    return list(zip(hull, hull[1:] + hull[:1]))


def between_hulls(a, b):
    """Squared; 0 where they meet."""
    for hull, p in ((a, b[0]), (b, a[0])):
        if len(hull) > 2 and all(cross(minus(v, u), minus(p, u)) >= 0 for u, v in edges(hull)):
            return 0
    return min(between_segments(u, v, s, t) for u, v in edges(a) for s, t in edges(b))


def root(value):
    """Of a Fraction, down to 1e-9."""
    return Fraction(math.isqrt(int(value * 10**18)), 10**9)


def near(r, size):
    return (r.randint(-size, size), r.randint(-size, size))


def on_circle(r, radius, angle=None):
    angle = r.uniform(0, 2 * math.pi) if angle is None else angle
    return (round(radius * math.cos(angle)), round(radius * math.sin(angle)))


def flat(*things):
    out = []
    for thing in things:
        if isinstance(thing, tuple):
            out += flat(*thing)
        elif isinstance(thing, list):
            out += [str(len(thing))] + flat(*thing)
        else:
            out.append(str(thing))
    return out


SIZES = [50, 3000, 10**6, 2**28, 2**29 - 1]


def segment_question(r):
    size = r.choice(SIZES)
    p, a, b = near(r, size), near(r, size), r.choice([near(r, size), None])
    b = b or a
    exact = to_segment(p, a, b)
    t = max(0, math.isqrt(int(exact)) + r.choice([-10, -1, 0, 1, 10]))
    return ["segment"] + flat(p, a, b, t), exact <= t * t


def segments_question(r):
    size = r.choice(SIZES)
    a, b, c, d = (near(r, size) for _ in range(4))
    exact = between_segments(a, b, c, d)
    t = max(0, math.isqrt(int(exact)) + r.choice([-10, -1, 0, 1, 10]))
    return ["segments"] + flat(a, b, c, d, t), exact > t * t


def apart_question(r):
    size = r.choice(SIZES[:4])
    shift = near(r, 2 * size)
    a = [near(r, size) for _ in range(r.randint(1, 6))]
    b = [(x + shift[0], y + shift[1]) for x, y in (near(r, size) for _ in range(r.randint(1, 6)))]
    exact = between_hulls(hull_of(a), hull_of(b))
    t = max(1, math.isqrt(int(exact)) + r.choice([-10, -1, 0, 1, 10]))
    return ["apart"] + flat(a, b, t), exact >= t * t


def an_arc(r):
    radius = r.choice([2_500, 10_000, 10**6, 3 * 10**6, 2**28])
    center = near(r, 1000)
    start = r.uniform(0, 2 * math.pi)
    turn = r.choice([r.uniform(0.01, 1.5), r.uniform(0.01, 6.2), math.pi, 2 * math.pi, r.uniform(1e-3, 1e-2)])
    first = on_circle(r, radius, start)
    last = first if turn == 2 * math.pi else on_circle(r, radius + r.choice([0, 0, 5, 900]), start + turn)
    radii = [square(first), square(last)]
    low, high = math.isqrt(min(radii)), math.isqrt(max(radii) - 1) + 1
    return (center, first, last, low, high), start, turn


def seen(first, last, v):
    """Whether direction v lies in the sector."""
    if first == last:
        return True
    if cross(first, last) > 0 or (cross(first, last) == 0):
        return cross(first, v) >= 0 and cross(v, last) >= 0
    return not (cross(last, v) > 0 and cross(v, first) > 0)


def farthest(arc, p):
    """Upper bound of the distance of p from the curve, over the curves that the arc may be, by what is known of each: ends, and a point on the ray of p."""
    center, first, last, low, high = arc
    v = minus(p, center)
    best = min(root(square(minus(v, first))), root(square(minus(v, last))))
    if v != (0, 0) and seen(first, last, v):
        rho = root(square(v))
        best = min(best, max(abs(rho - low), abs(high - rho)))
    return best + Fraction(2, 10**9)


def arc_question(r):
    """A hull about a rim of an arc's swath, near the bound."""
    arc, start, turn = an_arc(r)
    center, first, last, low, high = arc
    t = r.choice([max(30, low // 2), 2 * high, 3 * 10**6, 40_000])
    side = r.choice([1, -1])
    spread = min(turn, r.choice([1e-4, 1e-2, 0.3]))
    at = start + r.choice([0, 0, turn - spread, r.uniform(0, turn - spread)]) + r.choice([0, 0, -1, 1]) * 10 / low
    hull = []
    for _ in range(r.randint(1, 5)):
        radius = (low if side > 0 else high) + side * (t - 8) + r.choice([-10, -1, 0, 1, 10, -r.randint(0, t)])
        x, y = on_circle(r, max(radius, 0), at + r.uniform(0, spread))
        hull.append((center[0] + x, center[1] + y))
    return ["arc"] + flat(arc, hull, t), (arc, hull_of(hull), t)


def arc_faults(answer, arc, hull, t, r):
    if answer == "0":
        return []
    points = list(hull)
    for u, v in edges(hull):
        for k in range(1, 8):
            points.append((u[0] + (v[0] - u[0]) * k // 8, u[1] + (v[1] - u[1]) * k // 8))
    return [p for p in points if farthest(arc, p) > t + 1]  # rounding of the points in between: 1 nm


def chord_question(r):
    arc, start, turn = an_arc(r)
    _, first, last, low, high = arc
    half = min(turn, r.choice([0.01, 0.5, 3.0]))
    u, v = on_circle(r, low + r.randint(-3, 3), start), on_circle(r, high + r.randint(-3, 3), start + half)
    foot = to_segment((0, 0), u, v)
    exact = max(high - root(foot), root(max(square(u), square(v))) - low)
    return ["chord"] + flat(arc, u, v), exact


def piece_question(r):
    """A piece of a boundary along a wall of more than 180 degrees: forward within it, or over its gap."""
    radius = r.choice([10_000, 10**6])
    start, turn = r.uniform(0, 6.28), r.uniform(3.3, 6.1)
    first, last = on_circle(r, radius, start), on_circle(r, radius, start + turn)
    low, high = radius - 2, radius + 2
    at = r.uniform(0, turn - 0.2)
    wide = min(100_000 / radius, 0.1)
    scale = r.randint(1, 3)
    u, v, right = r.choice([
        (on_circle(r, radius, start + at), on_circle(r, radius, start + at + wide), True),
        (on_circle(r, radius, start + at + wide), on_circle(r, radius, start + at), False),
        (last, first, False),
        ((scale * last[0], scale * last[1]), on_circle(r, radius, start + turn + 0.01), False),
        (on_circle(r, radius, start - 0.01), first, False),
        (on_circle(r, radius, start + turn - 0.01), on_circle(r, radius, start + 0.01), False),
        (first, on_circle(r, radius, start + wide), True),
        (on_circle(r, radius, start + turn - wide), last, True),
    ])
    return ["piece"] + flat((0, 0), first, last, low, high, u, v), right


def turned_question(r):
    """A whole number of 1/10000 degrees; the right answer by complex numbers of 53 bits, good to 1e-6 nm here."""
    v, angle = near(r, r.choice([3, 10**6, 2**29])), r.choice([r.randint(-3_600_000, 3_600_000), 900_000 * r.randint(-4, 4)])
    return ["turned"] + flat(v, angle), complex(*v) * complex(math.cos(math.radians(angle / 1e4)), math.sin(math.radians(angle / 1e4)))


def chords_faults(arc, answer):
    """Chords of an arc: from end to end, each a turn of its own to the left, and as near to any curve of the arc as they say."""
    center, first, last, low, high = arc
    numbers = list(map(int, answer.split()))
    error, points = numbers[0], [minus((x, y), center) for x, y in zip(numbers[2::2], numbers[3::2])]
    faults = [] if points[0] == first and points[-1] == last else ["its ends"]
    turn = 0.0
    for u, v in zip(points, points[1:]):
        turn += math.atan2(cross(u, v), u[0] * v[0] + u[1] * v[1])
        exact = max(high - root(to_segment((0, 0), u, v)), root(max(square(u), square(v))) - low)
        if cross(u, v) <= 0 or exact > error + Fraction(1, 10**6):
            faults.append(f"chord at {u}, {float(exact)}")
    whole = math.atan2(cross(first, last), first[0] * last[0] + first[1] * last[1]) % (2 * math.pi) or 2 * math.pi
    return faults + ([] if abs(turn - whole) < 1e-6 else [f"turns by {turn}, not {whole}"])


def low_question(r):
    """The place of a line that slopes at which it is at a level, at the bound, give or take 10 nm."""
    size = r.choice(SIZES[1:])
    a, b, z0, z1 = near(r, size), near(r, size), r.randint(-10**6, 0), r.randint(1, 10**6)
    z0, z1 = r.choice([(z0, z1), (z1, z0)])
    level = min(max(r.choice([z0, z1]) + r.choice([-10, -1, 0, 1, 10]), min(z0, z1)), max(z0, z1) - 1)
    foot, head = ((a, z0), (b, z1)) if z0 < z1 else ((b, z1), (a, z0))
    share = Fraction(level - foot[1], head[1] - foot[1])
    return ["low"] + flat(a, b, z0, z1, level), tuple(foot[0][k] + share * (head[0][k] - foot[0][k]) for k in (0, 1))


def rim_question(r):
    """A sector of the rim beside an earlier parallel pass, such that its farthest place is near the bound."""
    radius = r.choice([100_000, 3 * 10**6, 40 * 10**6])
    start, size = r.randrange(3600), r.choice([1, 5, 50, 300, 900])
    way = r.uniform(0, 2 * math.pi)
    along = (math.cos(way), math.sin(way))
    length = r.choice([1000, radius])
    a, b = (0, 0), (round(length * along[0]), round(length * along[1]))
    angles = [math.radians((start + size * k / 12) / 10) for k in range(13)]
    # How far the pass lies aside, and which of the limits of the sector bounds it.
    side = max((-along[1] * math.cos(x) + along[0] * math.sin(x)) for x in angles) * (radius - 1000)
    aside = min(0, side - radius + r.choice([-10, -1, 0, 1, 10, 20, 30, 60, 400, 5000]))
    shift = (round(along[1] * -aside), round(-along[0] * -aside))
    long = 3 * radius
    before = tuple((round(k * long * along[0]) + shift[0], round(k * long * along[1]) + shift[1]) for k in (-1, 1))
    return ["rim"] + flat(radius, before[0], before[1], a, b, start, size), (radius, before, (a, b), angles)


def rim_excess(radius, before, ends, angles):
    """How far beyond the earlier cut the sector reaches at most, nm; by numbers of 53 bits, good to 1e-6 nm here."""
    d = minus(before[1], before[0])
    out = -radius
    for p in ends:
        for x in angles:
            q = (p[0] + (radius - 1000) * math.cos(x) - before[0][0], p[1] + (radius - 1000) * math.sin(x) - before[0][1])
            out = max(out, abs(cross(q, d)) / math.hypot(*d) - radius)
    return out


def ask(program, questions):
    text = "\n".join(" ".join(q) for q in questions) + "\n"
    return subprocess.run([program], input=text, capture_output=True, text=True, check=True).stdout.splitlines()


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    r = random.Random(1)
    faults = 0
    for make in (segment_question, segments_question, apart_question):
        asked = [make(r) for _ in range(count)]
        for (question, right), answer in zip(asked, ask(program, [q for q, _ in asked])):
            if (answer == "1") != right:
                faults += 1
                print("wrong:", " ".join(question), "is", right)
        if not 0.1 < sum(right for _, right in asked) / count < 0.95:
            faults += 1
            print(make.__name__, "asks nothing")
    asked = [arc_question(r) for _ in range(count)]
    answers = ask(program, [q for q, _ in asked])
    for (question, what), answer in zip(asked, answers):
        for p in arc_faults(answer, *what, r):
            faults += 1
            print("too bold:", " ".join(question), "at", p)
    if not 0.1 < sum(a == "1" for a in answers) / count < 0.95:
        faults += 1
        print("arc_question asks nothing:", sum(a == "1" for a in answers))
    asked = [chord_question(r) for _ in range(count)]
    for (question, exact), answer in zip(asked, ask(program, [q for q, _ in asked])):
        if not exact - Fraction(1, 10**6) <= int(answer) <= exact + 3:
            faults += 1
            print("wrong:", " ".join(question), "is", float(exact), "not", answer)
    asked = [piece_question(r) for _ in range(count)]
    for (question, right), answer in zip(asked, ask(program, [q for q, _ in asked])):
        if (int(answer) >= 0) != right:
            faults += 1
            print("wrong:", " ".join(question), "follows the wall" if right else "does not follow the wall")
    asked = [turned_question(r) for _ in range(count)]
    for (question, right), answer in zip(asked, ask(program, [q for q, _ in asked])):
        x, y = map(int, answer.split())
        if abs(x - right.real) > 0.501 or abs(y - right.imag) > 0.501:
            faults += 1
            print("wrong:", " ".join(question), "is", right, "not", answer)
    asked = [an_arc(r)[0] for _ in range(count // 4)]
    for arc, answer in zip(asked, ask(program, [["chords"] + flat(arc) for arc in asked])):
        for what in chords_faults(arc, answer):
            faults += 1
            print("wrong:", arc, what)
    asked = [low_question(r) for _ in range(count)]
    for (question, right), answer in zip(asked, ask(program, [q for q, _ in asked])):
        if any(abs(place - exact) > Fraction(1, 2) for place, exact in zip(map(int, answer.split()), right)):
            faults += 1
            print("wrong:", " ".join(question), "is", answer)
    asked = [r.choice([near(r, 2**30), on_circle(r, 10**9, math.radians(r.randint(0, 3600) / 10))]) for _ in range(count)]
    for v, answer in zip(asked, ask(program, [["tick"] + flat(v) for v in asked])):
        if not -1e-6 < (math.degrees(math.atan2(v[1], v[0])) % 360 * 10 - int(answer) + 1800) % 3600 - 1800 < 1 + 1e-6:
            faults += 1
            print("wrong: tick", v, "is", answer)
    asked = [rim_question(r) for _ in range(count)]
    answers = ask(program, [q for q, _ in asked])
    for (question, what), answer in zip(asked, answers):
        excess = rim_excess(*what)
        if (answer == "1" and excess > 0) or (answer == "0" and len(what[3]) and excess < -80 and question[-1] in ("1", "5")):
            faults += 1
            print("wrong:", " ".join(question), "is", answer, "with", excess)
    if not 0.1 < sum(a == "1" for a in answers) / count < 0.95:
        faults += 1
        print("rim_question asks nothing:", sum(a == "1" for a in answers))
    print(f"{10 * count + count // 4} questions, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
