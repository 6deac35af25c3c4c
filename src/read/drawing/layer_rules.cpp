#include "read/drawing/layer_rules.h"

#include <array>
#include <utility>

#include "base/error.h"
#include "base/text/format.h"
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

}  // namespace clearcut::read
