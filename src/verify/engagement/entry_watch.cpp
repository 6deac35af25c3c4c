#include "verify/engagement/entry_watch.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::verify {
namespace {

/// Degrees. A path of smaller slope is a sinking pass: at half a degree its length is more than a hundred times its
/// depth.
constexpr double kEntryAngle = 0.5;
/// mm down for each mm of advance, 0.17 degrees: on the first turn, because an entry takes one whole turn for the
/// thinnest layer, too.
constexpr double kLeastEntrySlope = 3e-3;
/// Share of a stated angle, for rounding of coordinates.
constexpr double kAngleRounding = 0.02;
/// Share of its depth by which an entry may be shallower than an earlier one and still be an entry into the same
/// layer.
constexpr double kSameLayerShare = 0.5;
/// Length that passes must cut before the next entry into the same place, as a multiple of the entry's length.
constexpr double kPassesBetween = 1;
/// Share of the radius: walls this near on both sides form a neck. Cosine from which on two directions are opposite.
constexpr double kNeck = 1.5, kOpposite = -0.5;
/// Alternate projections of two paths, and places between them.
constexpr int kProjections = 8, kPlaces = 16;
/// Degrees. Greatest slope of helices that are half in the air.
constexpr double kAngleInAir = 5;
/// mm. A level move this near to the preceding descent counts as over it.
constexpr double kOverDescent = 0.01;
/// mm; rounding of heights.
constexpr double kHeightRounding = 2e-3;
/// mm. A level move no longer than this between two ways down is a joint, as programs have where a helix whose end is given by an
/// angle goes back to a coordinate's last digit.
constexpr double kLongestJoint = 0.004;

bool is_joint(const CheckedMove& checked) {
  const Move& move = *checked.move;
  return checked.feeds() && move.z_to == move.z_from && !move.is_vertical() &&
         move.path.length() <= kLongestJoint;
}

}  // namespace

StatedEntry stated_entry(const Part& part, const Tool* tool) {
  StatedEntry stated;
  for (const Workingstep& step : part.workplan) {
    const auto index = static_cast<std::size_t>(step.operation.tool);
    if (!tool || step.operation.tool < 0 || index >= part.tools.size() ||
        part.tools[index].number != tool->number)
      continue;
    if (step.operation.entry_angle)
      stated.slope = std::min(stated.slope, base::tan(step.operation.entry_angle->radians()));
    stated.size = std::max(stated.size, step.operation.entry_size.value_or(0));
  }
  return stated;
}

std::span<const CheckedMove> descent_of(std::span<const CheckedMove> moves) {
  const auto goes_down = [](const CheckedMove& checked) {
    return is_joint(checked) ||
           (checked.feeds() && checked.move->z_to < checked.move->z_from && !checked.move->is_vertical());
  };
  const auto last = std::find_if_not(moves.begin(), moves.end(), goes_down);
  return moves.first(static_cast<std::size_t>(last - moves.begin()));
}

void EntryWatch::end() {
  if (state_ != State::kOutside && has_met_) {
    Past past{{}, {}, radius_, base_, kPassesBetween * length_};
    for (const Move* move : descent_) {
      past.path.push_back(move->path);
      past.box.add(move->path.box());
      past.level = std::min(past.level, move->z_to);
    }
    past_.push_back(std::move(past));
  }
  state_ = State::kOutside;
  begins_ = has_met_ = false;
  descent_.clear();
}

void EntryWatch::meets_material(const Move& move) {
  if (is_inside()) {
    has_met_ = true;
    return;
  }
  const double length = move.path.from == move.path.to ? 0 : move.path.length();
  for (Past& past : past_) past.passes -= length;
  std::erase_if(past_, [](const Past& past) { return past.passes <= 0; });
}

void EntryWatch::follow(std::span<const CheckedMove> moves, const StatedEntry& stated) {
  const CheckedMove& checked = moves.front();
  const Move& move = *checked.move;
  begins_ = at_joint_ = false;
  if (!checked.feeds() || move.z_to > move.z_from || move.is_vertical()) return end();
  if (move.z_to < move.z_from) return go_down(moves, stated);
  at_joint_ = state_ == State::kDescent && is_joint(checked);
  if (at_joint_) return;
  if (state_ == State::kOutside || !is_over_descent(move)) return end();
  state_ = State::kRound;
}

