#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "resolve/features/shaping.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

/// mm on each side between the neck and the walls of its slot, at least.
constexpr double kBesideNeck = 0.1;
/// mm between a descending cutter and the walls of a pocket.
constexpr double kBesideWall = 0.1;
/// mm. Heights, and places at the side of the stock, nearer than this are one.
constexpr double kSameHeight = 0.01;
/// mm. Distance of sampled places beyond the side of the stock.
constexpr double kLookStep = 0.25;
/// mm2. Greatest area of remnants left by booleans of areas that only touch.
constexpr double kRemnant = 1e-3;

/// Extension of the line beyond its end needed for a cutter beside the stock, with its centre `needed` mm off the
/// stock; nothing if the line ends in the stock, or leads back into it.
std::optional<double> way_out(const Path& line, double needed, const Box& stock) {
  const Vec2 end = line.back().to, ahead = line.back().tangent_at(1);
  const Box inner = stock.grown(-kSameHeight);
  for (double way = 0; way <= 10 * needed; way += kLookStep) {
    const Vec2 at = end + ahead * way;
    if (inner.contains(at)) return std::nullopt;
    if (stock.distance_to(at) >= needed) return way;
  }
  return std::nullopt;
}

/// The line extended beyond its end for a cutter with its centre `off` mm off the stock, if the extension leads out
/// of the stock.
Path drawn_on(Path line, double off, const std::optional<Stock>& stock) {
  const auto way = stock ? way_out(line, off, stock->plan) : std::nullopt;
  if (!way || *way <= 0) return line;
  const Vec2 end = line.back().to, out = end + line.back().tangent_at(1) * *way;
  if (line.back().is_arc()) {
    line.push_back(Edge::line(end, out));
  } else {
    line.back().to = out;
  }
  return line;
}

/// At both ends.
Path drawn_out(const Path& line, double off, const std::optional<Stock>& stock) {
  return reversed(drawn_on(reversed(drawn_on(line, off, stock)), off, stock));
}

class TSlotShaper {
 public:
  TSlotShaper(Part& part, const PlanOptions& options, StepSources& sources)
      : part_(part), options_(options), sources_(sources) {}

  void run() {
    std::vector<Workingstep> workplan;
    for (const Workingstep& step : part_.workplan) {
      if (feature_of(part_, step).kind == FeatureKind::kTSlot) {
        const std::optional<Workingstep> neck = shape(step, workplan);
        if (neck) workplan.push_back(*neck);
      }
      workplan.push_back(step);
    }
    part_.workplan = std::move(workplan);
  }

 private:
  /// The step for milling the slot of the neck; none if an earlier step mills this slot.
  std::optional<Workingstep> shape(const Workingstep& step, const std::vector<Workingstep>& before) {
    const Tool& cutter = cutter_of(step);
    Feature& feature = part_.features[static_cast<std::size_t>(step.feature)];
    const bool is_free = is_neck_free(feature, cutter, before);
    const int mill = is_free ? -1 : neck_mill(feature, cutter);
    Feature neck = feature;
    find_ends(feature, cutter);
    sources_[step_key(step)].set("stepdown", {Origin::kDerived, "the height of the disc"});
    feature.top_z = feature.floor_z + *cutter.flute_length;
    if (is_free) return std::nullopt;
    neck.name += "_neck";
    neck.kind = FeatureKind::kEngraving;
    ProfileCut cut = *neck.profile;
    cut.line = drawn_out(cut.line, off_stock(part_.tools[static_cast<std::size_t>(mill)]), part_.stock);
    features::follow(neck, std::move(cut), options_.tol);
    return step_on(std::move(neck), step, mill);
  }

  /// Whether what is milled before leaves nothing where the neck runs.
  bool is_neck_free(const Feature& slot, const Tool& cutter, const std::vector<Workingstep>& before) const {
    Regions missing = features::kerf_of(*slot.profile, cutter.shank_diameter, options_.tol);
    if (part_.stock && !missing.empty())
      missing = intersect(missing, {rectangular_region(part_.stock->plan)}, options_.tol);
    for (const Workingstep& step : before) {
      const Feature& other = feature_of(part_, step);
      const bool is_open = !other.profile && !other.chamfer && !other.carving && !is_formed(other) &&
                           other.wall_slope.radians() == 0 && clears_floors(tool_of(part_, step)) &&
                           other.floor_z <= slot.floor_z + kSameHeight;
      if (is_open && !missing.empty()) missing = subtract(missing, other.allowed, options_.tol);
    }
    return area(missing) < kRemnant;
  }

  const Tool& cutter_of(const Workingstep& step) const {
    const Tool& cutter = tool_of(part_, step);
    const Feature& feature = feature_of(part_, step);
    if (cutter.kind != ToolKind::kTSlot)
      throw InputError(
          feature.name,
          "it is a T-slot and needs a T-slot cutter, with an end mill for the slot above; give both, for "
          "example --tool endmill:12 --tool tslot:20:length=8:shank=10");
    const double depth = feature.top_z - feature.floor_z;
    if (depth <= *cutter.flute_length + kSameHeight)
      throw InputError(
          feature.name,
          fmt::format(
              "it is {} mm deep and the disc of T{} {} mm high: nothing would stand over it; give more "
              "depth, or mill a slot",
              trimmed(depth, 3), cutter.number, trimmed(*cutter.flute_length, 3)));
    return cutter;
  }

