"""Structural mutants of LinuxCNC programs: what a slip of the hand, a bad copy or a wrong edit makes of a right one."""
import re

HEADER = 8


class Program:
    def __init__(self, lines):
        self.lines = lines
        blocks = [i for i, line in enumerate(lines) if line and line[0] not in "(%" and i > HEADER]
        self.blocks = blocks
        self.moves = self.having("[XYZ]")
        self.heights = self.having("Z")
        self.operations = [i for i, line in enumerate(lines) if line.startswith("(OPERATION")]
        self.end = next((i for i in range(len(lines) - 1, 0, -1) if lines[i].startswith(("M2", "M30", "M5"))), len(lines) - 1)

    def having(self, pattern):
        return [i for i in self.blocks if re.search(pattern, self.lines[i])]

    def operation(self, r):
        """The first line of an operation, and of what follows it."""
        i = r.randrange(len(self.operations))
        return self.operations[i], self.operations[i + 1] if i + 1 < len(self.operations) else self.end

    def depths(self, begin, end):
        """The heights below zero in these lines."""
        return sorted({float(z) for i in range(begin, end) if not self.lines[i].startswith("(")
                       for z in re.findall(r"Z(-[\d.]+)", self.lines[i])})


def with_number(line, letter, change):
    """The line with another number of this word, where it has one."""
    def other(match):
        return letter + f"{change(float(match.group(1))):.4f}".rstrip("0").rstrip(".")
    return re.sub(letter + r"(-?[\d.]+)", other, line, count=1)


def in_force(line, word):
    """The line with the motion word that it had from an earlier one."""
    return line if re.match(r"[GMT(]", line) or not line else f"{word} {line}"


# Each returns the lines of a mutant, or nothing where the program has no place for it. They raise IndexError where they find no line.
def move_deleted(p, r):
    lines = p.lines[:]
    del lines[r.choice(p.moves)]
    return lines


def moves_deleted(p, r):
    i, count = r.choice(p.moves), r.randint(2, 8)
    return p.lines[:i] + p.lines[i + count:]


def move_doubled(p, r):
    i, j = r.choice(p.moves), r.choice(p.moves)
    return p.lines[:j] + [p.lines[i]] + p.lines[j:]


def moves_exchanged(p, r):
    lines, i = p.lines[:], r.choice(p.moves[:-1])
    lines[i], lines[i + 1] = lines[i + 1], lines[i]
    return lines


def moves_reversed(p, r):
    lines, i, count = p.lines[:], r.choice(p.moves), r.randint(2, 6)
    lines[i:i + count] = lines[i:i + count][::-1]
    return lines


def moves_carried_off(p, r):
    lines, i, count = p.lines[:], r.choice(p.moves), r.randint(1, 6)
    carried = lines[i:i + count]
    del lines[i:i + count]
    j = min(len(lines) - 3, max(HEADER + 1, i + r.randint(-20, 20)))
    return lines[:j] + carried + lines[j:]


def place_shifted(p, r):
    letter = r.choice("XY")
    return changed(p, r, p.having(letter), letter, r.choice([-3, -1, -0.4, 0.4, 1, 3]))


def changed(p, r, among, letter, by):
    lines, i = p.lines[:], r.choice(among)
    lines[i] = with_number(lines[i], letter, lambda v: v + by)
    return lines


def depth_changed(p, r):
    return changed(p, r, p.heights, "Z", r.choice([-2, -1, -0.3, 0.3, 1, 2, r.uniform(-2, 2)]))


def depths_changed(p, r):
    lines, i, by = p.lines[:], r.choice(p.moves), r.choice([-1, -0.4, 0.4, 1, 2])
    for k in range(i, min(i + r.randint(3, 40), p.end)):
        lines[k] = with_number(lines[k], "Z", lambda v: v + by if v < 0.5 else v)
    return lines


def drilled_to_another_depth(p, r):
    return changed(p, r, p.having(r"G8[1-5]|G73|G33\.1"), "Z", r.choice([-2, -0.5, 0.5, 1, 2]))


def cycle_shifted(p, r):
    return changed(p, r, p.having(r"G8[1-5]|G73"), "X", r.choice([-0.5, 0.5, 2]))


def cycle_deleted(p, r):
    lines = p.lines[:]
    lines[r.choice(p.having(r"G8[1-5]|G73|G33\.1"))] = ""
    return lines


