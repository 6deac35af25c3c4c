// References of an SVG's elements: to each other by id, and to style sheets.
#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "read/svg/svg_style.h"

namespace clearcut::read {

/// Elements within elements, and uses within uses, at most.
inline constexpr int kDeepestSvg = 200;

struct SvgDocument {
  std::map<std::string, pugi::xml_node> by_id;
  SvgStyleSheet sheet;
  bool sheet_understood = true;  ///< every rule of the style sheets has effect

  /// The element drawn by a <use>; an empty node if the file does not define it.
  pugi::xml_node used_by(const pugi::xml_node& use) const;
};

/// Reference of a <use>, as written: "#id".
std::string_view svg_target_of(const pugi::xml_node& use);

/// Ids and style sheets of all elements under `root`, at most 200 deep: `too_deep` gets the first deeper one, which
/// ends the search.
SvgDocument svg_document_of(const pugi::xml_node& root, pugi::xml_node& too_deep);

/// Whether more than `most` elements are drawn, with used elements counted at every use. Time grows with the elements
/// of the file, not with the drawn ones.
bool draws_more_than(int most, const pugi::xml_node& root, const SvgDocument& document);

/// Writes into `node` the place and size of its style (width, x, r, d, ...), which take precedence over attributes.
/// Lengths in percent and "auto" do not change the size of the page.
void take_svg_geometry(pugi::xml_node node, const SvgStyle& style);

}  // namespace clearcut::read
