#include "post/control_words.h"

namespace clearcut::post {

std::vector<std::string_view> coolant_words(Coolant held, Coolant wanted, const MistWords& mist) {
  std::vector<std::string_view> words;
  bool flood = has_flood(held), fog = has_mist(held);
  if (fog && !has_mist(wanted) && !mist.off.empty()) {
    words.push_back(mist.off);
    fog = false;
  }
  if ((flood && !has_flood(wanted)) || (fog && !has_mist(wanted))) {
    words.push_back("M9");
    flood = false;
    fog = fog && !mist.off.empty();
  }
  if (has_flood(wanted) && !flood) words.push_back("M8");
  if (has_mist(wanted) && !fog) words.push_back(mist.on);
  return words;
}

}  // namespace clearcut::post
