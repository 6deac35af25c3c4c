#include "report/picture/job_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "base/tolerances.h"
#include "features/derived_outlines.h"
#include "geometry/voronoi/clearance.h"
#include "report/words/text_table.h"

namespace clearcut::report {

namespace {

bool removes_sideways(const Move& move) {
  return !is_rapid(move.kind) && move.kind != MoveKind::kPlunge && move.kind != MoveKind::kRamp &&
         move.kind != MoveKind::kRetract && !move.is_vertical();
}

double lowest(const Move& move) {
  return std::min(move.z_from, move.z_to);
}

/// Depth of the layer above the last one: the start height of entries into the last layer.
double layer_above(const Section& section, double last) {
  double above = std::numeric_limits<double>::infinity();
  for (const Move& move : section.moves) {
    if (removes_sideways(move) && lowest(move) > last + kSamePlaceMm) above = std::min(above, lowest(move));
  }
  return above;
}

const char* words_for(ToolKind kind) {
  constexpr std::array kWords{
      "end mill",    "face mill",  "ball end mill", "bull nose end mill", "drill",
      "reamer",      "V-bit",      "chamfer mill",  "spot drill",         "tap",
      "thread mill", "boring bar", "counterbore",   "tapered end mill",   "T-slot cutter",
      "tool"};
  static_assert(kWords.size() == static_cast<std::size_t>(ToolKind::kOther) + 1);
  return kWords[static_cast<std::size_t>(kind)];
}

}  // namespace

int feature_of(const Part& part, const Section& section) {
  const int count = static_cast<int>(part.features.size());
  if (section.workingstep >= 0 && section.workingstep < static_cast<int>(part.workplan.size())) {
    const int feature = part.workplan[static_cast<std::size_t>(section.workingstep)].feature;
    if (feature >= 0 && feature < count) return feature;
  }
  for (int i = 0; i < count; ++i) {
    if (!section.label.empty() && part.features[static_cast<std::size_t>(i)].name == section.label) return i;
  }
  return count == 1 ? 0 : -1;
}

const Tool* tool_of(const Part& part, const Section& section) {
  return tool_numbered(part.tools, section.tool_number);
}

std::vector<const FeatureFindings*> findings_of(const Part& part, const Findings& findings, int feature) {
  std::vector<const FeatureFindings*> found;
  for (const FeatureFindings& one : findings.features) {
    Section section;
    section.label = one.name;
    section.workingstep = one.workingstep;
    if (feature_of(part, section) == feature) found.push_back(&one);
  }
  return found;
}

double last_layer(const Section& section) {
  double sideways = std::numeric_limits<double>::infinity(), any = sideways;
  for (const Move& move : section.moves) {
    if (!is_rapid(move.kind)) any = std::min(any, lowest(move));
    if (removes_sideways(move)) sideways = std::min(sideways, lowest(move));
  }
  return std::isfinite(sideways) ? sideways : any;
}

std::vector<Move> shown_moves(const Section& section, bool all_layers) {
  if (all_layers) return section.moves;
  const double last = last_layer(section), above = layer_above(section, last);
  const auto in_layer = [last](const Move& move) {
    return removes_sideways(move) && lowest(move) <= last + kSamePlaceMm;
  };
  const auto first = std::find_if(section.moves.begin(), section.moves.end(), in_layer);
  const auto end = std::find_if(section.moves.rbegin(), section.moves.rend(), in_layer).base();
  std::vector<Move> shown;
  for (auto move = section.moves.begin(); move != section.moves.end(); ++move) {
    const bool entry =
        !is_rapid(move->kind) && !removes_sideways(*move) && lowest(*move) < above - kSamePlaceMm;
    const bool between = is_rapid(move->kind) && move >= first && move < end;
    if (in_layer(*move) || entry || between) shown.push_back(*move);
  }
  return shown;
}

double depth_fraction(const Part& part, double z) {
  std::vector<double> levels{part.top_z()};
  for (const Feature& feature : part.features) levels.push_back(feature.floor_z);
  std::sort(levels.begin(), levels.end(), std::greater<>());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  const double extent = levels.front() - levels.back();
  if (!(extent > 0)) return 1;
  std::size_t next = 1;
  while (next + 1 < levels.size() && levels[next] > z) ++next;
  const double between = (levels[next - 1] - z) / (levels[next - 1] - levels[next]);
  const double rank = (static_cast<double>(next - 1) + between) / static_cast<double>(levels.size() - 1);
  return std::clamp(((levels.front() - z) / extent + std::clamp(rank, 0.0, 1.0)) / 2, 0.0, 1.0);
}

std::string headline_of(const Fault& fault) {
  const FaultRow& row = row_of(fault.kind);
  return row.has_length ? fmt::format("{} {} mm", row.name, fixed(fault.size, 3)) : row.name;
}

std::string description_of(const Tool& tool) {
  const bool tapers = tool.kind == ToolKind::kTapered;
  const std::string angle = tool.tip_angle ? " " + trimmed(tool.tip_angle->degrees() / (tapers ? 2 : 1), 2) +
                                                 "\u00b0" + (tapers ? " a side" : "")
                                           : std::string();
  return fmt::format("T{} {}{} {} mm", tool.number, words_for(tool.kind), angle, trimmed(tool.diameter, 3));
}

namespace {

const Tolerances kTolerances;

/// The least stock left on walls by any operation on the feature: the stock of finishing if there is any.
double wall_stock(const Part& part, int feature) {
  double least = std::numeric_limits<double>::infinity();
  for (const Workingstep& step : part.workplan) {
    if (step.feature == feature) least = std::min(least, step.operation.allowance_side);
  }
  return std::isfinite(least) ? std::max(least, 0.0) : 0;
}

const Tool* smaller(const Tool* tool, const Tool& other) {
  if (!(other.diameter > 0)) return tool;
  return tool && tool->diameter <= other.diameter ? tool : &other;
}

/// The smallest cutter that worked on the feature, or else was planned for it; null if there is none.
const Tool* smallest_cutter(const Job& job, int feature) {
  const Tool *worked = nullptr, *meant = nullptr;
  for (const Section& section : job.toolpath.sections) {
    const Tool* tool = tool_of(job.part, section);
    if (tool != nullptr && feature_of(job.part, section) == feature) worked = smaller(worked, *tool);
  }
  for (const Workingstep& step : job.part.workplan) {
    const auto tool = static_cast<std::size_t>(step.operation.tool);
    if (step.feature == feature && tool < job.part.tools.size()) meant = smaller(meant, job.part.tools[tool]);
  }
  return worked ? worked : meant;
}

Regions at_floor(const Regions& regions, const Feature& feature) {
  if (!(feature.wall_slope.radians() > 0)) return regions;
  return features::at_depth(regions, feature.wall_slope, feature.top_z - feature.floor_z, kTolerances);
}

}  // namespace

Regions floor_target(const Feature& feature) {
  return at_floor(feature.target, feature);
}
Regions floor_allowed(const Feature& feature) {
  return at_floor(feature.allowed, feature);
}

double width_on_floor(const Feature& feature, const Tool& tool, double above) {
  const bool is_hole = feature.kind == FeatureKind::kRoundHole || feature.hole;
  return is_hole && tool.kind == ToolKind::kDrill ? tool.diameter : 2 * radius_at(tool, above);
}

Reach reach_of(const Job& job, int feature) {
  Reach reach;
  const Tool* const cutter = smallest_cutter(job, feature);
  if (!cutter) return reach;
  reach.diameter = cutter->diameter;
  reach.flat = width_on_floor(job.part.features[static_cast<std::size_t>(feature)], *cutter, 0);
  const double distance = reach.diameter / 2 + wall_stock(job.part, feature);
  for (const Region& region : floor_allowed(job.part.features[static_cast<std::size_t>(feature)])) {
    const Clearance clearance(region, kTolerances);
    for (Region& piece : clearance.inset(distance)) reach.centers.push_back(std::move(piece));
    for (Path& line : clearance.fit_lines(distance)) reach.fit_lines.push_back(std::move(line));
    for (const AxisPoint& center : clearance.centers()) {
      if (std::abs(center.clearance - distance) <= kTolerances.fit) reach.fit_points.push_back(center.point);
    }
  }
  return reach;
}

}  // namespace clearcut::report
