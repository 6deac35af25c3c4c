// Parts of several kinds on one sheet: what the text of the one program makes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "base/random.h"
#include "pipeline/check.h"
#include "pipeline/copies.h"
#include "pipeline/job_options.h"
#include "pipeline/test_drawings.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

Part drawn_as(const std::string& file, const std::string& entities) {
  return read::read_part_text(drawing(entities), file, {});
}

/// A plate that is cut out, with a pocket and a hole; its box is from 0, 0 to `width`, `height`.
Part cut_out(const std::string& file, double width, double height) {
  return drawn_as(file, box("OUTSIDE_D6", 0, 0, width, height) +
                            rounded_box("POCKET_D2", 6, 6, width - 14, height - 6, 3) +
                            circle("DRILL_D6", {width - 7, height / 2}, 2));
}

/// A block with a pocket, which stays whole.
Part block_with_pocket(const std::string& file, double width, double height) {
  return drawn_as(file, box("STOCK_D6", 0, 0, width, height) +
                            rounded_box("POCKET_D3", 4, 5, width - 4, height - 5, 3.5));
}

/// Holes alone.
Part block_with_holes(const std::string& file, double width, double height) {
  return drawn_as(file, box("STOCK_D6", 0, 0, width, height) + circle("DRILL_D6", {6, 6}, 2) +
                            circle("DRILL_D5", {width - 6, height - 6}, 2));
}

PlanOptions on_sheet(const std::string& sheet, std::optional<double> gap = 8) {
  PlanOptions options = with({"endmill:4", "drill:4"});
  options.copies.sheet = sheet;
  options.copies.gap = gap;
  options.copies.edge = 6;
  options.accept = {"loose-part"};
  return options;
}

NestedPart nested(Part part, std::optional<int> count) {
  NestedPart one;
  one.part = std::move(part);
  one.count = count;
  return one;
}

std::size_t stays_of_tools(const Toolpath& toolpath) {
  std::size_t stays = 0;
  for (std::size_t i = 0; i < toolpath.sections.size(); ++i)
    stays += i == 0 || toolpath.sections[i].tool_number != toolpath.sections[i - 1].tool_number ? 1 : 0;
  return stays;
}

/// The place, from 1, of a section of the sheet.
int place_of(const Section& section, const Part& sheet) {
  const std::string& name =
      feature_of(sheet, sheet.workplan[static_cast<std::size_t>(section.workingstep)]).name;
  return std::atoi(name.substr(name.rfind('.') + 1).c_str());
}

/// The sections of one place.
Toolpath cut_back(const PlanResult& sheet, int place) {
  Toolpath one;
  for (const Section& section : sheet.planned.sections)
    if (place_of(section, sheet.part) == place) one.sections.push_back(section);
  return one;
}

/// Moved by `by`, then, where it was turned by a quarter to the left, turned back.
Toolpath moved(Toolpath toolpath, Vec2 by, bool turn_back) {
  const auto placed = [&](Vec2 p) {
    const Vec2 q = p + by;
    return turn_back ? Vec2{q.y, -q.x} : q;
  };
  for (Section& section : toolpath.sections) {
    for (Move& move : section.moves) {
      move.path.from = placed(move.path.from);
      move.path.to = placed(move.path.to);
      if (move.path.is_arc()) move.path.center = placed(move.path.center);
    }
  }
  return toolpath;
}

/// What mills one part where it was drawn: its box begins at 0, 0.
std::string program_at_home(const PlanResult& sheet, int place, const Part& alone) {
  const PlaceMade& made = sheet.copies->places[static_cast<std::size_t>(place) - 1];
  const Vec2 corner = made.turned ? Vec2{made.taken.max.x, made.taken.min.y} : made.taken.min;
  Toolpath home = moved(cut_back(sheet, place), Vec2{0, 0} - corner, made.turned);
  int first = std::numeric_limits<int>::max();
  for (const Section& section : home.sections) first = std::min(first, section.workingstep);
  for (Section& section : home.sections) section.workingstep -= first;
  return post::write_program(home, alone, {});
}

