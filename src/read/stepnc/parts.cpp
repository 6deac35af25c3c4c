#include "read/stepnc/parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clearcut::read::stepnc {

namespace {

constexpr double kSameHole = 0.05;  // mm

template <class Wanted>
std::vector<std::size_t> those(const std::vector<const Draft*>& parts, const Wanted& wanted) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (wanted(*parts[i])) chosen.push_back(i);
  return chosen;
}

bool lists(const Draft& part, const Node& operation) {
  const std::vector<Node> own = part.node.refs(2);
  return std::any_of(own.begin(), own.end(), [&](const Node& node) { return node.id() == operation.id(); });
}

}  // namespace

bool goes_straight_down(const Operation& operation) {
  return operation.kind == OperationKind::kDrilling || operation.kind == OperationKind::kReaming;
}

std::vector<std::size_t> parts_for(const std::vector<const Draft*>& parts, const Node& node,
                                   const Operation& operation, const Tool& tool) {
  std::vector<std::size_t> all(parts.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (parts.size() == 1) return all;
  std::vector<std::size_t> chosen = those(parts, [&](const Draft& part) { return lists(part, node); });
  if (!chosen.empty()) return chosen;
  if (goes_straight_down(operation))
    chosen = those(parts, [&](const Draft& part) {
      return part.hole_diameter && std::abs(*part.hole_diameter - tool.diameter) < kSameHole;
    });
  if (!chosen.empty()) return chosen;
  chosen = those(parts, [&](const Draft& part) {
    if (!part.hole_diameter) return !goes_straight_down(operation);
    return *part.hole_diameter > tool.diameter - kSameHole;
  });
  return chosen.empty() ? all : chosen;
}

}  // namespace clearcut::read::stepnc
