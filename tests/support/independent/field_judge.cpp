#include "support/independent/field_judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <stdexcept>

namespace clearcut::test_support {
namespace {

/// mm. What chords, printed digits and the tolerances of the product may make of a surface, and of a place in the plane.
constexpr double kSlack = 0.03, kAside = 0.03;
/// mm. Contact with material that counts.
constexpr double kContact = 0.06;
/// mm for each mm from the axis: what the point of a drill leaves may stand under tools that finish its hole.
constexpr double kPointLeft = 0.65;
/// mm. Chords of arcs.
constexpr double kSagitta = 0.002;
/// Number of places in a plan from which other programs that begin alike go on.
constexpr std::size_t kBegun = 16;

std::string text(const char* kind, double amount, const std::string& where) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, "%s %.3f mm %s", kind, amount, where.c_str());
  return buffer;
}

std::string place_text(double x, double y) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "at %.2f %.2f", x, y);
  return buffer;
}

bool is_one_of(const std::string& kind, std::initializer_list<const char*> kinds) {
  return std::any_of(kinds.begin(), kinds.end(), [&](const char* other) { return kind == other; });
}

/// The part of a cutter that cuts nothing straight down; none where all of it does.
std::optional<TurnedBody> blunt_core(const MadeCutter& cutter) {
  const double d = cutter.body.diameter;
  TurnedBody core;
  core.diameter = d;
  double ring = 0;
  bool may_meet_point = false;
  if (cutter.kind == "reamer" || cutter.kind == "boringbar" || cutter.kind == "tap") {
    ring = cutter.kind == "reamer"      ? std::max(0.25, 0.05 * d)
           : cutter.kind == "boringbar" ? 0.5
                                        : 0.5413 * cutter.pitch + 0.05 * d;
    may_meet_point = true;
  } else if (cutter.kind == "counterbore") {
    ring = 3 * d / 8;
  } else if (cutter.may_plunge && cutter.kind != "threadmill") {
    return {};
  }
  core.diameter = d - 2 * ring - 2 * kAside;
  if (core.diameter <= 0) return {};
  if (may_meet_point) {
    core.end = TurnedBody::End::kCone;
    core.angle = 2 * std::atan(1 / kPointLeft) * 180 / 3.141592653589793;
  }
  return core;
}

/// The part of a cutter that cuts nothing sideways; none where all of it does.
std::optional<TurnedBody> blunt_side(const MadeCutter& cutter) {
  TurnedBody side = cutter.body;
  if (is_one_of(cutter.kind, {"drill", "reamer", "boringbar", "counterbore", "tap"})) {
    side.diameter -= 4 * kAside;
  } else if (cutter.kind == "threadmill") {
    side.diameter /= 2;
  } else {
    return {};
  }
  return side;
}

double length_of(const BodyWay& way) {
  return std::hypot(way.x1 - way.x0, way.y1 - way.y0);
}

/// What is wrong with one way before it is cut, of the kinds that a field shows.
class WayJudge {
 public:
  WayJudge(const ProfileField& field, const TipWay& tip, const MadeCutter& cutter)
      : field_(field),
        tip_(tip),
        cutter_(cutter),
        way_{tip.x0, tip.y0, tip.z0, tip.x1, tip.y1, tip.z1},
        down_(tip.z0 - tip.z1),
        aside_(length_of(way_)) {}

  const BodyWay& way() const { return way_; }

  void judge(std::vector<std::string>& wrongs) const {
    if (tip_.rapid) {
      note("rapid", cutter_.body, kContact, wrongs);
      return;
    }
    const bool is_left_tap = cutter_.kind == "tap" && tip_.turning < 0;
    if (tip_.turning != 1 && !is_left_tap) note("spindle", cutter_.body, kContact, wrongs);
    if (!tip_.has_length) note("length", cutter_.body, kContact, wrongs);
    if (const auto core = blunt_core(cutter_); core && down_ > 0 && aside_ < 0.02 * down_)
      note("plunge", *core, 0.1, wrongs);
    if (const auto side = blunt_side(cutter_); side && aside_ > 0.2 * std::abs(down_))
      note("sideways", *side, 0.1, wrongs);
    if (cutter_.kind == "tap" && down_ > 0) judge_tap(wrongs);
  }

 private:
  void note(const char* kind, const TurnedBody& body, double most, std::vector<std::string>& wrongs) const {
    const double met = field_.hit(body, way_).certain;
    if (met > most) wrongs.push_back(text(kind, met, "line " + std::to_string(tip_.line)));
  }

