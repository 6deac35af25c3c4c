#include "report/picture/plan_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "geometry/region.h"
#include "report/picture/job_view.h"
#include "report/picture/plan_lines.h"
#include "report/picture/plan_marks.h"
#include "report/picture/svg_writer.h"
#include "report/words/text_table.h"

namespace clearcut::report {

namespace {

void add_drawable(Box& box, const Edge& edge) {
  if (drawable(edge)) box.add(edge.box());
}

void add_target(Box& box, const Feature& feature) {
  for (const Region& region : feature.target) {
    for (const Edge& edge : region.outer()) add_drawable(box, edge);
  }
}

void add_feed_moves(Box& box, const Section& section) {
  for (const Move& move : section.moves) {
    if (!is_rapid(move.kind)) add_drawable(box, move.path);
  }
}

/// The box enlarged by a margin, never empty or without extent.
Box framed(Box box) {
  if (box.empty()) box.add(Vec2{0, 0});
  return box.grown(std::max(0.035 * std::max(box.width(), box.height()), 1.0));
}

std::string path_of(const Regions& regions) {
  PathData data;
  data.add(regions);
  return data.text();
}

/// Opens two groups: clipped to the view's rectangle, then in mm with y up.
void open_world(SvgWriter& svg, const PlanView& view) {
  const std::string id = svg.new_id("view");
  svg.open("clipPath", {{"id", id}});
  svg.leaf("rect", {{"x", svg_number(view.corner.x)},
                    {"y", svg_number(view.corner.y)},
                    {"width", svg_number(view.width)},
                    {"height", svg_number(view.height)},
                    {"rx", "6"}});
  svg.close();
  svg.open("g", {{"clip-path", "url(#" + id + ")"}});
  const Vec2 origin = view.page({0, 0});
  svg.open("g", {{"transform", fmt::format("translate({:.6f} {:.6f}) scale({:.9f} {:.9f})", origin.x,
                                           origin.y, view.scale(), -view.scale())}});
}

void close_world(SvgWriter& svg, const PlanView& view) {
  svg.close();
  svg.close();
  svg.leaf("rect", {{"x", svg_number(view.corner.x)},
                    {"y", svg_number(view.corner.y)},
                    {"width", svg_number(view.width)},
                    {"height", svg_number(view.height)},
                    {"rx", "6"},
                    {"fill", "none"},
                    {"stroke", report::palette::kRule}});
}

/// Returns the id of a clip path for the inside of `data` (even-odd).
std::string clip_to(SvgWriter& svg, const std::string& data) {
  const std::string id = svg.new_id("clip");
  svg.open("clipPath", {{"id", id}});
  svg.leaf("path", {{"d", data}, {"clip-rule", "evenodd"}});
  svg.close();
  return id;
}

/// Opens a group clipped to the inside of the regions.
void open_clipped(SvgWriter& svg, const std::string& data, const char* opacity = "1") {
  svg.open("g", {{"clip-path", "url(#" + clip_to(svg, data) + ")"}, {"opacity", opacity}});
}

/// Stock as a block on white air; without a stock everything is material.
void draw_material(SvgWriter& svg, const PlanView& view, const Part& part, const std::string& color) {
  PathData data;
  data.add(rectangle(part.stock ? part.stock->plan : view.visible()));
  svg.leaf("path", {{"d", data.text()},
                    {"fill", color},
                    {"stroke", report::palette::kInk},
                    {"stroke-width", svg_number(view.mm(1))}});
}

void fill_regions(SvgWriter& svg, const Regions& regions, const std::string& color) {
  if (!regions.empty())
    svg.leaf("path", {{"d", path_of(regions)}, {"fill", color}, {"fill-rule", "evenodd"}});
}

/// The part's faces that no feature makes, hatched over what is drawn below.
void hatch_left_out(SvgWriter& svg, const PlanView& view, const Regions& left_out) {
  if (left_out.empty()) return;
  const std::string fill = hatch(svg, report::palette::kLeftOut, view.mm(kHatchStep), view.mm(kHatchWidth));
  svg.leaf("path", {{"class", "left-out"},
                    {"d", path_of(left_out)},
                    {"fill", fill},
                    {"fill-rule", "evenodd"},
                    {"stroke", report::palette::kLeftOut},
                    {"stroke-width", svg_number(view.mm(0.7))}});
}

void outline_regions(SvgWriter& svg, const PlanView& view, const Regions& regions, double width) {
  if (regions.empty()) return;
  svg.leaf("path", {{"d", path_of(regions)},
                    {"fill", "none"},
                    {"stroke", report::palette::kInk},
                    {"stroke-width", svg_number(view.mm(width))},
                    {"stroke-linejoin", "round"}});
}

std::vector<int> shallow_first(const Part& part) {
  std::vector<int> order(part.features.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&part](int a, int b) {
    return part.features[static_cast<std::size_t>(a)].floor_z >
           part.features[static_cast<std::size_t>(b)].floor_z;
  });
  return order;
}

/// One floor as seen from above, with the lines of its last layer.
void draw_floor(SvgWriter& svg, const PlanView& view, const Job& job, int feature) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  const double fraction = depth_fraction(job.part, f.floor_z);
  fill_regions(svg, f.target, report::palette::depth_color(fraction));
  open_clipped(svg, path_of(f.target), "0.6");
  LineStyle style;
  style.cut_color = report::palette::line_color_on_depth(fraction);
  style.cut_width = 0.8;
  style.links = style.arrows = style.rapids = style.entries = false;
  for (const Section& section : job.toolpath.sections) {
    if (feature_of(job.part, section) == feature)
      draw_lines(svg, view, shown_moves(section, job.all_layers), style);
  }
  svg.close();
  outline_regions(svg, view, f.target, 1.1);
}

