#include "model/options/tour_options.h"

#include <array>
#include <charconv>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::inline model {
namespace {

constexpr std::array kKinds{ObjectiveKind::kLength,         ObjectiveKind::kTurns,
                            ObjectiveKind::kAngle,          ObjectiveKind::kTime,
                            ObjectiveKind::kEngagement,     ObjectiveKind::kEngagementInverse,
                            ObjectiveKind::kEngagementExact};

ObjectiveKind kind_named(const std::string& name, const std::string& place) {
  std::string names;
  for (const ObjectiveKind kind : kKinds) {
    if (name == name_of(kind)) return kind;
    names += std::string(name_of(kind)) + ", ";
  }
  throw InputError(place,
                   "'" + name + "' is unknown; use one of " + names + "or weights such as 1:length,20:turns");
}

double weight_of(const std::string& text, const std::string& place) {
  double weight = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), weight);
  if (error != std::errc() || end != text.data() + text.size() || !(weight >= 0))
    throw InputError(place, "'" + text + "' is no weight of 0 or more");
  return weight;
}

}  // namespace

const char* name_of(ObjectiveKind kind) {
  switch (kind) {
    case ObjectiveKind::kLength:
      return "length";
    case ObjectiveKind::kTurns:
      return "turns";
    case ObjectiveKind::kAngle:
      return "angle";
    case ObjectiveKind::kTime:
      return "time";
    case ObjectiveKind::kEngagement:
      return "engagement";
    case ObjectiveKind::kEngagementInverse:
      return "engagement-inverse";
    case ObjectiveKind::kEngagementExact:
      break;
  }
  return "engagement-exact";
}

Objective parse_objective(const std::string& text, const std::string& place) {
  Objective objective;
  objective.terms.clear();
  if (text.find(':') == std::string::npos) {
    objective.terms.push_back({kind_named(text, place), 1});
    return objective;
  }
  objective.weighted = true;
  for (const std::string& part : split(text, ',')) {
    const auto colon = part.find(':');
    if (colon == std::string::npos) throw InputError(place, "'" + part + "' lacks its weight");
    objective.terms.push_back(
        {kind_named(part.substr(colon + 1), place), weight_of(part.substr(0, colon), place)});
  }
  return objective;
}

}  // namespace clearcut::inline model
