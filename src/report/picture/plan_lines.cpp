#include "report/picture/plan_lines.h"

#include <algorithm>
#include <map>

#include "base/tolerances.h"
#include "report/picture/job_view.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {

namespace {

constexpr double kArrowEvery = 110;   // page units along the path
constexpr double kArrowLength = 8.5;  // page units

bool is_cut(MoveKind kind) {
  return kind == MoveKind::kCut || kind == MoveKind::kLeadIn || kind == MoveKind::kLeadOut;
}

void stroke(SvgWriter& svg, const PathData& data, const std::string& color, double width,
            SvgWriter::Attributes more = {}) {
  if (data.empty()) return;
  SvgWriter::Attributes attributes{
      {"d", data.text()}, {"stroke", color}, {"stroke-width", svg_number(width)}};
  attributes.insert(attributes.end(), more.begin(), more.end());
  svg.leaf("path", attributes);
}

template <typename Wanted>
PathData curves(const std::vector<Move>& moves, Wanted wanted) {
  PathData data;
  for (const Move& move : moves) {
    if (wanted(move.kind) && !move.is_vertical()) data.add(move.path);
  }
  return data;
}

void add_arrow(PathData& data, Vec2 tip, Vec2 direction, double length) {
  const Vec2 back = tip - direction * length, side = left_of(direction) * (length * 0.36);
  data.add(
      Loop{Edge::line(tip, back + side), Edge::line(back + side, back - side), Edge::line(back - side, tip)});
}

/// One arrow after every kArrowEvery page units of cutting.
void draw_arrows(SvgWriter& svg, const PlanView& view, const std::vector<Move>& moves,
                 const std::string& color) {
  PathData data;
  const double every = view.mm(kArrowEvery), size = view.mm(kArrowLength);
  double since = every / 2;
  for (const Move& move : moves) {
    if (!is_cut(move.kind) || move.is_vertical() || !drawable(move.path)) continue;
    const double length = move.path.length();
    if (since + length >= every && length > 2 * size) {
      const double t = std::clamp((every - since) / length, 0.3, 0.7);
      add_arrow(data, move.path.at(t), move.path.tangent_at(t), size);
      since = (1 - t) * length;
    } else {
      since += length;
    }
  }
  if (!data.empty()) svg.leaf("path", {{"d", data.text()}, {"fill", color}, {"stroke", "none"}});
}

void draw_vertical(SvgWriter& svg, const PlanView& view, const Move& move) {
  if (!move.is_vertical() || is_rapid(move.kind) || !drawable(move.path)) return;
  const bool down = move.z_to < move.z_from;
  svg.leaf("circle", {{"cx", svg_number(move.path.from.x)},
                      {"cy", svg_number(move.path.from.y)},
                      {"r", svg_number(view.mm(down ? 4 : 2.5))},
                      {"fill", down ? report::palette::kEntry : "#ffffff"},
                      {"stroke", down ? "#ffffff" : report::palette::kRapid},
                      {"stroke-width", svg_number(view.mm(1))}});
}

/// The height down to which the move's whole strip is cut: a drill's depth, the high end of a ramp.
double height_cut(const Move& move) {
  return move.is_vertical() ? std::min(move.z_from, move.z_to) : std::max(move.z_from, move.z_to);
}

}  // namespace

void draw_lines(SvgWriter& svg, const PlanView& view, const std::vector<Move>& moves,
                const LineStyle& style) {
  svg.open("g", {{"fill", "none"}, {"stroke-linejoin", "round"}, {"stroke-linecap", "round"}});
  if (style.rapids) {
    stroke(svg, curves(moves, is_rapid), report::palette::kRapid, view.mm(0.8),
           {{"stroke-dasharray", svg_number(view.mm(4)) + " " + svg_number(view.mm(3.5))}});
  }
  stroke(svg, curves(moves, is_cut), style.cut_color, view.mm(style.cut_width));
  if (style.links) {
    const auto is_link = [](MoveKind kind) { return kind == MoveKind::kLink || kind == MoveKind::kRetract; };
    stroke(svg, curves(moves, is_link), report::palette::kLink, view.mm(style.cut_width));
  }
  if (style.arrows) draw_arrows(svg, view, moves, style.cut_color);
  if (style.entries) {
    const auto is_entry = [](MoveKind kind) { return kind == MoveKind::kRamp || kind == MoveKind::kPlunge; };
    stroke(svg, curves(moves, is_entry), report::palette::kEntry, view.mm(style.cut_width + 0.3));
    for (const Move& move : moves) draw_vertical(svg, view, move);
  }
  svg.close();
}

