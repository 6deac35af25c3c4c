// Visible parts of an SVG's shapes under clip paths and viewports.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "read/svg/svg_document.h"
#include "read/svg/svg_inherited.h"

namespace clearcut::read {

/// The visible areas of a document's <clipPath> elements.
class SvgClips {
 public:
  SvgClips(const SvgDocument& document, const ReadOptions& options)
      : document_(document), options_(options) {}

  /// Narrows own.shown to the visible area of the element's clip-path; `own` is inherited with the element's own
  /// transform. A broken reference hides nothing, as in browsers. False for unsupported clip paths: functions such as
  /// inset(), text, sizes by the bounding box of the clipped element. Source: SVG 1.1, section 14.3. Cost: each clip
  /// path under each transform once.
  bool narrow(SvgInherited& own);

 private:
  struct Area {
    bool is_read = true;
    SvgWindow shown;
  };
  Area area_of(std::string_view reference, const SvgInherited& user, int depth);
  Area shapes_of(const pugi::xml_node& clip, const SvgInherited& user, int depth);
  bool add_shape(const pugi::xml_node& node, SvgInherited own, int depth, Regions& seen);

  const SvgDocument& document_;
  const ReadOptions& options_;
  using Key = std::tuple<std::string, std::array<double, 6>, double, double>;
  std::map<Key, Area> areas_;
};

/// Narrows own.shown to a viewport from the origin to (width, height), user units, under `place`.
void narrow_to_viewport(SvgInherited& own, const Affine& place, double width, double height,
                        const Tolerances& tol);

/// Visible share of a shape.
enum class Seen { kWhole, kPart, kNothing };

/// Reduces curves filling an area together to the visible part, and returns how much is visible. Wholly visible
/// outlines are unchanged. `nonzero`: the winding rule; else even-odd.
Seen clip_fill(std::vector<RawCurve>& curves, bool nonzero, const SvgWindow& shown, const Tolerances& tol);

/// How much of a line is visible: also kPart if the decision takes too long.
Seen how_much_is_seen(const Path& line, const SvgWindow& shown, const Tolerances& tol);

}  // namespace clearcut::read
