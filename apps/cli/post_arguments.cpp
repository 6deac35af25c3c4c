#include "post_arguments.h"

namespace clearcut::cli {

void PostArguments::add_options(CLI::App& command) {
  command.add_option("--post", dialect_,
                     "Controller: linuxcnc, grbl, fanuc, haas, heidenhain, mach3, mach4, marlin");
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
  command.add_option("--spindle-wait", spindle_wait_, "Seconds to wait after the spindle starts")
      ->check(CLI::NonNegativeNumber);
}

PostOptions PostArguments::options(const JobOutput& job) const {
  PostOptions post;
  post.dialect = dialect_.value_or(job.post.value_or("linuxcnc"));
  post.inch = inch_ || job.inch.value_or(false);
  post.decimals = decimals_ ? decimals_ : job.decimals;
  post.arcs = !no_arcs_ && job.arcs.value_or(true);
  post.tool_changer = !no_tool_change_ && job.tool_change.value_or(true);
  post.length_offset = !no_length_offset_ && job.length_offset.value_or(true);
  if (work_offset_) post.work_offset = std::stoi(work_offset_->substr(1));
  post.program_number = program_number_;
  post.block_numbers = block_numbers_;
  post.optional_stop = optional_stop_;
  post.exact_stop = exact_stop_ || job.exact_stop.value_or(false);
  if (const auto wait = spindle_wait_ ? spindle_wait_ : job.spindle_wait)
    post.spindle_wait = Seconds::of(*wait);
  return post;
}

}  // namespace clearcut::cli