/// The program of the sheet in which the part of one place is treated.
template <typename Treat>
std::string program_with(const PlanResult& sheet, int place, const Treat& treat) {
  Toolpath other;
  for (const Section& section : sheet.planned.sections) {
    if (place_of(section, sheet.part) != place) {
      other.sections.push_back(section);
      continue;
    }
    for (Section& one : treat(Toolpath{{section}}).sections) other.sections.push_back(std::move(one));
  }
  return post::write_program(other, sheet.part, {});
}

bool lies_apart(const Box& a, const Box& b, double gap) {
  constexpr double kPrinted = 2e-3;
  return a.min.x >= b.max.x + gap - kPrinted || b.min.x >= a.max.x + gap - kPrinted ||
         a.min.y >= b.max.y + gap - kPrinted || b.min.y >= a.max.y + gap - kPrinted;
}

void expect_apart_on_sheet(const CopiesMade& made, double edge, const Box& sheet) {
  for (std::size_t i = 0; i < made.places.size(); ++i) {
    const Box& one = made.places[i].taken;
    EXPECT_TRUE(one.min.x >= sheet.min.x + edge - 1e-6 && one.min.y >= sheet.min.y + edge - 1e-6 &&
                one.max.x <= sheet.max.x - edge + 1e-6 && one.max.y <= sheet.max.y - edge + 1e-6);
    for (std::size_t k = 0; k < i; ++k) EXPECT_TRUE(lies_apart(one, made.places[k].taken, made.gap));
  }
}

TEST(NestOfKinds, EachKindIsMadeAndEachToolComesOnce) {
  PlanOptions options = on_sheet("220x140");
  options.copies.count = 3;
  options.nested = {nested(block_with_pocket("lid.dxf", 30, 24), 2),
                    nested(block_with_holes("bar.dxf", 60, 14), {})};
  const Part first = cut_out("plate.dxf", 50, 34);
  const PlanResult planned = plan_part(first, options);
  EXPECT_EQ(verdict_of(planned.findings), Verdict::kClean) << faults_of(planned.findings);
  ASSERT_TRUE(planned.copies);
  const CopiesMade& made = *planned.copies;
  ASSERT_EQ(made.kinds.size(), 3U);
  EXPECT_EQ(made.kinds[0].name, "plate.dxf");
  EXPECT_EQ(made.kinds[0].parts, 3);
  EXPECT_EQ(made.kinds[1].parts, 2);
  EXPECT_GT(made.kinds[2].parts, 1);
  EXPECT_EQ(made.kinds[2].clean_parts, made.kinds[2].parts);
  EXPECT_EQ(made.clean_parts, made.parts);
  EXPECT_FALSE(made.misses());
  EXPECT_EQ(stays_of_tools(planned.toolpath), 2U);
  const CheckResult read = check_program(first, planned.program, "sheet.ngc", options);
  EXPECT_EQ(verdict_of(read.findings), Verdict::kClean) << faults_of(read.findings);
  ASSERT_TRUE(read.copies);
  EXPECT_EQ(read.copies->clean_parts, made.parts);
  EXPECT_EQ(read.copies->kinds[1].clean_parts, 2);
}

/// More by hand: CLEARCUT_RANDOM_PARTS=200.
int random_nests() {
  const char* const asked = std::getenv("CLEARCUT_RANDOM_PARTS");
  return asked ? std::max(1, std::atoi(asked) / 10) : 2;
}

struct RandomSet {
  std::vector<Part> kinds;
  std::vector<std::optional<int>> counts;
};

