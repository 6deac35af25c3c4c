#!/usr/bin/env python3
"""Changes every number, or every term, in the sources of the published methods by 1 %, one at a time, and expects a quick test to fail.

Usage: scripts/mutate_constants.py [--build FOLDER] [--terms] [--list] [--first N] [--last N] [--sample N [--seed S]] [SOURCE...]

The numbers are found in the sources listed below; terms are the names and calls of floating point beside + - * /. --sample draws some of
them. scripts/mutants.sh has the changes of defaults in headers. The test
programs must be built. The sources stay as they are: a changed copy is compiled with the flags of the build folder and linked in
front of the libraries, so that a change takes seconds. Where the build joins the sources of a folder, a change that survives is tried
again with the whole folder. A whole number of which 1 % is cut off is changed by one. Numbers that are none of a method
(indexes, counts, rounding) are left out; scripts/mutate_constants.json names their lines, each with its reason.
Exit code 1 if a change survives.
"""
import argparse
import json
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# A name, member or call without nested brackets, before or after an operator.
TERM = re.compile(r"(?:(?<=[-+*/] )|(?<=[-+*/]= )|(?=[\w.:>()-]+(?:\([^()]*\))? [-+*/] ))"
                  r"(?<![\w.:>])((?:[A-Za-z_]\w*(?:::|\.|->))*[A-Za-z_]\w*(?:\([^()]*\))?)(?![\w(.:]|->)")
# Takes numbers with a point alone: counts and indexes do not compile.
GROWN = "#include <concepts>\ntemplate <std::floating_point T> constexpr T grown_by_one_percent(T x) { return T(1.01) * x; }\n#line 1\n"
NUMBER = re.compile(r"(?<![\w.\"{%:'])(\d+\.?\d*(?:e-?\d+)?)(?![\w\"'])")
PUBLISHED = ("pipeline_test", "PublishedConstants.*:Engagement*:MachineTime.*")
GRID = ("tests/system_test", "*Interpolator*:*Reduction*:*Table1*:EdgePointSearch*:ElementJob*")
# Source -> programs of tests, each with its filter.
SOURCES = {
    "src/plan/contour/formulas.cpp": [("plan_test", "Formulas.*:SideOffsets.*:StepRule.*")],
    "src/plan/contour/side_offsets.cpp": [("plan_test", "Formulas.*:SideOffsets.*:StepRule.*:Mitred*")],
    "src/plan/contour/step_rule.cpp": [("plan_test", "Formulas.*:StepRule.*")],
    "src/kinematics/kinematics.cpp": [("kinematics_test", "*")],
    "src/order/objective.cpp": [PUBLISHED, ("order_test", "Objective.*:Problem.*:TurnAngle.*")],
    "src/plan/contour/published_rings.cpp": [("plan_test", "CornerLoop.*:Passages.*:MitredRings.*:MitredInset.*")],
    "src/order/moves.cpp": [("order_test", "Moves.*:TurnAngle.*:Problem.*")],
    "src/order/genetic/genetic.cpp": [("order_test", "Genetic.*")],
    "src/order/genetic/operator_context.cpp": [("order_test", "OperatorsOfTheReview.*:Mutation.*:LegalNeighbours.*")],
    "src/order/genetic/operators.cpp": [("order_test", "OperatorsOfTheReview.*:Mutation.*:LegalNeighbours.*")],
    "src/order/genetic/crossover/by_position.cpp": [("order_test", "Crossover.*:OperatorsOfTheReview.*")],
    "src/order/genetic/crossover/by_adjacency.cpp": [("order_test", "Crossover.*:OperatorsOfTheReview.*")],
    "src/order/genetic/pool.cpp": [("order_test", "Genetic.*:FirstPopulation.*:NearestPath.*")],
    "src/order/genetic/selection.cpp": [("order_test", "Selection.*")],
    "src/pipeline/tour/engagement_model.cpp": [PUBLISHED],
    "src/pipeline/tour/tour.cpp": [PUBLISHED, ("pipeline_test", "Tour*:PublishedGridPlan.*")],
    "src/pipeline/tour/tour_solver.cpp": [PUBLISHED, ("pipeline_test", "Tour*:PublishedGridPlan.*")],
    "src/pipeline/tool_sets.cpp": [PUBLISHED, ("pipeline_test", "Tool*")],
    "src/plan/grid/interpolate.cpp": [PUBLISHED, GRID],
    "src/plan/grid/visit.cpp": [PUBLISHED, GRID],
    "src/plan/grid/shape.cpp": [PUBLISHED, GRID],
    "src/plan/tour/lattice.cpp": [PUBLISHED, ("plan_test", "PlanTour.*")],
    "studies/genetic/genetic_study.cpp": [("studies_test", "GeneticStudy.*")],
    "studies/reproduce/reproduce_published.cpp": [("studies_test", "PublishedFishhead.*:Reproduction.*:Texts.*")],
    "studies/genetic/study_claims.cpp": [("studies_test", "StudyClaims.*")],
}
# Source -> regular expression of a line -> why its numbers are none of a method.
LEFT_OUT = {}
LEFT_OUT_FILE = ROOT / "scripts/mutate_constants.json"


