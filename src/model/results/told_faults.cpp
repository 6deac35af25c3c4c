#include "model/results/told_faults.h"

#include <algorithm>
#include <iterator>

namespace clearcut::inline model {

std::vector<Fault> told_faults(const Findings& findings) {
  std::vector<Fault> told;
  std::copy_if(findings.faults.begin(), findings.faults.end(), std::back_inserter(told),
               [](const Fault& fault) { return fault.cause.empty(); });
  return told;
}

}  // namespace clearcut::inline model