RandomSet random_set(Random& random) {
  RandomSet set;
  const int kinds = 2 + static_cast<int>(random.between(0, 2.99));
  for (int k = 0; k < kinds; ++k) {
    const double width = random.between(36, 60), height = random.between(24, 40);
    const std::string file = fmt::format("kind{}.dxf", k);
    const double kind = random.unit();
    set.kinds.push_back(kind < 0.4   ? cut_out(file, width, height)
                        : kind < 0.7 ? block_with_pocket(file, width, height)
                                     : block_with_holes(file, width, height));
    set.counts.push_back(random.unit() < 0.7 ? std::optional(1 + static_cast<int>(random.between(0, 1.99)))
                                             : std::nullopt);
  }
  return set;
}

/// Each place of the sheet's program, cut back and moved home, mills its part as the part alone is milled.
void expect_parts_at_home(const PlanResult& sheet, const RandomSet& set, const PlanOptions& alone) {
  for (std::size_t k = 0; k < sheet.copies->places.size(); ++k) {
    const Part& part = set.kinds[sheet.copies->places[k].kind];
    const std::string program = program_at_home(sheet, static_cast<int>(k) + 1, part);
    const CheckResult home = check_program(part, program, "home.ngc", alone);
    EXPECT_EQ(verdict_of(home.findings), Verdict::kClean) << k << " " << faults_of(home.findings);
  }
}

/// A sheet on which the part of one place is not cut, or is cut beside its place, is at fault for that part.
void expect_faults_seen(const PlanResult& sheet, const Part& first, const PlanOptions& asked, int place) {
  const std::string name = fmt::format(".{}", place);
  const auto clean_but_one = [&](const std::string& program) {
    const CheckResult read = check_program(first, program, "sheet.ngc", asked);
    EXPECT_EQ(verdict_of(read.findings), Verdict::kFaulty);
    bool is_named = false;
    for (const Fault& fault : read.findings.faults)
      is_named = is_named || fault.feature.find(name) != std::string::npos;
    EXPECT_TRUE(is_named) << faults_of(read.findings);
    return read.copies->clean_parts;
  };
  EXPECT_EQ(clean_but_one(program_with(sheet, place, [](const Toolpath&) { return Toolpath{}; })),
            sheet.copies->parts - 1);
  EXPECT_LT(clean_but_one(program_with(sheet, place,
                                       [](const Toolpath& one) {
                                         return moved(one, {0.3, 0}, false);
                                       })),
            sheet.copies->parts);
}

TEST(NestOfKinds, RandomSetsAreMadeAsEachPartIsAlone) {
  Random random(77);
  for (int round = 0; round < random_nests(); ++round) {
    SCOPED_TRACE(round);
    const RandomSet set = random_set(random);
    PlanOptions options =
        on_sheet(fmt::format("{:.0f}x{:.0f}", random.between(180, 260), random.between(130, 180)));
    const PlanOptions alone = [&] {
      PlanOptions one = options;
      one.copies = {};
      return one;
    }();
    options.copies.count = set.counts[0];
    for (std::size_t k = 1; k < set.kinds.size(); ++k)
      options.nested.push_back(nested(set.kinds[k], set.counts[k]));
    const PlanResult sheet = plan_part(set.kinds[0], options);
    ASSERT_TRUE(sheet.copies);
    EXPECT_EQ(verdict_of(sheet.findings), Verdict::kClean) << faults_of(sheet.findings);
    expect_apart_on_sheet(*sheet.copies, 6, sheet.copies->sheet);
    int parts = 0;
    for (std::size_t k = 0; k < set.kinds.size(); ++k) {
      const KindMade& kind = sheet.copies->kinds[k];
      EXPECT_LE(kind.parts, set.counts[k].value_or(kind.parts));
      EXPECT_EQ(kind.clean_parts, kind.parts);
      EXPECT_EQ(verdict_of(plan_part(set.kinds[k], alone).findings), Verdict::kClean);
      parts += kind.parts;
    }
    EXPECT_EQ(parts, sheet.copies->parts);
    expect_parts_at_home(sheet, set, alone);
    const CheckResult read = check_program(set.kinds[0], sheet.program, "sheet.ngc", options);
    EXPECT_EQ(verdict_of(read.findings), Verdict::kClean) << faults_of(read.findings);
    expect_faults_seen(sheet, set.kinds[0], options,
                       1 + static_cast<int>(random.between(0, sheet.copies->parts - 0.01)));
  }
}

