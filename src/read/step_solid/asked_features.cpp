#include "read/step_solid/asked_features.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/repair/repair.h"
#include "read/step_solid/height_map.h"

namespace clearcut::read {

std::vector<Feature> settle_tops(std::vector<Feature>& features, const Stock& stock, const Tolerances& tol) {
  std::vector<Feature> thin;
  for (;;) {
    Part part;
    part.stock = stock;
    add_features(part, features);
    const std::vector<double> tops = features::stacked_tops(part, tol);
    for (std::size_t i = 0; i < tops.size(); ++i) features[i].top_z = tops[i];
    const auto first = std::find_if(features.begin(), features.end(), [&](const Feature& feature) {
      return feature.top_z - feature.floor_z < tol.gouge + kSameHeight;
    });
    if (first == features.end()) return thin;
    // One at a time: material not cut by it remains over the features below.
    thin.push_back(std::move(*first));
    features.erase(first);
  }
}

namespace {

/// mm. A thread's hole may be modelled so much narrower than its core or wider than its nominal size.
constexpr double kThreadSlack = 0.1;
/// mm. Width of a broken edge without a stated depth.
constexpr double kBrokenEdge = 0.2;
/// Depth of a modelled blind hole left free below its thread, in pitches: the tap's lead and room for chips.
constexpr double kUnderBlindThread = 3;
/// The same for a thread mill, which begins this far below the thread.
constexpr double kUnderMilledThread = 1.25;
constexpr double kSameSize = 1e-3;  // mm

constexpr const char* kKindsOfFeatures =
    "drill, spot, ream, bore, cbore, csk, tap, thread, pocket, inside, profile, chamfer or ignore";

std::string names_of(const std::vector<Feature>& features) {
  constexpr std::size_t kListed = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(features.size(), kListed); ++i)
    text += (i ? ", " : "") + features[i].name;
  return features.size() > kListed ? text + " and " + std::to_string(features.size() - kListed) + " more"
                                   : text;
}

/// "2,5": numbers from 1; nothing for other texts.
std::optional<std::set<std::size_t>> numbers_in(const std::string& pattern) {
  std::set<std::size_t> numbers;
  const char* at = pattern.data();
  const char* end = at + pattern.size();
  while (true) {
    std::size_t number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || number < 1) return std::nullopt;
    numbers.insert(number);
    if (next == end) return numbers;
    if (*next != ',') return std::nullopt;
    at = next + 1;
  }
}

/// One rule at one feature.
struct AskedOf {
  const LayerRule& rule;
  const Stock& stock;
  const Tolerances& tol;
};

std::string place_of(const Feature& feature) {
  return "--op (" + feature.name + ")";
}

[[noreturn]] void refuse(const Feature& feature, const std::string& why) {
  throw InputError(place_of(feature), why);
}

double drawn_diameter(const Feature& feature, const AskedOf& asked) {
  const auto diameter =
      feature.target.size() == 1 ? circle_diameter(feature.target.front(), asked.tol) : std::nullopt;
  if (feature.kind != FeatureKind::kRoundHole || !diameter)
    refuse(feature,
           "it is a " + std::string(name_of(feature.kind)) + " and no round hole; choose round holes");
  return *diameter;
}

/// z of the requested full depth of a thread, a seat or a hole; the feature's own floor if not stated.
double full_depth_asked(const Feature& feature, const AskedOf& asked) {
  if (!asked.rule.depth) return feature.floor_z;
  const double full = feature.top_z - checked_depth(*asked.rule.depth, place_of(feature));
  const double bottom = feature.through ? asked.stock.z_bottom : feature.floor_z;
  if (full < bottom - kSameSize)
    refuse(feature, "it is asked " + trimmed(*asked.rule.depth, 3) + " mm deep and the solid has " +
                        trimmed(feature.top_z - bottom, 3) + " mm there; use less depth");
  return full;
}

bool is_threaded(const HoleRequest& request) {
  return request.kind == HoleKind::kTapped || request.kind == HoleKind::kThreadMilled;
}

void refuse_other_width(const Feature& feature, double drawn, const HoleRequest& request) {
  const double least = minor_diameter(*request.thread) - kThreadSlack;
  const double most = request.thread->diameter + kThreadSlack;
  if (drawn >= least && drawn <= most) return;
  refuse(feature, "it is " + trimmed(drawn, 3) + " mm wide, and the hole of " + request.thread->name +
                      " is modelled " + trimmed(minor_diameter(*request.thread), 3) + " to " +
                      trimmed(request.thread->diameter, 3) +
                      " mm wide; choose other holes or another thread");
}

/// mm; finished diameter of the requested hole.
double finished_diameter(double drawn, const HoleRequest& request) {
  if (is_threaded(request)) return request.thread->diameter;
  return request.diameter.value_or(drawn);
}

/// mm between a blind thread and the hole's floor.
double room_under(const AskedOf& asked) {
  const HoleRequest& request = *asked.rule.hole;
  return (request.kind == HoleKind::kTapped ? kUnderBlindThread : kUnderMilledThread) * request.thread->pitch;
}