class Build:
    """The commands of a build folder."""

    def __init__(self, folder):
        self.folder = folder
        self.entries = json.loads((folder / "compile_commands.json").read_text())
        self.links = {}

    def compile_command(self, source, changed, out):
        """Of one changed source alone, by the flags of its module."""
        module = "studies" if source.startswith("studies/") else source.split("/")[1]
        words = shlex.split(self.entry_of(source, module)["command"])
        words = words[: words.index("-o")]
        return words + ["-Wno-error", "-w", "-o", str(out), "-c", str(changed)]

    def entry_of(self, source, module):
        for entry in self.entries:
            if entry["file"].endswith("/" + source):
                return entry
        for entry in self.entries:
            if f"/clearcut_{module}.dir/Unity/" in entry["file"]:
                return entry
        raise SystemExit(f"{source}: is in no library of {self.folder}")

    def unity_of(self, source):
        """The joined source that holds it, if there is one."""
        for entry in self.entries:
            if "/Unity/" in entry["file"] and f"/{source}\"" in pathlib.Path(entry["file"]).read_text():
                return pathlib.Path(entry["file"])
        return None

    def link_command(self, program, changed, out):
        if program not in self.links:
            lines = subprocess.run(["ninja", "-C", str(self.folder), "-t", "commands", program], capture_output=True,
                                   text=True, check=True).stdout.splitlines()
            line = next(one for one in reversed(lines) if f" -o {program} " in one)
            self.links[program] = shlex.split(line[line.index("&& ") + 3 :].split(" && ")[0])
        words = list(self.links[program])
        words[words.index("-o") + 1] = str(out)
        return [words[0], str(changed), "-Wl,-z,muldefs"] + words[1:]


def run(words, folder, timeout=600):
    try:
        return subprocess.run(words, cwd=folder, capture_output=True, timeout=timeout).returncode
    except subprocess.TimeoutExpired:
        return 1  # a loop that no longer ends: the test would not pass


def code_of(line):
    """The line without comments; numbers in texts keep their places but are no numbers."""
    line = re.sub(r'"[^"]*"', lambda text: '"' + "_" * (len(text[0]) - 2) + '"', line)
    return "" if line.lstrip().startswith("#") else line.split("//")[0]


def reason_of(source, line):
    for pattern, reason in LEFT_OUT.get(source, {}).items():
        if re.search(pattern, line):
            return reason
    return ""


def mutants_of(source):
    """(line number, column, number) of every number other than 0 and 1."""
    for at, line in enumerate((ROOT / source).read_text().splitlines()):
        for match in NUMBER.finditer(code_of(line)):
            if float(match[0]) not in (0, 1):
                yield at, match.start(), match[0]


def terms_of(source):
    """(line number, column, term) of every name or call beside an operator."""
    for at, line in enumerate((ROOT / source).read_text().splitlines()):
        for match in TERM.finditer(code_of(line)):
            yield at, match.start(1), match[1]


def texts_of(number):
    """The number in double 1 % greater, for one without a point also the next whole one; a term that has grown by 1 %."""
    if not number[0].isdigit():
        return [f"grown_by_one_percent({number})"]
    greater = repr(float(number) * 1.01)
    return [greater] if "." in number or "e" in number else [greater, str(int(number) + 1)]


