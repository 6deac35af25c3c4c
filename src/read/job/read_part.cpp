#include "read/job/read_part.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "read/board/excellon_reader.h"
#include "read/board/gerber_reader.h"
#include "read/common/foreign_files.h"
#include "read/common/text.h"
#include "read/drawing/overlaps.h"
#include "read/dxf/dxf_reader.h"
#include "read/job/job_file.h"
#include "read/outline/outline_reader.h"
#include "read/step_solid/step_solid.h"
#include "read/stepnc/stepnc.h"
#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

FileKind kind_of_extension(const std::string& extension) {
  for (const char* step : {".P21", ".STP", ".STEP", ".STPNC", ".238"}) {
    if (extension == step) return FileKind::kStep;
  }
  if (extension == ".DXF") return FileKind::kDxf;
  if (extension == ".SVG") return FileKind::kSvg;
  if (extension == ".JSON") return FileKind::kJson;
  if (extension == ".EDGES") return FileKind::kEdges;
  if (extension == ".TOML") return FileKind::kJob;
  for (const char* gerber : {".GBR", ".GER", ".PHO", ".GTL", ".GBL", ".GTS", ".GBS", ".GTO", ".GBO", ".GTP",
                             ".GBP", ".GKO", ".GML", ".GM1", ".GM2", ".GM3", ".CMP", ".SOL"}) {
    if (extension == gerber) return FileKind::kGerber;
  }
  if (extension == ".DRL" || extension == ".XLN" || extension == ".EXC" || extension == ".XNC")
    return FileKind::kExcellon;
  return FileKind::kUnknown;
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
  // No text contains these, in any code page.
  if (head.find_first_of(std::string_view("\0\1\2\3\4\5\6", 7)) != std::string_view::npos) {
    throw InputError(file_name,
                     "this is a binary file; give a STEP-NC, DXF, SVG or JSON file, of a board Gerber and "
                     "Excellon as text");
  }
}

/// STEP-NC is complete: options for drawings do not apply.
Part read_program(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  Part part = read::stepnc::read_stepnc(text, file_name, options.tol);
  if (options.unit || options.depth || options.top || !options.layers.empty()) {
    part.diagnostics.warn(file_name,
                          "unit, depth, top and layers given as options are for drawings; not used here");
  }
  return part;
}

bool is_program(std::string_view text, const std::string& file_name) {
  FileKind kind = kind_of_extension(capitals(std::filesystem::path(file_name).extension().string()));
  if (kind == FileKind::kUnknown) kind = kind_of_content(text);
  return kind == FileKind::kStep && !is_step_solid(text);
}