/// Whether both cutters pass over one area that passes could have crossed.
bool EntryWatch::is_beside(const Past& past, std::span<const CheckedMove> descent) const {
  return std::any_of(descent.begin(), descent.end(), [&](const CheckedMove& checked) {
    const double near = past.radius + checked.radius() - kOverDescent;
    const Edge& path = checked.move->path;
    return past.box.grown(near).overlaps(path.box()) &&
           std::any_of(past.path.begin(), past.path.end(), [&](const Edge& other) {
             return distance(other, path) < near && !is_cut_off(other, path, past.level, checked.radius());
           });
  });
}

/// Whether the straight line between two paths crosses a wall or a neck.
bool EntryWatch::is_cut_off(const Edge& a, const Edge& b, double z, double radius) const {
  if (finished_ == nullptr) return false;
  Vec2 from = a.at(0.5), to = b.at(0.5);
  for (int i = 0; i < kProjections; ++i) from = nearest_point(a, to), to = nearest_point(b, from);
  for (int i = 0; i <= kPlaces; ++i) {
    if (is_neck(from + (to - from) * (static_cast<double>(i) / kPlaces), z, radius)) return true;
  }
  return false;
}

/// Whether walls on opposite sides of p leave a cutter little or no room.
bool EntryWatch::is_neck(Vec2 p, double z, double radius) const {
  std::vector<Vec2> beside;
  const double near = radius * kNeck;
  finished_->wall_tree().within(p, near, [&](int i) {
    const Wall& wall = finished_->walls()[static_cast<std::size_t>(i)];
    const Vec2 way = nearest_point(wall.edge, p) - p;
    const double apart = norm(way);
    if (wall.stands_at(z + kHeightRounding) && apart < near && apart > 0) beside.push_back(way * (1 / apart));
  });
  return !finished_->is_free(p, z + kHeightRounding) ||
         std::any_of(beside.begin(), beside.end(), [&](Vec2 one) {
           return std::any_of(beside.begin(), beside.end(),
                              [&](Vec2 other) { return dot(one, other) < kOpposite; });
         });
}

void EntryWatch::begin(std::span<const CheckedMove> moves, const StatedEntry& stated) {
  const CheckedMove& first = moves.front();
  begins_ = true;
  base_ = first.move->z_from;
  slope_ = length_ = 0;
  radius_ = first.radius();
  turn_ = 2 * kPi * std::max(radius_, stated.size);
  const std::span<const CheckedMove> descent = descent_of(moves);
  const double floor = descent.back().move->z_to, same = floor - (base_ - floor) * kSameLayerShare;
  for (const Past& past : past_) {
    if (past.level >= same && past.level < base_ && is_beside(past, descent))
      base_ = std::max(floor, past.level);
  }
}

void EntryWatch::go_down(std::span<const CheckedMove> moves, const StatedEntry& stated) {
  const CheckedMove& checked = moves.front();
  if (state_ != State::kDescent) {
    end();
    begin(moves, stated);
  }
  const double slope = checked.slope(), usual = base::tan(kEntryAngle * kPi / 180);
  const bool steep = slope >= (1 - kAngleRounding) * std::min(usual, stated.slope);
  if (!steep && (slope < kLeastEntrySlope || length_ > turn_)) return end();
  state_ = State::kDescent;
  descent_.push_back(checked.move);
  slope_ = std::max(slope_, slope);
  slope_now_ = slope;
  length_ += checked.move->path.length();
}

bool EntryWatch::is_over_descent(const Move& move) const {
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec2 p = move.path.at(t);
    if (std::none_of(descent_.begin(), descent_.end(),
                     [&](const Move* ramp) { return distance(ramp->path, p) < kOverDescent; }))
      return false;
  }
  return true;
}

double EntryWatch::others_from(double z) const {
  if (state_ == State::kOutside) return z;
  const double own = state_ == State::kRound ? std::min(base_, z + turn_ * slope_) : base_;
  return std::max(z, own) + kHeightRounding;
}

void EntryWatch::meets_nothing_at(const Edge& path, double z) {
  if (state_ != State::kDescent || at_joint_) return;
  const double most = base::tan(kAngleInAir * kPi / 180);
  // One side of a descent may be in air, for half a turn; for a helix nearly a whole turn.
  double above = turn_ / 2 * std::min(slope_, most);
  if (path.is_arc())
    above = std::max(above, std::min(turn_, 2 * kPi * path.radius()) * std::min(slope_now_, most));
  base_ = std::min(base_, z + above);
}

}  // namespace clearcut::verify
