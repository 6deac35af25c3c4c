// What clip paths and the viewports of an SVG let be seen of its shapes.
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

/// The areas that the <clipPath> elements of a document let be seen.
class SvgClips {
 public:
  SvgClips(const SvgDocument& document, const ReadOptions& options)
      : document_(document), options_(options) {}

  /// Narrows own.shown to what the element's clip-path lets be seen; `own` is inherited with the element's own transform. A reference
  /// to nothing hides nothing, as in browsers. False for clip paths that are not read: functions as inset(), text, sizes by the
  /// bounding box of what they clip. Source: SVG 1.1, section 14.3. Cost of each clip path under each transform once.
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

/// How much of something is seen.
enum class Seen { kWhole, kPart, kNothing };

/// Leaves of curves that fill an area together what is seen of it, and says how much that is. Outlines that are wholly seen stay as
/// they are. `nonzero`: the winding rule; else even-odd.
Seen clip_fill(std::vector<RawCurve>& curves, bool nonzero, const SvgWindow& shown, const Tolerances& tol);

/// How much is seen of a line: kPart, too, where that takes too long to say.
Seen how_much_is_seen(const Path& line, const SvgWindow& shown, const Tolerances& tol);

}  // namespace clearcut::read