  void judge_tap(std::vector<std::string>& wrongs) const {
    const double off = std::abs(tip_.per_turn - cutter_.pitch);
    if (tip_.z1 < -0.5 && off > 0.02 * cutter_.pitch)
      wrongs.push_back(text("pitch", off, "line " + std::to_string(tip_.line)));
  }

  const ProfileField& field_;
  const TipWay& tip_;
  const MadeCutter& cutter_;
  BodyWay way_;
  double down_, aside_;
};

void keep_first_of_each_kind(std::vector<std::string>& wrongs) {
  std::vector<std::string> kept;
  for (const std::string& wrong : wrongs) {
    const std::string kind = wrong.substr(0, wrong.find(' '));
    const bool is_known = std::any_of(kept.begin(), kept.end(), [&](const std::string& other) {
      return other.substr(0, other.find(' ')) == kind;
    });
    if (!is_known) kept.push_back(wrong);
  }
  wrongs = kept;
}

}  // namespace

FieldJudge::FieldJudge(MadePart part, const std::string& plan, double cell)
    : part_(std::move(part)), cell_(cell), places_(all_places()), plan_(untouched()) {
  run_plan(plan);
}

std::vector<FieldJudge::Place> FieldJudge::all_places() const {
  std::vector<Place> places;
  for (double y = part_.y0 + cell_ / 2; y < part_.y1; y += cell_)
    for (double x = part_.x0 + cell_ / 2; x < part_.x1; x += cell_) places.push_back(place_at(x, y));
  return places;
}

FieldJudge::Place FieldJudge::place_at(double x, double y) const {
  Place place{x, y, 0, 0, 0, {}, {}};
  for (const MadeElement& element : part_.elements) {
    const double inside = element.inside(x, y);
    const auto low = element.low.at(inside + kAside), high = element.high.at(inside - kAside);
    if (element.undercut_roof) {
      if (low) place.undercuts.push_back({*low - kSlack, *element.undercut_roof + kSlack});
      if (high) place.undercuts_asked.push_back({*high + kSlack, *element.undercut_roof - kSlack});
      continue;
    }
    if (low) place.low = std::min(place.low, *low);
    if (!high) continue;
    place.drawn = std::min(place.drawn, *high);
    if (*high < place.asked && element.is_reached(x, y)) place.asked = *high;
  }
  place.low = std::max(place.low, part_.bottom);
  return place;
}

FieldJudge::Run FieldJudge::untouched() const {
  Run run{ProfileField(part_.x0, part_.y0, part_.x1, part_.y1, cell_, part_.bottom), {}, part_.visits, {}};
  for (const MadeThread& thread : part_.threads) run.threads.emplace_back(thread);
  return run;
}

std::vector<TipWay> FieldJudge::ways_about_part(const std::string& program) const {
  std::vector<TipWay> ways = ways_of(program, kSagitta);
  for (TipWay& tip : ways) {
    tip.x0 -= part_.zero_x, tip.y0 -= part_.zero_y, tip.z0 -= part_.zero_z;
    tip.x1 -= part_.zero_x, tip.y1 -= part_.zero_y, tip.z1 -= part_.zero_z;
  }
  return ways;
}

void FieldJudge::run_plan(const std::string& plan) {
  begun_.push_back(plan_);
  try {
    plan_ways_ = ways_about_part(plan);
  } catch (const std::runtime_error& error) {
    plan_.wrongs.push_back(std::string("words ") + error.what());
    return;
  }
  const std::size_t apart = plan_ways_.size() / kBegun + 1;
  for (const TipWay& tip : plan_ways_) {
    go(plan_, tip);
    if (plan_.done % apart == 0) begun_.push_back(plan_);
  }
}

FieldJudge::Run FieldJudge::run(const std::string& program) const {
  std::vector<TipWay> ways;
  try {
    ways = ways_about_part(program);
  } catch (const std::runtime_error& error) {
    Run none = untouched();
    none.wrongs.push_back(std::string("words ") + error.what());
    return none;
  }
  const auto differs = std::mismatch(ways.begin(), ways.end(), plan_ways_.begin(), plan_ways_.end()).first;
  Run run = last_before(static_cast<std::size_t>(differs - ways.begin()));
  while (run.done < ways.size()) go(run, ways[run.done]);
  return run;
}

