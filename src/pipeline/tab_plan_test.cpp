// Tabs through the whole way: their shapes and places, what wrong programs are called, and heights by a second method.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "base/random.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

resolve::PlanOptions triangular(const std::string& tool, int count = 0) {
  resolve::PlanOptions options = with({tool});
  options.strategy = "contour";
  options.tabs.count = count;
  options.tabs.shape = TabShape::kTriangular;
  return options;
}

/// A straight stretch of a programmed path, mm.
struct Stroke {
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  bool rapid = false;
};

/// The words of one block that moves: modal positions, and the arc's centre from its start.
struct Words {
  int code = 0;
  double x = 0, y = 0, z = 0, i = 0, j = 0;
};

void add_arc(const Words& from, const Words& to, std::vector<Stroke>& strokes) {
  const double cx = from.x + to.i, cy = from.y + to.j, r = std::hypot(to.i, to.j);
  const double a0 = std::atan2(from.y - cy, from.x - cx);
  double turn = std::atan2(to.y - cy, to.x - cx) - a0;
  if (to.code == 3 && turn <= 1e-9) turn += 2 * kPi;
  if (to.code == 2 && turn >= -1e-9) turn -= 2 * kPi;
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn) * r / 0.02)));
  for (int k = 0; k < count; ++k) {
    const auto at = [&](int n) { return a0 + turn * n / count; };
    const auto z = [&](int n) { return from.z + (to.z - from.z) * n / count; };
    strokes.push_back({cx + r * std::cos(at(k)), cy + r * std::sin(at(k)), z(k), cx + r * std::cos(at(k + 1)),
                       cy + r * std::sin(at(k + 1)), z(k + 1), false});
  }
}

/// The path of a program in words of G0 to G3 and X, Y, Z, I, J, read without the software's reader.
std::vector<Stroke> strokes_of(const std::string& program) {
  std::vector<Stroke> strokes;
  Words at{0, 0, 0, 1000};
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '(' || line[0] == 'M' || line[0] == 'T') continue;
    Words next = at;
    next.i = next.j = 0;
    bool moves = false;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const double value = std::strtod(word.c_str() + 1, nullptr);
      if (word[0] == 'G' && value > 3) break;
      if (word[0] == 'G') next.code = static_cast<int>(value);
      if (word[0] == 'X') next.x = value;
      if (word[0] == 'Y') next.y = value;
      if (word[0] == 'Z') next.z = value;
      if (word[0] == 'I') next.i = value;
      if (word[0] == 'J') next.j = value;
      moves = moves || (word[0] >= 'X' && word[0] <= 'Z');
    }
    if (moves && next.code >= 2) add_arc(at, next, strokes);
    if (moves && next.code < 2) strokes.push_back({at.x, at.y, at.z, next.x, next.y, next.z, next.code == 0});
    at = next;
  }
  return strokes;
}

/// mm; how deep a flat cutter of radius r came over a place: the lowest point of what each stroke's cylinder covers.
double depth_at(Vec2 p, double r, const std::vector<Stroke>& strokes) {
  double low = std::numeric_limits<double>::infinity();
  for (const Stroke& s : strokes) {
    const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, all = dx * dx + dy * dy;
    const double fx = s.x0 - p.x, fy = s.y0 - p.y;
    if (all < 1e-18) {
      if (fx * fx + fy * fy < r * r) low = std::min({low, s.z0, s.z1});
      continue;
    }
    const double b = (fx * dx + fy * dy) / all, c = (fx * fx + fy * fy - r * r) / all;
    if (b * b <= c) continue;
    const double t0 = std::max(0.0, -b - std::sqrt(b * b - c)), t1 = std::min(1.0, -b + std::sqrt(b * b - c));
    if (t0 < t1) low = std::min({low, s.z0 + (s.z1 - s.z0) * t0, s.z0 + (s.z1 - s.z0) * t1});
  }
  return low;
}