  /// Index of the narrowest end mill whose slot the neck can pass.
  int neck_mill(const Feature& feature, const Tool& cutter) const {
    const double least = cutter.shank_diameter + 2 * kBesideNeck, depth = part_.top_z() - feature.floor_z;
    int best = -1;
    for (std::size_t i = 0; i < part_.tools.size(); ++i) {
      const Tool& tool = part_.tools[i];
      const bool fits = mills_upright(tool) && tool.kind != ToolKind::kFaceMill && tool.corner_radius == 0 &&
                        tool.kind != ToolKind::kBallEndMill && tool.diameter >= least &&
                        tool.diameter < cutter.diameter - kSameHeight &&
                        tool.flute_length.value_or(depth) >= depth - kSameHeight;
      if (!fits) continue;
      if (best < 0 || tool.diameter < part_.tools[static_cast<std::size_t>(best)].diameter)
        best = static_cast<int>(i);
    }
    if (best >= 0) return best;
    throw InputError(
        feature.name,
        fmt::format(
            "the slot above it comes first, for the neck of T{} ({} mm): give an end mill with a flat end of "
            "{} mm or more, under {} mm, whose flutes reach {} mm, for example --tool endmill:{}:length={}",
            cutter.number, trimmed(cutter.shank_diameter, 3), trimmed(least, 3), trimmed(cutter.diameter, 3),
            trimmed(depth, 3), trimmed(example_width(cutter), 1), trimmed(std::ceil(depth), 0)));
  }

  static double example_width(const Tool& cutter) {
    const double whole = std::ceil(cutter.shank_diameter + 2 * kBesideNeck);
    return whole < cutter.diameter ? whole : (cutter.shank_diameter + cutter.diameter) / 2;
  }

  /// mm; distance of the cutter's centre from the stock during its descent.
  double off_stock(const Tool& cutter) const {
    return cutter.radius() + features::clear_of_raw_stock(cutter.radius()) +
           options_.shop.stock_oversize.value_or(0);
  }

  /// Extends the line to the place of the disc's descent, which becomes its beginning.
  void find_ends(Feature& feature, const Tool& cutter) const {
    ProfileCut& cut = *feature.profile;
    if (cut.closed)
      throw InputError(feature.name, "a T-slot runs along an open line; open it where the disc can go down");
    cut.line = drawn_out(cut.line, off_stock(cutter), part_.stock);
    const bool at_end = is_free(feature, cut.line.back().to, cutter);
    const bool at_begin = is_free(feature, cut.line.front().from, cutter);
    if (!at_begin && !at_end)
      throw InputError(
          feature.name,
          fmt::format(
              "at neither end of its line the disc of T{} can go down: draw the line to the side of the "
              "material (STOCK), or end it in a pocket or hole at least {} mm wide and down to z {}",
              cutter.number, trimmed(cutter.diameter + 2 * kBesideWall, 3), trimmed(feature.floor_z, 3)));
    if (!at_begin) cut.line = reversed(cut.line);
    feature.t_slot = TSlot{at_begin && at_end};
  }

  /// Whether the place of the disc's descent is free: pockets, holes, or no stock. Such features must be cut before.
  bool is_free(const Feature& slot, Vec2 end, const Tool& cutter) const {
    Regions missing{disc_about(end, cutter.radius() + kBesideWall)};
    for (const Feature& other : part_.features) {
      const bool open = !other.profile && !other.chamfer && !other.carving && !is_formed(other) &&
                        other.wall_slope.radians() == 0 && other.floor_z <= slot.floor_z + kSameHeight;
      if (open && !missing.empty()) missing = subtract(missing, other.allowed, options_.tol);
    }
    if (part_.stock && !missing.empty())
      missing = intersect(missing, {rectangular_region(part_.stock->plan)}, options_.tol);
    return area(missing) < kRemnant;
  }

  Workingstep step_on(Feature neck, const Workingstep& like, int mill) {
    Workingstep step = like;
    step.name = neck.name;
    step.feature = static_cast<int>(part_.features.size());
    step.operation.name = neck.name;
    step.operation.is_tool_chosen = true;
    change_tool(step.operation, mill, part_, options_);
    sources_[step_key(step)] = sources_[step_key(like)];
    sources_[step_key(step)].set("tool", {Origin::kDerived, "the slot for the neck of the T-slot cutter"});
    part_.features.push_back(std::move(neck));
    return step;
  }

  Part& part_;
  const PlanOptions& options_;
  StepSources& sources_;
};

}  // namespace

void shape_t_slots(Part& part, const PlanOptions& options, StepSources& sources) {
  TSlotShaper(part, options, sources).run();
}

}  // namespace clearcut::resolve
