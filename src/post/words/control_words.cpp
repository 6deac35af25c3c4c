#include "post/words/control_words.h"

#include <algorithm>

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

bool has_work_offset(const IsoDialect& dialect, const WorkOffset& offset) {
  if (dialect.safe_start.find("G54") == std::string_view::npos) return false;
  if (offset.number == 0) {
    if (offset.code >= kFirstSettable) return dialect.settable_offsets;
    return offset.code % 10 == 0 ? offset.code <= dialect.last_offset : dialect.fractional_offsets;
  }
  const auto& numbered = dialect.numbered_offsets;
  return std::any_of(numbered.begin(), numbered.end(), [&](const NumberedOffsets& one) {
    return one.code == offset.code && one.first <= offset.number && offset.number <= one.last;
  });
}

std::string work_offsets_of(const IsoDialect& dialect) {
  if (!has_work_offset(dialect, {})) return "";
  std::string text = "G54 to " + words_of({dialect.last_offset, 0});
  if (dialect.fractional_offsets) text += ", G59.1 to G59.3";
  if (dialect.settable_offsets)
    text += ", " + words_of({kFirstSettable, 0}) + " to " + words_of({kLastSettable, 0});
  for (const NumberedOffsets& one : dialect.numbered_offsets) {
    if (one.last > 0) text += ", " + words_of({one.code, one.first}) + " to P" + std::to_string(one.last);
  }
  return text;
}

std::vector<std::string> mode_blocks(const IsoDialect& dialect, const WorkOffset& offset) {
  const std::string_view first = "G54 ";
  std::string words(dialect.safe_start);
  const bool numbered = offset.number > 0;
  if (const std::size_t at = words.find(first); at != std::string::npos)
    words.replace(at, first.size(), numbered ? "" : words_of(offset) + " ");
  if (!numbered) return {words};
  return {words, words_of(offset)};
}

std::vector<std::string> later_mode_blocks(const IsoDialect& dialect, const WorkOffset& offset) {
  const std::string_view no_length = "G49 ";
  std::vector<std::string> blocks = mode_blocks(dialect, offset);
  if (const std::size_t at = blocks.front().find(no_length); at != std::string::npos)
    blocks.front().erase(at, no_length.size());
  return blocks;
}

std::vector<std::string> home_blocks(const IsoDialect& dialect) {
  const std::string zero = dialect.always_point ? "0." : "0";
  if (dialect.home == HomeForm::kSuppressed) return {"SUPA G0 Z0 D0", "SUPA G0 X0 Y0 D0"};
  if (dialect.home == HomeForm::kMachineZero) return {"G53 G0 Z" + zero, "G53 G0 X" + zero + " Y" + zero};
  return {"G91 G28 Z" + zero, "G28 X" + zero + " Y" + zero, "G90"};
}

}  // namespace clearcut::post