def cycle_begins_lower(p, r):
    return changed(p, r, p.having(r" R-?[\d.]+"), "R", -r.choice([1.5, 2, 4]))


def cycle_returns_low(p, r):
    return replaced(p, r, "G98", lambda line: line.replace("G98", "G99"))


def cycle_goes_on(p, r):
    lines = p.lines[:]
    del lines[r.choice([i for i in p.having("^G80") if i > HEADER])]
    return lines


def replaced(p, r, pattern, change):
    lines, i = p.lines[:], r.choice(p.having(pattern))
    lines[i] = change(lines[i])
    return lines


def tapped_at_another_pitch(p, r):
    factor = r.choice([0.5, 1.5, 2])
    return replaced(p, r, r"G84|G74|G33\.1",
                    lambda line: with_number(with_number(line, "K", lambda v: v * factor), "F", lambda v: v * factor))


def tap_not_tied(p, r):
    return replaced(p, r, r"G33\.1", lambda line: re.sub(r" K[\d.]+", "", line.replace("G33.1", "G1")) + " F300")


def spindle_not_started(p, r):
    return replaced(p, r, "^M3", lambda line: "")


def spindle_without_speed(p, r):
    return replaced(p, r, r"S\d", lambda line: re.sub(r"S\d+", "S0", line))


def spindle_backwards(p, r):
    return replaced(p, r, "^M3", lambda line: line.replace("M3", "M4"))


def spindle_stopped(p, r):
    i = r.choice(p.moves)
    return p.lines[:i] + ["M5"] + p.lines[i:]


def length_not_set(p, r):
    return replaced(p, r, "^G43", lambda line: "")


def tool_not_changed(p, r):
    lines = p.lines[:]
    del lines[r.choice(p.having(r"T\d+ M6")[1:])]
    return lines


def tools_exchanged(p, r):
    changes = p.having(r"T\d+ M6")
    if len(changes) < 2:
        return None
    lines, (i, j) = p.lines[:], r.sample(changes, 2)
    lines[i], lines[j] = lines[j], lines[i]
    return lines


def rapid_for_feed(p, r):
    lines, i = p.lines[:], r.choice([i for i in p.moves if not p.lines[i].startswith("G0")])
    if re.search(r"G[378]\d", lines[i]):
        return None
    lines[i] = "G0 " + re.sub(r"G[123] |[IJF]-?[\d.]+ ?", "", lines[i])
    if i + 1 < len(lines):
        lines[i + 1] = in_force(lines[i + 1], "G3" if " I" in lines[i + 1] else "G1")
    return lines


def feed_for_rapid(p, r):
    lines, i = p.lines[:], r.choice([i for i in p.moves if p.lines[i].startswith("G0")])
    lines[i] = "G1" + lines[i][2:] + " F500"
    lines[i + 1] = in_force(lines[i + 1], "G0")
    return lines


def entry_at_the_rapid(p, r):
    lines, i = p.lines[:], r.choice([i for i in p.heights if re.match("G1 Z", p.lines[i])])
    lines[i] = "G0 " + re.search(r"Z-?[\d.]+", lines[i]).group()
    lines[i + 1] = in_force(lines[i + 1], "G1")
    return lines


def retract_too_low(p, r):
    low = r.choice([0.5, 0.1, 0, -0.5, -1, -2])
    return replaced(p, r, "^G0.*Z", lambda line: with_number(line, "Z", lambda v: low))


def retract_deleted(p, r):
    return replaced(p, r, "^G0.*Z", lambda line: r.choice(["G0", ""]))


def arc_the_other_way(p, r):
    return replaced(p, r, "^G[23] ", lambda line: ("G2" if line[1] == "3" else "G3") + line[2:])


def arc_as_a_line(p, r):
    lines, i = p.lines[:], r.choice(p.having(r"I-?[\d.]+ J"))
    lines[i] = re.sub("^G[23]", "G1", re.sub(r" ?I-?[\d.]+ J-?[\d.]+", "", lines[i]))
    if i + 1 < len(lines) and " I" in lines[i + 1]:
        lines[i + 1] = in_force(lines[i + 1], "G3")
    return lines


def coordinate_dropped(p, r):
    letter = r.choice("XYZ")
    return replaced(p, r, "[XYZ]", lambda line: re.sub(letter + r"-?[\d.]+ ?", "", line))


