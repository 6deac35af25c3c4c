// What a page calls: texts in UTF-8 in the memory of the module, see package/index.js.
#include <clearcut/verify.h>
#include <emscripten/emscripten.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace {

/// A copy that the caller frees, ended by a zero.
char* handed_over(const std::string& text) {
  char* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy) std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE char* clearcut_check(const char* program, std::size_t program_size, const char* question,
                                          std::size_t question_size) {
  return handed_over(clearcut::check_text({program, program_size}, {question, question_size}));
}

EMSCRIPTEN_KEEPALIVE char* clearcut_option_names() {
  std::string names;
  for (const std::string& name : clearcut::question_options()) names += name + "\n";
  return handed_over(names);
}
}
