// Names, attributes and styles of SVG elements.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "read/svg/svg_style.h"

namespace pugi {
class xml_node;
}

namespace clearcut::read {

/// Elements that draw nothing at their own place.
bool is_svg_definition(std::string_view name);

/// Pictures, movements, colours and elements of other programs' own: they only show or describe, and no cutter
/// follows them. All other unread elements may be part of the work.
bool draws_nothing_to_cut(const pugi::xml_node& node);

/// "" if absent.
std::string_view svg_text_of(const pugi::xml_node& node, const char* attribute);

/// Adobe Illustrator writes characters not permitted in an id, and underscores, by their codes: "POCKET_x5F_D3".
std::string unescaped_svg_id(std::string_view id);

/// "text title1": its name and id, for messages.
std::string svg_source(const pugi::xml_node& node);

/// A length in mm, "5mm"; without unit in mm. Nothing if invalid.
std::optional<double> svg_mm(std::string_view text);

/// The file with its defined entities expanded, as Adobe Illustrator once wrote styles: <!ENTITY st0 "fill:none;">.
/// Entities within entities are kept. Nothing if it defines none. Throws InputError if the text grows too large.
std::optional<std::string> with_svg_entities(std::string_view text, const std::string& file);

/// Applies the style of `node` on top of `style`, inherited from the enclosing element.
void apply_svg_style(const pugi::xml_node& node, const SvgStyleSheet& sheet, SvgStyle& style);

}  // namespace clearcut::read
