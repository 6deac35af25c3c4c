#include "read/gcode/sinumerik/held_words.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace clearcut::read::gcode {
namespace {

/// Words of which one holds at a time: what drives the axes, what leads them, which feed arcs have, how approaches meet a contour.
const std::vector<std::vector<std::string_view>>& kinds_of_ways() {
  static const std::vector<std::vector<std::string_view>> kinds{
      {"BRISK", "SOFT", "DRIVE"},
      {"FFWON", "FFWOF"},
      {"DYNNORM", "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH", "DYNPREC"},
      {"CFC", "CFTCP", "CFIN"},
      {"RTLION", "RTLIOF"},
      {"WALIMON", "WALIMOF"},
      {"CUT2D", "CUT2DF"},
      {"COMPOF", "COMPON", "COMPCURV", "COMPCAD", "COMPSURF"},
      {"G450", "G451"},
      {"G460", "G461", "G462"},
      {"G601", "G602", "G603"},
      {"NORM"},
      {"FNORM"},
      {"DIAMOF"},
      {"TRAFOOF"}};
  return kinds;
}

void keep_way(const std::string& name, std::vector<std::string>& ways) {
  for (const auto& kind : kinds_of_ways()) {
    const auto is_of_kind = [&](std::string_view word) {
      return std::find(kind.begin(), kind.end(), word) != kind.end();
    };
    if (!is_of_kind(name)) continue;
    std::erase_if(ways, is_of_kind);
    ways.push_back(name);
  }
}

void keep_g(int g, HeldWords& words) {
  const std::string text = "G" + std::to_string(g);
  if (g >= 17 && g <= 19) words.plane = text;
  if (g >= 93 && g <= 95) words.feed_mode = text;
  if ((g >= 54 && g <= 57) || (g >= 500 && g <= 599)) words.offset = text;
  if (g == 40) words.compensation = text;
  if (g == 70 || g == 71 || g == 700 || g == 710) {
    words.units = text;
    words.feeds_in_mm = g == 70 || g == 71;
  }
  keep_way(text, words.ways);
}

const SinumerikWord* word_of(const SinumerikBlock& block, std::string_view name) {
  const auto found = std::find_if(block.words.begin(), block.words.end(),
                                  [&](const SinumerikWord& word) { return word.name == name; });
  return found == block.words.end() ? nullptr : &*found;
}

bool is_suppressed(const SinumerikBlock& block) {
  return std::any_of(block.words.begin(), block.words.end(), [](const SinumerikWord& word) {
    return word.name == "SUPA" || (word.name == "G" && (word.number == 53 || word.number == 153));
  });
}

/// Straight up to a height of the machine.
void keep_home(const SinumerikBlock& block, HeldWords& words) {
  const SinumerikWord* const z = word_of(block, "Z");
  if (!z || !is_suppressed(block) || word_of(block, "X") || word_of(block, "Y")) return;
  const SinumerikWord* const edge = word_of(block, "D");
  words.home =
      "SUPA G0 Z" + trimmed(z->number, 6) + (edge ? " D" + trimmed(edge->number, 0) : std::string());
}

}  // namespace

void keep_sinumerik_words(const SinumerikBlock& block, HeldWords& words) {
  const bool changes = std::any_of(block.words.begin(), block.words.end(), [](const SinumerikWord& word) {
    return word.name == "M" && word.number == 6;
  });
  // From the change on the tool's first edge holds until another is named.
  if (changes) words.length = "D1";
  for (const SinumerikWord& word : block.words) {
    if (word.name == "G") keep_g(static_cast<int>(word.number), words);
    if (word.name == "D") words.length = "D" + trimmed(word.number, 0);
    if (word.kind == SinumerikValue::kNone) keep_way(word.name, words.ways);
    if (word.name == "T")
      words.next_tool_name = word.kind == SinumerikValue::kText ? "T=\"" + word.text + "\"" : std::string();
  }
  if (changes) words.tool_name = words.next_tool_name;
  keep_home(block, words);
}

}  // namespace clearcut::read::gcode
