#include "read/dxf/dxf_style.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/text/stripped.h"
#include "base/units.h"
#include "read/common/characters.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

/// Families by the beginning of their file names in Windows, followed by "", "b" or "bd", "i", "bi" or "z".
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kFiles{{{"ARIAL", "Arial"},
                                                                                {"TIMES", "Times New Roman"},
                                                                                {"COUR", "Courier New"},
                                                                                {"CALIBRI", "Calibri"},
                                                                                {"VERDANA", "Verdana"},
                                                                                {"TAHOMA", "Tahoma"},
                                                                                {"SEGOEUI", "Segoe UI"},
                                                                                {"GEORGIA", "Georgia"},
                                                                                {"TREBUC", "Trebuchet MS"},
                                                                                {"COMIC", "Comic Sans MS"},
                                                                                {"CONSOLA", "Consolas"},
                                                                                {"IMPACT", "Impact"}}};

/// The family of a font file of Windows.
std::optional<FaceRequest> face_of_file(std::string_view stem) {
  for (const auto& [start, family] : kFiles) {
    if (!stem.starts_with(start)) continue;
    const std::string_view rest = stem.substr(start.size());
    const bool both = rest == "BI" || rest == "Z";
    const bool bold = both || rest == "B" || rest == "BD", italic = both || rest == "I";
    if (rest.empty() || bold || italic) return FaceRequest{{std::string(family)}, bold, italic};
  }
  return std::nullopt;
}

/// AutoCAD's data of fonts other than SHX: the family, and whether it is bold or italic.
std::optional<FaceRequest> told_face(const DxfDocument& document, const DxfEntity& style) {
  constexpr int kItalic = 1 << 24, kBold = 1 << 25;
  bool ours = false;
  FaceRequest face;
  for (const DxfGroup& group : style.groups) {
    if (group.code == 1001) ours = capitals(group.value) == "ACAD";
    if (ours && group.code == 1000 && face.families.empty() && !group.value.empty())
      face.families.push_back(utf8_of(characters_of(group.value)));
    if (ours && group.code == 1071) {
      const auto flags = static_cast<int>(document.number(group));
      face.bold = flags & kBold, face.italic = flags & kItalic;
    }
  }
  return face.families.empty() ? std::nullopt : std::optional(face);
}

}  // namespace

FaceRequest face_of_font(std::string name) {
  name = utf8_of(characters_of(stripped(name)));
  if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos)
    name.erase(0, slash + 1);
  const std::string large = capitals(name);
  if (!large.ends_with(".TTF") && !large.ends_with(".OTF") && !large.ends_with(".TTC"))
    return name.empty() ? FaceRequest{} : FaceRequest{{name}};
  if (auto face = face_of_file(std::string_view(large).substr(0, large.size() - 4))) return *face;
  // "LiberationSans-BoldItalic": fontconfig compares families without blanks.
  const std::size_t dash = std::min(name.find('-'), name.size() - 4);
  const std::string_view rest = std::string_view(large).substr(dash);
  return {{name.substr(0, dash)},
          rest.find("BOLD") != std::string_view::npos,
          rest.find("ITALIC") != std::string_view::npos || rest.find("OBLIQUE") != std::string_view::npos};
}

DxfTextStyle style_of(const DxfDocument& document, const DxfEntity& entity) {
  const auto found = document.styles.find(capitals(entity.text(7, "STANDARD")));
  if (found == document.styles.end()) return {};
  const DxfEntity& style = found->second;
  DxfTextStyle out;
  out.face = told_face(document, style).value_or(face_of_font(std::string(style.text(3))));
  if (const double factor = document.number(style, 41, 1); factor > 0) out.width_factor = factor;
  out.oblique = Radians::of_degrees(document.number(style, 50, 0)).radians();
  return out;
}

}  // namespace clearcut::read
