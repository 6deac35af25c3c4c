// Functions of include/clearcut/copies.h, by calls of the stages.
#include "pipeline/copies.h"

#include <clearcut/copies.h>

#include <utility>

namespace clearcut {

SheetOfCopies sheet_of_copies(const Part& part, const PlanOptions& options) {
  return pipeline::sheet_of_copies(part, options);
}

}  // namespace clearcut