/// A tab as it is found in the heights along one straight side.
struct Hill {
  double middle = 0;  ///< mm along the whole outline
  double foot = 0;    ///< mm
  double top = 0;
  double error = 0;  ///< mm; how far it is from a triangle at most
};

/// What stands along the middle of the kerf beside one side, `d` mm from it; `before`: mm of outline before the side.
std::vector<Hill> hills_beside(Vec2 from, Vec2 to, double d, double before, double floor, double steepness,
                               const std::vector<Stroke>& strokes) {
  constexpr double kStep = 0.05;
  const double all = std::hypot(to.x - from.x, to.y - from.y);
  const Vec2 way{(to.x - from.x) / all, (to.y - from.y) / all}, out{way.y, -way.x};
  std::vector<Hill> hills;
  std::vector<std::pair<double, double>> run;
  const auto finish = [&] {
    if (run.size() > 2) {
      Hill hill{before + (run.front().first + run.back().first) / 2, run.back().first - run.front().first};
      for (const auto& [s, z] : run) hill.top = std::max(hill.top, z - floor);
      for (const auto& [s, z] : run) {
        const double ideal = hill.top - steepness * std::abs(before + s - hill.middle);
        hill.error = std::max(hill.error, std::abs(std::max(0.0, ideal) - (z - floor)));
      }
      hills.push_back(hill);
    }
    run.clear();
  };
  for (double s = 0; s <= all; s += kStep) {
    const Vec2 p{from.x + way.x * s + out.x * d, from.y + way.y * s + out.y * d};
    const double z = depth_at(p, d, strokes);
    // Beside corners that point outwards the cutter goes round: there it never came over the place.
    if (std::isfinite(z) && z > floor + 0.012)
      run.emplace_back(s, z);
    else
      finish();
  }
  finish();
  return hills;
}

std::vector<Vec2> random_outline(Random& random) {
  std::vector<Vec2> points;
  const int count = 3 + static_cast<int>(random.between(0, 4.99));
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * (i + random.between(-0.2, 0.2)) / count, r = random.between(25, 45);
    points.push_back(
        {std::round(100 * r * std::cos(angle)) / 100, std::round(100 * r * std::sin(angle)) / 100});
  }
  return points;
}

std::string outline_of(const std::string& layer, const std::vector<Vec2>& points) {
  std::vector<BulgeVertex> vertices;
  for (const Vec2 p : points) vertices.push_back({p, 0});
  return outline(layer, vertices);
}

/// mm of the outline before each corner, and all of it.
std::vector<double> starts_of(const std::vector<Vec2>& points) {
  std::vector<double> starts{0};
  for (std::size_t i = 0; i < points.size(); ++i)
    starts.push_back(starts.back() + distance(points[i], points[(i + 1) % points.size()]));
  return starts;
}

/// The hills around an outline, in the order of the outline.
std::vector<Hill> hills_around(const std::vector<Vec2>& points, double r, double floor, double steepness,
                               const std::string& program) {
  const std::vector<Stroke> strokes = strokes_of(program);
  const std::vector<double> starts = starts_of(points);
  std::vector<Hill> hills;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 to = points[(i + 1) % points.size()];
    for (const Hill& hill : hills_beside(points[i], to, r, starts[i], floor, steepness, strokes))
      hills.push_back(hill);
  }
  return hills;
}