void draw_lines_by_depth(SvgWriter& svg, const PlanView& view, const std::vector<Move>& moves, double top,
                         double bottom) {
  std::map<double, PathData, std::greater<>> layers;
  for (const Move& move : moves) {
    if (!is_rapid(move.kind) && !move.is_vertical()) layers[std::min(move.z_from, move.z_to)].add(move.path);
  }
  svg.open("g", {{"fill", "none"}, {"stroke-linejoin", "round"}, {"stroke-linecap", "round"}});
  for (const auto& [z, data] : layers) {
    const double fraction = top > bottom ? (top - z) / (top - bottom) : 1;
    stroke(svg, data, report::palette::depth_color(0.3 + 0.7 * fraction), view.mm(1.2));
  }
  svg.close();
}

/// Width of a move's cut at height z.
double width_at(const Job& job, const Section& section, const Tool& tool, const Move& move, double z) {
  const int feature = feature_of(job.part, section);
  const double above = std::max(0.0, z - height_cut(move));
  return feature < 0 ? 2 * radius_at(tool, above)
                     : width_on_floor(job.part.features[static_cast<std::size_t>(feature)], tool, above);
}

namespace {

using ByDiameter = std::map<double, PathData>;

/// Where cleared areas are asked for.
struct SweptPlace {
  double z = 0;       ///< height of the lowest tips that count
  double height = 0;  ///< height at which the areas are cleared
  Box seen;
};

/// Adds the areas cleared by the moves of a section.
void add_sweeps(const Job& job, const Section& section, const SweptPlace& place, ByDiameter& by_diameter) {
  const Tool* tool = tool_of(job.part, section);
  if (tool == nullptr || !(tool->diameter > 0)) return;
  const Box reach = place.seen.grown(widest_radius(*tool));
  for (const Move& move : section.moves) {
    const bool counts = !is_rapid(move.kind) && height_cut(move) <= place.z + kSamePlaceMm;
    if (!counts || !drawable(move.path) || !move.path.box().overlaps(reach)) continue;
    const double width = width_at(job, section, *tool, move, place.height);
    if (width <= 0) continue;
    if (move.is_vertical()) {
      by_diameter[width].add(move.path.from);
    } else {
      by_diameter[width].add(move.path);
    }
  }
}

std::vector<Sweep> sweeps_of(const ByDiameter& by_diameter) {
  std::vector<Sweep> sweeps;
  for (const auto& [diameter, data] : by_diameter) sweeps.push_back({diameter, data.text()});
  return sweeps;
}

}  // namespace

std::vector<Sweep> sweeps_at(const Job& job, double z, const Box& seen, std::optional<int> feature,
                             std::optional<double> height) {
  ByDiameter by_diameter;
  for (const Section& section : job.toolpath.sections)
    if (!feature || feature_of(job.part, section) == *feature)
      add_sweeps(job, section, {z, height.value_or(z), seen}, by_diameter);
  return sweeps_of(by_diameter);
}

std::vector<Sweep> earlier_sweeps_at(const Job& job, double z, const Box& seen, double top) {
  ByDiameter by_diameter;
  if (!job.earlier) return {};
  for (const Section& section : job.earlier->sections)
    if (section.counts_below(top)) add_sweeps(job, section, {z, z, seen}, by_diameter);
  return sweeps_of(by_diameter);
}

void draw_sweeps(SvgWriter& svg, const std::vector<Sweep>& sweeps, const std::string& color) {
  for (const Sweep& sweep : sweeps) {
    svg.leaf("path", {{"d", sweep.data},
                      {"fill", "none"},
                      {"stroke", color},
                      {"stroke-width", svg_number(sweep.diameter)},
                      {"stroke-linejoin", "round"},
                      {"stroke-linecap", "round"}});
  }
}

}  // namespace clearcut::report
