#include "read/common/foreign_files.h"

#include <array>
#include <cstddef>
#include <filesystem>

#include "base/error.h"
#include "read/common/text.h"

namespace clearcut::read {

FileKind kind_of_content(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  const std::size_t first = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos) return FileKind::kUnknown;
  if (head.substr(first, 12) == "ISO-10303-21") return FileKind::kStep;
  if (head[first] == '{') return FileKind::kJson;
  if (head.substr(first, 3) == "M48") return FileKind::kExcellon;
  if (head.find("%FSLA") != std::string_view::npos || head.find("%FSTA") != std::string_view::npos)
    return FileKind::kGerber;
  if (head.find("<svg") != std::string_view::npos) return FileKind::kSvg;
  // After comments; in an SVG it may be the beginning of a path's line.
  if (head.find("\nM48") != std::string_view::npos || head.find("\rM48") != std::string_view::npos)
    return FileKind::kExcellon;
  if (head.find("SECTION") != std::string_view::npos) return FileKind::kDxf;
  return FileKind::kUnknown;
}

namespace {

/// An unsupported kind of file: its description, and an alternative.
struct Foreign {
  std::string_view what;
  std::string_view instead;
};

constexpr Foreign kMesh{"a mesh of triangles", "export the solid as STEP, or its outline as DXF or SVG"};
constexpr Foreign kZip{"a zip archive", "unpack it and give the STEP, DXF or SVG file in it"};
constexpr Foreign kPage{"a page for printing",
                        "open it in Inkscape and save the outlines as SVG, or export DXF"};
constexpr Foreign kPicture{"a picture of dots",
                           "trace it in Inkscape (Path > Trace Bitmap) and save it as SVG"};
constexpr Foreign kBoard{"a design of a circuit board", "export its edge and holes as DXF or SVG"};
constexpr Foreign kDwg{"a DWG drawing", "save it as DXF"};
constexpr Foreign kIges{"an IGES file", "export the solid as STEP, or the drawing as DXF"};
constexpr Foreign kCad{"a document of a CAD program", "export the solid as STEP, or the sketch as DXF"};
constexpr Foreign kDesign{"a document of a drawing program", "save it as SVG or DXF"};
constexpr Foreign kScad{"an OpenSCAD program", "export it from OpenSCAD: 2D as DXF or SVG"};
constexpr Foreign kProgram{"a program for a machine",
                           "check it by `clearcut verify`, or give the drawing of the part"};

struct Named {
  std::string_view extension;  ///< in capitals
  const Foreign* kind;
};
constexpr std::array kNamed{
    Named{".3MF", &kMesh},        Named{".STL", &kMesh},     Named{".OBJ", &kMesh},
    Named{".AMF", &kMesh},        Named{".PLY", &kMesh},     Named{".ZIP", &kZip},
    Named{".PDF", &kPage},        Named{".EPS", &kPage},     Named{".PS", &kPage},
    Named{".AI", &kPage},         Named{".PNG", &kPicture},  Named{".JPG", &kPicture},
    Named{".JPEG", &kPicture},    Named{".BMP", &kPicture},  Named{".GIF", &kPicture},
    Named{".TIF", &kPicture},     Named{".TIFF", &kPicture}, Named{".BRD", &kBoard},
    Named{".KICAD_PCB", &kBoard}, Named{".DWG", &kDwg},      Named{".IGS", &kIges},
    Named{".IGES", &kIges},       Named{".FCSTD", &kCad},    Named{".F3D", &kCad},
    Named{".F3Z", &kCad},         Named{".SLDPRT", &kCad},   Named{".SLDASM", &kCad},
    Named{".IPT", &kCad},         Named{".PRT", &kCad},      Named{".X_T", &kCad},
    Named{".X_B", &kCad},         Named{".SAT", &kCad},      Named{".3DM", &kCad},
    Named{".SKP", &kCad},         Named{".CDR", &kDesign},   Named{".AFDESIGN", &kDesign},
    Named{".SCAD", &kScad},       Named{".NGC", &kProgram},  Named{".NC", &kProgram},
    Named{".GCODE", &kProgram},   Named{".TAP", &kProgram},  Named{".H", &kProgram}};

struct Signature {
  std::string_view start;
  const Foreign* kind;
};
constexpr std::array kSignatures{Signature{"PK\x03\x04", &kZip},
                                 Signature{"%PDF-", &kPage},
                                 Signature{"%!PS", &kPage},
                                 Signature{"\x89PNG", &kPicture},
                                 Signature{"\xFF\xD8\xFF", &kPicture},
                                 Signature{"GIF8", &kPicture},
                                 Signature{"II*", &kPicture},
                                 Signature{"AC10", &kDwg},
                                 Signature{"(kicad_pcb", &kBoard},
                                 Signature{"solid ", &kMesh}};

[[noreturn]] void refuse(const Foreign& kind, const std::string& file_name) {
  throw InputError(file_name,
                   "this is " + std::string(kind.what) + ", which is not read; " + std::string(kind.instead));
}

const Foreign* kind_of_name(const std::string& file_name) {
  const std::string extension = capitals(std::filesystem::path(file_name).extension().string());
  for (const Named& named : kNamed)
    if (named.extension == extension) return named.kind;
  return nullptr;
}

const Foreign* signed_as(std::string_view text) {
  const std::size_t first = text.substr(0, 4096).find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos) return nullptr;
  const std::string_view start = text.substr(first, 4096);
  for (const Signature& signature : kSignatures)
    if (start.substr(0, signature.start.size()) == signature.start) return signature.kind;
  return nullptr;
}

/// Many documents are zip archives: their names say more.
const Foreign* kind_of_content(std::string_view text, const std::string& file_name) {
  const Foreign* kind = signed_as(text);
  const Foreign* named = kind == &kZip ? kind_of_name(file_name) : nullptr;
  return named != nullptr ? named : kind;
}

}  // namespace

std::string_view foreign_content(std::string_view text, const std::string& file_name) {
  const Foreign* kind = kind_of_content(text, file_name);
  return kind != nullptr ? kind->what : "";
}

void refuse_foreign_content(std::string_view text, const std::string& file_name) {
  if (const Foreign* kind = kind_of_content(text, file_name)) refuse(*kind, file_name);
}

void refuse_foreign_name(const std::string& file_name) {
  if (const Foreign* kind = kind_of_name(file_name)) refuse(*kind, file_name);
}

}  // namespace clearcut::read
