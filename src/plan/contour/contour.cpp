// Source and symbols (the papers CPO-kappa and CPO-rho, docs/texts.md):
//
//   paper   here                 unit   where
//   R       layer.tool_radius    mm
//   e       layer.wall_stock     mm     finishing allowance
//   H       step                 mm     R + e for the first contour, then 2 R kappa (CPO-kappa eq. 2)
//   kappa   kappa(), rho()              CPO-kappa eq. 6, CPO-rho eq. 8
//   A       see residual_paths   mm     from a contour to the centre; a residual is left there for R < A < 2R.
//                                       Here every maximum and ridge of the clearance counts as a centre.
//
// The contours come from one Voronoi diagram instead of edge by edge, so that vanishing edges (CPO-kappa alg.
// 2), splits and islands need no rule of their own. docs/contour.md lists the departures.
#include "plan/contour/contour.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/elementary.h"
#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "geometry/contours/mitred_inset.h"
#include "geometry/route/legal_area.h"
#include "plan/common/clearing_area.h"
#include "plan/common/cover.h"
#include "plan/common/layers.h"
#include "plan/common/pass_parts.h"
#include "plan/common/round_corners.h"
#include "plan/contour/passes.h"
#include "plan/contour/published_rings.h"
#include "plan/contour/step_rule.h"

