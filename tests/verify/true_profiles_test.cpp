// Programs of two and three cutters of all kinds, judged by the product and by a field of heights that cutters lower by their true
// profiles. What the field is certain of the product must say, and what the field rules out it must not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "support/independent/profile_field.h"
#include "support/random/first_seed.h"

namespace clearcut {
namespace {

using test_support::BodyWay;
using test_support::first_seed;
using test_support::ProfileField;
using test_support::TurnedBody;
using End = TurnedBody::End;

/// How many of each test: CLEARCUT_TRUE_PROFILES, else `usual`.
int profile_count(int usual) {
  const char* set = std::getenv("CLEARCUT_TRUE_PROFILES");
  return set ? std::atoi(set) : usual;
}

/// One cutter as the command line writes it, and its body as the field knows it.
struct Body {
  std::string tool;
  TurnedBody body;
  bool only_down = false;
  bool may_plunge = true;
};

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

/// Tenths of millimetres, so that both sides read the same size.
double size_between(Random& random, double low, double high) {
  return rounded(random.between(low, high), 0.1);
}

constexpr int kBodies = 14;

Body body_of(int kind, Random& random) {
  const double d = size_between(random, 3, 9), corner = std::min(size_between(random, 0.5, 2.5), d / 2);
  const double angle = std::round(random.between(60, 140));
  switch (kind) {
    case 0:
      return {fmt::format("endmill:{:.1f}", d), {End::kFlat, d}};
    case 1:
      return {fmt::format("bullnose:{:.1f}:corner={:.2f}", d, corner), {End::kRounded, d, corner}};
    case 2:
      return {fmt::format("ball:{:.1f}", d), {End::kRounded, d, d / 2}};
    case 3:
      return {fmt::format("drill:{:.1f}", d), {End::kCone, d, 0, 118}, true};
    case 4:
      return {fmt::format("drill:{:.1f}:{}deg", d, angle), {End::kCone, d, 0, angle}, true};
    case 5:
      return {fmt::format("vbit:{:.1f}:{}deg", d, angle), {End::kCone, d, 0, angle}};
    case 6:
      return {fmt::format("chamfer:{:.1f}:{}deg:tip=1", d, angle), {End::kCone, d, 0, angle, 1}};
    case 7:
      return {fmt::format("spotdrill:{:.1f}:{}deg", d, angle), {End::kCone, d, 0, angle}, true};
    case 8: {
      const double tip = size_between(random, 2, 5), widest = tip + 2 * 15 * std::tan(kPi / 18);
      return {fmt::format("tapered:{:.1f}:taper=10deg:length=15", tip), {End::kCone, widest, 0, 20, tip}};
    }
    case 9:
      return {fmt::format("counterbore:{:.1f}", d), {End::kFlat, d}, true};
    case 10:
      return {"tap:M6", {End::kFlat, 6, 0, 0, 0, false}, true};
    case 11:
      return {"threadmill:7", {End::kFlat, 7, 0, 0, 0, false}};
    case 12:
      return {fmt::format("endmill:{:.1f}:noplunge", d), {End::kFlat, d}, false, false};
    default:
      return {fmt::format("bullnose:{:.1f}:corner={:.2f}:noplunge", d, corner),
              {End::kRounded, d, corner},
              false,
              false};
  }
}

constexpr double kSide = 30, kCell = 0.3;

/// A program in the making, with the field that follows it.
class RandomProgram {
 public:
  explicit RandomProgram(Random& random) : random_(random), field_(0, 0, kSide, kSide, kCell) {
    text_ = "G21 G90 G17 G40 G49 G54 G80 G94 G64 P0.001\n";
    const int count = 2 + static_cast<int>(random.below(2));
    for (int i = 0; i < count; ++i) {
      bodies_.push_back(body_of(static_cast<int>(random.below(kBodies)), random));
      bodies_.back().tool += fmt::format(":T{}", i + 1);
    }
  }

  void run() {
    for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
      take(i);
      for (int n = 0; n < 2; ++n) cut();
    }
    take(static_cast<int>(random_.below(bodies_.size())));
    ask();
    text_ += "M5\nM2\n";
  }

