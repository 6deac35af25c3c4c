// Objective by which the order of a grid is judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

enum class ObjectiveKind {
  kLength,
  kTurns,
  kAngle,
  kTime,
  kEngagement,
  kEngagementInverse,
  kEngagementExact
};
/// "length", "turns", "angle", "time", "engagement", "engagement-inverse", "engagement-exact".
const char* name_of(ObjectiveKind kind);

struct ObjectiveTerm {
  ObjectiveKind kind = ObjectiveKind::kTime;
  double weight = 1;
};

/// A weighted sum of terms; a single term without weight is that quantity itself.
struct Objective {
  std::vector<ObjectiveTerm> terms{ObjectiveTerm{}};
  bool weighted = false;
};

/// "turns", or weights: "1:length,20:turns". Throws InputError at `place`, listing the names.
Objective parse_objective(const std::string& text, const std::string& place);

}  // namespace clearcut::inline model
