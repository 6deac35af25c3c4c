#include "commands/result_files.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/text.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

namespace clearcut::cli {
namespace {

bool is_pdf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending == ".pdf";
}

}  // namespace

void check_setup_sheet_name(const std::string& path) {
  if (is_pdf(path)) require_pdf(path);
}

std::string setup_sheet_file(const std::string& path, const SetupSheet& sheet) {
  return is_pdf(path) ? setup_sheets_pdf({sheet}, path) : setup_sheet_html(sheet);
}

std::string setup_sheets_file(const std::string& path, const std::vector<SetupSheet>& sheets) {
  if (is_pdf(path)) return setup_sheets_pdf(sheets, path);
  std::vector<std::string> pages;
  for (const SetupSheet& sheet : sheets) pages.push_back(setup_sheet_html(sheet));
  return joined_setup_sheets(pages);
}

namespace {

/// Possible claims, the strongest first.
struct Attempt {
  double uncut;   // mm; the second is for programs whose control rounds corners by more than the first leaves
  bool straight;  // rapids are assumed straight, also on controls that may move their axes one by one
  bool as_stated;  // about the original outline file; else about its repaired outlines
};
constexpr Attempt kAttempts[] = {{0.01, false, true}, {0.01, true, true},   {0.012, false, true},
                                 {0.012, true, true}, {0.01, false, false}, {0.01, true, false},
                                 {0.012, true, false}};

/// The counting shape of a tool: cylinders, and drills as the cylinder above their point.
std::optional<WitnessTool> proven_tool(const Tool& tool) {
  const bool mill = tool.kind == ToolKind::kEndMill || tool.kind == ToolKind::kFaceMill ||
                    tool.kind == ToolKind::kCounterbore;
  if ((!mill && tool.kind != ToolKind::kDrill) || tool.corner_radius != 0) return std::nullopt;
  return WitnessTool{tool.number, tool.diameter, mill ? 0.0 : point_length(tool)};
}

/// The part in the form of an outline: kerfs as areas, without features that no cylinder makes.
Part part_as_outline(const Part& part, std::vector<std::string>& missing) {
  Part out = part;
  out.features.clear();
  for (Feature feature : part.features) {
    if (feature.carving || feature.chamfer || feature.t_slot || feature.target.empty()) {
      missing.push_back(feature.name + ": no cylinder makes it");
      continue;
    }
    feature.profile.reset();
    out.features.push_back(std::move(feature));
  }
  return out;
}

bool has_thread_or_cone(const HoleForm& hole) {
  return hole.thread || hole.kind == HoleKind::kCountersunk || hole.kind == HoleKind::kSpotted;
}

/// Stock left by the steps of a feature, and their cutter.
WitnessFeature claim_of(const Part& part, const Feature& feature) {
  WitnessFeature claim{.name = feature.name, .floor = feature.floor_z};
  bool first = true;
  for (const Workingstep& step : part.workplan) {
    if (feature_of(part, step).name != feature.name) continue;
    const auto tool = proven_tool(tool_of(part, step));
    if (!tool) continue;
    const Operation& operation = step.operation;
    claim.diameter = first ? tool->diameter : std::min(claim.diameter, tool->diameter);
    claim.wall_stock =
        first ? operation.allowance_side : std::min(claim.wall_stock, operation.allowance_side);
    claim.floor_stock =
        first ? operation.allowance_floor : std::min(claim.floor_stock, operation.allowance_floor);
    first = false;
  }
  if (first) claim.why_not = "no flat cutter works on it";
  if (feature.floor_fillet > 0) claim.why_not = "its floor meets its walls in a fillet";
  if (feature.hole && has_thread_or_cone(*feature.hole))
    claim.why_not = "no cylinder makes its thread or its cone";
  return claim;
}

WitnessQuestion question_of(const Part& part, const Part& outline, const Toolpath& toolpath) {
  WitnessQuestion question;
  std::set<int> used;
  for (const Section& section : toolpath.sections) {
    if (section.moves.empty()) continue;
    if (used.empty()) question.first_tool = section.tool_number;
    used.insert(section.tool_number);
  }
  for (const Tool& tool : part.tools) {
    const auto proven = proven_tool(tool);
    if (proven) question.tools.push_back(*proven);
  }
  if (question.tools.size() == 1 && used.size() == 1) question.first_tool = question.tools[0].number;
  for (const Feature& feature : outline.features) {
    const WitnessFeature claim = claim_of(part, feature);
    question.features.insert(question.features.end(), feature.target.size(), claim);
  }
  return question;
}

std::string command_of(const WitnessFile& witness, const Proven& what, const std::string& path) {
  return fmt::format("clearcut-check {} {} {}{}{}", what.program_name,
                     witness.outline.empty() ? what.part_name : outline_name(path), path,
                     witness.options.empty() ? "" : " ", fmt::join(witness.options, " "));
}

bool is_outline(const std::string& part_name) {
  return std::filesystem::path(part_name).extension() == ".json";
}

}  // namespace

std::string outline_name(const std::string& witness) {
  return witness + ".json";
}

CertificateProof proof_of(const WitnessFile& witness) {
  CertificateProof proof{witness.found.proved, witness.found.missing, witness.options, ""};
  if (witness.found.bytes.empty()) {
    proof.not_proved.push_back(witness.found.why_not);
  } else {
    proof.witness_sha256 = sha256_hex(witness.found.bytes);
  }
  return proof;
}

std::vector<OutputFile> witness_files(const WitnessFile& witness, const std::string& path) {
  std::vector<OutputFile> files;
  if (witness.found.bytes.empty() || path.empty()) return files;
  files.push_back({path, witness.found.bytes});
  if (!witness.outline.empty()) files.push_back({outline_name(path), witness.outline});
  return files;
}

