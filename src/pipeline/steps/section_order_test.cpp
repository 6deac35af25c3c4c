#include "pipeline/steps/section_order.h"

#include <gtest/gtest.h>

#include <set>

#include "base/random.h"

namespace clearcut::pipeline {
namespace {

/// A square path of the cutter about `center`, with one workingstep and one of two tools.
Section square_at(Vec2 center, double half, int workingstep, int tool) {
  Section section;
  section.workingstep = workingstep;
  section.tool_number = tool + 1;
  const Vec2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  for (int i = 0; i < 4; ++i) {
    section.moves.push_back({Edge::line(center + corners[i], center + corners[(i + 1) % 4]), -1, -1,
                             MoveKind::kCut, MmPerMin::of(1000), 0});
  }
  return section;
}

struct Job {
  Part part;
  std::vector<Section> sections;
};

Job random_job(std::uint64_t seed, int count, double half) {
  Random random(seed);
  Job job;
  job.part.tools.resize(2);
  job.part.tools[0].diameter = job.part.tools[1].diameter = 4;
  for (int i = 0; i < count; ++i) {
    const int tool = static_cast<int>(random.below(2));
    Workingstep step;
    step.operation.tool = tool;
    job.part.workplan.push_back(step);
    job.sections.push_back(square_at({300 * random.unit(), 300 * random.unit()}, half, i, tool));
  }
  return job;
}

double rapids(const std::vector<Section>& sections) {
  double sum = 0;
  for (std::size_t i = 1; i < sections.size(); ++i)
    sum += distance(sections[i - 1].moves.back().path.to, sections[i].moves.front().path.from);
  return sum;
}

int tool_changes(const std::vector<Section>& sections) {
  int changes = 0;
  for (std::size_t i = 1; i < sections.size(); ++i)
    changes += sections[i].tool_number != sections[i - 1].tool_number ? 1 : 0;
  return changes;
}

bool may_meet(const Section& a, const Section& b) {
  Box boxes[2];
  for (int i = 0; i < 2; ++i) {
    for (const Move& move : (i == 0 ? a : b).moves) boxes[i].add(move.path.from);
  }
  return boxes[0].grown(2).overlaps(boxes[1].grown(2));
}

TEST(SectionOrder, HasEachSectionOnceAndKeepsTheOrderOfThoseThatMayMeet) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Job job = random_job(seed, 5 + static_cast<int>(seed), 12);
    const auto ordered = in_short_order(job.sections, job.part);
    std::set<int> steps;
    for (const Section& section : ordered) steps.insert(section.workingstep);
    EXPECT_EQ(steps.size(), job.sections.size());
    EXPECT_EQ(ordered.size(), job.sections.size());
    for (std::size_t i = 0; i < ordered.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!may_meet(ordered[i], ordered[j])) continue;
        EXPECT_LT(ordered[j].workingstep, ordered[i].workingstep) << "seed " << seed;
      }
    }
    EXPECT_LE(tool_changes(ordered), tool_changes(job.sections)) << "seed " << seed;
  }
}

/// Holes of three depths mixed over a plate: each depth is drilled in one go where the control repeats its cycle.
TEST(SectionOrder, KeepsHolesAlikeTogetherWhereItIsAskedFor) {
  Random random(9);
  Job job;
  job.part.tools.resize(1);
  for (int i = 0; i < 18; ++i) {
    job.part.workplan.emplace_back();
    const Vec2 at{300 * random.unit(), 300 * random.unit()};
    const Edge place = Edge::line(at, at);
    const double depth = -1.0 - i % 3;
    Section section;
    section.workingstep = i;
    section.tool_number = 1;
    section.moves = {{place, 5, depth, MoveKind::kPlunge, MmPerMin::of(100), 0},
                     {place, depth, 5, MoveKind::kRapid, {}, 0}};
    job.sections.push_back(section);
  }
  const auto changes = [](const std::vector<Section>& sections) {
    int count = 0;
    for (std::size_t i = 1; i < sections.size(); ++i)
      count += sections[i].moves[0].z_to != sections[i - 1].moves[0].z_to ? 1 : 0;
    return count;
  };
  const auto together = in_short_order(job.sections, job.part, true);
  EXPECT_EQ(together.size(), job.sections.size());
  EXPECT_EQ(changes(together), 2);
  EXPECT_GT(changes(in_short_order(job.sections, job.part)), 4);
  EXPECT_LT(rapids(together), rapids(job.sections));
}

TEST(SectionOrder, PutsSeparateHolesInAThirdOfTheRapidsAndTwoTurnsOfTools) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Job job = random_job(seed, 120, 0.01);
    const auto ordered = in_short_order(job.sections, job.part);
    EXPECT_LT(rapids(ordered), rapids(job.sections) / 3) << "seed " << seed;
    EXPECT_LE(tool_changes(ordered), 5) << "seed " << seed;
    const auto again = in_short_order(job.sections, job.part);
    for (std::size_t i = 0; i < ordered.size(); ++i) EXPECT_EQ(again[i].workingstep, ordered[i].workingstep);
  }
}

/// The fewest changes of any order, section by section over all subsets.
int fewest_changes(const std::vector<Section>& sections) {
  const std::size_t count = sections.size(), all = (std::size_t{1} << count) - 1;
  constexpr int kNever = 1000;
  std::vector<std::vector<int>> least(all + 1,
                                      std::vector<int>(count, kNever));  // by what is cut, and what was last
  int best = kNever;
  for (std::size_t cut = 0; cut <= all; ++cut) {
    for (std::size_t i = 0; i < count; ++i) {
      bool ready = (cut >> i & 1) == 0;
      for (std::size_t j = 0; j < i; ++j)
        ready = ready && ((cut >> j & 1) != 0 || !may_meet(sections[i], sections[j]));
      if (!ready) continue;
      int& with = least[cut | std::size_t{1} << i][i];
      if (cut == 0) with = 0;
      for (std::size_t last = 0; last < count; ++last)
        with = std::min(with,
                        least[cut][last] + (sections[last].tool_number != sections[i].tool_number ? 1 : 0));
    }
  }
  for (const int changes : least[all]) best = std::min(best, changes);
  return best;
}

TEST(SectionOrder, ChangesToolsAsRarelyAsTheKeptOrderAllows) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Job job = random_job(seed, 9, 45);
    Random random(seed + 1000);
    job.part.tools.resize(4, job.part.tools[0]);
    for (Section& section : job.sections) {
      const int tool = static_cast<int>(random.below(4));
      section.tool_number = tool + 1;
      job.part.workplan[static_cast<std::size_t>(section.workingstep)].operation.tool = tool;
    }
    EXPECT_EQ(tool_changes(in_short_order(job.sections, job.part)), fewest_changes(job.sections))
        << "seed " << seed;
  }
}

TEST(SectionOrder, LeavesNothingAndOneAsTheyAre) {
  EXPECT_TRUE(in_short_order({}, Part{}).empty());
  const Job job = random_job(1, 1, 1);
  EXPECT_EQ(in_short_order(job.sections, job.part).size(), 1u);
}

}  // namespace
}  // namespace clearcut::pipeline