  const std::string& text() const { return text_; }
  std::vector<Tool> tools() const {
    std::vector<Tool> tools;
    for (const Body& body : bodies_) tools.push_back(resolve::parse_tool(body.tool));
    return tools;
  }
  std::string names() const {
    std::string names;
    for (const Body& body : bodies_) names += body.tool + " ";
    return names;
  }
  ProfileField::Hit rapid, plunge;  ///< what the questions at its end meet

 private:
  void take(int i) {
    current_ = i;
    text_ += fmt::format("T{0} M6\nG43 H{0}\nM3 S2000\nG4 P2\n", i + 1);
  }

  double place() { return rounded(random_.between(6, kSide - 6), 0.01); }

  void go(const char* word, double x, double y, double z) {
    text_ += fmt::format("{} X{:.2f} Y{:.2f} Z{:.2f}{}\n", word, x, y, z, word[1] == '0' ? "" : " F200");
    way_ = {way_.x1, way_.y1, way_.z1, x, y, z};
    // What leaves material where it was meets it on its way out.
    const TurnedBody& body = bodies_[static_cast<std::size_t>(current_)].body;
    if (word[1] == '0' && !body.removes && std::min(way_.z0, way_.z1) < 0) meet(rapid);
  }

  void meet(ProfileField::Hit& met) const {
    const ProfileField::Hit hit = field_.hit(bodies_[static_cast<std::size_t>(current_)].body, way_);
    met = {std::max(met.certain, hit.certain), std::max(met.possible, hit.possible)};
  }

  void feed(double x, double y, double z) {
    const double from_z = way_.z1;
    go("G1", x, y, z);
    field_.cut(bodies_[static_cast<std::size_t>(current_)].body, way_);
    tips_.push_back({x, y, z});
    tips_.push_back({way_.x0, way_.y0, from_z});
  }

  void cut() {
    const Body& body = bodies_[static_cast<std::size_t>(current_)];
    double x = place(), y = place(), z = rounded(random_.between(-6, -0.5), 0.01);
    if (!tips_.empty() && random_.below(2) == 0) x = tips_.back().x, y = tips_.back().y;
    go("G0", x, y, 5);
    go("G0", x, y, 1);
    // What may not plunge comes in on a gentle slope, and stays at one height.
    if (body.may_plunge) {
      feed(x, y, z);
    } else {
      feed(x = x < kSide / 2 ? x + 8 : x - 8, y = place(), z = rounded(random_.between(-4, -0.5), 0.01));
    }
    const int lines = body.only_down ? 0 : 1 + static_cast<int>(random_.below(3));
    for (int i = 0; i < lines; ++i) {
      if (body.may_plunge && random_.below(3) == 0) z = rounded(random_.between(-6, -0.5), 0.01);
      feed(x = place(), y = place(), z);
    }
    go("G0", x, y, 5);
  }

  /// A rapid, and of cutters that may not plunge a plunge at times, near where something was cut.
  void ask() {
    const Body& body = bodies_[static_cast<std::size_t>(current_)];
    const Tip tip = tips_[random_.below(tips_.size())];
    const double aside = random_.below(2) == 0 ? 0 : random_.between(-1, 1);
    const double x = rounded(tip.x + aside, 0.01), y = tip.y;
    const double z = rounded(
        std::min(tip.z, -0.3) + (random_.below(2) == 0 ? random_.between(0, 0.5) : random_.between(0, 3)),
        0.01);
    go("G0", x, y, 5);
    if (!body.may_plunge && random_.below(2) == 0) {
      go("G0", x, y, 1);
      go("G1", x, y, z);
      meet(plunge);
    } else {
      go("G0", x, y, z);
      meet(rapid);
      if (random_.below(3) == 0) {
        const Tip other = tips_[random_.below(tips_.size())];
        go("G0", other.x, other.y, z);
        meet(rapid);
      }
    }
    go("G0", way_.x1, way_.y1, 5);
  }

