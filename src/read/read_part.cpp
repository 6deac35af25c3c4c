#include "read/read_part.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/files/file.h"
#include "read/board/drill/excellon_reader.h"
#include "read/board/gerber_reader.h"
#include "read/common/foreign_files.h"
#include "read/common/text.h"
#include "read/dxf/dxf_reader.h"
#include "read/edges/edges_reader.h"
#include "read/job/job_file.h"
#include "read/outline/outline_reader.h"
#include "read/step_solid/step_solid.h"
#include "read/stepnc/stepnc.h"
#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

enum class Kind { kStep, kDxf, kSvg, kJson, kEdges, kJob, kGerber, kExcellon, kUnknown };

Kind kind_of_extension(const std::string& extension) {
  for (const char* step : {".P21", ".STP", ".STEP", ".STPNC", ".238"}) {
    if (extension == step) return Kind::kStep;
  }
  if (extension == ".DXF") return Kind::kDxf;
  if (extension == ".SVG") return Kind::kSvg;
  if (extension == ".JSON") return Kind::kJson;
  if (extension == ".EDGES") return Kind::kEdges;
  if (extension == ".TOML") return Kind::kJob;
  for (const char* gerber : {".GBR", ".GER", ".PHO", ".GTL", ".GBL", ".GTS", ".GBS", ".GTO", ".GBO", ".GTP",
                             ".GBP", ".GKO", ".GML", ".GM1", ".GM2", ".GM3", ".CMP", ".SOL"}) {
    if (extension == gerber) return Kind::kGerber;
  }
  if (extension == ".DRL" || extension == ".XLN" || extension == ".EXC" || extension == ".XNC")
    return Kind::kExcellon;
  return Kind::kUnknown;
}

/// What the first bytes say, for files without a telling name.
Kind kind_of_content(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  const std::size_t first = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos) return Kind::kUnknown;
  if (head.substr(first, 12) == "ISO-10303-21") return Kind::kStep;
  if (head[first] == '{') return Kind::kJson;
  if (head.substr(first, 3) == "M48" || head.find("\nM48") != std::string_view::npos) return Kind::kExcellon;
  if (head.find("%FSLA") != std::string_view::npos || head.find("%FSTA") != std::string_view::npos)
    return Kind::kGerber;
  if (head.find("<svg") != std::string_view::npos) return Kind::kSvg;
  if (head.find("SECTION") != std::string_view::npos) return Kind::kDxf;
  return Kind::kUnknown;
}

void refuse_what_is_no_text(std::string_view text, const std::string& file_name) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(file_name, "the file is empty; save the drawing again");
  }
  const std::string_view head = text.substr(0, 4096);
  if (head.substr(0, 2) == "\xFF\xFE" || head.substr(0, 2) == "\xFE\xFF") {
    throw InputError(file_name, "this is UTF-16 text; save it as UTF-8");
  }
  // These two say more in their readers.
  if (head.substr(0, 18) == "AutoCAD Binary DXF" || head.substr(0, 2) == "\x1f\x8b") return;
  // No text has these, whatever its code page.
  if (head.find_first_of(std::string_view("\0\1\2\3\4\5\6", 7)) != std::string_view::npos) {
    throw InputError(file_name,
                     "this is a binary file; give a STEP-NC, DXF, SVG or JSON file, of a board Gerber and "
                     "Excellon as text");
  }
}

/// STEP-NC says all by itself: options for drawings do not apply.
Part read_program(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  Part part = read::stepnc::read_stepnc(text, file_name, options.tol);
  if (options.unit || options.depth || options.top || !options.layers.empty()) {
    part.diagnostics.warn(file_name,
                          "unit, depth, top and layers given as options are for drawings; not used here");
  }
  return part;
}

/// mm; finer differences are arithmetic, not drawing.
constexpr double kStepsPerMm = 1e9;

double snapped(double x) {
  return std::round(x * kStepsPerMm) / kStepsPerMm;
}
Vec2 snapped(Vec2 p) {
  return {snapped(p.x), snapped(p.y)};
}

Loop snapped(Loop loop) {
  for (Edge& edge : loop) {
    edge.from = snapped(edge.from);
    edge.to = snapped(edge.to);
    if (edge.is_arc()) edge.center = snapped(edge.center);
  }
  return loop;
}

void snap(Regions& regions) {
  for (Region& region : regions) {
    std::vector<Loop> islands;
    for (const Loop& island : region.islands()) islands.push_back(snapped(island));
    region = Region::from_valid_loops(snapped(region.outer()), std::move(islands));
  }
}

/// The same part in another format has the same numbers: what formats add in the last digits is taken away.
Part snapped(Part part) {
  for (Feature& feature : part.features) {
    snap(feature.target);
    snap(feature.allowed);
    if (feature.profile) feature.profile->line = snapped(feature.profile->line);
    feature.top_z = snapped(feature.top_z);
    feature.floor_z = snapped(feature.floor_z);
    if (feature.hole_diameter) feature.hole_diameter = snapped(*feature.hole_diameter);
  }
  return part;
}

void refuse_to_mirror(Kind kind, const std::string& file_name, const ReadOptions& options) {
  const bool is_drawing = kind == Kind::kDxf || kind == Kind::kSvg || kind == Kind::kGerber ||
                          kind == Kind::kExcellon || kind == Kind::kJob;
  if (options.mirror && !is_drawing)
    throw InputError(
        file_name, "only drawings are mirrored (DXF, SVG, Gerber, Excellon); turn a solid over with --up -Z");
}

Part read_text(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  refuse_foreign_content(text, file_name);
  Kind kind = kind_of_extension(capitals(std::filesystem::path(file_name).extension().string()));
  if (kind == Kind::kUnknown) {
    refuse_foreign_name(file_name);
    kind = kind_of_content(text);
  }
  refuse_what_is_no_text(text, file_name);
  refuse_to_mirror(kind, file_name, options);
  switch (kind) {
    case Kind::kStep:
      if (is_step_solid(text)) return read_step_solid(text, file_name, options);
      return read_program(text, file_name, options);
    case Kind::kDxf:
      return read_dxf(text, file_name, options);
    case Kind::kSvg:
      return read_svg(text, file_name, options);
    case Kind::kJson:
      return read_outline_json(text, file_name, options);
    case Kind::kGerber:
      return read_gerber(text, file_name, options);
    case Kind::kExcellon:
      return read_excellon(text, file_name, options);
    case Kind::kEdges:
      return read_edges(text, file_name, options);
    case Kind::kJob:
      return part_of_job(read_job_text(text, file_name), options);
    case Kind::kUnknown:
      break;
  }
  throw InputError(
      file_name,
      "unknown kind of file; give STEP-NC (.stpnc, .p21), a solid (.step), DXF, SVG, Gerber (.gbr), a drill "
      "file (.drl), outline JSON, lengths and angles (.edges) or a job (.toml)");
}

}  // namespace

Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  ReadOptions own = options;
  if (own.join_gap) own.tol.join_gap = *own.join_gap;
  return snapped(read_text(text, file_name, own));
}

Part read_part(const std::filesystem::path& file, const ReadOptions& options) {
  return read_part_text(read_file(file.string(), kLargestPart), file.string(), options);
}

}  // namespace clearcut::read
