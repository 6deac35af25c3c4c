#include "read/svg/svg_document.h"

#include <algorithm>

#include "read/svg/svg_elements.h"
#include "read/svg/svg_numbers.h"
#include "read/svg/svg_shapes.h"

namespace clearcut::read {
namespace {

void index(const pugi::xml_node& node, int depth, SvgDocument& document, pugi::xml_node& too_deep) {
  if (depth > kDeepestSvg) too_deep = node;
  if (too_deep) return;
  if (const auto id = svg_text_of(node, "id"); !id.empty()) document.by_id.try_emplace(std::string(id), node);
  if (local_name(node) == "style") {
    std::string css;
    for (const pugi::xml_node& child : node) css += child.value();
    document.sheet_understood = document.sheet.add(css) && document.sheet_understood;
  }
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_element) index(child, depth + 1, document, too_deep);
  }
}

/// Elements drawn by each element; saturates above `most`.
class DrawnCount {
 public:
  DrawnCount(int most, const SvgDocument& document) : most_(most), document_(document) {}

  int of(const pugi::xml_node& node, int depth = 0) {
    // Elements used at greater depth are refused by the drawing.
    if (depth > kDeepestSvg) return 1;
    const auto [found, is_new] = counts_.try_emplace(node.internal_object(), 1);
    // A self-reference is refused by the drawing.
    if (!is_new) return found->second;
    int sum = 1;
    const auto add = [&](const pugi::xml_node& part) {
      sum = std::min(sum + of(part, depth + 1), most_ + 1);
    };
    if (local_name(node) == "use") {
      if (const pugi::xml_node used = document_.used_by(node)) add(used);
    } else {
      for (const pugi::xml_node& child : node) {
        if (child.type() == pugi::node_element && !is_svg_definition(local_name(child))) add(child);
      }
    }
    return counts_[node.internal_object()] = sum;
  }

 private:
  int most_;
  const SvgDocument& document_;
  std::map<const void*, int> counts_;
};

/// The value of a property in the form of an attribute: path("M0 0") without its function.
std::string as_attribute(const std::string& property, const std::string& value) {
  const std::size_t open = value.find_first_of("\"'"), close = value.find_last_of("\"'");
  return property == "d" && open < close ? value.substr(open + 1, close - open - 1) : value;
}

}  // namespace

std::string_view svg_target_of(const pugi::xml_node& use) {
  const std::string_view target = svg_text_of(use, "href");
  return target.empty() ? svg_text_of(use, "xlink:href") : target;
}

pugi::xml_node SvgDocument::used_by(const pugi::xml_node& use) const {
  const std::string_view target = svg_target_of(use);
  const auto found = target.substr(0, 1) == "#" ? by_id.find(std::string(target.substr(1))) : by_id.end();
  return found == by_id.end() ? pugi::xml_node() : found->second;
}

SvgDocument svg_document_of(const pugi::xml_node& root, pugi::xml_node& too_deep) {
  SvgDocument document;
  index(root, 0, document, too_deep);
  return document;
}

bool draws_more_than(int most, const pugi::xml_node& root, const SvgDocument& document) {
  return DrawnCount(most, document).of(root) > most;
}

void take_svg_geometry(pugi::xml_node node, const SvgStyle& style) {
  const bool is_page = node.parent() == node.root();
  for (const auto& [property, value] : style.geometry) {
    if (is_page && !svg_plain_length(value)) continue;
    pugi::xml_attribute attribute = node.attribute(property.c_str());
    if (!attribute) attribute = node.append_attribute(property.c_str());
    attribute.set_value(as_attribute(property, value).c_str());
  }
}

}  // namespace clearcut::read
