#include "post/post.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/text.h"
#include "post/iso_writer.h"
#include "post/klartext_writer.h"
#include "post/words/comment.h"
#include "post/words/iso_dialect.h"
#include "post/words/print_grid.h"
#include "post/words/steps.h"

namespace clearcut::post {

namespace {

constexpr const char* kKlartext = "heidenhain";
constexpr double kLongestWait = 3600;  // s; controls take dwells of no more digits
constexpr double kJoint = 1e-4;        // mm; moves of a section meet to within the finest grid printed

void require_printable(double value, const Section& section, const std::string& what = "a coordinate",
                       const std::string& check = "the part and its units") {
  if (std::abs(value) <= PrintGrid::kLargest) return;  // false for NaN
  throw InputError("", what + " in operation '" + section.label + "' is " + trimmed(value, 3) +
                           ", which no machine reaches; check " + check);
}

void check_move(const Move& move, const Section& section) {
  for (const double value :
       {move.path.from.x, move.path.from.y, move.path.to.x, move.path.to.y, move.z_from, move.z_to}) {
    require_printable(value, section);
  }
  require_printable(move.feed.mm_per_min(), section, "a feed (mm/min)",
                    "the feeds of options, job and tools");
  if (move.path.is_arc() && !std::isfinite(move.path.center.x + move.path.center.y)) {
    require_printable(move.path.center.x + move.path.center.y, section);
  }
  if (!is_rapid(move.kind) && move.feed.mm_per_min() <= 0) {
    throw InputError("", "a feed move in operation '" + section.label + "' has no feed; give one");
  }
}

void check(const Section& section) {
  require_printable(section.spindle_rpm, section, "the spindle's speed (rpm)",
                    "that of options, job and tools");
  const Move* before = nullptr;
  for (const Move& move : section.moves) {
    check_move(move, section);
    if (before) {
      CLEARCUT_ASSERT(distance(before->path.to, move.path.from) <= kJoint);
      CLEARCUT_ASSERT(std::abs(before->z_to - move.z_from) <= kJoint);
    }
    before = &move;
  }
}

[[noreturn]] void refuse_dialect(const std::string& name) {
  std::string known;
  for (const std::string& dialect : post_dialects()) known += (known.empty() ? "" : ", ") + dialect;
  throw InputError("", "unknown post '" + name + "'; known: " + known);
}

/// Null: Klartext.
void refuse_missing_offset(const PostOptions& options, const IsoDialect* dialect) {
  const WorkOffset& wanted = options.work_offset;
  if (wanted == WorkOffset{} || (dialect && has_work_offset(*dialect, wanted))) return;
  const std::string known = dialect ? work_offsets_of(*dialect) : "";
  const std::string instead = !dialect        ? "its zero is the preset that is active; leave it out"
                              : known.empty() ? "its programs have no work offsets; leave it out"
                                              : "it has " + known;
  throw InputError("--work-offset", options.dialect + " has no " + words_of(wanted) + ": " + instead);
}

/// Throws for requests not supported by this control. Null: Klartext.
void refuse_missing_words(const PostOptions& options, const IsoDialect* dialect) {
  const auto refuse = [&](const char* option, const std::string& what) {
    throw InputError(option, options.dialect + " has no " + what + "; leave it out");
  };
  if (options.end.kind == EndPosition::Kind::kHome && dialect && dialect->home == HomeForm::kSwitches)
    throw InputError("--end-position",
                     options.dialect +
                         " has no home to go to: its G28 drives to the end switches, wherever "
                         "they are; give X,Y or none");
  for (const double value : {options.end.place.x, options.end.place.y}) {
    if (!(std::abs(value) <= PrintGrid::kLargest))
      throw InputError("--end-position", "lies where no machine reaches; give X,Y in mm");
  }
  if (options.optional_stop && dialect && !dialect->optional_stop)
    refuse("--optional-stop", "M1 that stops only where the operator wants it");
  if (options.spindle_wait && !(options.spindle_wait->seconds() <= kLongestWait))
    throw InputError("--spindle-wait", "must be at most " + trimmed(kLongestWait, 0) + " s");
  const bool is_unwritten = !dialect || dialect->radius == RadiusWord::kUnwritten;
  if (options.wear && (is_unwritten || dialect->radius == RadiusWord::kNone))
    refuse("--compensation",
           is_unwritten ? "compensation for wear alone that is written here" : "cutter compensation");
  const int digits = dialect ? dialect->program_digits : 0;
  if (options.program_number && digits == 0) refuse("--program-number", "O word");
  if (options.program_number && std::to_string(*options.program_number + options.programs_before).size() >
                                    static_cast<std::size_t>(digits))
    refuse("--program-number", "O word of so many digits");
  if (options.block_numbers && !(dialect && dialect->block_numbers))
    refuse("--block-numbers", "N words to choose");
}

}  // namespace

const std::vector<std::string>& post_dialects() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = iso_dialect_names();
    all.emplace_back(kKlartext);
    return all;
  }();
  return names;
}

