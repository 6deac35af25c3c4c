// TEXT, ATTRIB and MTEXT of a DXF drawing as outlines of their letters: codes between the letters, text styles.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "read/common/affine.h"
#include "read/dxf/dxf_document.h"
#include "read/lettering/face.h"
#include "read/lettering/lettering.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// Text without its codes.
struct DxfWords {
  std::vector<std::u32string> paragraphs;  ///< at least one
  /// Font named by a code before the first letter: "Arial", "txt.shx".
  std::optional<std::string> font;
  bool bold = false, italic = false;    ///< stated with the font
  std::optional<double> height;         ///< height of capitals stated there, in units of the drawing
  std::optional<double> height_factor;  ///< the same, of the entity's height
  std::set<std::string> ignored;        ///< unsupported codes that change the appearance: "\\S"
};

/// For TEXT: %%c, %%d, %%p, %%nnn, %%%, \U+XXXX, ^I. One paragraph.
DxfWords words_of_text(std::string_view text);

/// For MTEXT: these codes, \P, \~, {}, \\, \{, \}, \S, \f, \H; all others are removed.
/// Source: DXF reference, "MTEXT format codes".
DxfWords words_of_mtext(std::string_view text);

struct DxfTextStyle {
  FaceRequest face;
  double width_factor = 1;
  double oblique = 0;  ///< radians
};

/// The face of a font named as in files: "arialbd.ttf", "Arial", "txt.shx".
FaceRequest face_of_font(std::string name);

/// The STYLE named by `entity` in group 7, else STANDARD; the machine's default face if the file defines none.
DxfTextStyle style_of(const DxfDocument& document, const DxfEntity& entity);

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
