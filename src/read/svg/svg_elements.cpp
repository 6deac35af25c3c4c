#include "read/svg/svg_elements.h"

#include <charconv>
#include <pugixml.hpp>

#include "read/common/text.h"
#include "read/common/units.h"
#include "read/svg/svg_numbers.h"
#include "read/svg/svg_shapes.h"

namespace clearcut::read {

bool is_svg_definition(std::string_view name) {
  for (const std::string_view one :
       {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "linearGradient", "radialGradient",
        "filter", "metadata", "title", "desc", "style", "namedview", "script", "font", "cursor", "view"}) {
    if (name == one) return true;
  }
  return false;
}

std::string_view svg_text_of(const pugi::xml_node& node, const char* attribute) {
  return node.attribute(attribute).value();
}

std::string unescaped_svg_id(std::string_view id) {
  std::string text;
  for (std::size_t i = 0; i < id.size(); ++i) {
    unsigned code = 0;
    const bool escaped =
        id.substr(i, 2) == "_x" && i + 4 < id.size() && id[i + 4] == '_' &&
        std::from_chars(id.data() + i + 2, id.data() + i + 4, code, 16).ptr == id.data() + i + 4;
    text += escaped ? static_cast<char>(code) : id[i];
    if (escaped) i += 4;
  }
  return text;
}

std::string svg_source(const pugi::xml_node& node) {
  const std::string_view id = svg_text_of(node, "id");
  return std::string(local_name(node)) + (id.empty() ? "" : " " + printable(id));
}

std::optional<double> svg_mm(std::string_view text) {
  SvgScanner scanner(text);
  const auto value = scanner.number();
  const std::string_view unit = scanner.word();
  const auto mm = unit.empty() ? std::optional(1.0) : mm_per_unit(unit);
  if (!value || !mm || !scanner.at_end()) return std::nullopt;
  return *value * *mm;
}

void apply_svg_style(const pugi::xml_node& node, const SvgStyleSheet& sheet, SvgStyle& style) {
  style.cut_off.clear();
  style.font.outer_size = style.font.size;
  for (const char* property : {"fill", "stroke", "fill-rule", "fill-opacity", "stroke-opacity", "opacity",
                               "visibility", "display", "clip-path", "mask", "stroke-width", "stroke-linecap",
                               "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray"}) {
    style.set(property, svg_text_of(node, property));
  }
  for (const char* property : kSvgFontProperties) style.set(property, svg_text_of(node, property));
  sheet.apply(local_name(node), svg_text_of(node, "id"), svg_text_of(node, "class"), style);
  apply_declarations(svg_text_of(node, "style"), style);
}

}  // namespace clearcut::read