/// Best place for a feature's number: inside the feature, far from its walls and from deeper features. Nothing if no
/// sample is visible.
std::optional<Vec2> label_point(const Part& part, int feature) {
  constexpr int kSamples = 18;
  const Feature& f = part.features[static_cast<std::size_t>(feature)];
  const Box box = clearcut::box(f.target);
  std::optional<Vec2> best;
  double best_room = 0;
  for (int i = 0; i < kSamples * kSamples; ++i) {
    const int column = i % kSamples, row = i / kSamples;
    const Vec2 p{box.min.x + box.width() * (column + 0.5) / kSamples,
                 box.min.y + box.height() * (row + 0.5) / kSamples};
    if (!contains(f.target, p) || (part.stock && !part.stock->plan.contains(p))) continue;
    double room = std::numeric_limits<double>::infinity();
    for (const Feature& other : part.features) {
      const bool hides = &other != &f && other.floor_z < f.floor_z && contains(other.target, p);
      if (hides) room = 0;
      if (&other != &f && other.floor_z >= f.floor_z) continue;
      for (const Region& region : other.target) room = std::min(room, region.boundary_distance(p));
    }
    if (room > best_room) {
      best_room = room;
      best = p;
    }
  }
  return best;
}

/// Draws the area reached by the cutter from its legal positions, slightly narrower than the cutter, so that no rim
/// shows beside the swept area.
void draw_reach(SvgWriter& svg, const PlanView& view, const Reach& reach) {
  PathData data;
  data.add(reach.centers);
  for (const Path& line : reach.fit_lines) {
    for (const Edge& edge : line) data.add(edge);
  }
  for (const Vec2 point : reach.fit_points) data.add(point);
  if (data.empty() || !(reach.flat > 0)) return;
  svg.leaf("path", {{"d", data.text()},
                    {"fill", report::palette::kUncut},
                    {"fill-rule", "evenodd"},
                    {"stroke", report::palette::kUncut},
                    {"stroke-width", svg_number(std::max(reach.flat - view.mm(1.4), 0.0))},
                    {"stroke-linejoin", "round"},
                    {"stroke-linecap", "round"}});
}

/// Whether another feature also permits the cutter in the area of `feature` down to z.
bool opens_beside(const Feature& other, const Feature& feature, double z) {
  constexpr double kHair = 1e-6;
  return &other != &feature && other.floor_z <= z + kHair &&
         box(other.allowed).overlaps(box(feature.allowed).grown(kHair));
}