class Trial:
    def __init__(self, build, folder):
        self.build = build
        self.folder = pathlib.Path(folder)
        self.originals = {}

    def object_of(self, source, text, name):
        path = self.folder / name / pathlib.Path(source).name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        out = path.with_suffix(".o")
        code = run(self.build.compile_command(source, path, out), self.build.folder)
        return out if code == 0 else None

    def code_in(self, path):
        """All sections of an object file, without its name."""
        text = subprocess.run(["objdump", "-s", str(path)], capture_output=True, text=True).stdout
        return text.split("\n", 3)[-1]

    def is_killed(self, changed, tests):
        for program, names in tests:
            out = self.folder / program.replace("/", "_")
            if run(self.build.link_command(program, changed, out), self.build.folder) != 0:
                raise SystemExit(f"{program} does not link")
            if run([str(out), "--gtest_brief=1", f"--gtest_filter={names}"], self.folder) != 0:
                return True
        return False

    def survives_whole(self, source, text, tests):
        """With all sources of the folder joined, as the build compiles them."""
        unity = self.build.unity_of(source)
        if unity is None:
            return True
        changed = self.folder / "whole" / pathlib.Path(source).name
        changed.parent.mkdir(exist_ok=True)
        changed.write_text(text)
        joined = changed.parent / unity.name
        joined.write_text(re.sub(rf'"[^"]*/{re.escape(source)}"', f'"{changed}"', unity.read_text()))
        entry = next(one for one in self.build.entries if one["file"] == str(unity))
        words = shlex.split(entry["command"])
        words = words[: words.index("-o")] + ["-w", "-Wno-error", "-o", str(joined.with_suffix(".o")), "-c", str(joined)]
        return run(words, self.build.folder) != 0 or not self.is_killed(joined.with_suffix(".o"), tests)

    def verdict(self, source, at, column, number):
        lines = (ROOT / source).read_text().splitlines(keepends=True)
        if source not in self.originals:
            self.originals[source] = self.code_in(self.object_of(source, "".join(lines), "one"))
        for changed in texts_of(number):
            line = lines[at][:column] + changed + lines[at][column + len(number) :]
            text = ("" if number[0].isdigit() else GROWN) + "".join(lines[:at] + [line] + lines[at + 1 :])
            made = self.object_of(source, text, "one")
            if made is None:
                continue  # 1 % more is no value there
            if self.code_in(made) == self.originals[source]:
                continue  # cut off again
            if self.is_killed(made, SOURCES[source]) or not self.survives_whole(source, text, SOURCES[source]):
                return f"killed   {changed}"
            return f"SURVIVED {changed}"
        return "SAME     compiles to the same, or not at all"


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    asked.add_argument("--terms", action="store_true", help="change terms, not numbers")
    asked.add_argument("--sample", type=int, default=0, help="only so many, drawn by the seed")
    asked.add_argument("--seed", type=int, default=1)
    asked.add_argument("--list", action="store_true", help="only list the numbers")
    asked.add_argument("--first", type=int, default=1)
    asked.add_argument("--last", type=int, default=100000)
    asked.add_argument("sources", nargs="*")
    options = asked.parse_args()
    LEFT_OUT.update(json.loads(LEFT_OUT_FILE.read_text()))
    count = {"killed": 0, "SURVIVED": 0, "SAME": 0, "left out": 0}
    found = terms_of if options.terms else mutants_of
    changes = [(source, *change) for source in options.sources or SOURCES for change in found(source)]
    drawn = range(len(changes))
    if options.sample:
        drawn = sorted(random.Random(options.seed).sample(drawn, min(options.sample, len(changes))))
    with tempfile.TemporaryDirectory() as folder:
        trial = Trial(Build(options.build.resolve()), folder)
        for number_of in drawn:
            source, at, column, number = changes[number_of]
            if not options.first <= number_of + 1 <= options.last:
                continue
            line = (ROOT / source).read_text().splitlines()[at]
            reason = reason_of(source, line)
            if reason or options.list:
                verdict = f"left out ({reason})" if reason else ""
                count["left out"] += 1 if reason else 0
            else:
                verdict = trial.verdict(source, at, column, number)
                count[verdict.split()[0]] += 1
            print(f"{number_of + 1:3} {verdict:20} {source}:{at + 1}: {number}: {line.strip()}", flush=True)
    print(", ".join(f"{number} {name}" for name, number in count.items()))
    return 1 if count["SURVIVED"] else 0


if __name__ == "__main__":
    sys.exit(main())