/// Right: along the middle of the kerf, in heights that come from the text of the program alone, there are as many triangles as were
/// asked for, of their width and height, and no farther apart than was asked for; nothing else stands. Cannot see: what stands
/// beside the middle, and in the corners.
TEST(TriangularTabs, StandAsAskedForInHeightsOfTheirOwn) {
  Random random(11);
  int seen = 0;
  for (int i = 0; i < 40; ++i) {
    const std::vector<Vec2> points = random_outline(random);
    const int mill = 2 + i % 5;
    auto options = triangular("endmill:" + std::to_string(mill), i % 2 == 0 ? 2 + i % 3 : 0);
    const double spacing = random.between(40, 90);
    if (i % 2 == 1) options.tabs.spacing = spacing;
    options.tabs.width = random.between(2, 6);
    options.tabs.height = random.between(0.5, 2.5);
    if (i % 3 == 0) options.stepdown = 1.1;
    if (i % 5 == 0) options.shop.finish = "walls";
    const double steepness = *options.tabs.height * 2 / options.tabs.width;
    try {
      const auto result = plan_part(drawn(outline_of("PROFILE_D4", points)), options);
      EXPECT_EQ(faults_of(result.findings), "") << i;
      const std::vector<Hill> hills = hills_around(points, mill / 2.0, -4, steepness, result.program);
      if (options.tabs.count > 0)
        EXPECT_EQ(static_cast<int>(hills.size()), options.tabs.count) << i;
      else
        ASSERT_GE(hills.size(), 2u) << i;
      for (std::size_t k = 0; k < hills.size(); ++k) {
        EXPECT_NEAR(hills[k].foot, options.tabs.width, 0.2 + 0.03 / steepness) << i;
        EXPECT_NEAR(hills[k].top, *options.tabs.height, 0.03 * steepness + 0.002) << i;
        EXPECT_LT(hills[k].error, 0.08 * steepness + 0.015) << i;
        const double round = starts_of(points).back();
        const double gap =
            k > 0 ? hills[k].middle - hills[k - 1].middle : hills[k].middle + round - hills.back().middle;
        EXPECT_LT(gap, options.tabs.spacing.value_or(round) + 0.1) << i;
      }
      ++seen;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("tabs of")) << i;
    }
  }
  EXPECT_GT(seen, 25);
}

/// On arcs, inside outlines, and through the material.
TEST(TriangularTabs, AreCleanOnArcsAndThrough) {
  for (const char* layer : {"INSIDE_D5", "PROFILE_D5"}) {
    for (const std::string& entities : {circle(layer, {3, 4}, 30), rounded_box(layer, 0, 0, 70, 50, 20)}) {
      for (const EntryKind entry : {EntryKind::kRamp, EntryKind::kHelix, EntryKind::kPlunge}) {
        auto options = triangular("endmill:4", 5);
        options.entry = entry;
        options.stepdown = 1.3;
        options.tabs.height = 1.7;
        if (entry == EntryKind::kHelix) options.lead = 1;
        const auto result = plan_part(drawn(entities), options);
        EXPECT_EQ(faults_of(result.findings), "") << layer;
        EXPECT_EQ(verdict_of(result.findings), Verdict::kClean) << layer;
      }
    }
  }
}

TEST(TriangularTabs, AreRisenOverWithoutAStop) {
  const auto result = plan_part(drawn(box("PROFILE_D6", 0, 0, 80, 50)), triangular("endmill:4", 4));
  EXPECT_EQ(faults_of(result.findings), "");
  // One way down and one way up for all four.
  const Section& section = result.toolpath.sections.back();
  EXPECT_EQ(std::count_if(section.moves.begin(), section.moves.end(),
                          [](const Move& move) { return is_rapid(move.kind) && move.z_to > move.z_from; }),
            1);
  for (const Move& move : section.moves) {
    const double down = move.z_from - move.z_to;
    if (move.kind != MoveKind::kCut || down <= 0) continue;
    EXPECT_LE(move.feed.mm_per_min() * down / move.length(), 301);
  }
}

/// Ways over square tabs: level, at the feed, on the height of a tab's top, between two passes that end beside it.
int feeds_over(const Section& section, const std::vector<Tab>& tabs) {
  return static_cast<int>(std::count_if(section.moves.begin(), section.moves.end(), [&](const Move& move) {
    return !is_rapid(move.kind) && !move.is_vertical() && move.z_from == move.z_to &&
           std::any_of(tabs.begin(), tabs.end(), [&](const Tab& tab) {
             return distance(move.path, tab.center) < 0.01 && std::abs(move.z_to - tab.top_z - 0.2) < 1e-9;
           });
  }));
}

