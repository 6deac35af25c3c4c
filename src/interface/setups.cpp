// Functions of include/clearcut/setups.h, by calls of the stages.
#include <clearcut/setups.h>

#include <utility>

#include "post/part/stepnc_setups.h"

namespace clearcut {

std::string write_stepnc(const std::vector<WrittenSetup>& setups) {
  return post::write_stepnc(setups);
}

}  // namespace clearcut
