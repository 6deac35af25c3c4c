// TEXT, ATTRIB and MTEXT of a DXF drawing as outlines of their letters.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "read/common/affine.h"
#include "read/dxf/dxf_codes.h"
#include "read/dxf/dxf_document.h"
#include "read/lettering/lettering.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// TEXT, ATTRIB, MTEXT.
bool is_text(std::string_view dxf_type);

class DxfLettering {
 public:
  explicit DxfLettering(const DxfDocument& document) : document_(document) {}

  /// The letters of `entity` under `map` (drawing to mm), all in the area `compound`. Heights are those of capitals.
  /// Nothing if the entity is not parallel to the plane. Throws InputError "file:line: ..." for damaged entities.
  /// Source: DXF reference, TEXT groups 72 and 73, MTEXT group 71.
  std::optional<std::vector<RawCurve>> letters_of(const DxfEntity& entity, const Affine& map,
                                                  Compound compound);

  void report(Diagnostics& diagnostics) const;

 private:
  TextLoops text(const DxfEntity& entity, const Affine& map);
  TextLoops mtext(const DxfEntity& entity, const Affine& map, bool from_below);
  std::vector<SetLine> wrapped(const Face& face, const DxfWords& words, double width);
  double height_of(const DxfEntity& entity) const;

  const DxfDocument& document_;
  Lettering lettering_;
  LeftOut ignored_;  ///< texts by their unsupported codes
};

}  // namespace clearcut::read
