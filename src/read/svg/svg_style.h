// What SVG's attributes and style sheets say of an element, as far as it matters for milling.
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
  std::string clip_rule = "nonzero";  ///< of shapes in clip paths
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
  bool shown = true;          ///< display; an element that is not shown hides all within
  bool seen = true;           ///< opacity above 0; the same
  SvgFont font;
  bool overflows = false;  ///< overflow: a viewport shows what lies beyond it; not inherited
  std::string clip;        ///< clip-path, as written; "" for none; not inherited
  bool masked = false;     ///< a mask hides part of the element; not inherited

  std::string transform, transform_origin;  ///< as written; not inherited
  std::string transform_box;                ///< what origin and percentages refer to; not inherited
  std::string
      moved_by;  ///< "rotate", "scale" or "translate" where the element has this property; not inherited
  /// Place and size, with properties' names and their values as written; not inherited.
  std::vector<std::pair<std::string, std::string>> geometry;

  bool fills() const;
  bool strokes() const;
  /// Its pen in user units; widths in percent are of `diagonal`.
  Pen pen(double diagonal) const;
  void set(std::string_view property, std::string_view value);
  /// The same of a style, which says place and size, too.
  void set_by_style(std::string_view property, std::string_view value);
};

/// "#rrggbb" in small letters for #rgb, #rrggbb, rgb() and the common names; else the text itself.
std::string normal_color(std::string_view color);

/// The rules of <style> elements with simple selectors: "*", "path", ".class", "#id" and lists of them.
class SvgStyleSheet {
 public:
  /// Adds the rules of one <style>; false when something in it was not understood.
  bool add(std::string_view css);
  /// What its rules say of an element, those that are said to be important or the others.
  void apply(std::string_view element, std::string_view id, std::string_view classes, bool important,
             SvgStyle& style) const;

 private:
  struct Rule {
    int order;  ///< in the sheet: of rules as special as each other the last counts
    std::string declarations;
  };
  std::map<std::string, std::vector<Rule>, std::less<>> rules_;  ///< by selector
  int count_ = 0;
};

/// Applies those of "fill:none;stroke:#000 !important" that are important, or the others.
void apply_declarations(std::string_view declarations, bool important, SvgStyle& style);

}  // namespace clearcut::read
