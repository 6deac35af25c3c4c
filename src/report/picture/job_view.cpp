#include "report/picture/job_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text/format.h"
#include "base/tolerances.h"
#include "report/words/text.h"

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

}  // namespace clearcut::report