def move_halved(p, r):
    i = r.choice(p.having("X"))
    before = next(k for k in range(i - 1, 0, -1) if "X" in p.lines[k] and not p.lines[k].startswith("("))
    x = float(re.search(r"X(-?[\d.]+)", p.lines[before]).group(1))
    lines = p.lines[:]
    lines[i] = with_number(lines[i], "X", lambda v: (x + v) / 2)
    return lines


def layer_dropped(p, r):
    i = r.choice(p.heights)
    j = next((k for k in p.heights if k > i), p.end)
    return p.lines[:i + 1] + p.lines[j:]


def depth_for_depth(p, begin, end, depth, other):
    """The lines of an operation with another height in place of one."""
    lines = p.lines[:]
    for i in range(begin, end):
        if not lines[i].startswith("("):
            lines[i] = with_number(lines[i], "Z", lambda v: other if abs(v - depth) < 1e-6 else v)
    return lines


def layer_shifted(p, r):
    begin, end = p.operation(r)
    depth = r.choice(p.depths(begin, end))
    return depth_for_depth(p, begin, end, depth, depth + r.choice([-0.3, 0.3, 1, -depth / 2]))


def layers_merged(p, r):
    begin, end = p.operation(r)
    depths = p.depths(begin, end)
    i = r.randrange(1, len(depths)) if len(depths) > 1 else 0
    return depth_for_depth(p, begin, end, depths[i], depths[i - 1]) if i else None


def operation_deleted(p, r):
    begin, end = p.operation(r)
    kept = ("T", "M6", "M3", "S", "G43")
    return [line for i, line in enumerate(p.lines) if not begin <= i < end or line.startswith(kept)]


def operations_exchanged(p, r):
    if len(p.operations) < 2:
        return None
    i = r.randrange(len(p.operations) - 1)
    a, b = p.operations[i], p.operations[i + 1]
    c = p.operations[i + 2] if i + 2 < len(p.operations) else p.end
    return p.lines[:a] + p.lines[b:c] + p.lines[a:b] + p.lines[c:]


def operation_cut_short(p, r):
    begin, end = p.operation(r)
    moves = [i for i in range(begin + 1, end) if re.search("[XYZ]", p.lines[i])]
    if len(moves) < 6:
        return None
    gone = set(moves[-r.randint(1, len(moves) // 2) - 1:-1])
    return [line for i, line in enumerate(p.lines) if i not in gone]


def operation_shifted(p, r):
    (begin, end), by, letter = p.operation(r), r.choice([-0.6, 0.1, 0.6]), r.choice("XY")
    return [with_number(line, letter, lambda v: v + by) if begin <= i < end and not line.startswith("(") else line
            for i, line in enumerate(p.lines)]


def operation_stretched(p, r):
    (begin, end), factor = p.operation(r), r.choice([0.9, 0.97, 1.03])
    return [with_number(line, "Z", lambda v: v * factor if v < 0 else v) if begin <= i < end and not line.startswith("(") else line
            for i, line in enumerate(p.lines)]


KINDS = [move_deleted, moves_deleted, move_doubled, moves_exchanged, moves_reversed, moves_carried_off, place_shifted, depth_changed,
         depths_changed, drilled_to_another_depth, cycle_shifted, cycle_deleted, cycle_begins_lower, cycle_returns_low, cycle_goes_on,
         tapped_at_another_pitch, tap_not_tied, spindle_not_started, spindle_without_speed, spindle_backwards, spindle_stopped,
         length_not_set, tool_not_changed, tools_exchanged, rapid_for_feed, feed_for_rapid, entry_at_the_rapid, retract_too_low,
         retract_deleted, arc_the_other_way, arc_as_a_line, coordinate_dropped, move_halved, layer_dropped, layer_shifted, layers_merged,
         operation_deleted, operations_exchanged, operation_cut_short, operation_shifted, operation_stretched]


def mutants(text, count, r):
    """Up to `count` pairs of a kind and a program, each different from the given one."""
    program = Program(text.split("\n"))
    made, tries = [], 0
    while len(made) < count and tries < 6 * count:
        tries += 1
        kind = r.choice(KINDS)
        try:
            lines = kind(program, r)
        except (IndexError, ValueError, StopIteration):
            continue
        if lines and lines != program.lines:
            made.append((kind.__name__, "\n".join(lines)))
    return made
