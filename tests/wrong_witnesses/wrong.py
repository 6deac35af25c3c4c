#!/usr/bin/env python3
"""Makes wrong witnesses from a right one and has clearcut-check refuse each of them.

    wrong.py CHECKER PROGRAM PART WITNESS [COUNT]

A kind is one function below; what it makes proves nothing, whatever the program. Ends with 1 where the checker accepts one, crashes, or
refuses without a reason.
"""
import collections
import hashlib
import os
import random
import subprocess
import sys
import tempfile


LARGEST = 2**30  # nm


def number(value):
    out = bytearray()
    while value >= 128:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes(out + bytes([value]))


def signed(value):
    return number(2 * value if value >= 0 else -2 * value - 1)


class Witness:
    """docs/witness.md, read and written."""

    def __init__(self, data):
        self.data, self.at = data, 68
        self.magic, self.hashes = data[:4], data[4:68]
        self.tools = [[self.take() for _ in range(3)] for _ in range(self.take())]
        self.vertices, x, y = [], -LARGEST, -LARGEST
        for _ in range(self.take()):
            dx = self.take()
            x, y = x + dx, y + (self.take_signed() if dx else 1 + self.take())
            self.vertices.append((x, y))
        self.claims = [[[self.take() for _ in range(4)], self.take_tiles(), self.take_tiles()] for _ in range(self.take())]
        self.stated, self.cover, self.centre = max(self.claims, key=lambda claim: (len(claim[2]), len(claim[1])))
        self.rapids = [(self.take(), self.take_tiles()) for _ in range(self.take())]
        self.rims = [[self.take(), [[self.take(), [[self.take() for _ in range(3)] for _ in range(self.take())]] for _ in range(self.take())]]
                     for _ in range(self.take())]
        assert self.at == len(data)

    def take(self):
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    def take_signed(self):
        value = self.take()
        return -(value // 2) - 1 if value % 2 else value // 2

    def take_tiles(self):
        tiles, of, index = [], 0, 0
        for _ in range(self.take()):
            label = self.take()
            if label == 0:
                of += self.take_signed()
            corners = []
            for _ in range(self.take()):
                index += self.take_signed()
                corners.append(index)
            tiles.append([label, of, corners])
        return tiles

    def bytes(self):
        out = self.magic + self.hashes + number(len(self.tools)) + b"".join(number(n) for tool in self.tools for n in tool)
        out += number(len(self.vertices))
        x = y = -LARGEST
        for vx, vy in self.vertices:
            out += number((vx - x) % 2**56) + (signed(vy - y) if vx != x else number((vy - y - 1) % 2**56))
            x, y = vx, vy
        out += number(len(self.claims))
        for stated, cover, centre in self.claims:
            out += b"".join(map(number, stated)) + tiles_bytes(cover) + tiles_bytes(centre)
        out += number(len(self.rapids))
        for move, tiles in self.rapids:
            out += number(move) + tiles_bytes(tiles)
        out += number(len(self.rims))
        for move, pieces in self.rims:
            out += number(move) + number(len(pieces))
            for steps, sectors in pieces:
                out += number(steps) + number(len(sectors)) + b"".join(number(n) for sector in sectors for n in sector)
        return out


def tiles_bytes(tiles):
    parts, of, index = [number(len(tiles))], 0, 0
    for label, tile_of, corners in tiles:
        parts.append(number(label))
        if label == 0:
            parts.append(signed(tile_of - of))
            of = tile_of
        parts.append(number(len(corners)))
        for corner in corners:
            parts.append(signed(corner - index))
            index = corner
    return b"".join(parts)


def area(w, tile):
    v = [w.vertices[i] for i in tile[2]]
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(v, v[1:] + v[:1])) / 2


def some_tile(w, r):
    """Of either tiling one that is no mere line."""
    tiles = r.choice([tiles for tiles in (w.cover, w.centre) if tiles])
    return tiles, r.choice([t for t in tiles if abs(area(w, t)) > 1e6])


def dropped(w, r):
    tiles, tile = some_tile(w, r)
    tiles.remove(tile)


def twice(w, r):
    tiles, tile = some_tile(w, r)
    tiles.append([tile[0], tile[1], list(tile[2])])


def reversed_tile(w, r):
    some_tile(w, r)[1][2].reverse()


def collapsed(w, r):
    tile = some_tile(w, r)[1]
    tile[2] = tile[2][:1]