namespace clearcut::plan::contour {
namespace {

/// Steps smaller than this share of the radius are typing errors.
constexpr double kSmallestStep = 0.005;
/// mm. Rings a whole diameter apart just meet; rounding of the program's numbers may part them by this.
constexpr double kRingResidual = 0.001;
/// mm. On layers without permitted residual: overlap of rings, and of the paths clearing the residuals of rings.
constexpr double kBareOverlap = 0.004;
constexpr double kBareMargin = 0.002;
/// mm. An edge of the target with one of a few places farther than this from every wall is open: a side that a wall touches at a place
/// alone is none. At these shares of its length, which no outline has for a reason.
constexpr double kOpenDistance = 1e-3;
constexpr double kPlacesOnEdge[] = {0.23, 0.5, 0.71};

bool on_wall(Vec2 p, const Regions& allowed) {
  return std::any_of(allowed.begin(), allowed.end(),
                     [&](const Region& region) { return region.boundary_distance(p) <= kOpenDistance; });
}

bool is_wall(const Edge& edge, const Regions& allowed) {
  return std::all_of(std::begin(kPlacesOnEdge), std::end(kPlacesOnEdge),
                     [&](double share) { return on_wall(edge.at(share), allowed); });
}

bool has_wall(const Loop& loop, const Regions& allowed) {
  return std::any_of(loop.begin(), loop.end(), [&](const Edge& e) { return is_wall(e, allowed); });
}

bool has_open_side(const Loop& loop, const Regions& allowed) {
  return std::any_of(loop.begin(), loop.end(), [&](const Edge& e) { return !is_wall(e, allowed); });
}

/// Share of the radius. Beside a wall's end the strip of air must be wider than the cutter, or a ring would
/// just fit into it; thin rests along walls need at least 2.
constexpr double kReachBesideWalls = 2.05;

/// Place of the first ring of a target with open sides.
enum class FaceRing {
  kFromWalls,  ///< rings are at growing distance from the walls alone, and end at the open sides
  kInside,     ///< inside the edge, just near enough to clear the sharpest corner
  kOnEdge      ///< on the edge, so that arms too narrow for a ring inside are also cleared
};

/// mm; permitted extent of rings through air beyond the target's open sides (docs/contour.md, "Open sides").
/// Beside walls by Layer::rounded more, as material there may be narrower than the rounding of the cutter's end.
double reach_beyond(const Region& target, const Layer& layer, FaceRing face_ring) {
  const Regions& allowed = layer.allowed;
  const double radius = layer.tool_radius;
  const auto islands_clear = [&](const Loop& island) {
    return std::all_of(island.begin(), island.end(), [&](const Edge& e) {
      return std::all_of(target.outer().begin(), target.outer().end(),
                         [&](const Edge& side) { return distance(e, side) > 3 * radius; });
    });
  };
  const bool face = !has_wall(target.outer(), allowed) &&
                    std::all_of(target.islands().begin(), target.islands().end(), islands_clear);
  if (!face) return kReachBesideWalls * radius + layer.rounded;
  if (face_ring == FaceRing::kOnEdge) return radius;
  return radius - 0.98 * radius * base::sin(smallest_angle(target) / 2);
}

/// Where only the walls that the cutter may touch bound the rings: a wide frame around the target, less the walls. Empty if there
/// are none.
Regions domain_of_walls(const Layer& layer, const Tolerances& tol) {
  const double beyond = kReachBesideWalls * layer.tool_radius + layer.rounded + layer.wall_stock;
  const auto walls = subtract(dilate(layer.target, beyond, tol), layer.allowed, tol);
  if (walls.empty()) return {};
  const Box around = box(layer.target);
  // Nothing in the target is nearer to the frame than to a wall.
  const double frame = distance(around.min, around.max) + 2 * beyond;
  return subtract({rectangular_region(around.grown(frame))}, walls, tol);
}

/// Takes off what the passes have beyond the places from which the target is reached.
void end_at_open_sides(const Layer& layer, bool keeps_direction, const Tolerances& tol,
                       LayerPasses& planned) {
  const Regions near = dilate(layer.target, layer.tool_radius + layer.rounded, tol);
  std::vector<std::vector<Pass>> parts;
  for (const Pass& pass : planned.passes) {
    parts.emplace_back();
    for (Path& stretch : stretches_inside(pass.path, pass.closed, near)) {
      Pass& part = parts.back().emplace_back(pass);
      part.closed = pass.closed && stretch.front().from == stretch.back().to;
      part.path = std::move(stretch);
      part.reversible = pass.reversible || (!part.closed && pass.parent >= 0 && !keeps_direction);
    }
  }
  replace_passes(planned, std::move(parts));
}

/// The area in which rings are planned: `allowed` without the area far beyond the target's open sides.
Regions working_domain(const Layer& layer, FaceRing face_ring, const Tolerances& tol) {
  if (closed_all_round(layer)) return layer.allowed;
  if (face_ring == FaceRing::kFromWalls) return domain_of_walls(layer, tol);
  Regions closed, open;
  double beyond = 0;
  for (const auto& target : layer.target) {
    const bool opens = has_open_side(target.outer(), layer.allowed) ||
                       std::any_of(target.islands().begin(), target.islands().end(),
                                   [&](const Loop& loop) { return has_open_side(loop, layer.allowed); });
    (opens ? open : closed).push_back(target);
    // Rings keep wall_stock off the border of their area; no stock is needed in the air, so wall_stock is added
    // again.
    const double reach = reach_beyond(target, layer, face_ring) + layer.wall_stock;
    if (opens) beyond = std::max(beyond, reach);
  }
  if (!open.empty()) {
    const auto near = intersect(layer.allowed, dilate(open, beyond, tol), tol);
    closed.insert(closed.end(), near.begin(), near.end());
  }
  return closed;
}

Regions legal_centers(const Layer& layer, const Tolerances& tol) {
  Regions legal;
  for (const auto& region : layer.allowed) {
    const auto inside = safe_inset(Clearance(region, tol), region, layer.tool_radius + layer.wall_stock, tol);
    legal.insert(legal.end(), inside.begin(), inside.end());
  }
  return legal;
}

std::vector<Domain> domains_of(const Layer& layer, FaceRing face_ring, const Tolerances& tol) {
  std::vector<Domain> domains;
  for (const auto& region : working_domain(layer, face_ring, tol)) domains.emplace_back(region, tol);
  return domains;
}

/// Legal area of the cutter's centre. If the pocket is closed all round, the rings at the wall bound it.
Regions legal_area(const Layer& layer, const std::vector<Domain>& domains, double first_level,
                   const Tolerances& tol) {
  if (!closed_all_round(layer)) return legal_centers(layer, tol);
  Regions legal;
  for (const auto& domain : domains) {
    const auto inside = safe_inset(domain.clearance, domain.region, first_level, tol);
    legal.insert(legal.end(), inside.begin(), inside.end());
  }
  return legal;
}

bool is_path(const Pass& pass) {
  return !pass.closed && !pass.reversible;
}

/// Turns shortened paths from inside-out to outside-in: each runs backwards, and the last comes first.
void reverse_paths(LayerPasses& layer) {
  const auto paths = std::stable_partition(layer.passes.begin(), layer.passes.end(),
                                           [](const Pass& pass) { return !is_path(pass); });
  std::reverse(paths, layer.passes.end());
  std::for_each(paths, layer.passes.end(), [](Pass& pass) { pass.path = reversed(pass.path); });
}

/// Adds a straight path from `start` to the first path reachable by a straight path.
void begin_at(Vec2 start, LayerPasses& layer) {
  const LegalArea legal(layer.legal);
  for (auto& pass : layer.passes) {
    if (!is_path(pass)) continue;
    const Vec2 first = pass.path.front().from;
    if (first == start || !legal.holds_line(start, first)) continue;
    pass.path.insert(pass.path.begin(), Edge::line(start, first));
    return;
  }
}

bool is_corrected(const StepRule& rule) {
  if (rule.kind == StepRule::Kind::kPerContour)
    return std::all_of(rule.contours.begin(), rule.contours.end(), is_corrected);
  return rule.kind == StepRule::Kind::kKappaCorrected || rule.kind == StepRule::Kind::kRhoCorrected;
}

/// Whether a method clears everything, by its steps or by what it adds to its contours.
bool leaves_nothing(const ContourOptions& options) {
  switch (options.residuals) {
    case ResidualRule::kNone:
      return is_corrected(options.step);
    case ResidualRule::kPassages:
    case ResidualRule::kBisectors:
      return false;
    default:
      return true;
  }
}

/// Plans rings and shortened paths from the inside out.
LayerPasses plan_inside_out(const Layer& layer, const ContourOptions& options, FaceRing face_ring,
                            const Tolerances& tol);

}  // namespace

LayerPasses plan_contour(const Layer& layer, const ContourOptions& options, const Tolerances& tol) {
  ContourOptions inside_out = options;
  // The paths are reversed at the end, so their rings are planned in the opposite direction.
  if (options.outside_in) inside_out.wall_on_right = !options.wall_on_right;
  const bool is_from_walls = options.from_walls && !closed_all_round(layer);
  LayerPasses result =
      plan_inside_out(layer, inside_out, is_from_walls ? FaceRing::kFromWalls : FaceRing::kInside, tol);
  const bool clears = !is_from_walls && options.residuals == ResidualRule::kOurs && !closed_all_round(layer);
  if (clears && leaves_border(result, layer.tool_radius, layer.tool_radius - kBorderResidual))
    result = plan_inside_out(layer, inside_out, FaceRing::kOnEdge, tol);
  result.outside_in = options.outside_in;
  result.start = options.start;
  if (options.passage == Passage::kBisector)
    join_along_bisectors(result, options);
  else if (options.outside_in)
    reverse_paths(result);
  if (options.start) begin_at(*options.start, result);
  return result;
}

namespace {

/// Whether contours that were to keep reflex corners are round at one of them.
bool rounds_reflex_corners(const Layer& layer, const std::vector<Domain>& domains,
                           const std::vector<bool>& with_corners) {
  if (!closed_all_round(layer))
    return std::any_of(layer.allowed.begin(), layer.allowed.end(), has_reflex_corner);
  for (std::size_t i = 0; i < domains.size(); ++i)
    if (!with_corners[i] && has_reflex_corner(domains[i].region)) return true;
  return false;
}

Remark rounded_corners(const Layer& layer, const std::vector<Domain>& domains) {
  const bool has_an_arc = std::any_of(domains.begin(), domains.end(),
                                      [](const Domain& domain) { return has_arcs(domain.region); });
  const char* const why = !closed_all_round(layer) ? "the outline has open sides"
                          : has_an_arc             ? "the outline has arcs"
                                                   : "with corners they are not proven to leave nothing";
  return {"ROUND AT REFLEX CORNERS",
          fmt::format("contours are round at reflex corners, which were to stay corners: {}", why)};
}

LayerPasses plan_inside_out(const Layer& layer, const ContourOptions& options, FaceRing face_ring,
                            const Tolerances& tol) {
  CLEARCUT_ASSERT(layer.tool_radius > 0);
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "contour";
  const auto domains = domains_of(layer, face_ring, tol);
  RingJob job;
  job.radius = layer.tool_radius;
  job.first_level = layer.tool_radius + layer.wall_stock;
  job.reserve = layer.reserve;
  job.residuals = options.residuals;
  // If rings fit exactly, as in pockets of round dimensions, accepting a residual saves a pass; on faces there is no
  // saving.
  const bool bare = layer.bare || !closed_all_round(layer);
  job.margin = bare ? kBareMargin : 0;
  const double overlap = bare && options.step.kind == StepRule::Kind::kWidest ? kBareOverlap : 0;
  job.step = [&](const RingNode& ring, const std::vector<AxisPiece>& inside) {
    const double step = step_after(ring, inside, options.step, layer.tool_radius) - overlap;
    return std::max(step, kSmallestStep * layer.tool_radius);
  };
  if (options.sharp_reflex) {
    job.sharp_step = [&, step = job.step](const RingNode& ring, const std::vector<AxisPiece>& inside) {
      return std::min(step(ring, inside),
                      step_past_reflex_corners(ring, options.step, layer.tool_radius) - overlap);
    };
    job.leaves_nothing = leaves_nothing(options);
  }
  result.legal = legal_area(layer, domains, job.first_level, tol);
  job.fit_lines = fit_lines_of(domains, job);
  RingPasses rings = ring_passes(domains, job, tol);
  result.passes = std::move(rings.passes);
  if (options.sharp_reflex && rounds_reflex_corners(layer, domains, rings.with_corners))
    result.remarks.push_back(rounded_corners(layer, domains));
  result.residual = bare ? 0 : kRingResidual;
  for (const auto& pass : result.passes) {
    if (!pass.closed && pass.parent < 0) result.fit_lines.push_back(pass.path);
  }
  const bool has_corners = std::any_of(domains.begin(), domains.end(), [&](const Domain& domain) {
    return keeps_corners(domain, job) && has_reflex_corner(domain.region);
  });
  // Shortened paths and rounded corners are no contours with corners.
  const bool ours = options.step.kind == StepRule::Kind::kWidest &&
                    options.residuals == ResidualRule::kOurs && !has_corners;
  if (ours && options.passage == Passage::kShortest && closed_all_round(layer))
    shorten_passes(domains, job, layer, options, tol, result);
  if (face_ring == FaceRing::kFromWalls) end_at_open_sides(layer, options.keeps_direction, tol, result);
  if (ours) round_corners(result, job.radius, options.feed.mm_per_s(), options.machine.acceleration);
  return result;
}

}  // namespace

namespace {

/// A contour-parallel method: its name, its step if none is given, and its rule for clearing residuals.
struct ContourMethod {
  const char* name;
  const char* description;
  const char* stepover;
  ResidualRule residuals;
};

constexpr ContourMethod kContourMethods[] = {
    {"contour", "contours as wide as the cutter allows, rests cut locally", "widest", ResidualRule::kOurs},
    {"lom", "published: step 2 R kappa from the smallest angle", "lom", ResidualRule::kNone},
    {"rho", "published: step 2 R rho, overlap of 1 mm in the corner", "rho", ResidualRule::kNone},
    {"second", "published: rho of the second smallest angle, passages along the smallest", "second",
     ResidualRule::kPassages},
    {"lom-corrected", "ours: the widest step between contours that leaves nothing", "lom-corrected",
     ResidualRule::kNone},
    {"rho-corrected", "ours: the same with the overlap of rho", "rho-corrected", ResidualRule::kNone},
    {"fixed", "contours at a fixed step, nothing else", "0.9", ResidualRule::kNone},
    {"loops", "published: fixed step and a loop in every corner", "0.9", ResidualRule::kLoops},
    {"pwid", "published: fixed step and a kite in every corner", "0.9", ResidualRule::kPwid},
    {"single", "published: fixed step and a tangent loop in every corner", "0.9", ResidualRule::kSingleLoops},
    {"double", "published: fixed step and two tangent loops in every corner", "0.9",
     ResidualRule::kDoubleLoops},
    {"bisectors", "published: fixed step and every corner's bisector", "0.9", ResidualRule::kBisectors}};

/// Published methods connect contours along bisectors, but use the shortest links if another strategy was requested
/// and they only serve for comparison, and if there are leads, because leads need closed rings.
Passage passage_of(const ContourMethod& method, const StrategyRequest& request) {
  const bool leads = request.step.lead > 0;
  if (request.step.bisector_passages.value_or(false) && leads)
    throw InputError("--passage",
                     "rings that begin with leads are not joined; leave out --lead or --passage bisector");
  const std::string name = method.name;
  const bool is_published = name != "contour" && !name.ends_with("-corrected");
  const bool is_asked_for = request.step.strategy != nullptr && request.step.strategy->name == name;
  return request.step.bisector_passages.value_or(is_published && is_asked_for && !leads) ? Passage::kBisector
                                                                                         : Passage::kShortest;
}

/// As in the published texts: lom, rho and second have corners.
bool has_sharp_reflex(const ContourMethod& method, const StrategyRequest& request) {
  const std::string name = method.name;
  const bool is_printed_so = name == "lom" || name == "rho" || name == "second";
  return request.step.sharp_reflex.value_or(is_printed_so);
}

Strategy make(const ContourMethod& method, const StrategyRequest& request, bool from_walls = false) {
  ContourOptions options;
  options.from_walls = from_walls;
  options.keeps_direction = request.step.is_direction_asked;
  options.step = parse_step_rule(request.stepover.is_given() ? request.stepover.text : method.stepover);
  options.residuals = method.residuals;
  options.passage = passage_of(method, request);
  options.sharp_reflex = has_sharp_reflex(method, request);
  options.machine = request.plan.machine;
  options.feed = request.step.feed;
  if (request.step.lead > 0) options.effort = 0;  // rings stay whole, because leads need a place to begin
  options.wall_on_right = request.step.wall_on_right();
  options.outside_in = request.plan.order == ContourOrder::kOutsideIn;
  options.start = request.plan.start;
  options.cancel = request.plan.cancel;
  return once_per_outline(
      [options, tol = request.plan.tol](const Layer& layer) { return plan_contour(layer, options, tol); });
}

StrategyEntry entry_of(const ContourMethod& method) {
  StrategyEntry entry;
  entry.name = method.name;
  entry.description = method.description;
  entry.make = [&method](const StrategyRequest& request) { return make(method, request); };
  if (method.residuals != ResidualRule::kOurs) return entry;
  entry.in_auto = AutoUse::kFirst;
  entry.loses_air_cuts = true;
  StrategyEntry from_walls = entry;
  from_walls.make = [&method](const StrategyRequest& request) { return make(method, request, true); };
  entry.form_for_open = std::make_shared<const StrategyEntry>(std::move(from_walls));
  // Methods without residuals by construction are compared with this one.
  entry.rivals = {"single", "double", "pwid", "loops", "lom-corrected"};
  entry.fallbacks = {"", "0.6", "0.35"};
  return entry;
}

}  // namespace

std::vector<StrategyEntry> entries() {
  std::vector<StrategyEntry> all;
  for (const ContourMethod& method : kContourMethods) all.push_back(entry_of(method));
  return all;
}

std::optional<StepRule> contour_rule(const std::string& name, const Stepover& stepover) {
  const auto method = std::find_if(std::begin(kContourMethods), std::end(kContourMethods),
                                   [&](const ContourMethod& one) { return name == one.name; });
  if (method == std::end(kContourMethods) || method->residuals == ResidualRule::kOurs) return std::nullopt;
  return parse_step_rule(stepover.is_given() ? stepover.text : method->stepover);
}

std::optional<StepRule> published_rule(const std::string& name) {
  const auto method = std::find_if(std::begin(kContourMethods), std::end(kContourMethods),
                                   [&](const ContourMethod& one) { return name == one.name; });
  const bool steps_alone =
      method != std::end(kContourMethods) &&
      (method->residuals == ResidualRule::kNone || method->residuals == ResidualRule::kPassages);
  if (!steps_alone) return std::nullopt;
  return parse_step_rule(method->stepover);
}

}  // namespace clearcut::plan::contour
