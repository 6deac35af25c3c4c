#include "read/common/moved_part.h"

#include "base/error.h"
#include "base/text.h"

namespace clearcut::read {
namespace {

class Mover {
 public:
  explicit Mover(const std::array<double, 3>& zero) : in_plan_{false, {-zero[0], -zero[1]}}, up_(-zero[2]) {}
  explicit Mover(const PlanPlacement& placement) : in_plan_(placement) {}

  void move(Feature& feature) const {
    move(feature.target);
    move(feature.allowed);
    feature.top_z += up_;
    feature.floor_z += up_;
    if (feature.profile) move(*feature.profile);
    if (feature.chamfer) move(*feature.chamfer);
    if (!feature.hole) return;
    feature.hole->center = in_plan_.placed(feature.hole->center);
    feature.hole->full_z += up_;
  }
  void move(Box& plan, double& bottom, double& top) const {
    const Vec2 low = in_plan_.placed(plan.min), high = in_plan_.placed(plan.max);
    plan = {};
    plan.add(low);
    plan.add(high);
    bottom += up_;
    top += up_;
  }
  void move(StatedPath& stated) const {
    for (StatedMove& move : stated.moves) {
      Path path{move.path};
      this->move(path);
      move.path = path.front();
      move.z_from += up_;
      move.z_to += up_;
    }
  }
  void move(PredrilledHole& hole) const { hole.center = in_plan_.placed(hole.center); }
  void move(Regions& regions) const {
    for (Region& region : regions) {
      Loop outer = region.outer();
      std::vector<Loop> islands = region.islands();
      move(outer);
      for (Loop& island : islands) move(island);
      region = Region::from_valid_loops(std::move(outer), std::move(islands));
    }
  }
  double up() const { return up_; }

 private:
  void move(Path& path) const {
    for (Edge& edge : path) {
      edge.from = in_plan_.placed(edge.from);
      edge.to = in_plan_.placed(edge.to);
      if (edge.is_arc()) edge.center = in_plan_.placed(edge.center);
    }
  }
  void move(ProfileCut& profile) const {
    move(profile.line);
    for (Tab& tab : profile.tabs) {
      tab.center = in_plan_.placed(tab.center);
      Path foot{tab.foot};
      move(foot);
      tab.foot = foot.front();
      tab.top_z += up_;
      tab.bottom_z += up_;
      move(tab.body);
    }
  }
  void move(Chamfer& chamfer) const {
    move(chamfer.line);
    move(chamfer.free_beside);
    chamfer.free_floor += up_;
  }

  PlanPlacement in_plan_;
  double up_ = 0;
};

}  // namespace

ZeroPoint parse_zero_point(const std::string& text, const std::string& place) {
  ZeroPoint zero;
  if (text == "corner" || text == "centre") {
    zero.place = text;
    return zero;
  }
  const auto words = split(text, ',');
  for (std::size_t i = 0; words.size() == zero.point.size() && i < words.size(); ++i) {
    const auto coordinate = length_in_mm(words[i]);
    if (!coordinate) break;
    zero.point[i] = *coordinate;
    if (i + 1 == words.size()) return zero;
  }
  throw InputError(place, "'" + text + "' is unknown; use corner, centre, or X,Y,Z in mm");
}

std::array<double, 3> zero_of(const Part& part, const ZeroPoint& zero) {
  if (zero.place.empty()) return zero.point;
  Box plan;
  if (part.stock) {
    plan = part.stock->plan;
  } else {
    for (const Feature& feature : part.features) plan.add(box(feature.target));
  }
  const Vec2 at = zero.place == "corner" ? plan.min : plan.center();
  return {at.x, at.y, part.top_z()};
}

namespace {

Part moved_by(const Mover& mover, Part part) {
  for (Feature& feature : part.features) mover.move(feature);
  if (part.stock) mover.move(part.stock->plan, part.stock->z_bottom, part.stock->z_top);
  for (KeepOut& clamp : part.keep_outs) mover.move(clamp.plan, clamp.bottom_z, clamp.top_z);
  for (PredrilledHole& hole : part.predrilled) mover.move(hole);
  mover.move(part.left_out);
  for (Workingstep& step : part.workplan) {
    if (step.operation.retract_z) *step.operation.retract_z += mover.up();
    if (step.stated_path) mover.move(*step.stated_path);
  }
  if (part.clearance_z) *part.clearance_z += mover.up();
  return part;
}

}  // namespace

Part with_zero_at(Part part, const std::array<double, 3>& zero) {
  return moved_by(Mover(zero), std::move(part));
}

Part with_placement(Part part, const PlanPlacement& placement) {
  return moved_by(Mover(placement), std::move(part));
}

}  // namespace clearcut::read
