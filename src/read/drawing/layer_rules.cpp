#include "read/drawing/layer_rules.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"

namespace clearcut::read {
namespace {

constexpr std::array<std::pair<const char*, LayerRole>, 14> kRoleNames{{{"pocket", LayerRole::kPocket},
                                                                        {"step", LayerRole::kStep},
                                                                        {"profile", LayerRole::kProfile},
                                                                        {"inside", LayerRole::kInside},
                                                                        {"drill", LayerRole::kHole},
                                                                        {"engrave", LayerRole::kEngrave},
                                                                        {"tslot", LayerRole::kTSlot},
                                                                        {"vcarve", LayerRole::kVCarve},
                                                                        {"isolate", LayerRole::kIsolate},
                                                                        {"chamfer", LayerRole::kChamfer},
                                                                        {"face", LayerRole::kFace},
                                                                        {"island", LayerRole::kIsland},
                                                                        {"stock", LayerRole::kStock},
                                                                        {"ignore", LayerRole::kIgnore}}};

}  // namespace

const char* name_of(LayerRole role) {
  for (const auto& [name, value] : kRoleNames) {
    if (value == role) return name;
  }
  return "pocket";
}

LayerRule rule_named(const std::string& kind, const std::string& place) {
  const LayerMeaning meaning = meaning_of_kind(kind);
  if (!meaning.says_role) {
    std::string known;
    for (const auto& [name, value] : kRoleNames) known += (known.empty() ? "" : ", ") + std::string(name);
    throw InputError(place, "'" + printable(kind) + "' is no kind of operation; use one of " + known);
  }
  LayerRule rule;
  rule.role = meaning.role;
  rule.depth = meaning.depth;
  rule.top = meaning.top;
  rule.width = meaning.width;
  rule.hole = meaning.hole;
  rule.asked = true;
  return rule;
}

LayerRule rule_of_option(const std::string& text, const std::string& place) {
  const auto colon = text.find(':');
  if (colon == std::string::npos || colon + 1 == text.size()) {
    throw InputError(place,
                     "'" + text +
                         "' names no outlines; write KIND:LAYER, KIND:outer or KIND:NUMBER, for example "
                         "profile:outer");
  }
  LayerRule rule = rule_named(text.substr(0, colon), place);
  rule.pattern = text.substr(colon + 1);
  return rule;
}

ReadOptions read_options_of(const InputOptions& input) {
  ReadOptions options;
  for (const auto& text : input.operations) options.layer_rules.push_back(rule_of_option(text, "--op"));
  options.scale = input.scale.value_or(1);
  options.scale_is_right = input.scale.has_value();
  options.mirror = input.mirror;
  options.join_gap = input.join_gap;
  if (input.open_curves)
    options.open_curves = *input.open_curves == "skip" ? OpenCurves::kSkip : OpenCurves::kRefuse;
  if (input.text) options.text_outlines = *input.text == "outlines";
  if (input.strokes) options.stroke_areas = *input.strokes == "areas";
  options.find_arcs = input.find_arcs;
  options.unit = input.unit;
  options.layers = input.layers;
  options.top = input.top;
  options.depth = input.depth;
  options.solid.up = input.up.value_or("");
  options.solid.turn_deg = input.turn_deg.value_or(0);
  options.solid.body = input.body.value_or("");
  options.solid.breakthrough = input.breakthrough;
  return options;
}

namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The number at the start of `text`, after one separator at most: "5", "_3.2", "=-4", " 3,2".
std::optional<double> leading_number(std::string_view text) {
  if (!text.empty() && std::string_view("_ =:").find(text[0]) != std::string_view::npos)
    text.remove_prefix(1);
  std::string number;
  for (const char c : text) {
    const bool sign = c == '-' && number.empty();
    if (!is_digit(c) && !sign && c != '.' && c != ',') break;
    number += c == ',' ? '.' : c;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return value;
}

/// Visits every word of letters: visit(word, text after it).
template <typename Visit>
void for_words(std::string_view text, Visit visit) {
  for (std::size_t i = 0; i < text.size();) {
    if (!is_letter(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    visit(text.substr(i, end - i), text.substr(end));
    i = end;
  }
}

std::optional<HoleKind> hole_kind_of_word(std::string_view word) {
  constexpr std::pair<std::string_view, HoleKind> kWords[] = {{"SPOT", HoleKind::kSpotted},
                                                              {"REAM", HoleKind::kReamed},
                                                              {"BORE", HoleKind::kBored},
                                                              {"CBORE", HoleKind::kCounterbored},
                                                              {"COUNTERBORE", HoleKind::kCounterbored},
                                                              {"CSK", HoleKind::kCountersunk},
                                                              {"COUNTERSINK", HoleKind::kCountersunk},
                                                              {"TAP", HoleKind::kTapped},
                                                              {"THREAD", HoleKind::kThreadMilled}};
  for (const auto& [name, kind] : kWords) {
    if (name == word) return kind;
  }
  return std::nullopt;
}

/// The thread beginning at the word `begin`, up to the next underscore or blank.
std::optional<Thread> thread_at(std::string_view text, std::size_t begin) {
  const std::size_t end = text.find_first_of("_ ", begin);
  return thread_named(text.substr(begin, end == std::string_view::npos ? end : end - begin));
}

/// Request of a layer's words for its holes; nothing for plain holes.
std::optional<HoleRequest> holes_of(std::string_view text) {
  HoleRequest request;
  bool any = false, left = false;
  for_words(text, [&](std::string_view word, std::string_view rest) {
    const auto begin = static_cast<std::size_t>(word.data() - text.data());
    if (const auto kind = hole_kind_of_word(word)) request.kind = *kind, any = true;
    if (word == "THRU" || word == "THROUGH") request.through = any = true;
    if (word == "LH") left = true;
    if (word == "EXTERNAL" || word == "EXT") request.external = true;
    if (word == "DIA") request.diameter = leading_number(rest), any = true;
    if (word == "PECK" || word == "CHIP") {
      request.chip_break = word == "CHIP";
      request.peck = leading_number(rest);
      any = true;
    }
    if (word == "M" || word == "UNC" || word == "UNF") {
      if (const auto thread = thread_at(text, begin)) request.thread = thread;
    }
  });
  if (left && request.thread && !request.thread->left_hand)
    request.thread = thread_named(request.thread->name + "LH");
  return any ? std::optional(request) : std::nullopt;
}

std::optional<LayerRole> role_of_word(std::string_view word) {
  if (word == "ISLAND" || word == "ISLANDS" || word == "BOSS" || word == "BOSSES") return LayerRole::kIsland;
  if (word == "HOLE" || word == "HOLES" || word == "DRILL" || hole_kind_of_word(word))
    return LayerRole::kHole;
  if (word == "POCKET" || word == "POCKETS") return LayerRole::kPocket;
  for (const std::string_view profile :
       {"PROFILE", "PROFILES", "CUTOUT", "CUTOUTS", "OUTLINE", "OUTLINES", "OUTSIDE", "PERIMETER"}) {
    if (word == profile) return LayerRole::kProfile;
  }
  if (word == "INSIDE") return LayerRole::kInside;
  if (word == "VCARVE" || word == "CARVE") return LayerRole::kVCarve;
  if (word == "ISOLATE" || word == "ISOLATION") return LayerRole::kIsolate;
  if (word == "ENGRAVE") return LayerRole::kEngrave;
  if (word == "TSLOT" || word == "TSLOTS") return LayerRole::kTSlot;
  if (word == "CHAMFER" || word == "CHAMFERS" || word == "DEBURR") return LayerRole::kChamfer;
  if (word == "FACE") return LayerRole::kFace;
  if (word == "STOCK") return LayerRole::kStock;
  for (const std::string_view ignored :
       {"IGNORE", "CONSTRUCTION", "DEFPOINTS", "DIM", "DIMS", "DIMENSION", "DIMENSIONS"}) {
    if (word == ignored) return LayerRole::kIgnore;
  }
  return std::nullopt;
}

/// The number ending at `end` of the text, with at most one blank or underscore after it: the 6 of "POCKET 6 " before
/// "MM".
std::optional<double> number_before(std::string_view text, std::size_t end) {
  if (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '_')) --end;
  std::size_t begin = end;
  const auto is_of_number = [](char c) { return is_digit(c) || c == '.' || c == ','; };
  while (begin > 0 && is_of_number(text[begin - 1])) --begin;
  if (begin == end || (begin > 0 && is_letter(text[begin - 1]))) return std::nullopt;
  return leading_number(text.substr(begin, end - begin));
}

/// Roles whose layers are called by their depth. The number of a hole's layer is its diameter.
bool is_called_by_depth(LayerRole role) {
  return role == LayerRole::kPocket || role == LayerRole::kProfile || role == LayerRole::kInside ||
         role == LayerRole::kEngrave;
}

/// A depth without a D: "POCKET 6MM", "6 MM POCKET", "POCKET-6".
void take_plain_depth(std::string_view text, LayerMeaning& meaning) {
  for_words(text, [&](std::string_view word, std::string_view) {
    const auto begin = static_cast<std::size_t>(word.data() - text.data());
    if (word == "MM" && !meaning.depth) {
      meaning.depth = number_before(text, begin);
      meaning.depth_in_mm = meaning.depth.has_value();
    }
  });
  for_words(text, [&](std::string_view word, std::string_view rest) {
    if (role_of_word(word) && !meaning.depth && rest.size() > 1 && rest[0] == '-' && is_digit(rest[1]))
      meaning.depth = leading_number(rest.substr(1));
  });
  if (meaning.depth && !(*meaning.depth > 0)) meaning.depth.reset(), meaning.depth_in_mm = false;
}

}  // namespace

LayerMeaning meaning_of_layer(std::string_view name) {
  LayerMeaning meaning;
  const std::string text = capitals(name);
  for_words(text, [&](std::string_view word, std::string_view rest) {
    // "on" is a word of every language's sentences: it counts only as the first word.
    const bool on = word == "ON" && word.data() == text.data();
    if (const auto role = on ? LayerRole::kEngrave : role_of_word(word)) {
      meaning.role = *role;
      meaning.says_role = true;
    }
    if (word == "D" || word == "DEPTH") {
      if (const auto depth = leading_number(rest)) meaning.depth = std::abs(*depth);
    }
    if (word == "START") {
      if (const auto start = leading_number(rest)) meaning.start = std::abs(*start);
    }
    if (word == "W") {
      if (const auto width = leading_number(rest)) meaning.width = std::abs(*width);
    }
    if (word == "TOP") {
      if (const auto top = leading_number(rest)) meaning.top = top;
    }
  });
  if (meaning.says_role && !meaning.depth && is_called_by_depth(meaning.role))
    take_plain_depth(text, meaning);
  if (meaning.role == LayerRole::kHole) meaning.hole = holes_of(text);
  return meaning;
}

LayerMeaning meaning_of_kind(std::string_view kind) {
  LayerMeaning meaning = meaning_of_layer(kind);
  for_words(capitals(kind), [&](std::string_view word, std::string_view) {
    if (word == "STEP") meaning.role = LayerRole::kStep, meaning.says_role = true;
  });
  return meaning;
}

bool matches(std::string_view pattern, std::string_view name) {
  const std::string p = capitals(pattern), n = capitals(name);
  std::size_t i = 0, k = 0, star = std::string::npos, resume = 0;
  while (k < n.size()) {
    if (i < p.size() && p[i] == '*') {
      star = i++;
      resume = k;
    } else if (i < p.size() && p[i] == n[k]) {
      ++i;
      ++k;
    } else if (star != std::string::npos) {
      i = star + 1;
      k = ++resume;
    } else {
      return false;
    }
  }
  while (i < p.size() && p[i] == '*') ++i;
  return i == p.size();
}

}  // namespace clearcut::read
