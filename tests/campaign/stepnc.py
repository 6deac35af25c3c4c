#!/usr/bin/env python3
"""Random STEP-NC programs of all planned kinds, planned and judged by a field of heights, with attributes changed, and written back.

    stepnc.py CLEARCUT JUDGE FOLDER [--first SEED] [--files N] [--mutants N] [--seconds S] [--anew]

Each file is one line of FOLDER/stepnc.jsonl; files that stand there are not made again. Of each file:
- each set-up's program is judged beside the solid that the file means;
- of `--mutants` of its attributes, each changed or taken away alone, a change that nobody sees in programs or words is told;
- it is written with its toolpaths, read again, and planned by them: the programs move alike to the digit.
Ends with 1 where the field is certain of a wrong, where a plan is not clean, where moves differ, and where a command crashes or hangs.
"""
import collections
import pathlib
import random
import re
import sys

sys.dont_write_bytecode = True
from campaign import Bench, asked_of, judged  # noqa: E402
from part21 import Program  # noqa: E402

WORDS = ["--accept", "out-of-reach", "--accept", "leaning-walls"]
OTHER = {".T.": ".F.", ".F.": ".T.", ".CW.": ".CCW.", ".CCW.": ".CW.", ".CLIMB.": ".CONVENTIONAL.", ".CONVENTIONAL.": ".CLIMB.",
         ".RIGHT.": ".LEFT.", ".TCP.": ".CCP."}


def attribute_names():
    """Of each entity, from the page of what is read; those that begin with ~ are annotations."""
    page = pathlib.Path(__file__).resolve().parents[2] / "docs" / "stepnc.md"
    rows = re.findall(r"^\| ([A-Z0-9_]+) \| ([a-z0-9_ ~?]+) \|$", page.read_text(), re.MULTILINE)
    return {keyword: words.split() for keyword, words in rows}


NAMES = attribute_names()


def arguments(text):
    """Those of an entity's list, as texts."""
    parts, depth, begin, quoted = [], 0, 0, False
    for i, c in enumerate(text):
        quoted = quoted != (c == "'")
        if quoted:
            continue
        depth += (c == "(") - (c == ")")
        if depth == 0 and c == ",":
            parts.append(text[begin:i])
            begin = i + 1
    return parts + [text[begin:]]


def other_value(value, r):
    if r.random() < 0.5:
        return "()" if value.startswith("(") else "$"
    if value in OTHER:
        return OTHER[value]
    if re.fullmatch(r"[-+0-9.E]*\.[-+0-9.E]*", value):
        return f"{float(value) * 1.2 + 0.07:.9f}"
    if value.isdigit():
        return str(int(value) + 1)
    if value.startswith("(") and re.fullmatch(r"\([-0-9., ]+\)", value):
        numbers = value[1:-1].split(",")
        i = r.randrange(len(numbers))
        numbers[i] = f"{float(numbers[i]) + 0.7:.9f}"
        return "(" + ",".join(numbers) + ")"
    return "()" if value.startswith("(") else "$"


def mutant(text, r):
    """The text with one attribute changed, and which."""
    lines = text.split("\n")
    first = lines.index("DATA;") + 1
    while True:
        i = r.randrange(first, len(lines))
        found = re.fullmatch(r"(#\d+)=([A-Z0-9_]+)\((.*)\);", lines[i])
        if not found:
            continue
        values = arguments(found[3])
        j = r.randrange(len(values))
        if values[j] in ("$", "", "()", "''"):
            continue
        words = NAMES.get(found[2], [])
        name = words[j] if j < len(words) else f"argument {j + 1}"
        other = other_value(values[j], r)
        if other == values[j]:
            continue
        was, values[j] = values[j], other
        lines[i] = f"{found[1]}={found[2]}({','.join(values)});"
        return "\n".join(lines), f"{found[2]}.{name} {found[1]}: {was} -> {other}"


def moves(program):
    """Without comments, which name files and times."""
    return [line for line in re.sub(r"\([^)]*\)", "", program).split("\n") if line.strip()]


