#include "model/options/tour_options.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::inline model {
namespace {

constexpr std::array kKinds{ObjectiveKind::kLength,
                            ObjectiveKind::kTurns,
                            ObjectiveKind::kAngle,
                            ObjectiveKind::kTime,
                            ObjectiveKind::kEngagement,
                            ObjectiveKind::kEngagementInverse,
                            ObjectiveKind::kEngagementExact,
                            ObjectiveKind::kForce,
                            ObjectiveKind::kEnergy,
                            ObjectiveKind::kWear,
                            ObjectiveKind::kClimb};

ObjectiveKind kind_named(const std::string& name, const std::string& place) {
  std::string names;
  for (const ObjectiveKind kind : kKinds) {
    if (name == name_of(kind)) return kind;
    names += std::string(name_of(kind)) + ", ";
  }
  throw InputError(place, "'" + name + "' is unknown; use one of " + names +
                              "or weights such as 1:length,20:turns or force=0.3,time=0.7");
}

double weight_of(const std::string& text, const std::string& place) {
  double weight = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), weight);
  if (error != std::errc() || end != text.data() + text.size() || !(weight >= 0))
    throw InputError(place, "'" + text + "' is no weight of 0 or more");
  return weight;
}

/// "20:turns" or "turns=20".
ObjectiveTerm term_of(const std::string& text, const std::string& place) {
  if (const auto colon = text.find(':'); colon != std::string::npos)
    return {kind_named(text.substr(colon + 1), place), weight_of(text.substr(0, colon), place)};
  if (const auto equals = text.find('='); equals != std::string::npos)
    return {kind_named(text.substr(0, equals), place), weight_of(text.substr(equals + 1), place)};
  throw InputError(place, "'" + text + "' lacks its weight");
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
      return "engagement-exact";
    case ObjectiveKind::kForce:
      return "force";
    case ObjectiveKind::kEnergy:
      return "energy";
    case ObjectiveKind::kWear:
      return "wear";
    case ObjectiveKind::kClimb:
      break;
  }
  return "climb";
}

bool is_load(ObjectiveKind kind) {
  return needs_material(kind) || kind == ObjectiveKind::kClimb;
}

bool needs_material(ObjectiveKind kind) {
  return kind == ObjectiveKind::kForce || kind == ObjectiveKind::kEnergy || kind == ObjectiveKind::kWear;
}

bool Objective::asks_load() const {
  return std::any_of(terms.begin(), terms.end(),
                     [](const ObjectiveTerm& term) { return is_load(term.kind); });
}

Objective parse_objective(const std::string& text, const std::string& place) {
  Objective objective;
  objective.terms.clear();
  if (text.find_first_of(":=") == std::string::npos) {
    objective.terms.push_back({kind_named(text, place), 1});
    return objective;
  }
  objective.weighted = true;
  for (const std::string& part : split(text, ',')) objective.terms.push_back(term_of(part, place));
  return objective;
}

}  // namespace clearcut::inline model
