#include "read/svg/svg_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text.h"
#include "read/svg/svg_numbers.h"

namespace clearcut::read {
namespace {

std::string small(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

/// Calls visit(piece) for the pieces of `text` between separators.
template <typename Visit>
void for_pieces(std::string_view text, char separator, Visit visit) {
  while (true) {
    const std::size_t end = text.find(separator);
    visit(stripped(text.substr(0, end)));
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

std::string without_comments(std::string_view css) {
  std::string out;
  while (!css.empty()) {
    const std::size_t start = css.find("/*");
    out += css.substr(0, start);
    if (start == std::string_view::npos) break;
    const std::size_t end = css.find("*/", start + 2);
    if (end == std::string_view::npos) break;
    css.remove_prefix(end + 2);
  }
  return out;
}

bool is_simple(std::string_view selector) {
  return !selector.empty() && selector.find_first_of(" >+~:|[](){}@\t\n\r", 0) == std::string_view::npos &&
         selector.find_first_of(".#", 1) == std::string_view::npos;
}

std::string hex_color(double r, double g, double b) {
  static const char* const kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const double value : {r, g, b}) {
    const int byte = static_cast<int>(std::clamp(std::round(value), 0.0, 255.0));
    out += kDigits[byte / 16];
    out += kDigits[byte % 16];
  }
  return out;
}

/// "0", "0.0", "0%".
bool is_zero(std::string_view number) {
  SvgScanner scanner(number);
  const auto value = scanner.number();
  return value && *value <= 0;
}

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> all) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kNames{{{"black", "#000000"},
                                                                                {"white", "#ffffff"},
                                                                                {"red", "#ff0000"},
                                                                                {"green", "#008000"},
                                                                                {"lime", "#00ff00"},
                                                                                {"blue", "#0000ff"},
                                                                                {"yellow", "#ffff00"},
                                                                                {"cyan", "#00ffff"},
                                                                                {"aqua", "#00ffff"},
                                                                                {"magenta", "#ff00ff"},
                                                                                {"fuchsia", "#ff00ff"},
                                                                                {"gray", "#808080"},
                                                                                {"grey", "#808080"},
                                                                                {"orange", "#ffa500"},
                                                                                {"purple", "#800080"},
                                                                                {"brown", "#a52a2a"},
                                                                                {"silver", "#c0c0c0"}}};

/// Whether a colour is seen at all: "none", "rgba(0, 0, 0, 0)", "#f000" and "#ff000000" are not.
bool is_seen(std::string_view color) {
  if (color == "none" || color == "transparent") return false;
  if (color.substr(0, 1) == "#") {
    if (color.size() == 5) return color[4] != '0';
    return color.size() != 9 || color.substr(7) != "00";
  }
  const bool by_numbers = color.substr(0, 3) == "rgb" || color.substr(0, 3) == "hsl";
  const bool has_alpha =
      by_numbers && (color.substr(3, 1) == "a" || color.find('/') != std::string_view::npos);
  return !has_alpha || !is_zero(color.substr(color.find_last_of(",/ ") + 1));
}

}  // namespace

bool SvgStyle::fills() const {
  return fill_seen && is_seen(fill);
}

bool SvgStyle::strokes() const {
  return stroke_seen && is_seen(stroke);
}

void SvgStyle::set(std::string_view property, std::string_view value) {
  value = stripped(value);
  if (value.empty() || value == "inherit" || value == "unset") return;
  if (property == "clip-path") clip = value == "none" ? "" : value;
  if (property == "mask") masked = value != "none";
  if (property == "filter") filtered = value != "none";
  if (property == "fill") fill = small(value);
  if (property == "stroke") stroke = small(value);
  if (property == "fill-rule") fill_rule = small(value);
  if (property == "clip-rule") clip_rule = small(value);
  if (property == "stroke-width") stroke_width = value;
  if (property == "stroke-linecap") cap = small(value);
  if (property == "stroke-linejoin") join = small(value);
  if (property == "stroke-miterlimit") miter_limit = value;
  if (property == "stroke-dasharray") dashed = value != "none" && !is_zero(value);
  if (property == "fill-opacity") fill_seen = !is_zero(value);
  if (property == "stroke-opacity") stroke_seen = !is_zero(value);
  if (property == "opacity") seen = !is_zero(value);
  if (property == "visibility") visible = value == "visible";
  if (property == "display") shown = value != "none";
  if (property == "transform") transform = value;
  if (property == "transform-origin") transform_origin = value;
  if (property == "transform-box") transform_box = small(value);
  if (property == "vector-effect") fixed_stroke = value != "none";
  if (property.substr(0, 6) == "marker") marked = value != "none";
  if (property == "overflow") overflows = value == "visible" || value == "auto";
  if (value != "none" && is_one_of(property, {"rotate", "scale", "translate"})) moved_by = property;
  font.set(property, value);
}

Pen SvgStyle::pen(double diagonal) const {
  Pen pen;
  pen.width = svg_length(stroke_width, diagonal).value_or(pen.width);
  if (cap != "butt") pen.cap = cap == "round" ? StrokeCap::kRound : StrokeCap::kSquare;
  if (join == "round") pen.join = StrokeJoin::kRound;
  if (join == "bevel") pen.join = StrokeJoin::kBevel;
  pen.miter_limit = SvgScanner(miter_limit).number().value_or(pen.miter_limit);
  return pen;
}

std::string normal_color(std::string_view color) {
  const std::string text = small(stripped(color));
  for (const auto& [name, hex] : kNames) {
    if (text == name) return std::string(hex);
  }
  if (text.size() == 4 && text[0] == '#') {
    return {'#', text[1], text[1], text[2], text[2], text[3], text[3]};
  }
  if (text.rfind("rgb(", 0) != 0) return text;
  SvgScanner scanner(std::string_view(text).substr(4));
  double values[3] = {};
  for (double& value : values) {
    const auto number = scanner.number();
    if (!number) return text;
    value = *number;
    if (scanner.peek() == '%') {
      value = value * 255 / 100;
      scanner.skip();
    }
  }
  return hex_color(values[0], values[1], values[2]);
}

void SvgStyle::set_by_style(std::string_view property, std::string_view value) {
  set(property, value);
  if (is_one_of(property, {"x", "y", "width", "height", "cx", "cy", "r", "rx", "ry", "d"}))
    geometry.emplace_back(property, stripped(value));
}

void apply_declarations(std::string_view declarations, bool important, SvgStyle& style) {
  for_pieces(declarations, ';', [&](std::string_view declaration) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) return;
    const std::size_t mark = declaration.find('!', colon);
    if ((mark != std::string_view::npos) != important) return;
    const std::size_t length = mark == std::string_view::npos ? mark : mark - colon - 1;
    style.set_by_style(stripped(declaration.substr(0, colon)), declaration.substr(colon + 1, length));
  });
}