/// z down to which a blind thread is full: the tap's lead remains above the modelled floor.
double full_thread(const Feature& feature, const AskedOf& asked) {
  if (feature.through) return full_depth_asked(feature, asked);
  if (asked.rule.depth) {
    const double full = full_depth_asked(feature, asked), least = feature.floor_z + room_under(asked);
    if (full >= least - kSameSize) return full;
    refuse(feature, "its thread is asked full down to z " + trimmed(full, 3) +
                        ", and above the solid's floor its tool needs " + trimmed(room_under(asked), 3) +
                        " mm; ask for at most " + trimmed(feature.top_z - least, 3) + " mm");
  }
  const double under = room_under(asked);
  if (feature.top_z - feature.floor_z <= under)
    refuse(
        feature,
        "it is " + trimmed(feature.top_z - feature.floor_z, 3) +
            " mm deep, too little for a thread with its lead; say how far down it is full, as in tap_m6_d12");
  return feature.floor_z + under;
}

/// Whether the solid's hole is kept as a preceding step: the core of a thread, the hole below a cone or a seat.
bool stays_before(const HoleRequest& request, double drawn, bool is_through) {
  if (request.kind == HoleKind::kSpotted) return true;
  if (request.kind == HoleKind::kCountersunk || request.kind == HoleKind::kCounterbored)
    return request.diameter.value_or(drawn) > drawn + kSameSize;
  // The pilot hole of a through thread ends below the solid: it is added with the thread.
  if (!is_threaded(request) || is_through) return false;
  const double least = minor_diameter(*request.thread);
  return drawn > least - kSameSize && drawn < least + minor_tolerance(*request.thread) + kSameSize;
}

void refuse_without_size(const Feature& feature, const HoleRequest& request, double drawn,
                         const LayerRule& rule) {
  const bool is_seat = request.kind == HoleKind::kCountersunk || request.kind == HoleKind::kCounterbored;
  if (is_seat && request.diameter.value_or(drawn) <= drawn + kSameSize)
    refuse(feature, "it says no width above the hole's " + trimmed(drawn, 3) +
                        " mm; name it, as in csk_dia12 or cbore_dia12_d5");
  if (request.kind == HoleKind::kCounterbored && !rule.depth)
    refuse(feature, "a counterbore needs its depth, as in cbore_dia12_d5");
}

/// Changes the hole as requested; adds the preceding hole to `before`.
void make_asked_hole(Feature& feature, const AskedOf& asked, std::vector<Feature>& before) {
  const double drawn = drawn_diameter(feature, asked);
  const HoleRequest request = asked.rule.hole.value_or(HoleRequest{});
  if (is_threaded(request) && !request.thread)
    refuse(feature,
           "it is to be threaded and names no thread there is a table for; write tap_m6_thru, tap_m6_d12 or "
           "thread_m20x1.5_thru");
  if (request.external)
    refuse(feature, "it is a hole; threads about bosses are drawn on a layer of a drawing");
  if (is_threaded(request)) refuse_other_width(feature, drawn, request);
  refuse_without_size(feature, request, drawn, asked.rule);
  if (request.through && !feature.through)
    refuse(feature,
           "it is asked to go through, and the solid has a floor at z " + trimmed(feature.floor_z, 3));
  HoleForm form;
  form.kind = request.kind;
  form.center = feature.target.front().outer().front().center;
  form.diameter = finished_diameter(drawn, request);
  form.full_z = is_threaded(request) ? full_thread(feature, asked) : full_depth_asked(feature, asked);
  if (is_threaded(request)) form.thread = request.thread;
  form.chip_break = request.chip_break;
  form.peck = request.peck;
  if (stays_before(request, drawn, feature.through)) before.push_back(feature);
  const bool is_seat = request.kind == HoleKind::kCountersunk || request.kind == HoleKind::kCounterbored ||
                       request.kind == HoleKind::kSpotted;
  if (asked.rule.depth || is_seat) feature.through = false;
  if (request.kind == HoleKind::kCounterbored || (asked.rule.depth && !is_threaded(request)))
    feature.floor_z = form.full_z;
  feature.hole_diameter = form.diameter;
  feature.target = feature.allowed = {disc_about(form.center, form.diameter / 2)};
  feature.hole = form;
}

