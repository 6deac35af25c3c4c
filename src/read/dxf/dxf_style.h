// Text styles of a DXF file.
#pragma once

#include <string>

#include "read/dxf/dxf_document.h"
#include "read/lettering/face.h"

namespace clearcut::read {

struct DxfTextStyle {
  FaceRequest face;
  double width_factor = 1;
  double oblique = 0;  ///< radians
};

/// The face of a font named as in files: "arialbd.ttf", "Arial", "txt.shx".
FaceRequest face_of_font(std::string name);

/// The STYLE named by `entity` in group 7, else STANDARD; the machine's default face if the file defines none.
DxfTextStyle style_of(const DxfDocument& document, const DxfEntity& entity);

}  // namespace clearcut::read
