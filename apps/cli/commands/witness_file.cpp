#include "commands/witness_file.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <set>

namespace clearcut::cli {
namespace {

/// mm. The second is for programs whose control rounds corners by more than the first leaves.
constexpr double kUncuts[] = {0.01, 0.012};

/// The one flat cutter, or why there is none.
const Tool* flat_cutter(const Proven& what, std::string& why_not) {
  std::set<int> numbers;
  for (const Section& section : what.toolpath.sections) {
    if (!section.moves.empty()) numbers.insert(section.tool_number);
  }
  const Tool* tool = nullptr;
  if (numbers.size() == 1) tool = tool_numbered(what.part.tools, *numbers.begin());
  if (!tool && what.part.tools.size() == 1) tool = &what.part.tools.front();
  if (numbers.size() > 1 || !tool) {
    why_not = "witnesses are for programs with one cutter";
    return nullptr;
  }
  const bool flat =
      (tool->kind == ToolKind::kEndMill || tool->kind == ToolKind::kFaceMill) && tool->corner_radius == 0;
  if (!flat) why_not = "witnesses are for flat cutters";
  return flat ? tool : nullptr;
}

std::string command_of(const WitnessFile& witness, const Proven& what, const std::string& path) {
  return fmt::format("clearcut-check {} {} {}{}", what.program_name, what.part_name, path,
                     witness.uncut == kUncuts[0] ? "" : fmt::format(" --uncut {}", witness.uncut));
}

}  // namespace

void require_outline(const std::string& part_name) {
  if (std::filesystem::path(part_name).extension() != ".json")
    throw InputError("--witness", "needs an outline file (.json) as the part; clearcut convert writes one");
}

WitnessFile witness_of(const Proven& what) {
  require_outline(what.part_name);
  WitnessFile out;
  const Tool* tool = flat_cutter(what, out.found.why_not);
  if (!tool) return out;
  if (what.part.features.size() != 1 || what.part.workplan.size() != 1) {
    out.found.why_not = "witnesses are for parts with one pocket that is cut in one workingstep";
    return out;
  }
  const Feature& pocket = what.part.features.front();
  const Operation& operation = what.part.workplan.front().operation;
  const std::string text = read_file(what.part_name);
  for (const double uncut : kUncuts) {
    out.uncut = uncut;
    out.found = find_witness(what.program, what.program_name, text, what.part_name,
                             {.diameter = tool->diameter,
                              .wall_stock = operation.allowance_side,
                              .floor_stock = operation.allowance_floor,
                              .uncut = uncut,
                              .top = pocket.top_z,
                              .floor = pocket.floor_z});
    if (!out.found.bytes.empty()) break;
  }
  return out;
}

std::string witness_lines(const WitnessFile& witness, const std::string& path, const Proven& what) {
  if (witness.found.bytes.empty()) return "NO WITNESS: " + witness.found.why_not;
  return fmt::format("witness: {} tiles, {} bytes; to check it: {}", witness.found.tiles,
                     witness.found.bytes.size(), command_of(witness, what, path));
}

std::string checked_by_program(const WitnessFile& witness, const Proven& what, bool& proved) {
  proved = false;
  if (witness.found.bytes.empty()) return "NOT PROVED: " + witness.found.why_not;
  if (checker_program().empty()) return "NOT PROVED: the program clearcut-check is not beside this one";
  const auto started = std::chrono::steady_clock::now();
  const std::string file = (std::filesystem::temp_directory_path() /
                            fmt::format("clearcut-{}.ccw", started.time_since_epoch().count()))
                               .string();
  write_files({{file, witness.found.bytes}});
  const auto before = std::chrono::steady_clock::now();
  const auto answer = claims_by_checker(what.program_name, what.part_name, file, witness.uncut);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  std::filesystem::remove(file);
  if (!answer) return "NOT PROVED: clearcut-check does not accept the witness";
  proved = true;
  return fmt::format("proved by witness (checked in {:.2f} s), {}", seconds,
                     answer->substr(answer->find('\n') + 1));
}

}  // namespace clearcut::cli