def corner_dropped(w, r):
    tile = some_tile(w, r)[1]
    v = [w.vertices[i] for i in tile[2]]
    cut = [abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) for a, b, c in zip([v[-1]] + v, v, v[1:] + v[:1])]
    del tile[2][cut.index(max(cut))]


def cancelled(w, r):
    """A tile and its reverse instead of the tile: all edges cancel, nothing is covered."""
    tiles, tile = some_tile(w, r)
    tiles.append([tile[0], tile[1], tile[2][::-1]])


def all_cancelled(w, r):
    w.cover[:] = []


def far_label(w, r):
    cut = [t for t in w.cover if t[0] == 0]
    tile = r.choice(cut)
    x, y = w.vertices[tile[2][0]]
    far = max(cut, key=lambda t: abs(w.vertices[t[2][0]][0] - x) + abs(w.vertices[t[2][0]][1] - y))
    tile[1] = far[1] if distance(w, tile, far) > 3 * w.stated[1] else 10**6


def distance(w, a, b):
    (ax, ay), (bx, by) = w.vertices[a[2][0]], w.vertices[b[2][0]]
    return max(abs(ax - bx), abs(ay - by))


def called_out(w, r):
    tile = r.choice([t for t in w.cover if t[0] == 0 and abs(area(w, t)) > 1e10])
    tile[0] = 1


def all_out(w, r):
    for tile in w.cover:
        tile[0] = 1


def called_illegal(w, r):
    maybe = [t for t in w.centre if t[0] == 1 and abs(area(w, t)) > 4 * w.stated[1] ** 2]
    if not maybe:
        return True
    tile = r.choice(maybe)
    tile[0], tile[1] = 0, r.randrange(4)


def unknown_label(w, r):
    some_tile(w, r)[1][0] = r.choice([2, 3, 99, 2**40])


def no_such_move(w, r):
    r.choice([t for t in w.cover if t[0] == 0])[1] = r.choice([-1, 10**6, 2**50])


def no_such_vertex(w, r):
    some_tile(w, r)[1][2][0] = r.choice([-1, len(w.vertices), 2**50])


def vertex_far_away(w, r):
    w.vertices[0] = (-r.choice([2**30, 2**40, 2**54]), 0)


def vertices_swapped(w, r):
    i = r.randrange(len(w.vertices) - 1)
    w.vertices[i], w.vertices[i + 1] = w.vertices[i + 1], w.vertices[i]


def corner_of_wall_moved(w, r):
    """All of the boundary a little to the right: the walls' starts are vertices no longer."""
    w.vertices[:] = [(x + r.choice([1, 7, 1000]), y) for x, y in w.vertices]


def wider_cutter(w, r):
    w.tools[0][1] += r.choice([20_000, 10**6])
    w.stated[1] = w.tools[0][1]


def strange_cutter(w, r):
    """A claim for a cutter that is so wide that it reaches nothing."""
    w.stated[1] *= 100
    w.centre[:] = [[1, 0, tile[2]] for tile in w.centre]
    all_out(w, r)


def cutter_dropped(w, r):
    del w.tools[0]


def cutter_twice(w, r):
    w.tools.append(list(w.tools[0]))


def no_such_feature(w, r):
    w.stated[0] = r.choice([len(w.claims), 2**20, 2**40])


def nothing_claimed(w, r):
    """Of no cutter and no feature, so that nothing is left to be checked."""
    w.tools, w.claims, w.rapids, w.rims = [], [], [], []


def feature_twice(w, r):
    w.claims.append(r.choice(w.claims))


def stock_stated(w, r):
    w.stated[2] += r.choice([20_000, 10**6])


def centre_dropped(w, r):
    w.centre.clear()


def rapid_in_air(w, r):
    """What is not cut before a rapid is called air."""
    if not w.rapids:
        return True
    for tile in r.choice(w.rapids)[1]:
        tile[0] = 2


def rapid_dropped(w, r):
    if not w.rapids:
        return True
    del w.rapids[r.randrange(len(w.rapids))]


def rapid_tile_dropped(w, r):
    if not w.rapids:
        return True
    w.rapids[r.randrange(len(w.rapids))][1].pop()


def rapid_later_move(w, r):
    if not w.rapids:
        return True
    move, tiles = r.choice(w.rapids)
    for tile in tiles:
        tile[1] = move + r.randrange(3)


def rapid_for_a_feed(w, r):
    w.rapids.append((10**6, []))


def some_piece(w, r):
    return r.choice(r.choice(w.rims)[1])


def rim_dropped(w, r):
    """A piece of a rim is missing: it ends before its move."""
    rim = r.choice(w.rims)
    del rim[1][r.randrange(len(rim[1]))]


