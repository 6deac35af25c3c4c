// What the elements of an SVG refer to: each other by id, and style sheets.
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

  /// The element that a <use> draws; an empty node where the file does not define it.
  pugi::xml_node used_by(const pugi::xml_node& use) const;
};

/// Where a <use> looks for what it draws, as written: "#id".
std::string_view svg_target_of(const pugi::xml_node& use);

/// Ids and style sheets of all elements under `root`, at most 200 deep: `too_deep` gets the first that lies deeper, which
/// ends the search.
SvgDocument svg_document_of(const pugi::xml_node& root, pugi::xml_node& too_deep);

/// Whether more than `most` elements are drawn, what is used counted at every use of it. Time grows with the elements of the
/// file, not with what they draw.
bool draws_more_than(int most, const pugi::xml_node& root, const SvgDocument& document);

/// Writes into `node` what its style says of place and size (width, x, r, d, ...), which goes before attributes.
/// Lengths in percent and "auto" leave the size of the page as it is.
void take_svg_geometry(pugi::xml_node node, const SvgStyle& style);

}  // namespace clearcut::read