/// The pocket of the one kind that a cutter clears is not out of reach of the drill that the other kinds' program calls.
TEST(NestOfKinds, AKindWhoseToolIsNeverCalledIsAtFault) {
  PlanOptions options = on_sheet("220x130");
  options.copies.count = 2;
  options.nested = {nested(block_with_pocket("lid.dxf", 36.5, 29.5), 1)};
  const Part first = block_with_holes("bar.dxf", 39, 25.6);
  const PlanResult sheet = plan_part(first, options);
  EXPECT_EQ(verdict_of(sheet.findings), Verdict::kClean) << faults_of(sheet.findings);
  ASSERT_TRUE(sheet.copies);
  for (std::size_t k = 0; k < sheet.copies->places.size(); ++k)
    if (sheet.copies->places[k].kind == 1) expect_faults_seen(sheet, first, options, static_cast<int>(k) + 1);
}

/// A part with too narrow a place for its tools is at fault alone, and so is each place of it on a sheet, and no other.
TEST(NestOfKinds, AKindThatIsFaultyAloneIsFaultyOnTheSheet) {
  PlanOptions options = on_sheet("200x120");
  const Part narrow = drawn_as(
      "narrow.dxf",
      box("STOCK_D6", 0, 0, 40, 30) +
          outline(
              "POCKET_D2",
              {{{5, 5}}, {{15, 5}}, {{15, 14}}, {{35, 14}}, {{35, 17}}, {{15, 17}}, {{15, 25}}, {{5, 25}}}));
  EXPECT_NE(verdict_of(plan_part(narrow, with({"endmill:4", "drill:4"})).findings), Verdict::kClean);
  options.copies.count = 1;
  options.nested = {nested(narrow, 2)};
  const PlanResult sheet = plan_part(block_with_pocket("lid.dxf", 40, 30), options);
  EXPECT_NE(verdict_of(sheet.findings), Verdict::kClean);
  ASSERT_TRUE(sheet.copies);
  EXPECT_EQ(sheet.copies->kinds[0].clean_parts, 1);
}

/// Calls of what the copies of each kind have in common cut what is cut without them.
TEST(NestOfKinds, SubprogramsMakeTheSameParts) {
  for (const char* dialect : {"linuxcnc", "fanuc", "haas", "heidenhain", "siemens"}) {
    SCOPED_TRACE(dialect);
    PlanOptions options = on_sheet("200x120");
    options.post.dialect = dialect;
    options.accept.push_back("blending");
    options.copies.count = 2;
    options.nested = {nested(block_with_pocket("lid.dxf", 30, 24), 3)};
    const Part first = cut_out("plate.dxf", 50, 34);
    const PlanResult plain = plan_part(first, options);
    options.copies.subprograms = true;
    const PlanResult called = plan_part(first, options);
    EXPECT_EQ(verdict_of(called.findings), verdict_of(plain.findings)) << faults_of(called.findings);
    EXPECT_EQ(called.copies->clean_parts, 5);
    EXPECT_LT(called.program.size(), plain.program.size());
    const CheckResult read = check_program(first, called.program, "sheet.ngc", options);
    EXPECT_EQ(faults_of(read.findings), "");
    EXPECT_EQ(read.copies->clean_parts, 5);
  }
}

