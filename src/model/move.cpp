#include "model/move.h"

#include <algorithm>

#include "base/elementary.h"

namespace clearcut::inline model {

const std::vector<std::string>& coolant_names() {
  static const std::vector<std::string> names{"off", "flood", "mist", "both"};
  return names;
}

const std::string& name_of(Coolant coolant) {
  return coolant_names()[static_cast<std::size_t>(coolant)];
}

std::optional<Coolant> coolant_named(const std::string& name) {
  const auto& names = coolant_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Coolant>(found - names.begin());
}

const char* name_of(MoveKind kind) {
  switch (kind) {
    case MoveKind::kRapid:
      return "rapid";
    case MoveKind::kPlunge:
      return "plunge";
    case MoveKind::kRamp:
      return "ramp";
    case MoveKind::kLeadIn:
      return "lead-in";
    case MoveKind::kCut:
      return "cut";
    case MoveKind::kLeadOut:
      return "lead-out";
    case MoveKind::kLink:
      return "link";
    case MoveKind::kRetract:
      return "retract";
  }
  return "unknown";
}

double Move::length() const {
  return base::hypot(path.length(), z_to - z_from);
}

double feed_length(const Section& section) {
  double sum = 0;
  for (const Move& move : section.moves) {
    if (!is_rapid(move.kind)) sum += move.length();
  }
  return sum;
}

double rapid_length(const Section& section) {
  double sum = 0;
  for (const Move& move : section.moves) {
    if (is_rapid(move.kind)) sum += move.length();
  }
  return sum;
}

}  // namespace clearcut::inline model