/// On lines, on arcs bent either way, and in layers below each other.
TEST(SquareTabs, AreFedOverWithinTheKerf) {
  const std::string outlines[] = {box("PROFILE_D6", 0, 0, 80, 50), circle("PROFILE_D6", {0, 0}, 30),
                                  circle("INSIDE_D6", {0, 0}, 30),
                                  rounded_box("PROFILE_D6", 0, 0, 90, 60, 8)};
  for (const std::string& outline : outlines) {
    for (const EntryKind entry : {EntryKind::kPlunge, EntryKind::kRamp}) {
      resolve::PlanOptions options = triangular("endmill:4", 3);
      options.tabs.shape = TabShape::kSquare;
      options.entry = entry;
      const auto result = plan_part(drawn(outline), options);
      EXPECT_EQ(faults_of(result.findings), "");
      const Section& section = result.toolpath.sections.back();
      EXPECT_EQ(feeds_over(section, result.part.features.back().profile->tabs), 2);
      EXPECT_EQ(
          std::count_if(section.moves.begin(), section.moves.end(),
                        [](const Move& move) { return is_rapid(move.kind) && move.z_to > move.z_from; }),
          1);
    }
  }
}

TEST(TriangularTabs, WrongProgramsAreFaultyByName) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  const auto asked = triangular("endmill:4", 4);
  const auto faults_with = [&](const std::function<void(TabOptions&)>& change) {
    auto other = asked;
    change(other.tabs);
    const auto wrong = plan_part(part, other);
    return faults_of(check_program(part, wrong.program, "wrong.ngc", asked).findings);
  };
  EXPECT_EQ(faults_with([](TabOptions&) {}), "");
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.count = 0; }), HasSubstr("missing tab: "));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.height = 1.9; }),
              HasSubstr("stands 1.9 mm high where 2 mm"));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.height = 2.1; }),
              HasSubstr("stands 2.1 mm high where 2 mm"));
  // As high in the middle, and lower beside it.
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.width = 3.8; }),
              HasSubstr("tab height: PROFILE_D6_tabs: a side of the triangular tab stands"));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.width = 3.8; }), HasSubstr("mm too low"));
  EXPECT_THAT(faults_with([](TabOptions& tabs) { tabs.shape = TabShape::kSquare; }),
              HasSubstr("mm too high"));
}

/// A move across the tab at another place than its middle line.
TEST(TriangularTabs, ACutFromBesideIsSeen) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  const auto options = triangular("endmill:4", 4);
  const auto good = plan_part(part, options);
  const Tab& tab = good.part.features.back().profile->tabs.front();
  const auto at = [](double value) { return std::to_string(value); };
  const Vec2 along = tab.foot.tangent_at(0.5), p = tab.center + along * 2.5;
  const std::string cut =
      "G0 Z10\nG0 X" + at(p.x) + " Y" + at(p.y) + "\nG1 Z" + at(tab.bottom_z + 0.7) + " F100\nG0 Z10\n";
  std::string text = good.program;
  text.insert(text.rfind("M5"), cut);
  const auto checked = check_program(part, text, "cut.ngc", options);
  EXPECT_TRUE(has(checked.findings, FaultKind::kTabHeight)) << faults_of(checked.findings);
}