/// The plan with at most so many of its ways.
const FieldJudge::Run& FieldJudge::last_before(std::size_t ways) const {
  const auto after =
      std::find_if(begun_.begin(), begun_.end(), [&](const Run& run) { return run.done > ways; });
  return *std::prev(after);
}

void FieldJudge::go(Run& run, const TipWay& tip) const {
  ++run.done;
  if (std::min(tip.z0, tip.z1) >= 0) return;
  const auto found = part_.cutters.find(tip.tool);
  if (found == part_.cutters.end()) {
    run.wrongs.push_back("tool unknown, line " + std::to_string(tip.line));
    return;
  }
  const MadeCutter& cutter = found->second;
  const WayJudge judge(run.field, tip, cutter);
  judge.judge(run.wrongs);
  run.field.cut(cutter.body, judge.way());
  if (cutter.kind == "threadmill")
    for (ThreadRays& thread : run.threads) thread.cut(cutter, judge.way());
  const auto is_made = [&](const MadeVisit& visit) {
    return visit.kind == cutter.kind && std::hypot(visit.x - tip.x1, visit.y - tip.y1) < kAside &&
           tip.z1 < visit.z + kSlack;
  };
  run.missed.erase(std::remove_if(run.missed.begin(), run.missed.end(), is_made), run.missed.end());
}

/// `plan`: what another program has cut of the same part; without it, what cutters certainly reach is asked.
void FieldJudge::compare(const Run& run, const Run* plan, std::vector<std::string>& wrongs) const {
  double left = 0, gouge = 0, roofed = 0, undercut = 0;
  const Place *left_at = nullptr, *gouge_at = nullptr, *roofed_at = nullptr, *undercut_at = nullptr;
  const auto note = [](double amount, const Place& place, double& worst, const Place*& worst_at) {
    if (amount <= worst) return;
    worst = amount;
    worst_at = &place;
  };
  for (const Place& place : places_) {
    const double high = plan ? std::max(place.drawn, plan->field.possible_at(place.x, place.y)) : place.asked;
    const double standing = run.field.certain_at(place.x, place.y),
                 open = run.field.possible_at(place.x, place.y);
    note(standing - std::max(high, part_.bottom) - kSlack, place, left, left_at);
    note(place.low - std::max(open, part_.bottom) - kSlack, place, gouge, gouge_at);
    for (const ProfileField::Gap& gap : place.undercuts_asked)
      note(run.field.standing_at(place.x, place.y, gap.low, gap.high) - kSlack, place, roofed, roofed_at);
    for (const ProfileField::Gap& gap : run.field.undercut_at(place.x, place.y)) {
      double beyond = std::min(gap.high, place.low - kSlack) - gap.low;
      for (const ProfileField::Gap& room : place.undercuts)
        beyond = std::min(beyond, std::max(room.low - gap.low, std::min(gap.high, place.low) - room.high));
      note(beyond, place, undercut, undercut_at);
    }
  }
  if (left_at) wrongs.push_back(text("left", left, place_text(left_at->x, left_at->y)));
  if (gouge_at) wrongs.push_back(text("gouge", gouge, place_text(gouge_at->x, gouge_at->y)));
  if (roofed_at) wrongs.push_back(text("roofed", roofed, place_text(roofed_at->x, roofed_at->y)));
  if (undercut_at) wrongs.push_back(text("undercut", undercut, place_text(undercut_at->x, undercut_at->y)));
}

void FieldJudge::compare_threads(const Run& run, std::vector<std::string>& wrongs) {
  for (const ThreadRays& thread : run.threads) {
    const std::string wrong = thread.wrong();
    if (!wrong.empty()) wrongs.push_back(wrong);
  }
  for (const MadeVisit& visit : run.missed)
    wrongs.push_back("missed " + visit.kind + " " + place_text(visit.x, visit.y));
}

std::vector<std::string> FieldJudge::wrongs_of_plan() const {
  std::vector<std::string> wrongs = plan_.wrongs;
  compare(plan_, nullptr, wrongs);
  compare_threads(plan_, wrongs);
  keep_first_of_each_kind(wrongs);
  return wrongs;
}

std::vector<std::string> FieldJudge::wrongs_of(const std::string& program) const {
  const Run done = run(program);
  std::vector<std::string> wrongs = done.wrongs;
  compare(done, &plan_, wrongs);
  compare_threads(done, wrongs);
  keep_first_of_each_kind(wrongs);
  return wrongs;
}

}  // namespace clearcut::test_support
