#include "arguments/post_arguments.h"

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
  command.add_option("--work-offset", work_offset_, "Where the part's zero is: G54 (default) to G59")
      ->check(CLI::IsMember({"G54", "G55", "G56", "G57", "G58", "G59"}, CLI::ignore_case));
  command.add_option("--program-number", program_number_, "O word of Fanuc and Haas programs")
      ->check(CLI::Range(1, 99999));
  command.add_flag("--block-numbers", block_numbers_, "N words");
  command.add_flag("--optional-stop", optional_stop_, "M1 before every tool but the first");
  command
      .add_option("--spindle-wait", spindle_wait_,
                  "Seconds to wait after the spindle starts (default: of the machine)")
      ->check(CLI::NonNegativeNumber);
}

PostOptions PostArguments::options(PostOptions post) const {
  if (dialect_) post.dialect = *dialect_;
  post.inch = post.inch || inch_;
  if (decimals_) post.decimals = decimals_;
  post.arcs = post.arcs && !no_arcs_;
  post.tool_changer = post.tool_changer && !no_tool_change_;
  post.length_offset = post.length_offset && !no_length_offset_;
  if (work_offset_) post.work_offset = std::stoi(work_offset_->substr(1));
  if (program_number_) post.program_number = program_number_;
  post.block_numbers = post.block_numbers || block_numbers_;
  post.optional_stop = post.optional_stop || optional_stop_;
  post.exact_stop = post.exact_stop || exact_stop_;
  if (spindle_wait_) post.spindle_wait = Seconds::of(*spindle_wait_);
  return post;
}

}  // namespace clearcut::cli
