#include "read/board/gerber_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "base/error.h"
#include "geometry/contours/loops.h"
#include "read/board/gerber_image.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/layer_rules.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {
namespace {

/// Meaning of a word of the attribute or of the file's name.
struct LayerWord {
  std::string_view word;
  LayerRole role;
};

/// First fields of the attribute FileFunction (section 5.6.3 of the specification).
constexpr std::array kFunctions{
    LayerWord{"COPPER", LayerRole::kIsolate}, LayerWord{"PROFILE", LayerRole::kProfile},
    LayerWord{"PLATED", LayerRole::kHole}, LayerWord{"NONPLATED", LayerRole::kHole}};

/// Parts of names as CAD programs give them: KiCad, EAGLE, Altium and their kin.
constexpr std::array kNames{
    LayerWord{"EDGE_CUTS", LayerRole::kProfile}, LayerWord{"EDGE.CUTS", LayerRole::kProfile},
    LayerWord{"OUTLINE", LayerRole::kProfile},   LayerWord{"PROFILE", LayerRole::kProfile},
    LayerWord{"DIMENSION", LayerRole::kProfile}, LayerWord{".GKO", LayerRole::kProfile},
    LayerWord{".GM1", LayerRole::kProfile},      LayerWord{".GML", LayerRole::kProfile},
    LayerWord{"F_CU", LayerRole::kIsolate},      LayerWord{"B_CU", LayerRole::kIsolate},
    LayerWord{"F.CU", LayerRole::kIsolate},      LayerWord{"B.CU", LayerRole::kIsolate},
    LayerWord{"COPPER", LayerRole::kIsolate},    LayerWord{".GTL", LayerRole::kIsolate},
    LayerWord{".GBL", LayerRole::kIsolate},      LayerWord{".CMP", LayerRole::kIsolate},
    LayerWord{".SOL", LayerRole::kIsolate},      LayerWord{"MASK", LayerRole::kPocket},
    LayerWord{"PASTE", LayerRole::kPocket},      LayerWord{"SILK", LayerRole::kPocket},
    LayerWord{".GTS", LayerRole::kPocket},       LayerWord{".GBS", LayerRole::kPocket},
    LayerWord{".GTP", LayerRole::kPocket},       LayerWord{".GBP", LayerRole::kPocket},
    LayerWord{".GTO", LayerRole::kPocket},       LayerWord{".GBO", LayerRole::kPocket}};

std::optional<LayerRole> role_of_function(const std::string& function) {
  const std::string field = capitals(function.substr(0, function.find(',')));
  for (const LayerWord& word : kFunctions)
    if (field == word.word) return word.role;
  return field.empty() ? std::nullopt : std::optional(LayerRole::kPocket);
}

std::optional<LayerRole> role_of_name(const std::string& file_name) {
  const std::string name = capitals(std::filesystem::path(file_name).filename().string());
  for (const LayerWord& word : kNames)
    if (name.find(word.word) != std::string::npos) return word.role;
  return std::nullopt;
}

bool is_bottom(const std::string& function, const std::string& file_name) {
  const std::string words = "," + capitals(function) + ",";
  if (words.size() > 2) return words.find(",BOT,") != std::string::npos;
  const std::string name = capitals(std::filesystem::path(file_name).filename().string());
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return has("B_CU") || has("B.CU") || has(".GBL") || has("BOTTOM");
}

DrawnGroup group_of(const std::string& function, const std::string& file_name, const ReadOptions& options) {
  DrawnGroup group;
  group.name = std::filesystem::path(file_name).stem().string();
  group.where = file_name;
  std::optional<LayerRole> role = role_of_function(function);
  if (!role) role = role_of_name(file_name);
  group.role = role.value_or(LayerRole::kPocket);
  group.says_role = role.has_value();
  apply_rules(options.layer_rules, group.name, group);
  return group;
}

/// Paths of a cutter along drawn items: strokes without their width, and the outlines of areas.
std::vector<RawCurve> lines_of(std::vector<Drawn> drawn) {
  std::vector<RawCurve> curves;
  for (Drawn& one : drawn) {
    if (!one.line.empty()) {
      curves.push_back({std::move(one.line), false, "a line", {}});
    } else {
      for (Path& piece : one.pieces) curves.push_back({std::move(piece), true, "an area", {}});
    }
  }
  return curves;
}

std::vector<RawCurve> areas_of(const std::vector<Drawn>& drawn, const RepairOptions& repair) {
  std::vector<RawCurve> curves;
  for (Path& loop : loops_of(dark_area(drawn, repair)))
    curves.push_back({std::move(loop), true, "what is drawn", Compound{}});
  return curves;
}

void scale(std::vector<Drawn>& drawn, double by) {
  if (by == 1) return;
  for (Drawn& one : drawn) one = mapped(one, Affine::scaling(by, by));
}

}  // namespace

Part read_gerber(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  Part part;
  part.name = std::filesystem::path(file_name).stem().string();
  part.source_file = file_name;
  RepairOptions repair;
  repair.tol = options.tol;
  repair.where = file_name;
  GerberImage image = gerber_image(text, file_name, repair);
  scale(image.drawn, options.scale);
  DrawnGroup group = group_of(image.function, file_name, options);
  if (!group.says_role && options.ask_if_unclear && !options.overview) {
    throw InputError(file_name,
                     "nothing says what this layer is for (no attribute FileFunction, no usual name): say "
                     "--op isolate:'*' for copper, "
                     "profile:'*' for the board's outline, pocket:'*' to mill what is drawn");
  }
  const bool follows = group.role == LayerRole::kProfile || group.role == LayerRole::kInside ||
                       group.role == LayerRole::kEngrave;
  group.curves = follows ? lines_of(std::move(image.drawn)) : areas_of(image.drawn, repair);
  if (!image.function.empty())
    part.diagnostics.note(file_name,
                          "the layer is " + printable(image.function) + ", read as " + name_of(group.role));
  if (is_bottom(image.function, file_name) && !options.mirror) {
    part.diagnostics.warn(file_name,
                          "this is the bottom of the board, drawn as seen from the top; --mirror gives it as "
                          "seen from below, as it lies when the board is turned over");
  }
  std::vector<DrawnGroup> groups{std::move(group)};
  question_size(groups, file_name, options);
  add_drawn_features(part, std::move(groups), options);
  return part;
}

}  // namespace clearcut::read