/// The cutter follows the line through the wall, and the inside remains a piece.
void cut_out(Feature& feature, const AskedOf& asked, ProfileSide side) {
  const bool inside = side == ProfileSide::kInside;
  if (!feature.through)
    refuse(feature, "it does not go through the solid; only what does is cut out along its wall");
  const Region& region = feature.target.front();
  if (inside && (feature.kind == FeatureKind::kOutsideProfile || !region.islands().empty()))
    refuse(feature, "it is no single opening; choose through pockets and holes without islands");
  if (!inside && (feature.kind != FeatureKind::kOutsideProfile || region.islands().size() != 1))
    refuse(feature,
           "it is not the outside all round of one part; state a larger stock in a job, or choose inside for "
           "an opening");
  ProfileCut cut;
  cut.side = side;
  cut.line = inside ? region.outer() : region.islands().front();
  if (signed_area(cut.line) < 0) cut.line = reversed(cut.line);
  cut.beyond = std::max(0.0, asked.stock.z_bottom - feature.floor_z);
  feature.kind = inside ? FeatureKind::kInsideProfile : FeatureKind::kOutsideProfile;
  feature.hole_diameter.reset();
  features::follow(feature, std::move(cut), asked.tol);
}

/// The edges at the top of a feature.
void add_edges(const Feature& feature, const AskedOf& asked, std::vector<Feature>& after) {
  const double depth = checked_depth(asked.rule.depth.value_or(kBrokenEdge), place_of(feature));
  if (feature.hole || feature.chamfer)
    refuse(feature, "it has no edge of its own; choose pockets and plain holes");
  for (Loop& loop : loops_of(feature.target)) {
    Feature edge;
    edge.kind = FeatureKind::kChamfer;
    edge.name = feature.name + "_chamfer";
    edge.source = feature.source;
    edge.top_z = feature.top_z;
    edge.floor_z = feature.top_z - depth;
    edge.target = edge.allowed = features::kerf_of({ProfileSide::kOn, loop, true, 0, {}}, depth, asked.tol);
    edge.chamfer = Chamfer{std::move(loop), depth, true, {}, 0, 0};
    after.push_back(std::move(edge));
  }
}

/// Features resulting from a rule.
struct Outcome {
  std::vector<Feature> features, after;
};

/// Adds the resulting feature; nothing if it is left out.
void apply(Feature feature, const AskedOf& asked, Outcome& out) {
  switch (*asked.rule.role) {
    case LayerRole::kIgnore:
      return;
    case LayerRole::kHole: {
      std::vector<Feature> before;
      make_asked_hole(feature, asked, before);
      if (before.empty()) {
        out.features.push_back(std::move(feature));
        return;
      }
      for (Feature& one : before) out.features.push_back(std::move(one));
      feature.name += "_" + std::string(name_of(feature.hole->kind));
      out.after.push_back(std::move(feature));
      return;
    }
    case LayerRole::kPocket:
      if (feature.kind == FeatureKind::kRoundHole && !feature.hole) {
        feature.kind = FeatureKind::kClosedPocket;
        feature.hole_diameter.reset();
      }
      break;
    case LayerRole::kInside:
      cut_out(feature, asked, ProfileSide::kInside);
      break;
    case LayerRole::kProfile:
      cut_out(feature, asked, ProfileSide::kOutside);
      break;
    case LayerRole::kChamfer:
      add_edges(feature, asked, out.after);
      break;
    default:
      refuse(feature, std::string("features of a solid are made so: ") + kKindsOfFeatures);
  }
  out.features.push_back(std::move(feature));
}

/// Features matched by a rule; throws if none.
std::vector<bool> chosen_by(const LayerRule& rule, const std::vector<Feature>& features) {
  std::vector<bool> chosen(features.size(), false);
  const auto numbers = numbers_in(rule.pattern);
  for (std::size_t i = 0; i < features.size(); ++i)
    chosen[i] = numbers ? numbers->contains(i + 1) : matches(rule.pattern, features[i].name);
  const bool any = std::find(chosen.begin(), chosen.end(), true) != chosen.end();
  const bool too_many = numbers && *numbers->rbegin() > features.size();
  if ((!any || too_many) && rule.asked)
    throw InputError("--op", "no feature of the solid is called '" + printable(rule.pattern) + "'; it has " +
                                 names_of(features) +
                                 " (numbers count them in this order, * stands for anything)");
  return chosen;
}

}  // namespace

void name_features(std::vector<Feature>& features) {
  Part part;
  add_features(part, std::move(features));
  features = std::move(part.features);
}

void apply_operations(std::vector<Feature>& features, const Stock& stock, const ReadOptions& options,
                      Diagnostics& diagnostics) {
  std::vector<std::optional<LayerRule>> rules(features.size());
  for (const LayerRule& rule : options.layer_rules) {
    if (!rule.role) {
      diagnostics.warn("--op", "'" + printable(rule.pattern) +
                                   "' says no kind, and depths are those of the solid: not used");
      continue;
    }
    const std::vector<bool> chosen = chosen_by(rule, features);
    for (std::size_t i = 0; i < features.size(); ++i)
      if (chosen[i] && !rules[i]) rules[i] = rule;
  }
  Outcome out;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!rules[i]) {
      out.features.push_back(std::move(features[i]));
      continue;
    }
    apply(std::move(features[i]), {*rules[i], stock, options.tol}, out);
  }
  for (Feature& one : out.after) out.features.push_back(std::move(one));
  features = std::move(out.features);
}

}  // namespace clearcut::read
