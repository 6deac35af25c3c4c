// Properties inherited by an SVG element from the groups around it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "read/common/affine.h"
#include "read/drawing/drawing.h"
#include "read/svg/svg_shapes.h"
#include "read/svg/svg_style.h"

namespace pugi {
class xml_node;
}

namespace clearcut::read {

/// Visible area of the drawing, mm; null: all.
using SvgWindow = std::shared_ptr<const Regions>;

struct SvgInherited {
  SvgStyle style;
  Affine map;  ///< user units to mm
  SvgViewSize view;
  std::string layer;    ///< name of the nearest enclosing layer
  bool chosen = false;  ///< an enclosing group is among the chosen layers
  std::optional<LayerRole> role;
  std::optional<HoleRequest> hole;
  std::optional<double> depth, top, width;  ///< mm
  SvgWindow shown;                          ///< through clip paths and viewports
};

/// Adds style, transform, layer and depth of `node` to the inherited ones. Returns an unreadable value, "" if there
/// is none.
std::string inherit_svg(const pugi::xml_node& node, const SvgStyleSheet& sheet, const ReadOptions& options,
                        SvgInherited& own);

}  // namespace clearcut::read
