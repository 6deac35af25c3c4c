#include "read/svg/svg_elements.h"

#include <charconv>
#include <map>
#include <pugixml.hpp>

#include "base/error.h"
#include "read/common/text.h"
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

bool draws_nothing_to_cut(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  if (const std::size_t colon = name.find(':');
      colon != std::string_view::npos && name.substr(0, colon) != "svg")
    return true;
  for (const std::string_view one :
       {"image", "foreignObject", "video", "audio", "canvas", "iframe", "animate", "animateMotion",
        "animateTransform", "set", "color-profile", "solidcolor", "hatch", "meshgradient"}) {
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

namespace {

/// Values by names, of a document type's inner part.
std::map<std::string, std::string, std::less<>> entities_of(std::string_view prolog) {
  std::map<std::string, std::string, std::less<>> entities;
  constexpr std::string_view kBegin = "<!ENTITY", kBlanks = " \t\r\n";
  for (std::size_t at = prolog.find(kBegin); at != std::string_view::npos; at = prolog.find(kBegin, at)) {
    at += kBegin.size();
    const std::size_t name = prolog.find_first_not_of(kBlanks, at);
    const std::size_t end = prolog.find_first_of(kBlanks, name);
    const std::size_t quote = prolog.find_first_not_of(kBlanks, end);
    if (quote == std::string_view::npos || (prolog[quote] != '"' && prolog[quote] != '\'')) continue;
    const std::size_t close = prolog.find(prolog[quote], quote + 1);
    if (close == std::string_view::npos) break;
    entities.emplace(prolog.substr(name, end - name), prolog.substr(quote + 1, close - quote - 1));
    at = close;
  }
  return entities;
}

}  // namespace

std::optional<std::string> with_svg_entities(std::string_view text, const std::string& file) {
  constexpr std::size_t kLongestName = 256, kLargest = 256'000'000;
  const std::size_t root = text.find("<svg");
  const auto entities = entities_of(text.substr(0, root));
  if (entities.empty() || root == std::string_view::npos) return std::nullopt;
  std::string out(text.substr(0, root));
  for (std::string_view rest = text.substr(root); !rest.empty();) {
    const std::size_t begin = rest.find('&');
    out += rest.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const std::string_view name = rest.substr(begin + 1, rest.substr(begin + 1, kLongestName).find(';'));
    const auto entity = entities.find(name);
    out += entity == entities.end() ? std::string_view("&") : std::string_view(entity->second);
    rest.remove_prefix(entity == entities.end() ? begin + 1 : begin + name.size() + 2);
    if (out.size() > kLargest) throw InputError(file, "its entities make it larger than 256 MB; simplify it");
  }
  return out;
}

void apply_svg_style(const pugi::xml_node& node, const SvgStyleSheet& sheet, SvgStyle& style) {
  style.clip.clear();
  style.transform.clear();
  style.transform_box.clear();
  style.moved_by.clear();
  style.geometry.clear();
  style.fixed_stroke = style.overflows = style.masked = style.filtered = false;
  style.transform_origin = svg_text_of(node, "transform-origin");
  style.font.outer_size = style.font.size;
  for (const char* property :
       {"fill",         "stroke",         "fill-rule",       "fill-opacity",      "stroke-opacity",
        "opacity",      "visibility",     "display",         "clip-path",         "mask",
        "stroke-width", "stroke-linecap", "stroke-linejoin", "stroke-miterlimit", "stroke-dasharray",
        "marker-start", "marker-mid",     "marker-end",      "vector-effect",     "transform-box",
        "overflow",     "clip-rule",      "filter"}) {
    style.set(property, svg_text_of(node, property));
  }
  for (const char* property : kSvgFontProperties) style.set(property, svg_text_of(node, property));
  // Important properties take precedence over all others, and then the element's style over that of sheets.
  for (const bool important : {false, true}) {
    sheet.apply(local_name(node), svg_text_of(node, "id"), svg_text_of(node, "class"), important, style);
    apply_declarations(svg_text_of(node, "style"), important, style);
  }
}

}  // namespace clearcut::read
