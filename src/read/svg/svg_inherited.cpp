#include "read/svg/svg_inherited.h"

#include <algorithm>
#include <pugixml.hpp>

#include "read/common/text.h"
#include "read/svg/svg_document.h"
#include "read/svg/svg_elements.h"
#include "read/svg/svg_numbers.h"

namespace clearcut::read {
namespace {

/// Whether a named group within a layer is itself a layer. A plain group belongs to the layer, so that its outlines
/// nest in those around them.
bool is_layer(const pugi::xml_node& node, const std::string& label, const LayerMeaning& meaning,
              const ReadOptions& options, const std::string& around) {
  const bool says = meaning.says_role || meaning.depth || meaning.top;
  const auto is_meant = [&](const LayerRule& rule) {
    return matches(rule.pattern, label) && !matches(rule.pattern, around);
  };
  return says || svg_text_of(node, "inkscape:groupmode") == "layer" ||
         std::any_of(options.layer_rules.begin(), options.layer_rules.end(), is_meant);
}

void inherit_layer(const pugi::xml_node& node, std::string_view name, const ReadOptions& options,
                   SvgInherited& own) {
  std::string label(svg_text_of(node, "inkscape:label"));
  if (label.empty()) label = unescaped_svg_id(svg_text_of(node, "id"));
  if (label.empty()) return;
  const LayerMeaning meaning = meaning_of_layer(label);
  // Every shape has an id; only an id with a role is more than a number.
  if (name != "g" && !meaning.says_role) return;
  own.chosen = own.chosen || std::any_of(options.layers.begin(), options.layers.end(),
                                         [&](const std::string& p) { return matches(p, label); });
  if (own.layer.empty() || is_layer(node, label, meaning, options, own.layer)) own.layer = label;
  if (meaning.says_role) own.role = meaning.role, own.hole = meaning.hole, own.width = meaning.width;
  if (meaning.depth) own.depth = meaning.depth;
  if (meaning.top) own.top = meaning.top;
}

/// The origin of an element's transform, user units; nothing if invalid.
std::optional<Vec2> transform_origin(std::string_view text) {
  if (text.empty()) return Vec2{};
  const std::size_t gap = text.find_first_of(" \t\r\n");
  const auto x = svg_plain_length(text.substr(0, gap));
  const auto y = svg_plain_length(gap == std::string_view::npos ? std::string_view{} : text.substr(gap + 1));
  if (!x || !y) return std::nullopt;
  return Vec2{*x, *y};
}

std::string inherit_transform(const pugi::xml_node& node, SvgInherited& own) {
  const std::string_view attribute = svg_text_of(node, "transform");
  // The transform of the style takes precedence over the attribute.
  const std::string_view text = own.style.transform.empty() ? attribute : own.style.transform;
  if (!own.style.moved_by.empty())
    return "the property " + own.style.moved_by + " of a style is not read; write it as a transform";
  if (text.empty()) return {};
  const auto transform = svg_transform(text);
  if (!transform) return "transform '" + printable(text) + "' is not understood; correct it";
  const std::string& box = own.style.transform_box;
  if (!box.empty() && box != "view-box")
    return "transform-box '" + printable(box) +
           "' is not read; leave it out and turn the shape about a point in user units";
  const auto origin = transform_origin(own.style.transform_origin);
  if (!origin)
    return "transform-origin '" + printable(own.style.transform_origin) +
           "' is no pair of lengths; write it in user units, or move the shape itself";
  own.map = own.map * Affine::translation(*origin) * *transform * Affine::translation(-*origin);
  return {};
}

/// A length in mm; without unit in mm.
std::string take_length(const pugi::xml_node& node, const char* name, std::optional<double>& length) {
  const std::string_view text = svg_text_of(node, name);
  if (text.empty()) return {};
  const auto mm = svg_mm(text);
  if (!mm) return std::string(name) + " '" + printable(text) + "' is no length; write it like \"5mm\"";
  length = mm;
  return {};
}

}  // namespace

std::string inherit_svg(const pugi::xml_node& node, const SvgStyleSheet& sheet, const ReadOptions& options,
                        SvgInherited& own) {
  apply_svg_style(node, sheet, own.style);
  const std::string_view name = local_name(node);
  if (name == "g" || name == "text" || is_svg_shape(name)) inherit_layer(node, name, options, own);
  take_svg_geometry(node, own.style);
  std::string problem = inherit_transform(node, own);
  if (problem.empty()) problem = take_length(node, "data-depth", own.depth);
  return problem.empty() ? take_length(node, "data-top", own.top) : problem;
}

}  // namespace clearcut::read
