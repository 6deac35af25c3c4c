// Functions of include/clearcut/text.h, by calls of the stages.
#include <clearcut/text.h>

#include <utility>

#include "report/words/text_table.h"

namespace clearcut {

std::string fitted(const TextTable& table, std::size_t width) {
  return report::fitted(table, width);
}

std::string markdown(const TextTable& table) {
  return report::markdown(table);
}

std::string plain(const TextTable& table) {
  return report::plain(table);
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  return report::wrapped(text, width);
}

}  // namespace clearcut
