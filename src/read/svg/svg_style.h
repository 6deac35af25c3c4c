// Style of an element from SVG's attributes and style sheets, as far as relevant for milling.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "read/drawing/stroke.h"
#include "read/svg/svg_font.h"

namespace clearcut::read {

/// Inherited properties.
struct SvgStyle {
  std::string fill = "black";
  std::string stroke = "none";
  std::string fill_rule = "nonzero";
  std::string clip_rule = "nonzero";  ///< fill rule of shapes in clip paths
  std::string stroke_width = "1";     ///< a length, as written
  std::string cap = "butt";
  std::string join = "miter";
  std::string miter_limit = "4";
  bool dashed = false;
  bool marked = false;        ///< markers on its corners
  bool fixed_stroke = false;  ///< vector-effect: the pen is not scaled with the shape; not inherited
  bool fill_seen = true;      ///< its opacity is above 0
  bool stroke_seen = true;    ///< the same
  bool visible = true;        ///< visibility; inherited
  bool shown = true;          ///< display; a hidden element hides all within
  bool seen = true;           ///< opacity above 0; the same
  SvgFont font;
  bool overflows = false;  ///< overflow: a viewport also shows its outside; not inherited
  std::string clip;        ///< clip-path, as written; "" for none; not inherited
  bool masked = false;     ///< a mask hides part of the element; not inherited
  bool filtered = false;   ///< the element is drawn through a filter; not inherited

  std::string transform, transform_origin;  ///< transform as written; not inherited
  std::string transform_box;                ///< reference of origin and percentages; not inherited
  std::string moved_by;  ///< "rotate", "scale" or "translate" if the element has this property; not inherited
  /// Place and size, with properties' names and their values as written; not inherited.
  std::vector<std::pair<std::string, std::string>> geometry;

  bool fills() const;
  bool strokes() const;
  /// Its pen in user units; widths in percent are of `diagonal`.
  Pen pen(double diagonal) const;
  void set(std::string_view property, std::string_view value);
  /// The same for a style, which also contains place and size.
  void set_by_style(std::string_view property, std::string_view value);
};

/// "#rrggbb" in small letters for #rgb, #rrggbb, rgb() and the common names; else the text itself.
std::string normal_color(std::string_view color);

/// The rules of <style> elements with simple selectors: "*", "path", ".class", "#id" and lists of them.
class SvgStyleSheet {
 public:
  /// Adds the rules of one <style>; false if a part of it was not understood.
  bool add(std::string_view css);
  /// Applies its rules to an element: the important ones or the others.
  void apply(std::string_view element, std::string_view id, std::string_view classes, bool important,
             SvgStyle& style) const;

 private:
  struct Rule {
    int order;  ///< order in the sheet: of equally specific rules the last counts
    std::string declarations;
  };
  std::map<std::string, std::vector<Rule>, std::less<>> rules_;  ///< rules by selector
  int count_ = 0;
};

/// Applies those of "fill:none;stroke:#000 !important" marked important, or the others.
void apply_declarations(std::string_view declarations, bool important, SvgStyle& style);

}  // namespace clearcut::read