/// Draws the area swept by a feature's moves outside of its own and other outlines at that depth.
void draw_gouges(SvgWriter& svg, const PlanView& view, const Job& job, const Feature& feature, double z,
                 const std::vector<Sweep>& own) {
  const std::vector<Fault>& faults = job.findings.faults;
  const bool gouged = std::any_of(faults.begin(), faults.end(),
                                  [](const Fault& fault) { return fault.kind == FaultKind::kGouge; });
  if (!gouged) return;
  PathData all;
  all.add(rectangle(view.visible()));
  open_clipped(svg, all.text() + path_of(floor_allowed(feature)));
  int open = 1;
  for (const Feature& other : job.part.features) {
    if (!opens_beside(other, feature, z)) continue;
    open_clipped(svg, all.text() + path_of(floor_allowed(other)));
    ++open;
  }
  draw_sweeps(svg, own, report::palette::kGouge);
  for (; open > 0; --open) svg.close();
}

/// The floor of a feature: the area out of reach, over it the area within reach, over it the swept area, and gouges.
void draw_coverage(SvgWriter& svg, const PlanView& view, const Job& job, int feature, double z) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  const std::vector<Sweep> own = sweeps_at(job, z, view.visible(), feature);
  const std::string target = path_of(floor_target(f));
  PathData all;
  all.add(rectangle(view.visible()));
  fill_regions(svg, f.target, report::palette::kWall);
  if (f.chamfer) return;  // a chamfer has no floor
  open_clipped(svg, all.text(), "0.25");
  draw_sweeps(svg, own, report::palette::kImpact);
  svg.close();
  draw_gouges(svg, view, job, f, z, own);
  open_clipped(svg, target);
  const Reach reach = reach_of(job, feature);
  svg.leaf("path", {{"d", target},
                    {"fill", reach.diameter > 0 ? report::palette::kUnreachable : report::palette::kUncut},
                    {"fill-rule", "evenodd"}});
  draw_reach(svg, view, reach);
  draw_sweeps(svg, earlier_sweeps_at(job, z, view.visible(), f.top_z), report::palette::kFloor);
  draw_sweeps(svg, sweeps_at(job, z, view.visible()), report::palette::kFloor);
  svg.close();
  if (f.wall_slope.radians() > 0) outline_regions(svg, view, floor_target(f), 0.7);
}

/// Drafted walls are cut layer by layer, so there all layers are shown.
void draw_feature_lines(SvgWriter& svg, const PlanView& view, const Job& job, int feature) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  const bool all_layers = job.all_layers || f.wall_slope.radians() > 0;
  for (const Section& section : job.toolpath.sections) {
    if (feature_of(job.part, section) != feature) continue;
    const std::vector<Move> moves = shown_moves(section, all_layers);
    if (all_layers) {
      draw_lines_by_depth(svg, view, moves, f.top_z, f.floor_z);
    } else {
      const Tool* tool = tool_of(job.part, section);
      LineStyle style;
      style.cut_color =
          report::palette::tool_color(tool == nullptr ? 0 : static_cast<int>(tool - job.part.tools.data()));
      draw_lines(svg, view, moves, style);
    }
  }
}

/// Depths of feed moves, the shallowest first; of very many depths only as many as there are distinguishable shades.
std::vector<double> depths_cut(const Job& job) {
  constexpr std::size_t kMostDepths = 32;
  const double top = job.part.top_z();
  std::set<double, std::greater<>> depths;
  for (const Section& section : job.toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || !drawable(move.path)) continue;
      for (const double z : {move.z_from, move.z_to})
        if (z < top) depths.insert(std::round(z * 1000) / 1000);
    }
  }
  if (depths.size() <= kMostDepths) return {depths.begin(), depths.end()};
  std::vector<double> even;
  for (std::size_t i = 1; i <= kMostDepths; ++i)
    even.push_back(top + (*depths.rbegin() - top) * static_cast<double>(i) / kMostDepths);
  return even;
}