  struct Tip {
    double x, y, z;
  };
  Random& random_;
  ProfileField field_;
  std::vector<Body> bodies_;
  int current_ = 0;
  BodyWay way_{0, 0, 5, 0, 0, 5};
  std::vector<Tip> tips_;
  std::string text_;
};

/// mm. What the field has to be sure of: more than the thousandth that the product leaves to rounding.
constexpr double kSure = 0.005;

struct Answer {
  const char* what;
  FaultKind kind;
  ProfileField::Hit hit;
};

bool is_said(const Findings& findings, const Answer& answer) {
  return std::any_of(findings.faults.begin(), findings.faults.end(), [&](const Fault& fault) {
    const bool tells_of_it =
        answer.kind == FaultKind::kRapidInMaterial || fault.text.find("straight down") != std::string::npos;
    return fault.kind == answer.kind && tells_of_it;
  });
}

TEST(TrueProfiles, RapidsAndPlungesMeetWhatStandsAndNothingElse) {
  int certain = 0, free = 0;
  for (int seed = first_seed(); seed < first_seed() + profile_count(250); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    RandomProgram program(random);
    program.run();
    PlanOptions options;
    options.tools = program.tools();
    const Stock stock{Box{{0, 0}, {kSide, kSide}}, -30, 0};
    const auto checked =
        pipeline::check_program_alone(stock, program.text(), "random", options, Dialect::kLinuxCnc);
    for (const Answer& answer : {Answer{"rapid", FaultKind::kRapidInMaterial, program.rapid},
                                 Answer{"plunge", FaultKind::kPlungeTooFast, program.plunge}}) {
      const bool said = is_said(checked.findings, answer);
      certain += answer.hit.certain > kSure;
      free += answer.hit.possible <= 0 && answer.hit.certain <= 0;
      const std::string what =
          fmt::format("seed {}: {}, {}\n{}", seed, answer.what, program.names(), program.text());
      EXPECT_TRUE(said || answer.hit.certain <= kSure)
          << "meets " << answer.hit.certain << " mm unsaid, " << what;
      EXPECT_FALSE(said && answer.hit.possible <= 0) << "meets nothing, " << what;
    }
  }
  std::cout << certain << " certain, " << free << " free\n";
  EXPECT_GT(certain, profile_count(250) / 8);
  EXPECT_GT(free, profile_count(250) / 8);
}

/// A pocket: a rectangle, or a disc of that width.
struct Pocket {
  bool is_disc = false, is_hole = false;
  double width = 0, height = 0, depth = 0;
  double lean = 0;  ///< radians that its walls lean

