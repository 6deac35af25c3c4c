// Checks the elements of a job before they are interpolated and reduced.
#pragma once

#include <string>
#include <vector>

#include "model/design_element.h"

namespace clearcut::plan::grid {

struct ElementFault {
  std::string place;  ///< "file:line element 'id'"
  std::string text;   ///< the wrong size, and the remedy
};

/// Every fault of every element, in the elements' order; empty for a valid job.
std::vector<ElementFault> faults_of(const ElementJob& job);

/// Throws one InputError with all faults on one line.
void check(const ElementJob& job);

/// Elements off the grid, so that their squares are off by up to half a square. A warning, no
/// fault.
std::vector<ElementFault> off_grid(const ElementJob& job);

}  // namespace clearcut::plan::grid
