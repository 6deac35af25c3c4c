#include "post/words/between_steps.h"

#include <algorithm>
#include <map>

namespace clearcut::post {
namespace {

const Workingstep* step_of(const Section& section, const Part& part) {
  const bool known = section.workingstep >= 0 && section.workingstep < static_cast<int>(part.workplan.size());
  return known ? &part.workplan[static_cast<std::size_t>(section.workingstep)] : nullptr;
}

bool is_finishing(OperationKind kind) {
  return kind == OperationKind::kFinishing || kind == OperationKind::kBottomFinishing ||
         kind == OperationKind::kSideFinishing;
}

}  // namespace

CutLevel level_of(const Section& section, const Part& part) {
  const Workingstep* step = step_of(section, part);
  if (step == nullptr) return CutLevel::kMedium;
  if (is_finishing(step->operation.kind)) return CutLevel::kFinishing;
  const bool leaves_stock = step->operation.allowance_side > 0 || step->operation.allowance_floor > 0;
  const bool is_finished_later =
      std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& other) {
        return other.feature == step->feature && is_finishing(other.operation.kind);
      });
  return leaves_stock || is_finished_later ? CutLevel::kRoughing : CutLevel::kMedium;
}

std::vector<int> tool_changes_of(const Toolpath& toolpath) {
  std::vector<int> tools;
  for (const Section& section : toolpath.sections) {
    const bool changes = section.tool_number > 0 && (tools.empty() || tools.back() != section.tool_number);
    if (!section.moves.empty() && changes) tools.push_back(section.tool_number);
  }
  return tools;
}

std::vector<ProgramStop> Stops::before(const Section& section) {
  if (step_of(section, part_) == nullptr) return {};
  std::vector<ProgramStop> stops;
  for (int i = 0; i <= section.workingstep; ++i) {
    if (!said_.insert(i).second) continue;
    const std::vector<ProgramStop>& own = part_.workplan[static_cast<std::size_t>(i)].stops;
    stops.insert(stops.end(), own.begin(), own.end());
  }
  return stops;
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

std::vector<MoveRun> runs_of(const Section& section) {
  std::vector<MoveRun> runs;
  std::size_t first = 0;
  const auto add = [&](std::size_t end, double dwell_s) {
    if (end <= first) return;
    const auto at = [&](std::size_t i) { return section.moves.begin() + static_cast<std::ptrdiff_t>(i); };
    runs.push_back({{at(first), at(end)}, dwell_s});
    first = end;
  };
  for (const Dwell& dwell : section.dwells)
    add(std::min(dwell.after + 1, section.moves.size()), dwell.seconds);
  add(section.moves.size(), 0);
  return runs;
}

std::vector<int> shared_subprograms(const std::vector<int>& same_moves,
                                    const std::function<bool(std::size_t)>& may_be) {
  std::vector<int> called(same_moves.size(), 0);
  std::map<int, int> uses, numbers;
  std::vector<bool> usable(same_moves.size());
  for (std::size_t i = 0; i < same_moves.size(); ++i) {
    usable[i] = same_moves[i] > 0 && may_be(i);
    if (usable[i]) ++uses[same_moves[i]];
  }
  for (std::size_t i = 0; i < same_moves.size(); ++i) {
    if (!usable[i] || uses[same_moves[i]] < 2) continue;
    called[i] = numbers.try_emplace(same_moves[i], static_cast<int>(numbers.size()) + 1).first->second;
  }
  return called;
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

double safe_height(const Toolpath& toolpath, const Part& part) {
  double highest = part.safe_z();
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) highest = std::max({highest, move.z_from, move.z_to});
  }
  return highest;
}

}  // namespace clearcut::post