  double to_wall(double x, double y) const {
    if (is_disc) return width / 2 - std::hypot(x - width / 2, y - width / 2);
    return std::min({x, y, width - x, height - y});
  }
  /// Whether a flat mill comes there with some place to spare.
  bool is_reached(double x, double y, double diameter, double spare) const {
    const double r = diameter / 2;
    if (is_disc) return to_wall(x, y) > spare && diameter <= width;
    const double cx = std::clamp(x, r, width - r), cy = std::clamp(y, r, height - r);
    return 2 * r < std::min(width, height) && to_wall(x, y) > spare && std::hypot(x - cx, y - cy) < r - spare;
  }
};

Part part_of(const Pocket& pocket) {
  Part part;
  part.name = "profiles";
  Feature feature;
  feature.name = "POCKET";
  const double w = pocket.width, h = pocket.height, r = w / 2;
  Loop outline;
  if (pocket.is_disc) {
    outline = {Edge::arc({w, r}, {0, r}, {r, r}, Turn::kCounterClockwise),
               Edge::arc({0, r}, {w, r}, {r, r}, Turn::kCounterClockwise)};
  } else {
    outline = loop_from_points(std::vector<Vec2>{{0, 0}, {w, 0}, {w, h}, {0, h}});
  }
  feature.kind = pocket.is_hole ? FeatureKind::kRoundHole : FeatureKind::kClosedPocket;
  if (pocket.is_hole) feature.hole_diameter = w;
  feature.target = feature.allowed = {Region::from_valid_loops(outline, {})};
  feature.floor_z = -pocket.depth;
  feature.wall_slope = Radians::of(pocket.lean);
  part.features.push_back(feature);
  part.workplan.push_back({});
  part.stock = Stock{Box{{-10, -10}, {40, 40}}, -40, 0};
  return part;
}

struct Job {
  Pocket pocket;
  std::vector<Body> bodies;
};

Job random_job(Random& random) {
  Job job;
  Pocket& pocket = job.pocket;
  pocket.is_disc = random.below(3) == 0;
  pocket.is_hole = pocket.is_disc && random.below(2) == 0;
  pocket.width = pocket.is_hole ? size_between(random, 4, 9) : size_between(random, 9, 18);
  pocket.height = pocket.is_disc ? pocket.width : size_between(random, 9, 18);
  pocket.depth = size_between(random, 1, 7);
  const double least = std::min(pocket.width, pocket.height);
  const double flat = rounded(random.between(0.35, 0.7) * least, 0.1);
  if (pocket.is_disc && random.below(2) == 0)
    job.bodies.push_back(
        {fmt::format("drill:{:.1f}", pocket.width), {End::kCone, pocket.width, 0, 118}, true});
  if (!pocket.is_hole) {
    const double wide = std::max(flat, rounded(random.between(0.4, 0.8) * least, 0.1));
    const double corner = std::min(size_between(random, 0.5, 2.5), wide / 2 - 0.5);
    if (random.below(3) > 0)
      job.bodies.push_back({fmt::format("bullnose:{:.1f}:corner={:.2f}", wide, corner),
                            {End::kRounded, wide, rounded(corner, 0.01)}});
    if (random.below(3) == 0)
      job.bodies.push_back({fmt::format("ball:{:.1f}", wide), {End::kRounded, wide, wide / 2}});
  }
  job.bodies.push_back({fmt::format("endmill:{:.1f}", flat), {End::kFlat, flat}});
  for (std::size_t i = 0; i < job.bodies.size(); ++i) job.bodies[i].tool += fmt::format(":T{}", i + 1);
  return job;
}

PlanOptions options_of(const Job& job, Random& random) {
  PlanOptions options;
  for (const Body& body : job.bodies) options.tools.push_back(resolve::parse_tool(body.tool));
  options.shop.rest = true;
  options.accept = {"out-of-reach"};
  options.threads = 1;
  static const char* const kStrategies[] = {"contour", "zigzag", "spiral", "adaptive"};
  options.strategy = kStrategies[random.below(4)];
  return options;
}

std::vector<BodyWay> ways_of_move(const Move& move) {
  const Edge& path = move.path;
  if (path.turn == Turn::kStraight)
    return {{path.from.x, path.from.y, move.z_from, path.to.x, path.to.y, move.z_to}};
  const double r = std::hypot(path.from.x - path.center.x, path.from.y - path.center.y);
  const double sense = path.turn == Turn::kCounterClockwise ? 1 : -1;
  const double from = std::atan2(path.from.y - path.center.y, path.from.x - path.center.x);
  double sweep = sense * (std::atan2(path.to.y - path.center.y, path.to.x - path.center.x) - from);
  while (sweep <= 1e-9) sweep += 2 * kPi;
  const int count = 1 + static_cast<int>(sweep * std::sqrt(r) / 0.06);
  std::vector<BodyWay> ways;
  BodyWay way{0, 0, 0, path.from.x, path.from.y, move.z_from};
  for (int i = 1; i <= count; ++i) {
    const double t = static_cast<double>(i) / count, a = from + sense * sweep * t;
    way = {way.x1,
           way.y1,
           way.z1,
           path.center.x + r * std::cos(a),
           path.center.y + r * std::sin(a),
           std::lerp(move.z_from, move.z_to, t)};
    ways.push_back(way);
  }
  return ways;
}

/// mm. What chords, printed digits and the tolerances of the product may make of a surface.
constexpr double kSpare = 0.03;

/// What the program's cutters leave of the block, and the first rapid that meets something for certain.
struct Cut {
  ProfileField field;
  std::string rapids;
};

Cut cut_by(const Job& job, const Toolpath& toolpath) {
  const Pocket& pocket = job.pocket;
  const double margin = 4 * kCell;
  Cut cut{ProfileField(-margin, -margin, pocket.width + margin, pocket.height + margin, kCell), ""};
  for (const Section& section : toolpath.sections) {
    const auto at = static_cast<std::size_t>(section.tool_number - 1);
    if (at >= job.bodies.size()) return {cut.field, "an unknown tool"};
    const TurnedBody& body = job.bodies[at].body;
    for (const Move& move : section.moves) {
      for (const BodyWay& way : ways_of_move(move)) {
        if (!is_rapid(move.kind)) {
          cut.field.cut(body, way);
        } else if (std::min(way.z0, way.z1) < 0 && cut.rapids.empty()) {
          const double met = cut.field.hit(body, way).certain;
          if (met > kSpare)
            cut.rapids = fmt::format("a rapid meets {:.3f} mm at x {:.2f} y {:.2f} z {:.2f}", met, way.x1,
                                     way.y1, way.z1);
        }
      }
    }
  }
  return cut;
}

/// Why the field is certain that the program is wrong; "" where it is not.
std::string certainly_wrong(const Job& job, const Toolpath& toolpath) {
  const Pocket& pocket = job.pocket;
  const double margin = 4 * kCell;
  double flat = 0;
  const auto& [field, rapids] = cut_by(job, toolpath);
  if (!rapids.empty()) return rapids;
  // A program is asked for what the tools reach that it cuts with.
  for (const Section& section : toolpath.sections) {
    const TurnedBody& body = job.bodies[static_cast<std::size_t>(section.tool_number - 1)].body;
    const bool cuts = std::any_of(section.moves.begin(), section.moves.end(),
                                  [](const Move& move) { return !is_rapid(move.kind); });
    if (body.end == End::kFlat && cuts) flat = body.diameter;
  }
  const bool is_drilled = pocket.is_hole && job.bodies.front().body.end == End::kCone;
  const double cone = is_drilled ? pocket.width / 2 / std::tan(59 * kPi / 180) : 0;
  for (double x = -margin + kCell / 2; x < pocket.width + margin; x += kCell) {
    for (double y = -margin + kCell / 2; y < pocket.height + margin; y += kCell) {
      const double inside = pocket.to_wall(x, y), stands = field.certain_at(x, y),
                   gone = field.possible_at(x, y);
      if (inside < -kCell && gone < -kSpare)
        return fmt::format("cut {:.3f} mm deep beside the pocket at {:.2f} {:.2f}", -gone, x, y);
      if (gone < -pocket.depth - kSpare)
        return fmt::format("cut {:.3f} mm under the floor at {:.2f} {:.2f}", -pocket.depth - gone, x, y);
      const bool asked = is_drilled ? inside > kCell : flat > 0 && pocket.is_reached(x, y, flat, kCell);
      if (asked && stands > -pocket.depth + cone + kSpare)
        return fmt::format("{:.3f} mm stand at {:.2f} {:.2f}", stands + pocket.depth, x, y);
    }
  }
  return "";
}

std::string text_of(const Job& job) {
  std::string names = fmt::format("{} {} x {} x {}:",
                                  job.pocket.is_hole   ? "hole"
                                  : job.pocket.is_disc ? "disc"
                                                       : "box",
                                  job.pocket.width, job.pocket.height, job.pocket.depth);
  for (const Body& body : job.bodies) names += " " + body.tool;
  return names;
}

/// One block changed: another height, a rapid for a feed, a block or a run of blocks left out, the tools exchanged.
std::string mutant_of(const std::string& program, Random& random) {
  std::vector<std::string> lines;
  std::istringstream in(program);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::regex_search(lines[i], std::regex("^(G[0123] |G98 )?[XYZG].*"))) blocks.push_back(i);
  const std::size_t i = blocks[random.below(blocks.size())];
  std::smatch z;
  switch (random.below(5)) {
    case 0:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    case 1:
      lines.erase(
          lines.begin() + static_cast<std::ptrdiff_t>(i),
          lines.begin() + static_cast<std::ptrdiff_t>(std::min(lines.size(), i + 2 + random.below(12))));
      break;
    case 2:
      lines[i] = std::regex_replace(lines[i], std::regex("^G1 "), "G0 ");
      break;
    case 3:
      for (std::string& line : lines) {
        if (line == "T1 M6")
          line = "T2 M6";
        else if (line == "T2 M6")
          line = "T1 M6";
      }
      break;
    default:
      for (std::size_t k = 0; k < lines.size(); ++k) {
        std::string& line = lines[(i + k) % lines.size()];
        if (line.empty() || line[0] == '(' || !std::regex_search(line, z, std::regex("Z(-[0-9.]+)")))
          continue;
        line = z.prefix().str() + fmt::format("Z{:.3f}", std::stod(z[1].str()) + random.between(-1, 2)) +
               z.suffix().str();
        break;
      }
  }
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(TrueProfiles, PlansAreCleanAndMutantsFaultyWhereTheFieldSaysSo) {
  int plans = 0, wrong = 0, mutants = 0;
  for (int seed = first_seed(); seed < first_seed() + profile_count(140); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 5000);
    const Job job = random_job(random);
    const PlanOptions options = options_of(job, random);
    const std::string what = fmt::format("seed {}: {} by {}", seed, text_of(job), *options.strategy);
    const PlanResult plan = pipeline::plan_part(part_of(job.pocket), options);
    EXPECT_NE(verdict_of(plan.findings), Verdict::kFaulty) << what << "\n"
                                                           << verdict_and_reasons(plan.findings);
    EXPECT_EQ(certainly_wrong(job, plan.toolpath), "") << what << "\n" << plan.program;
    ++plans;
    for (int n = 0; n < 2; ++n) {
      const std::string text = mutant_of(plan.program, random);
      CheckResult checked;
      try {
        PlanOptions tools;
        tools.tools = options.tools;
        tools.accept = options.accept;
        tools.shop.rest = true;
        checked = pipeline::check_program(plan.part, text, "mutant", tools, Dialect::kLinuxCnc);
      } catch (const InputError&) {
        continue;
      }
      ++mutants;
      const std::string why = certainly_wrong(job, checked.toolpath);
      wrong += !why.empty();
      EXPECT_TRUE(why.empty() || verdict_of(checked.findings) == Verdict::kFaulty)
          << what << ", " << why << ", called " << name_of(verdict_of(checked.findings)) << "\n"
          << text;
    }
  }
  std::cout << plans << " plans; " << wrong << " of " << mutants << " mutants certainly wrong\n";
  EXPECT_GT(wrong, mutants / 4);
}

