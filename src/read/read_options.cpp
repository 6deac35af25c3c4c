#include "read/read_options.h"

#include "read/read_part.h"

namespace clearcut::read {

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
