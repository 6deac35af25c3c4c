#include "post/between_steps.h"

#include <algorithm>

namespace clearcut::post {
namespace {

const Workingstep* step_of(const Section& section, const Part& part) {
  const bool known = section.workingstep >= 0 && section.workingstep < static_cast<int>(part.workplan.size());
  return known ? &part.workplan[static_cast<std::size_t>(section.workingstep)] : nullptr;
}

}  // namespace

std::vector<ProgramStop> Stops::before(const Section& section) {
  const Workingstep* step = step_of(section, part_);
  if (step == nullptr || !said_.insert(section.workingstep).second) return {};
  return step->stops;
}

bool halts(const std::vector<ProgramStop>& stops) {
  return std::any_of(stops.begin(), stops.end(),
                     [](const ProgramStop& stop) { return stop.kind != StopKind::kMessage; });
}

std::string stop_comment(const ProgramStop& stop) {
  const char* word = stop.kind == StopKind::kHalt       ? "STOP"
                     : stop.kind == StopKind::kOptional ? "OPTIONAL STOP"
                                                        : "MESSAGE";
  return stop.text.empty() ? word : std::string(word) + ": " + stop.text;
}

double dwell_of(const Section& section, const Part& part) {
  const Workingstep* step = step_of(section, part);
  return step != nullptr && step->operation.hole_feeds ? step->operation.hole_feeds->dwell_s : 0;
}

bool ends_at_floor(const Move& move, const Section& section) {
  double lowest = move.z_to;
  for (const Move& other : section.moves) lowest = std::min(lowest, other.z_to);
  return move.is_vertical() && move.z_to < move.z_from && move.z_to <= lowest;
}

}  // namespace clearcut::post
