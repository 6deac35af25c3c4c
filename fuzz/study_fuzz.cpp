// Any text as the rows of an earlier study: taken over, or refused in one line. What is made of it is read again, the
// same.
#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "studies/genetic/genetic_study.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace clearcut;
  studies::GeneticStudyOptions options;
  options.runs = 1;
  options.generations = 2;
  options.side = 3;
  options.threads = 1;
  static const studies::GeneticStudy study = studies::genetic_study("spread", options);
  const std::string text(data, data + size);
  try {
    const std::string once =
        studies::study_csv(study, options, studies::run_genetic_study(study, options, text));
    const std::string twice =
        studies::study_csv(study, options, studies::run_genetic_study(study, options, once));
    CLEARCUT_ASSERT(once == twice);
  } catch (const InputError& error) {
    CLEARCUT_ASSERT(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
