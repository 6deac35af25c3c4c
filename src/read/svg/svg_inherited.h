// What an element of an SVG takes over from the groups around it.
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

/// What of the drawing is seen, mm; null: all of it.
using SvgWindow = std::shared_ptr<const Regions>;

struct SvgInherited {
  SvgStyle style;
  Affine map;  ///< user units to mm
  SvgViewSize view;
  std::string layer;    ///< name of the nearest group that is a layer
  bool chosen = false;  ///< a group around it is among the chosen layers
  std::optional<LayerRole> role;
  std::optional<HoleRequest> hole;
  std::optional<double> depth, top, width;  ///< mm
  SvgWindow shown;                          ///< through clip paths and viewports
};

/// Style, transform, layer and depth of `node` on top of what is around it. Returns what cannot be read, "" if all can.
std::string inherit_svg(const pugi::xml_node& node, const SvgStyleSheet& sheet, const ReadOptions& options,
                        SvgInherited& own);

}  // namespace clearcut::read