bool SvgStyleSheet::add(std::string_view css) {
  const std::string text = without_comments(css);
  std::string_view rest = text;
  bool understood = true;
  while (!stripped(rest).empty()) {
    const std::size_t open = rest.find('{');
    const std::size_t close = open == std::string_view::npos ? open : rest.find('}', open);
    if (close == std::string_view::npos) return false;
    const std::string_view declarations = rest.substr(open + 1, close - open - 1);
    const bool names_font = stripped(rest.substr(0, open)) == "@font-face";
    if (!names_font)
      for_pieces(rest.substr(0, open), ',', [&](std::string_view selector) {
        if (is_simple(selector)) {
          rules_[std::string(selector)].push_back({count_++, std::string(declarations)});
        } else {
          understood = false;
        }
      });
    rest.remove_prefix(close + 1);
  }
  return understood;
}

void SvgStyleSheet::apply(std::string_view element, std::string_view id, std::string_view classes,
                          bool important, SvgStyle& style) const {
  if (rules_.empty()) return;
  const auto apply_rules = [&](std::vector<const Rule*> rules) {
    std::stable_sort(rules.begin(), rules.end(),
                     [](const Rule* a, const Rule* b) { return a->order < b->order; });
    for (const Rule* rule : rules) apply_declarations(rule->declarations, important, style);
  };
  const auto add = [&](const std::string& selector, std::vector<const Rule*>& to) {
    const auto found = rules_.find(selector);
    if (found == rules_.end()) return;
    for (const Rule& rule : found->second) to.push_back(&rule);
  };
  std::vector<const Rule*> all, elements, of_classes, of_id;
  add("*", all);
  add(std::string(element), elements);
  for_pieces(classes, ' ', [&](std::string_view name) {
    if (!name.empty()) add("." + std::string(name), of_classes);
  });
  if (!id.empty()) add("#" + std::string(id), of_id);
  for (auto* rules : {&all, &elements, &of_classes, &of_id}) apply_rules(std::move(*rules));
}

}  // namespace clearcut::read
