// Boundaries of filled areas of a DXF drawing: HATCH, SOLID and TRACE.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "read/common/affine.h"
#include "read/dxf/dxf_document.h"
#include "read/repair/repair.h"

namespace clearcut::read {

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
