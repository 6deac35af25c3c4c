#include "read/step_solid/solid_model.h"

#include "base/apart.h"
#include "base/error.h"
#include "base/programs.h"
#include "read/part21/part21.h"

namespace clearcut::read {
namespace {

/// Seconds of the processor.
constexpr int kLongestRead = 120;

/// The program with the CAD kernel: beside this one, at its build place, or at its installed place. Empty if there is
/// none.
std::string reader_of_solids() {
  return companion("clearcut-solids", CLEARCUT_SOLIDS, CLEARCUT_SOLIDS_INSTALLED);
}

}  // namespace

bool solids_can_be_read() {
  return !reader_of_solids().empty();
}

SolidModel load_solid(std::string_view text, const std::string& file_name, const SolidChoice& choice) {
  const std::string reader = reader_of_solids();
  if (reader.empty())
    throw InputError(
        file_name,
        "a STEP solid, and this build reads none; install libocct-data-exchange-dev (Open CASCADE) "
        "and build again");
  // Names the line of a broken file; the kernel does not.
  parse_part21(text, file_name);
  const auto got = done_apart({reader, file_name, choice.up, std::to_string(choice.turn), choice.body}, text,
                              kLongestRead);
  if (!got || got->empty())
    throw InputError(file_name, "Open CASCADE breaks down over this solid, or takes more than " +
                                    std::to_string(kLongestRead) + " s; export it again");
  if (got->front() == 'E') throw InputError("", got->substr(1));
  return model_from_bytes(got->substr(1));
}

}  // namespace clearcut::read