class StepNcBench(Bench):
    def programs(self, base, count):
        """Of each set-up; nothing where none was written."""
        files = [base.with_suffix(".ngc")] if count == 1 else [base.parent / f"{base.name}-{i + 1}.ngc" for i in range(count)]
        return files, [f.read_text() if f.exists() else None for f in files]

    def plan_text(self, text, name, count, more=()):
        """Verdict, programs and all that is said of a text."""
        base = self.folder / name
        base.with_suffix(".p21").write_text(text)
        files, _ = self.programs(base, count)
        for file in files:
            file.unlink(missing_ok=True)
        verdict, said = self.run(["plan", str(base.with_suffix(".p21")), "-o", str(base.with_suffix(".ngc")), *WORDS, *more])
        # That of all set-ups comes last.
        verdict = (re.findall(r"verdict: (\w+)", said) or [verdict])[-1]
        return verdict, self.programs(base, count)[1], said

    def file(self, seed, mutants):
        program = Program(seed)
        text, count = program.text(), len(program.setups)
        base = f"s{seed}"
        verdict, made, said = self.plan_text(text, base, count)
        line = {"seed": seed, "unit": program.file.unit.name, "kinds": [s.kinds for s in program.setups], "plan": verdict, "field": [],
                "silent": [], "seen": 0, "again": ""}
        if verdict != "CLEAN":
            line["said"] = [x.strip()[:300] for x in said.split("\n") if re.match(r"  [a-z -]+[a-z]: |  condition |clearcut: ", x)][:8]
        for s, ngc, text_of in zip(program.setups, self.programs(self.folder / base, count)[0], made):
            description = self.folder / f"{base}_{s.number}.made"
            description.write_text(s.description())
            line["field"].append(self.field(str(description), [str(ngc)])[0] if text_of else "NO PROGRAM")
        self.mutate(text, (verdict, made, said), count, mutants, random.Random(seed + 1), line)
        if verdict in ("CLEAN", "CONDITIONAL"):
            line["again"] = self.again(base, count, made)
        if verdict == "CLEAN" and not any(line["field"]) and line["again"] in ("same", "refused"):
            for path in self.folder.glob(f"{base}[._-]*"):
                path.unlink()
        return line

    def mutate(self, text, before, count, mutants, r, line):
        for _ in range(mutants):
            changed, what = mutant(text, r)
            after = self.plan_text(changed, "mutant", count)
            if after[0] in ("CRASHED", "HUNG"):
                line["silent"].append(f"{after[0]} {what}")
            elif self.told(after) == self.told(before) and ".~" not in what:
                line["silent"].append(what)
            else:
                line["seen"] += 1

    def told(self, outcome):
        """What a person sees, without names of files."""
        verdict, programs, said = outcome
        plain = [re.sub(r"\([^)]*[.]p21[^)]*\)", "", p) if p else "" for p in programs]
        return verdict, plain, re.sub(re.escape(str(self.folder)) + r"/\w+", "", said)

    def again(self, base, count, made):
        """Whether the file with its toolpaths gives the same moves."""
        written = self.folder / f"{base}_paths.p21"
        verdict, said = self.run(["convert", str(self.folder / f"{base}.p21"), "-o", str(written), "--with-toolpaths"])
        if not written.exists():
            return "refused" if verdict == "REFUSED" else verdict
        second, programs, said = self.plan_text(written.read_text(), f"{base}_again", count)
        if any(p is None for p in programs):
            return f"{second}: " + said[-300:]
        differ = [i + 1 for i, (a, b) in enumerate(zip(made, programs)) if moves(a) != moves(b)]
        return "same" if not differ else f"moves differ in set-ups {differ}"


def main():
    asked = asked_of(__doc__, "files", 300, 4)
    bench = StepNcBench(asked.clearcut, asked.judge, asked.folder)
    lines = judged(asked, asked.folder / "stepnc.jsonl", lambda seed: bench.file(seed, asked.mutants))
    counts, bad = collections.Counter(), False
    for line in lines:
        wrong = any(line["field"])
        counts["plans", line["plan"] + (", wrong by the field" if wrong else ", right by the field")] += 1
        counts["written back", line["again"].split(":")[0] or "not tried"] += 1
        counts["attributes", "seen"] += line["seen"]
        counts["attributes", "not seen"] += len(line["silent"])
        crashed = any(word.startswith(("CRASHED", "HUNG")) for word in line["silent"])
        if line["plan"] != "CLEAN" or wrong or crashed or line["again"] not in ("same", "refused"):
            bad = True
            print(line["seed"], line["plan"], line["field"], line["again"], line.get("said", ""))
    for (what, said), count in sorted(counts.items()):
        print(f"{count:6} {what}: {said}")
    return 1 if bad or not lines else 0


if __name__ == "__main__":
    sys.exit(main())
