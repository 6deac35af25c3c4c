// Functions of include/clearcut/verify.h for programs in other languages, by calls of the stages: a source of their own, since the
// module that checks programs compiles it without planners.
#include "pipeline/check_text.h"

#include <clearcut/verify.h>

namespace clearcut {

std::string check_text(std::string_view program, std::string_view question) {
  return pipeline::check_text(program, question);
}

std::vector<std::string> question_options() {
  return pipeline::question_options();
}

}  // namespace clearcut
