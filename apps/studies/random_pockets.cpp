// compare --random: the contour methods on many random pockets.
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/studies.h>
#include <fmt/format.h>

#include <filesystem>

#include "research_commands.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

/// A pocket on which a published method is faster than Clearcut's, as an outline named by the difference.
void write_slower(const studies::StudyCase& one, const std::string& folder) {
  Part part = one.part;
  part.name +=
      fmt::format(", endmill:{}, contour {:.2f} s, {} {:.2f} s", part.tools.front().diameter,
                  one.outcomes.at("contour").time_s, *one.faster, one.outcomes.at(*one.faster).time_s);
  std::filesystem::create_directories(folder);
  write_outputs({{folder + "/" + std::to_string(one.seed) + ".json", write_outline_json(part)}}, {});
}

}  // namespace

void compare_at_random(const RandomPockets& command) {
  ProgressLine line(kStops);
  std::size_t done = 0;
  const auto study = studies::study_methods(
      command.count, command.options.seed, command.options, [&](const studies::StudyCase& one) {
        if (one.faster && !command.slower.empty()) write_slower(one, command.slower);
        line.count(++done, static_cast<std::size_t>(command.count), "pockets");
      });
  line.end();
  print_table(studies::study_table(study), command.as_markdown);
}

}  // namespace clearcut::cli