std::string file_extension_of(const std::string& dialect) {
  if (dialect == kKlartext) return ".h";
  const IsoDialect* iso = iso_dialect_named(dialect);
  return iso ? std::string(iso->extension) : ".ngc";
}

std::optional<int> program_number_of(const std::string& dialect, const std::string& program_name) {
  const IsoDialect* const iso = iso_dialect_named(dialect);
  if (iso == nullptr || iso->program_digits == 0) return std::nullopt;
  return program_number(program_name);
}

std::string work_offset_words(const std::string& dialect, const WorkOffset& offset) {
  const IsoDialect* const iso = iso_dialect_named(dialect);
  return words_of(iso != nullptr && offset == WorkOffset{} ? iso->first_offset : offset);
}

bool repeats_cycles(const std::string& dialect) {
  const IsoDialect* const iso = iso_dialect_named(dialect);
  return iso != nullptr && iso->modal_cycles;
}

bool has_subprograms(const std::string& dialect) {
  if (dialect == kKlartext) return true;
  const IsoDialect* const iso = iso_dialect_named(dialect);
  return iso != nullptr && iso->subprograms != SubprogramForm::kNone;
}

clearcut::PathControl path_control_of(const PostOptions& options) {
  const double within = options.least_corner_tolerance();
  const IsoDialect* const dialect = iso_dialect_named(options.dialect);
  if (dialect == nullptr) return {PathMode::kTolerance, within, std::nullopt};
  const PathMode stop = dialect->exact_stop_halts ? PathMode::kExactStop : PathMode::kExactPath;
  if (options.exact_stop || dialect->path_control == PathControl::kNone) return {stop, {}, {}};
  if (dialect->path_control != PathControl::kExactStop) return {PathMode::kTolerance, within, std::nullopt};
  return {options.continuous ? PathMode::kContinuous : stop, {}, {}};
}

int decimals_of(const PostOptions& options) {
  if (options.decimals) return *options.decimals;
  const IsoDialect* dialect = iso_dialect_named(options.dialect);
  if (!dialect) return options.inch ? kKlartextInchDecimals : kKlartextMmDecimals;
  return options.inch ? dialect->inch_decimals : dialect->mm_decimals;
}

double rounding_of(const PostOptions& options) {
  const PrintGrid grid(options.inch, decimals_of(options));
  return largest_deviation(grid) + (options.dialect == kKlartext ? kKlartextDrift * grid.step() : 0);
}

double rounding_of_lines(const PostOptions& options) {
  return PrintGrid(options.inch, decimals_of(options)).step() * std::sqrt(0.5);
}

double rounding_of_heights(const PostOptions& options) {
  return PrintGrid(options.inch, decimals_of(options)).step() / 2;
}

std::string write_program(const Toolpath& toolpath, const Part& part, const PostOptions& options) {
  const IsoDialect* dialect = iso_dialect_named(options.dialect);
  if (!dialect && options.dialect != kKlartext) refuse_dialect(options.dialect);
  if (options.decimals && (*options.decimals < 1 || *options.decimals > 6)) {
    throw InputError("", "decimals must be 1 to 6");
  }
  refuse_missing_offset(options, dialect);
  refuse_missing_words(options, dialect);
  for (const Section& section : toolpath.sections) check(section);
  return dialect ? write_iso(toolpath, part, options, *dialect) : write_klartext(toolpath, part, options);
}

}  // namespace clearcut::post
