// Functions of include/clearcut/certificate.h, by calls of the stages.
#include <clearcut/certificate.h>

#include <utility>

#include "report/certificate/certificate_check.h"

namespace clearcut {

std::vector<std::string> certificate_contradictions(std::string_view certificate) {
  return report::certificate_contradictions(certificate);
}

std::vector<std::string> certificate_differences(std::string_view before, std::string_view now,
                                                 const std::set<std::string>& left_out) {
  return report::certificate_differences(before, now, left_out);
}

std::vector<std::string> certificate_faults(std::string_view certificate) {
  return report::certificate_faults(certificate);
}

bool seal_holds(std::string_view certificate) {
  return report::seal_holds(certificate);
}

}  // namespace clearcut