/// Whether a program can have several set-ups: most have one, and should not be read twice for this question.
bool names_setups(const std::string& text) {
  const std::string capital = capitals(text);
  int found = 0;
  for (std::size_t at = capital.find("SETUP"); at != std::string::npos && found < 2;
       at = capital.find("SETUP", at + 1)) {
    const std::size_t before = capital.find_last_not_of(" \t\r\n", at - 1);
    const std::size_t after = capital.find_first_not_of(" \t\r\n", at + 5);
    const bool begins = at > 0 && before != std::string::npos && capital[before] == '=';
    if (begins && after != std::string::npos && capital[after] == '(') ++found;
  }
  return found > 1;
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

/// The same part in another format has the same numbers: the last digits added by formats are removed.
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

void refuse_to_mirror(FileKind kind, const std::string& file_name, const ReadOptions& options) {
  const bool is_drawing = kind == FileKind::kDxf || kind == FileKind::kSvg || kind == FileKind::kGerber ||
                          kind == FileKind::kExcellon || kind == FileKind::kJob;
  if (options.mirror && !is_drawing)
    throw InputError(
        file_name, "only drawings are mirrored (DXF, SVG, Gerber, Excellon); turn a solid over with --up -Z");
}

Part read_text(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  refuse_foreign_content(text, file_name);
  FileKind kind = kind_of_extension(capitals(std::filesystem::path(file_name).extension().string()));
  if (kind == FileKind::kUnknown) {
    refuse_foreign_name(file_name);
    kind = kind_of_content(text);
  }
  refuse_what_is_no_text(text, file_name);
  refuse_to_mirror(kind, file_name, options);
  switch (kind) {
    case FileKind::kStep:
      if (is_step_solid(text)) return read_step_solid(text, file_name, options);
      return read_program(text, file_name, options);
    case FileKind::kDxf:
      return read_dxf(text, file_name, options);
    case FileKind::kSvg:
      return read_svg(text, file_name, options);
    case FileKind::kJson:
      return read_outline_json(text, file_name, options);
    case FileKind::kGerber:
      return read_gerber(text, file_name, options);
    case FileKind::kExcellon:
      return read_excellon(text, file_name, options);
    case FileKind::kEdges:
      return read_edges(text, file_name, options);
    case FileKind::kJob:
    case FileKind::kUnknown:
      break;
  }
  throw InputError(
      file_name,
      "unknown kind of file; give STEP-NC (.stpnc, .p21), a solid (.step), DXF, SVG, Gerber (.gbr), a drill "
      "file (.drl), outline JSON, lengths and angles (.edges) or a job (.toml)");
}

StockRequest requested(const Stock& block) {
  return {{{block.plan.min.x, block.plan.max.x}},
          {{block.plan.min.y, block.plan.max.y}},
          0,
          {block.z_bottom, block.z_top}};
}

std::string extent_text(const Stock& block) {
  const auto span = [](double low, double high) { return trimmed(low, 3) + " to " + trimmed(high, 3); };
  return "x " + span(block.plan.min.x, block.plan.max.x) + ", y " + span(block.plan.min.y, block.plan.max.y) +
         ", z " + span(block.z_bottom, block.z_top) + " mm";
}

/// Gives the part of a drawing its stock block. A block stated in the file must be equal.
void lay_on_block(Part& part, const Stock& block, const ReadOptions& options, const std::string& file_name) {
  constexpr double kSame = 1e-3;
  const auto apart = [](double a, double b) { return std::abs(a - b) > kSame; };
  if (!part.stock) {
    part.stock = block;
    return open_at_stock_edge(part, options.tol);
  }
  const Stock& own = *part.stock;
  if (apart(own.plan.min.x, block.plan.min.x) || apart(own.plan.max.x, block.plan.max.x) ||
      apart(own.plan.min.y, block.plan.min.y) || apart(own.plan.max.y, block.plan.max.y) ||
      apart(own.z_bottom, block.z_bottom) || apart(own.z_top, block.z_top))
    throw InputError(file_name, "states a block of " + extent_text(own) +
                                    ", and the stock that is given as a solid takes " + extent_text(block) +
                                    "; correct one of them");
}

/// mm; default depth of profiles of drawings below the stock: the edge comes free without a burr.
constexpr double kProfileBreakthrough = 0.3;

/// Lets profiles ending at the underside of a stated stock go slightly below it.
void go_below_stock(Part& part, const ReadOptions& options) {
  if (options.solid.breakthrough || !part.stock || part.is_solid) return;
  for (Feature& feature : part.features) {
    if (!feature.profile || !feature.through || feature.profile->beyond > 0) continue;
    if (std::abs(feature.floor_z - part.stock->z_bottom) > kSamePlaceMm) continue;
    feature.profile->beyond = kProfileBreakthrough;
    feature.floor_z -= kProfileBreakthrough;
  }
}

}  // namespace

void refuse_what_is_no_part(std::string_view text, const std::string& file_name) {
  refuse_foreign_content(text, file_name);
  refuse_what_is_no_text(text, file_name);
}

bool is_job_file(const std::string& file_name) {
  return kind_of_extension(capitals(std::filesystem::path(file_name).extension().string())) == FileKind::kJob;
}

Part as_asked(Part part, const ReadOptions& options, const std::string& file_name) {
  part = snapped(std::move(part));
  if (options.block && !part.is_solid) lay_on_block(part, *options.block, options, file_name);
  go_below_stock(part, options);
  return part;
}

ReadOptions completed(ReadOptions options) {
  if (options.join_gap) options.tol.join_gap = *options.join_gap;
  if (options.block) options.solid.stock = requested(*options.block);
  return options;
}

Part read_part_file(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  const ReadOptions own = completed(options);
  return as_asked(read_text(text, file_name, own), own, file_name);
}

int setups_of_program(const std::filesystem::path& file) {
  try {
    const std::string text = read_file(file.string(), kLargestPart);
    if (!is_program(text, file.string()) || !names_setups(text)) return 0;
    const int count = stepnc::count_setups(text, file.string());
    return count > 1 ? count : 0;
  } catch (const InputError&) {
    return 0;  // the reader reports the fault
  }
}

Part read_part_of_setup(const std::filesystem::path& file, int number, const ReadOptions& options,
                        SetupPlace& place) {
  const std::string text = read_file(file.string(), kLargestPart);
  const int count = is_program(text, file.string()) ? stepnc::count_setups(text, file.string()) : 0;
  if (number < 1 || number > count)
    throw InputError("--setup", std::to_string(number) + ": " + file.string() + " has " +
                                    (count == 0 ? "no set-ups" : std::to_string(count)));
  return snapped(stepnc::read_setup(text, file.string(), options.tol, number, place));
}

Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  if (!is_job_file(file_name)) return read_part_file(text, file_name, options);
  refuse_what_is_no_part(text, file_name);
  const ReadOptions own = completed(options);
  return as_asked(part_of_job(read_job_text(text, file_name), own), own, file_name);
}

Part read_part(const std::filesystem::path& file, const ReadOptions& options) {
  return read_part_text(read_file(file.string(), kLargestPart), file.string(), options);
}

}  // namespace clearcut::read