/// Draws the cut area, with the lines of all tools, if the shape to be made is not stated.
void draw_cut_away(SvgWriter& svg, const PlanView& view, const Job& job) {
  const std::vector<double> depths = depths_cut(job);
  const double top = job.part.top_z(), bottom = depths.empty() ? top - 1 : depths.back();
  double above = top;
  for (const double z : depths) {
    // Seen from above, a depth is cut everywhere that some cutter with its tip below clears at the upper side of this
    // depth range.
    draw_sweeps(svg, sweeps_at(job, z, view.visible(), {}, above),
                report::palette::depth_color((top - z) / (top - bottom)));
    above = z;
  }
  for (const Section& section : job.toolpath.sections) {
    const Tool* tool = tool_of(job.part, section);
    LineStyle style;
    style.cut_width = 0.8;
    style.cut_color =
        report::palette::tool_color(tool == nullptr ? 0 : static_cast<int>(tool - job.part.tools.data()));
    draw_lines(svg, view, shown_moves(section, true), style);
  }
}

}  // namespace

double PlanView::scale() const {
  return std::min(width / world.width(), height / world.height());
}

Vec2 PlanView::page(Vec2 point) const {
  const Vec2 off = (point - world.center()) * scale();
  return {corner.x + width / 2 + off.x, corner.y + height / 2 - off.y};
}

double PlanView::mm(double size) const {
  return size / scale();
}

Box PlanView::visible() const {
  const Vec2 half{mm(width) / 2, mm(height) / 2};
  return {world.center() - half, world.center() + half};
}

Box world_of(const Job& job) {
  Box box;
  if (job.part.stock && !job.part.stock->plan.empty()) return framed(job.part.stock->plan);
  for (const Feature& feature : job.part.features) add_target(box, feature);
  if (box.empty()) {
    for (const Section& section : job.toolpath.sections) add_feed_moves(box, section);
  }
  return framed(box);
}

Box world_of(const Job& job, int feature) {
  Box box;
  add_target(box, job.part.features[static_cast<std::size_t>(feature)]);
  for (const Section& section : job.toolpath.sections) {
    if (feature_of(job.part, section) == feature) add_feed_moves(box, section);
  }
  return framed(box);
}

void draw_overview(SvgWriter& svg, const PlanView& view, const Job& job,
                   const std::vector<std::string>& badges) {
  open_world(svg, view);
  draw_material(svg, view, job.part, report::palette::depth_color(0));
  PathData seen;
  seen.add(rectangle(job.part.stock ? job.part.stock->plan : view.visible()));
  open_clipped(svg, seen.text());
  if (!job.part.is_shape_stated) draw_cut_away(svg, view, job);
  for (const int feature : shallow_first(job.part)) draw_floor(svg, view, job, feature);
  hatch_left_out(svg, view, job.part.left_out);
  svg.close();
  close_world(svg, view);
  std::vector<Badge> wanted;
  for (int i = 0; i < static_cast<int>(job.part.features.size()); ++i) {
    const auto p = label_point(job.part, i);
    const std::string text = badges.empty() ? std::to_string(i + 1) : badges[static_cast<std::size_t>(i)];
    if (p && !text.empty()) wanted.push_back({view.page(*p), text});
  }
  draw_badges(svg, placed_apart(wanted, {view.corner, view.corner + Vec2{view.width, view.height}}));
  if (job.margin) draw_margin(svg, view, *job.margin, nullptr);
  draw_faults(svg, view, job.findings, nullptr);
  draw_scale_bar(svg, view);
}

void draw_feature(SvgWriter& svg, const PlanView& view, const Job& job, int feature) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  double z = std::numeric_limits<double>::infinity();
  for (const Section& section : job.toolpath.sections) {
    if (feature_of(job.part, section) == feature) z = std::min(z, last_layer(section));
  }
  open_world(svg, view);
  draw_material(svg, view, job.part, report::palette::kMaterial);
  draw_coverage(svg, view, job, feature, std::isfinite(z) ? z : f.floor_z);
  outline_regions(svg, view, f.target, 1.4);
  draw_feature_lines(svg, view, job, feature);
  hatch_left_out(svg, view, job.part.left_out);
  close_world(svg, view);
  draw_worst_places(svg, view, findings_of(job.part, job.findings, feature));
  if (job.margin) draw_margin(svg, view, *job.margin, &f);
  draw_faults(svg, view, job.findings, &f);
  draw_scale_bar(svg, view);
}

}  // namespace clearcut::report
