#include "read/svg/svg_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/tolerances.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "read/svg/svg_elements.h"
#include "read/svg/svg_shapes.h"

namespace clearcut::read {
namespace {

/// Clip paths on the shapes of clip paths on ..., at most.
constexpr int kDeepestClip = 8;
/// Greatest number of halvings of edges that may cross the border of the visible area.
constexpr int kHalvings = 6;
constexpr double kSameArea = 1e-9;

/// The id of "url(#id)", quoted or not; nothing for anything else.
std::optional<std::string> id_of(std::string_view reference) {
  const std::size_t begin = reference.find('#'), end = reference.find_first_of("\"')", begin);
  if (reference.substr(0, 4) != "url(" || begin == std::string_view::npos || end == std::string_view::npos)
    return std::nullopt;
  return std::string(reference.substr(begin + 1, end - begin - 1));
}

SvgWindow window(Regions seen) {
  return std::make_shared<const Regions>(std::move(seen));
}

/// The area visible through both.
SvgWindow through_both(const SvgWindow& a, const SvgWindow& b, const Tolerances& tol) {
  if (!a || !b) return a ? a : b;
  return a == b ? a : window(intersect(*a, *b, tol));
}

/// A loop along the edges; from their end straight back to their start.
Loop closed_loop(Path edges) {
  if (!(edges.back().to == edges.front().from))
    edges.push_back(Edge::line(edges.back().to, edges.front().from));
  return edges;
}

Regions filled(const std::vector<Loop>& loops, bool nonzero, const Tolerances& tol) {
  return nonzero ? resolve_nonzero(loops, tol) : resolve_even_odd(loops, tol);
}

bool is_rectangle(const Regions& seen) {
  if (seen.size() != 1 || !seen.front().islands().empty() || seen.front().outer().size() != 4) return false;
  const Box all = box(seen);
  return std::abs(all.width() * all.height() - area(seen)) <= kSameArea * area(seen);
}

/// How much of a non-empty box is visible.
Seen seen_of_box(const Box& all, const Regions& seen, const Tolerances& tol) {
  const Box window = box(seen).grown(kSamePlaceMm);
  if (seen.empty() || !window.overlaps(all)) return Seen::kNothing;
  if (is_rectangle(seen))
    return window.contains(all.min) && window.contains(all.max) ? Seen::kWhole : Seen::kPart;
  const Regions part{rectangular_region(all.grown(kSamePlaceMm))};
  if (subtract(part, seen, tol).empty()) return Seen::kWhole;
  return intersect(part, seen, tol).empty() ? Seen::kNothing : Seen::kPart;
}

/// How much of an edge is visible: by halving as often as needed, at most `more` times.
Seen seen_of_edge(const Edge& edge, const Regions& seen, int more, const Tolerances& tol) {
  const Seen whole = seen_of_box(edge.box(), seen, tol);
  if (whole != Seen::kPart || more == 0) return whole;
  const Seen half = seen_of_edge(edge.part(0, 0.5), seen, more - 1, tol);
  return half == seen_of_edge(edge.part(0.5, 1), seen, more - 1, tol) ? half : Seen::kPart;
}

}  // namespace

bool SvgClips::narrow(SvgInherited& own) {
  if (own.style.clip.empty()) return true;
  const Area area = area_of(own.style.clip, own, 0);
  own.shown = through_both(own.shown, area.shown, options_.tol);
  return area.is_read;
}

SvgClips::Area SvgClips::area_of(std::string_view reference, const SvgInherited& user, int depth) {
  const auto id = id_of(reference);
  if (!id || depth > kDeepestClip) return {false, nullptr};
  const auto found = document_.by_id.find(*id);
  if (found == document_.by_id.end() || local_name(found->second) != "clipPath") return {};
  const Affine& m = user.map;
  const Key key{*id, {m.a, m.b, m.c, m.d, m.e, m.f}, user.view.width, user.view.height};
  const auto known = areas_.find(key);
  if (known != areas_.end()) return known->second;
  const Area area = shapes_of(found->second, user, depth);
  areas_.emplace(key, area);
  return area;
}

SvgClips::Area SvgClips::shapes_of(const pugi::xml_node& clip, const SvgInherited& user, int depth) {
  if (svg_text_of(clip, "clipPathUnits") == "objectBoundingBox") return {false, nullptr};
  SvgInherited own;
  own.map = user.map;
  own.view = user.view;
  if (!inherit_svg(clip, document_.sheet, options_, own).empty()) return {false, nullptr};
  Area whole;
  if (!own.style.clip.empty()) whole = area_of(own.style.clip, own, depth + 1);
  Regions seen;
  for (const pugi::xml_node& child : clip) {
    if (child.type() == pugi::node_element)
      whole.is_read = add_shape(child, own, depth, seen) && whole.is_read;
  }
  if (!whole.is_read) return {false, nullptr};
  whole.shown = through_both(window(std::move(seen)), whole.shown, options_.tol);
  return whole;
}

bool SvgClips::add_shape(const pugi::xml_node& node, SvgInherited own, int depth, Regions& seen) {
  const std::string_view name = local_name(node);
  if (is_svg_definition(name)) return true;
  if (!inherit_svg(node, document_.sheet, options_, own).empty()) return false;
  if (!own.style.shown || !own.style.visible) return true;
  if (name == "use") {
    const pugi::xml_node used = document_.used_by(node);
    if (!used || !is_svg_shape(local_name(used)) || !own.style.clip.empty()) return false;
    own.map = own.map * Affine::translation({svg_attribute(node, "x", own.view.width, 0),
                                             svg_attribute(node, "y", own.view.height, 0)});
    return add_shape(used, own, depth, seen);
  }
  if (!is_svg_shape(name)) return false;
  const SvgPathData data = svg_shape(node, own.view, own.map);
  if (!data.error.empty()) return false;
  std::vector<Loop> loops;
  for (const Subpath& path : data.subpaths)
    if (!path.edges.empty()) loops.push_back(closed_loop(path.edges));
  Regions shape = filled(loops, own.style.clip_rule != "evenodd", options_.tol);
  if (!own.style.clip.empty()) {
    const Area area = area_of(own.style.clip, own, depth + 1);
    if (!area.is_read) return false;
    if (area.shown) shape = intersect(shape, *area.shown, options_.tol);
  }
  seen = seen.empty() ? std::move(shape) : unite(seen, shape, options_.tol);
  return true;
}

void narrow_to_viewport(SvgInherited& own, const Affine& place, double width, double height,
                        const Tolerances& tol) {
  Loop corners;
  const Vec2 all[] = {place({0, 0}), place({width, 0}), place({width, height}), place({0, height})};
  for (std::size_t i = 0; i < 4; ++i) corners.push_back(Edge::line(all[i], all[(i + 1) % 4]));
  if (std::abs(signed_area(corners)) <= kSameArea) return;
  own.shown = through_both(own.shown, window({Region::from_valid_loops(std::move(corners), {})}), tol);
}

Seen how_much_is_seen(const Path& line, const SvgWindow& shown, const Tolerances& tol) {
  if (!shown || line.empty()) return Seen::kWhole;
  const Seen first = seen_of_edge(line.front(), *shown, kHalvings, tol);
  const bool same = std::all_of(line.begin(), line.end(), [&](const Edge& edge) {
    return seen_of_edge(edge, *shown, kHalvings, tol) == first;
  });
  return same ? first : Seen::kPart;
}

Seen clip_fill(std::vector<RawCurve>& curves, bool nonzero, const SvgWindow& shown, const Tolerances& tol) {
  if (!shown || curves.empty()) return Seen::kWhole;
  Box all;
  std::vector<Loop> loops;
  for (const RawCurve& curve : curves) {
    if (curve.edges.empty()) continue;
    all.add(box(curve.edges));
    loops.push_back(closed_loop(curve.edges));
  }
  if (loops.empty() || seen_of_box(all, *shown, tol) == Seen::kWhole) return Seen::kWhole;
  const Regions area = filled(loops, nonzero, tol);
  if (subtract(area, *shown, tol).empty()) return Seen::kWhole;
  const RawCurve first = curves.front();
  curves.clear();
  for (Loop& loop : loops_of(intersect(area, *shown, tol)))
    curves.push_back({std::move(loop), true, first.source, first.compound});
  return curves.empty() ? Seen::kNothing : Seen::kPart;
}

}  // namespace clearcut::read