def rim_too_long(w, r):
    some_piece(w, r)[0] += r.choice([1, 2**20])


def rim_without_steps(w, r):
    r.choice(w.rims)[1].append([0, []])


def rim_of_no_move(w, r):
    r.choice(w.rims)[0] += r.choice([2**20, 2**29])


def rims_exchanged(w, r):
    if len(w.rims) < 2:
        return True
    i = r.randrange(len(w.rims) - 1)
    w.rims[i], w.rims[i + 1] = w.rims[i + 1], w.rims[i]


def rim_free_all_around(w, r):
    """A slot's sides are never free all around."""
    some_piece(w, r)[1].extend([900 * k, 900, 1] for k in range(4))


def rim_free_by_a_later_move(w, r):
    some_piece(w, r)[1].append([0, 10, 2**29])


def rim_sector_too_wide(w, r):
    some_piece(w, r)[1].append([r.randrange(3600), r.choice([0, 901, 3600, 2**29]), 1])


def rim_direction_beyond_a_turn(w, r):
    some_piece(w, r)[1].append([3600 + r.randrange(3600), 1, 1])


KINDS = [dropped, twice, reversed_tile, collapsed, corner_dropped, cancelled, all_cancelled, far_label, called_out, all_out, called_illegal,
         unknown_label, no_such_move, no_such_vertex, vertex_far_away, vertices_swapped, corner_of_wall_moved, wider_cutter, strange_cutter, cutter_dropped, cutter_twice,
         no_such_feature, nothing_claimed, feature_twice, stock_stated, centre_dropped, rapid_in_air,
         rim_dropped, rim_too_long, rim_without_steps, rim_of_no_move, rims_exchanged, rim_free_all_around, rim_free_by_a_later_move, rim_sector_too_wide, rim_direction_beyond_a_turn,
         rapid_dropped, rapid_tile_dropped, rapid_later_move, rapid_for_a_feed]


def other_program(data, r):
    return data[:4] + hashlib.sha256(r.randbytes(9)).digest() + data[36:]


def other_part(data, r):
    return data[:36] + hashlib.sha256(r.randbytes(9)).digest() + data[68:]


def other_version(data, r):
    return b"CCW" + bytes([r.choice([0, 48, 49, 50, 255])]) + data[4:]


def cut_off(data, r):
    return data[:r.randrange(len(data))]


def longer(data, r):
    return data + r.choice([b"\0", b"CCW1", r.randbytes(40)])


def overlong_number(data, r):
    at = 70  # of the first tool's radius
    while data[at] & 128:
        at += 1
    return data[:at] + bytes([data[at] | 128]) + r.choice([b"\x80" * 9, b"\x80", b"\xff" * 20]) + b"\0" + data[at + 1:]


def huge_count(data, r):
    return data[:68] + r.choice([b"", number(0), number(0) + number(0)]) + number(r.choice([2**30, 2**55])) + data[-40:]


BYTE_KINDS = [other_program, other_part, other_version, cut_off, longer, overlong_number, huge_count]


def wrong_witness(data, kind, r):
    """None where the witness has nothing of that kind."""
    if kind in BYTE_KINDS:
        return kind(data, r)
    w = Witness(data)
    if kind(w, r):
        return None
    return w.bytes()


def main():
    checker, program, part, witness = sys.argv[1:5]
    count = int(sys.argv[5]) if len(sys.argv) > 5 else 1000
    data = open(witness, "rb").read()
    assert Witness(data).bytes() == data
    assert subprocess.run([checker, program, part, witness], capture_output=True).returncode == 0, "the right one is not accepted"
    tried, faults = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "wrong.ccw")
        for i in range(count):
            r = random.Random(i)
            kind = (KINDS + BYTE_KINDS)[i % len(KINDS + BYTE_KINDS)]
            wrong = wrong_witness(data, kind, r)
            if wrong is None or wrong == data:
                continue
            with open(path, "wb") as file:
                file.write(wrong)
            answer = subprocess.run([checker, program, part, path], capture_output=True, text=True)
            tried[kind.__name__] += 1
            if answer.returncode not in (1, 2) or not answer.stderr.startswith("refused: ") or len(answer.stderr) < 20:
                faults += 1
                print(f"{kind.__name__} {i}: ended with {answer.returncode}: {answer.stdout[:80]}{answer.stderr[:200]}")
    print(f"{sum(tried.values())} wrong witnesses of {len(tried)} kinds, {faults} not refused")
    return 1 if faults or len(tried) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