namespace {

std::vector<std::string> options_of(const Attempt& attempt) {
  std::vector<std::string> options;
  if (attempt.uncut != kAttempts[0].uncut) options = {"--uncut", fmt::format("{}", attempt.uncut)};
  if (attempt.straight) options.push_back("--straight");
  return options;
}

/// A witness about the original outline file, or about the part as an outline; nothing if the file is no outline.
std::optional<WitnessFile> attempted(const Proven& what, const Attempt& attempt) {
  const bool outline_given = is_outline(what.part_name);
  if (attempt.as_stated && !outline_given) return std::nullopt;
  WitnessFile out;
  out.options = options_of(attempt);
  std::vector<std::string> missing;
  const Part outline = attempt.as_stated ? what.part : part_as_outline(what.part, missing);
  if (!attempt.as_stated) out.outline = write_outline_json(outline);
  WitnessQuestion question = question_of(what.part, outline, what.toolpath);
  question.uncut = attempt.uncut;
  question.straight = attempt.straight;
  out.found =
      find_witness(what.program, what.program_name,
                   attempt.as_stated ? read_file(what.part_name) : out.outline, what.part_name, question);
  if (question.tools.empty()) out.found.why_not = "witnesses are for flat cutters and drills";
  out.found.missing.insert(out.found.missing.end(), missing.begin(), missing.end());
  if (!out.found.missing.empty()) out.options.push_back("--partial");
  return out;
}

}  // namespace

WitnessFile witness_of(const Proven& what) {
  std::optional<WitnessFile> best;
  for (const Attempt& attempt : kAttempts) {
    std::optional<WitnessFile> one = attempted(what, attempt);
    if (!one) continue;
    const bool found = !one->found.bytes.empty();
    const bool better =
        !best ||
        (found && (best->found.bytes.empty() || one->found.missing.size() < best->found.missing.size()));
    if (better) best = std::move(one);
    if (found && best->found.missing.empty()) break;
  }
  return *best;
}

std::string witness_lines(const WitnessFile& witness, const std::string& path, const Proven& what) {
  if (witness.found.bytes.empty()) return "NO WITNESS: " + witness.found.why_not;
  std::string lines = fmt::format("witness: {} tiles, {} bytes; to check it: {}", witness.found.tiles,
                                  witness.found.bytes.size(), command_of(witness, what, path));
  const std::size_t engagement = witness.found.claims.find("C4 engagement");
  if (engagement != std::string::npos)
    lines += "\nproved: " + witness.found.claims.substr(
                                engagement, witness.found.claims.find('\n', engagement) - engagement);
  for (const std::string& one : witness.found.missing) lines += "\nNOT PROVED: " + one;
  return lines;
}

std::string checked_by_program(const WitnessFile& witness, const Proven& what, bool& proved) {
  proved = false;
  if (witness.found.bytes.empty()) return "NOT PROVED: " + witness.found.why_not;
  if (checker_program().empty()) return "NOT PROVED: the program clearcut-check is not beside this one";
  const auto started = std::chrono::steady_clock::now();
  const std::string file = (std::filesystem::temp_directory_path() /
                            fmt::format("clearcut-{}.ccw", started.time_since_epoch().count()))
                               .string();
  const std::string outline = witness.outline.empty() ? what.part_name : outline_name(file);
  write_files(witness_files(witness, file));
  const auto before = std::chrono::steady_clock::now();
  const auto answer = claims_by_checker(what.program_name, outline, file, witness.options);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  for (const OutputFile& one : witness_files(witness, file)) std::filesystem::remove(one.path);
  if (!answer) return "NOT PROVED: clearcut-check does not accept the witness";
  proved = witness.found.missing.empty();
  std::string lines = fmt::format("proved by witness (checked in {:.2f} s), {}", seconds,
                                  answer->substr(answer->find('\n') + 1));
  for (const std::string& one : witness.found.missing) lines += "NOT PROVED: " + one + "\n";
  return lines;
}

namespace {

/// "1-3, 7": numbers of the places of a kind.
std::string numbers_of(std::size_t kind, const std::vector<PlaceMade>& places) {
  std::string told;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k].kind != kind) continue;
    std::size_t last = k;
    while (last + 1 < places.size() && places[last + 1].kind == kind) ++last;
    told += fmt::format("{}{}", told.empty() ? "" : ", ", k + 1);
    if (last > k) told += fmt::format("-{}", last + 1);
    k = last;
  }
  return told;
}

std::string kinds_lines(const CopiesMade& made) {
  std::string told;
  for (std::size_t kind = 0; kind < made.kinds.size(); ++kind) {
    const KindMade& one = made.kinds[kind];
    told += fmt::format("\n{}: {} parts, {} clean, numbered {}", one.name, one.parts, one.clean_parts,
                        numbers_of(kind, made.places));
    if (one.missing() > 0) told += fmt::format("; {} of {} do not fit", one.missing(), *one.wanted);
  }
  return told;
}

}  // namespace

std::string parts_line(const CopiesMade& made) {
  std::string told =
      fmt::format("{} parts on {} by {} mm, {} clean", made.parts, trimmed(made.sheet.width(), 3),
                  trimmed(made.sheet.height(), 3), made.clean_parts);
  if (made.turned > 0) told += fmt::format("; {} are turned by 90 degrees", made.turned);
  if (made.misses()) told += fmt::format("; {} of {} do not fit", *made.wanted - made.parts, *made.wanted);
  if (made.at_most && *made.at_most > made.parts && (made.misses() || !made.wanted))
    told += fmt::format("; no layout has more than {}", *made.at_most);
  return told + kinds_lines(made);
}

}  // namespace clearcut::cli
