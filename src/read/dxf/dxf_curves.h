// DXF entities as curves of lines and arcs, and the boundaries of filled areas: HATCH, SOLID and TRACE.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "read/common/affine.h"
#include "read/dxf/dxf_document.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// Whether curve_of reads entities of this type.
bool is_curve(std::string_view dxf_type);

/// From the entity's own coordinates (mirrored if its extrusion points down) to the drawing's; nothing if it is not
/// parallel to the plane.
std::optional<Affine> entity_map(const DxfDocument& document, const DxfEntity& entity);

/// Radius of a circle or an arc, mm >= 0. Throws  InputError for a radius below 0.
double radius_of(const DxfDocument& document, const DxfEntity& entity);

/// The curve of `entity` under `map` (drawing to mm); `vertices` are the VERTEX entities of a POLYLINE.
/// Nothing for meshes, tilted entities and splines without points. Throws InputError "file:line:
/// ..." for damaged entities.
std::optional<RawCurve> curve_of(const DxfDocument& document, const DxfEntity& entity,
                                 std::span<const DxfEntity> vertices, const Affine& map);

/// Width of a polyline in the entity's own units; `constant` is absent where it varies along the line.
struct DxfWidth {
  double widest = 0;
  std::optional<double> constant;
};
/// `vertices` are the VERTEX entities of a POLYLINE. Other entities have no width.
DxfWidth width_of(const DxfDocument& document, const DxfEntity& entity, std::span<const DxfEntity> vertices);

/// The vertices with bulges in `entity`, for example an LWPOLYLINE, under `map`.
Path light_polyline(const DxfDocument& document, const DxfEntity& entity, bool closed, const Affine& map);

/// Whether boundaries_of reads entities of this type.
bool is_fill(std::string_view dxf_type);

/// The closed boundaries of `entity` under `map` (drawing to mm): of a HATCH its boundary paths, of a SOLID or TRACE
/// its corners in turn, without the boundaries ignored by the style of a HATCH. Together they bound the area by the
/// even-odd rule. Nothing if the entity is not parallel to the plane, has no boundary, or an incomplete one. Throws
/// InputError "file:line: ..." for damaged entities. Source: DXF reference, HATCH "boundary path data"; ends of
/// elliptical edges are angles seen from the centre.
std::optional<std::vector<RawCurve>> boundaries_of(const DxfDocument& document, const DxfEntity& entity,
                                                   const Affine& map);

}  // namespace clearcut::read