TEST(TabPlaces, AreThoseAskedFor) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  for (const TabShape shape : {TabShape::kSquare, TabShape::kTriangular}) {
    auto options = triangular("endmill:4");
    options.tabs.shape = shape;
    options.tabs.at = {{30, -1}, {78, 22}, {41, 53}};
    const auto result = plan_part(part, options);
    EXPECT_EQ(faults_of(result.findings), "");
    const auto& tabs = result.part.features.back().profile->tabs;
    ASSERT_EQ(tabs.size(), 3u);
    const Vec2 centers[] = {{30, -2}, {82, 22}, {41, 52}};
    for (std::size_t i = 0; i < tabs.size(); ++i) EXPECT_LT(distance(tabs[i].center, centers[i]), 1e-6);
    // One of them cut away.
    auto two = options;
    two.tabs.at.pop_back();
    const auto wrong = plan_part(part, two);
    EXPECT_TRUE(has(check_program(part, wrong.program, "two.ngc", options).findings, FaultKind::kMissingTab));
  }
}

std::string refusal_at(const Part& part, const std::vector<Vec2>& places) {
  auto options = triangular("endmill:4");
  options.tabs.at = places;
  try {
    resolve::check(options);
    plan_part(part, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TabPlaces, ThatCannotBeAreRefused) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50) + circle("INSIDE_D6", {40, 25}, 5));
  EXPECT_EQ(refusal_at(part, {{40, -3}}), "");
  EXPECT_THAT(refusal_at(part, {{40, -6}}),
              HasSubstr("--tab-at: 40,-6 is 6 mm from the nearest profile, PROFILE_D6"));
  EXPECT_THAT(refusal_at(part, {{2, 0}}), HasSubstr("at 2,0 a corner or a narrow arc of PROFILE_D6"));
  EXPECT_THAT(refusal_at(part, {{2, 0}}), HasSubstr("the nearest place is 8.5,0"));
  EXPECT_THAT(refusal_at(part, {{45, 25}}), HasSubstr("narrow arc of INSIDE_D6"));
  EXPECT_THAT(refusal_at(part, {{30, 0}, {32, 0}}), HasSubstr("another tab is too near"));
  EXPECT_THAT(refusal_at(drawn(box("POCKET_D6", 0, 0, 80, 50)), {{30, 0}}), HasSubstr("no profile"));
}

TEST(TabPlaces, AlongLinesThatTheCentreFollowsTheLackOfThemIsTold) {
  auto options = with({"endmill:3"});
  options.tabs.count = 3;
  const auto told = [&](const std::string& entities) {
    std::string text;
    const PlanResult result = plan_part(drawn(entities), options);
    for (const Diagnostic& one : result.part.diagnostics.items())
      if (one.severity == Severity::kWarning) text += one.what;
    return text;
  };
  const std::string stock = box("STOCK_D4", 0, 0, 60, 50), through = box("ON_D4", 20, 20, 40, 30);
  // Within a part it frees waste; alone it frees the part, as an outer profile would.
  EXPECT_THAT(told(stock + box("PROFILE_D4", 10, 10, 50, 40) + through), HasSubstr("surrounds comes loose"));
  EXPECT_THROW(told(stock + through), InputError);
  EXPECT_THAT(
      told(box("STOCK_D4", 0, 0, 60, 50) + box("ON_D2", 10, 10, 50, 40)),
      ::testing::AllOf(HasSubstr("tabs are left in profiles alone"), ::testing::Not(HasSubstr("loose"))));
  EXPECT_EQ(told(box("STOCK_D4", 0, 0, 60, 50) + box("PROFILE_D4", 10, 10, 50, 40)), "");
}

TEST(TabSpacing, IsKeptOrRefused) {
  const Part part = drawn(box("PROFILE_D6", 0, 0, 80, 50));
  auto options = triangular("endmill:4");
  options.tabs.spacing = 65;
  EXPECT_EQ(plan_part(part, options).part.features.back().profile->tabs.size(), 4u);
  options.tabs.spacing = 1000;
  EXPECT_EQ(plan_part(part, options).part.features.back().profile->tabs.size(), 2u);
  options.tabs.spacing = 8;
  EXPECT_THROW(plan_part(part, options), InputError);
  options.tabs.count = 3;
  EXPECT_THROW(resolve::check(options), InputError);
}

}  // namespace
}  // namespace clearcut::pipeline