/// Tools of the kinds' own files: equal ones share a number, others get numbers of their own, and what is shared is said.
TEST(NestOfKinds, ToolsOfAllKindsAreInOneTable) {
  const auto with_tools = [](Part part, const std::vector<std::string>& tools) {
    for (const std::string& tool : tools) part.tools.push_back(resolve::parse_tool(tool));
    return part;
  };
  PlanOptions options = on_sheet("200x120");
  options.tools.clear();
  const Part first = with_tools(block_with_pocket("lid.dxf", 40, 30), {"endmill:5:T1"});
  options.copies.count = 1;
  options.nested = {nested(with_tools(cut_out("plate.dxf", 50, 34), {"endmill:4:T1", "drill:4:T2"}), 2),
                    nested(with_tools(block_with_holes("bar.dxf", 60, 14), {"drill:4:T7"}), 1)};
  const PlanResult planned = plan_part(first, options);
  EXPECT_EQ(faults_of(planned.findings), "");
  ASSERT_EQ(planned.part.tools.size(), 3U);
  EXPECT_EQ(planned.part.tools[0].number, 1);
  EXPECT_EQ(planned.part.tools[0].diameter, 5);
  EXPECT_EQ(planned.part.tools[2].number, 2 + 1);
  EXPECT_EQ(stays_of_tools(planned.toolpath), 3U);
  std::string said;
  for (const Diagnostic& one : planned.part.diagnostics.items()) said += one.where + " " + one.what + "\n";
  EXPECT_THAT(said, HasSubstr("T1 of this file is T"));
  const CheckResult read = check_program(first, planned.program, "sheet.ngc", options);
  EXPECT_EQ(faults_of(read.findings), "");
  EXPECT_EQ(read.copies->clean_parts, 4);
}