/// A pocket with leaning walls and what clears it: flat, rounded or tapered ends of one size.
Job leaning_job(Random& random) {
  Job job;
  Pocket& pocket = job.pocket;
  pocket.is_disc = random.below(3) == 0;
  pocket.width = size_between(random, 14, 22);
  pocket.height = pocket.is_disc ? pocket.width : size_between(random, 14, 22);
  pocket.lean = rounded(random.between(0.05, 0.9), 0.01);
  pocket.depth = std::min(size_between(random, 1, 6), rounded(4 / std::tan(pocket.lean), 0.1));
  const double d = size_between(random, 3, 5), corner = rounded(random.between(0.3, d / 2 - 0.7), 0.01);
  switch (random.below(3)) {
    case 0:
      job.bodies.push_back({fmt::format("endmill:{:.1f}:T1", d), {End::kFlat, d}});
      break;
    case 1:
      job.bodies.push_back(
          {fmt::format("bullnose:{:.1f}:corner={:.2f}:T1", d, corner), {End::kRounded, d, corner}});
      break;
    default:
      job.bodies.push_back({fmt::format("ball:{:.1f}:T1", d), {End::kRounded, d, d / 2}});
  }
  return job;
}

/// The same of a pocket with leaning walls: on them `scallop` mm may stand, square to them.
std::string wrong_on_leaning_walls(const Job& job, const Toolpath& toolpath, double scallop) {
  const Pocket& pocket = job.pocket;
  const double margin = 4 * kCell, half = kCell * 0.70711, lean = std::tan(pocket.lean);
  const TurnedBody& body = job.bodies.front().body;
  const double radius = body.diameter / 2;
  const auto& [field, rapids] = cut_by(job, toolpath);
  if (!rapids.empty()) return rapids;
  const auto wall_at = [&](double inside) { return std::max(-pocket.depth, -std::max(0.0, inside) / lean); };
  for (double x = -margin + kCell / 2; x < pocket.width + margin; x += kCell) {
    for (double y = -margin + kCell / 2; y < pocket.height + margin; y += kCell) {
      const double inside = pocket.to_wall(x, y), stands = field.certain_at(x, y),
                   gone = field.possible_at(x, y);
      const double lowest = inside < -half ? 0 : wall_at(inside + half);
      if (gone < lowest - kSpare)
        return fmt::format("cut {:.3f} mm into the part at {:.2f} {:.2f}", lowest - gone, x, y);
      const double across =
          pocket.is_disc ? HUGE_VAL : std::max(std::min(x, pocket.width - x), std::min(y, pocket.height - y));
      const double foot = pocket.depth * lean, highest = wall_at(inside - half);
      const bool is_corner = across<foot + radius + kCell, is_floor = inside> foot + half;
      if (inside < half || is_corner) continue;
      // Rounded ends leave their rounding in the corner of the floor.
      if (!is_floor && highest < -pocket.depth + body.round) continue;
      if (is_floor && (body.round >= radius || inside < foot + radius + kCell)) continue;
      const double most = is_floor ? -pocket.depth : highest + scallop / std::sin(pocket.lean);
      if (stands > most + kSpare) return fmt::format("{:.3f} mm stand at {:.2f} {:.2f}", stands - most, x, y);
    }
  }
  return "";
}

