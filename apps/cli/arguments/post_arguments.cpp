#include "arguments/post_arguments.h"

#include <clearcut/error.h>

#include "arguments/suggest.h"

namespace clearcut::cli {

void PostArguments::add_options(CLI::App& command) {
  command.option_defaults()->group("Controller");
  command
      .add_option("--post", dialect_,
                  "Controller: linuxcnc (default), grbl, fanuc, haas, heidenhain, mach3, mach4, marlin")
      ->check(one_of({"linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3", "mach4", "marlin"}));
  command.add_flag("--inch", inch_, "Write the program in inches");
  command.add_option("--decimals", decimals_, "Of coordinates (default: what the controller resolves)")
      ->check(CLI::Range(3, 6));
  command.add_flag("--no-arcs", no_arcs_, "Lines only");
  command.add_flag("--no-tool-change", no_tool_change_, "A pause (M0) instead of M6");
  command.add_flag("--no-length-offset", no_length_offset_, "No G43");
  command.add_flag("--exact-stop", exact_stop_, "G61 instead of blending");
  command
      .add_option(
          "--work-offset", work_offset_,
          "Where the part's zero is: G54 (default) to G59, or as the controller has them G59.1 to G59.3, "
          "\"G54.1 P1\" to P300, \"G154 P1\" to P99")
      ->check(for_example({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"}));
  command
      .add_option(
          "--end-position", end_position_,
          "Where the machine goes at the end: home, X,Y at the safe height, or none (default: Z to its home "
          "for Fanuc and Haas, else the safe height)")
      ->check(for_example({"home", "none"}));
  command.add_option("--program-number", program_number_, "O word of Fanuc and Haas programs")
      ->check(CLI::Range(1, 99999));
  command.add_flag("--block-numbers", block_numbers_, "N words");
  command.add_flag("--optional-stop", optional_stop_, "M1 before every tool but the first");
  command
      .add_option("--spindle-wait", spindle_wait_,
                  "Seconds to wait after the spindle starts (default: of the machine)")
      ->check(CLI::NonNegativeNumber);
}

namespace {

WorkOffset work_offset_of(const std::string& text) {
  if (const auto offset = work_offset_named(text)) return *offset;
  throw InputError("--work-offset",
                   "'" + text + "' is unknown; use one of " + std::string(kKnownWorkOffsets));
}

EndPosition end_position_of(const std::string& text) {
  if (const auto end = end_position_named(text)) return *end;
  throw InputError("--end-position", "'" + text + "' is unknown; use home, none, or X,Y in mm");
}

}  // namespace

PostOptions PostArguments::options(PostOptions post) const {
  if (dialect_) post.dialect = *dialect_;
  post.inch = post.inch || inch_;
  if (decimals_) post.decimals = decimals_;
  post.arcs = post.arcs && !no_arcs_;
  post.tool_changer = post.tool_changer && !no_tool_change_;
  post.length_offset = post.length_offset && !no_length_offset_;
  if (work_offset_) post.work_offset = work_offset_of(*work_offset_);
  if (end_position_) post.end = end_position_of(*end_position_);
  if (program_number_) post.program_number = program_number_;
  post.block_numbers = post.block_numbers || block_numbers_;
  post.optional_stop = post.optional_stop || optional_stop_;
  post.exact_stop = post.exact_stop || exact_stop_;
  if (spindle_wait_) post.spindle_wait = Seconds::of(*spindle_wait_);
  return post;
}

}  // namespace clearcut::cli