std::string nest_refusal(const Part& first, const PlanOptions& options) {
  try {
    plan_part(first, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(NestOfKinds, WhatCannotBeOnOneSheetIsRefused) {
  const Part first = block_with_pocket("lid.dxf", 40, 30);
  PlanOptions options = on_sheet("100x60");
  options.copies.count = 1;
  options.nested = {nested(block_with_holes("bar.dxf", 120, 14), 1)};
  EXPECT_THAT(nest_refusal(first, options), HasSubstr("not one part of bar.dxf, 120 by 14 mm, fits"));
  EXPECT_THAT(nest_refusal(first, options), HasSubstr("lid.dxf 1, bar.dxf 0"));
  options.nested = {
      nested(drawn_as("thin.dxf", box("STOCK_D3", 0, 0, 20, 20) + circle("DRILL_D3", {6, 6}, 2)), 1)};
  EXPECT_THAT(nest_refusal(first, options), HasSubstr("thin.dxf: is of material down to Z -3"));
  options.nested.clear();
  options.copies.with = {"bar.dxf:1"};
  EXPECT_THAT(nest_refusal(first, options), HasSubstr("bar.dxf:1 is not read"));
  options.copies = {.grid = "2x1", .with = {"bar.dxf"}};
  EXPECT_THAT(nest_refusal(first, options), HasSubstr("--nest-with: lies on a sheet that is filled"));
  EXPECT_FALSE(nested_file("bar.dxf:0"));
  EXPECT_FALSE(nested_file("bar.dxf:99999"));
  EXPECT_EQ(nested_file("C:\\a.dxf")->file, "C:\\a.dxf");
  EXPECT_EQ(nested_file("a.dxf:12")->count, 12);
}

/// An option that serves one of the kinds is none too many; one that serves none is refused.
TEST(NestOfKinds, OptionsServeOneKindAtLeast) {
  PlanOptions options = on_sheet("200x120");
  options.tabs.count = 2;
  options.copies.gap = 10;
  options.sources.set("tabs", {Origin::kUser, "--tabs"});
  options.copies.count = 1;
  options.nested = {nested(cut_out("plate.dxf", 50, 34), 1)};
  const Part first = block_with_pocket("lid.dxf", 40, 30);
  EXPECT_EQ(nest_refusal(first, options), "no refusal");
  options.nested = {nested(block_with_holes("bar.dxf", 60, 14), 1)};
  EXPECT_THAT(nest_refusal(first, options), HasSubstr("--tabs: has no effect"));
}

/// A folder with the files of further parts.
class FilesOfKinds : public ::testing::Test {
 protected:
  FilesOfKinds()
      : folder_(std::filesystem::path(::testing::TempDir()) / ("clearcut_nest_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    write("lid.dxf", drawing(box("STOCK_D6", 0, 0, 40, 30) + rounded_box("POCKET_D3", 4, 5, 36, 25, 3.5)));
  }
  ~FilesOfKinds() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  /// What is asked of the sheet of a job whose [plan] ends in `plan`, with the parts that it names.
  std::pair<Part, PlanOptions> asked(const std::string& plan) const {
    write("sheet.toml",
          "[part]\nfile = \"lid.dxf\"\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 4\n[plan]\n"
          "nest = \"200x100\"\ngap = 8\nedge = 6\ncount = 1\n" +
              plan);
    const JobFile job = read::read_job(path("sheet.toml"));
    std::pair<Part, PlanOptions> all{read::part_of_job(job, {}), options_of_job(job)};
    all.second.nested = read_nested_parts(all.second, job, {});
    all.second.threads = 1;
    return all;
  }
  std::string asked_refusal(const std::string& plan) const {
    try {
      asked(plan);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no refusal";
  }

 private:
  std::filesystem::path folder_;
};

/// A drawing is cut with the tools of the sheet's job, a job with its own.
TEST_F(FilesOfKinds, AreReadByTheJobOfTheSheetOrTheirOwn) {
  write("own.toml",
        "[part]\nfile = \"lid.dxf\"\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 5\n"
        "[plan]\nfeed = 700\n");
  const auto [part, options] = asked("feed = 900\nnest_with = [\"lid.dxf:1\", \"own.toml:2\"]\n");
  ASSERT_EQ(options.nested.size(), 2U);
  const PlanResult planned = plan_part(part, options);
  EXPECT_EQ(faults_of(planned.findings), "");
  EXPECT_EQ(planned.copies->parts, 4);
  EXPECT_EQ(planned.copies->kinds[2].name, "own.toml");
  ASSERT_EQ(planned.part.tools.size(), 2U);
  EXPECT_EQ(planned.part.tools[1].number, 2);
  EXPECT_THAT(planned.program, HasSubstr("F900"));
  EXPECT_THAT(planned.program, HasSubstr("F700"));
  const CheckResult read = check_program(part, planned.program, "sheet.ngc", options);
  EXPECT_EQ(faults_of(read.findings), "");
  EXPECT_EQ(read.copies->clean_parts, 4);
}

/// What a part's own job says of the whole plan is refused where the sheet is planned otherwise.
TEST_F(FilesOfKinds, MayNotStateAnotherSheet) {
  const std::string part =
      "[part]\nfile = \"lid.dxf\"\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 5\n";
  write("own.toml", part + "[plan]\ntabs = 3\n");
  EXPECT_THAT(asked_refusal("nest_with = [\"own.toml\"]\n"), HasSubstr("tabs: is of the whole sheet"));
  EXPECT_EQ(asked_refusal("tabs = 3\nnest_with = [\"own.toml\"]\n"), "no refusal");
  write("own.toml", part + "[machine]\nmax_feed = 500\n");
  EXPECT_THAT(asked_refusal("nest_with = [\"own.toml\"]\n"), HasSubstr("states another [machine]"));
  EXPECT_THAT(asked_refusal("nest_with = [\"none.dxf\"]\n"), HasSubstr("none.dxf"));
}

/// Fewer than are wanted: the rest is told by kind.
TEST(NestOfKinds, WhatIsMissingIsCountedByKind) {
  PlanOptions options = on_sheet("110x70");
  options.copies.count = 1;
  options.nested = {nested(block_with_pocket("lid.dxf", 40, 30), 5)};
  const PlanResult planned = plan_part(block_with_holes("bar.dxf", 80, 14), options);
  ASSERT_TRUE(planned.copies);
  EXPECT_TRUE(planned.copies->misses());
  EXPECT_EQ(planned.copies->kinds[0].missing(), 0);
  EXPECT_GT(planned.copies->kinds[1].missing(), 0);
}

}  // namespace
}  // namespace clearcut::pipeline
