#include "model/move.h"

#include "base/elementary.h"

namespace clearcut::inline model {

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