TEST(TrueProfiles, PlansOnLeaningWallsAreCleanAndMutantsFaulty) {
  int wrong = 0, mutants = 0;
  for (int seed = first_seed(); seed < first_seed() + profile_count(4); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 90000);
    const Job job = leaning_job(random);
    PlanOptions options = options_of(job, random);
    options.shop.rest = false;
    const double scallop = random.below(2) == 0 ? 0.2 : rounded(random.between(0.05, 0.4), 0.01);
    options.scallop = scallop;
    const std::string what = fmt::format("seed {}: {} leaning {} scallop {} by {}", seed, text_of(job),
                                         job.pocket.lean, scallop, *options.strategy);
    const PlanResult plan = pipeline::plan_part(part_of(job.pocket), options);
    EXPECT_NE(verdict_of(plan.findings), Verdict::kFaulty) << what << "\n"
                                                           << verdict_and_reasons(plan.findings);
    EXPECT_EQ(wrong_on_leaning_walls(job, plan.toolpath, scallop), "") << what << "\n" << plan.program;
    for (int n = 0; n < 3; ++n) {
      const std::string text = mutant_of(plan.program, random);
      CheckResult checked;
      try {
        PlanOptions tools;
        tools.tools = options.tools;
        tools.accept = options.accept;
        tools.scallop = scallop;
        checked = pipeline::check_program(plan.part, text, "mutant", tools, Dialect::kLinuxCnc);
      } catch (const InputError&) {
        continue;
      }
      ++mutants;
      const std::string why = wrong_on_leaning_walls(job, checked.toolpath, scallop);
      wrong += !why.empty();
      EXPECT_TRUE(why.empty() || verdict_of(checked.findings) == Verdict::kFaulty)
          << what << ", " << why << ", called " << name_of(verdict_of(checked.findings)) << "\n"
          << text;
    }
  }
  std::cout << wrong << " of " << mutants << " mutants certainly wrong\n";
  EXPECT_GT(wrong, 0);
}

}  // namespace
}  // namespace clearcut
