// The same program on every processor: glibc is told to leave out what only some of them have, as on those that have not.
#include <gtest/gtest.h>
#include <stdlib.h>

#include "base/file.h"
#include "post/part/part_writers.h"
#include "support/command.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;

/// For as long as it lives, programs that are started find a plain processor, as far as glibc asks.
class PlainProcessor {
 public:
  PlainProcessor() { ::setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2", 1); }
  ~PlainProcessor() { ::unsetenv("GLIBC_TUNABLES"); }
  PlainProcessor(const PlainProcessor&) = delete;
  PlainProcessor& operator=(const PlainProcessor&) = delete;
};

std::string program(const std::vector<std::string>& part, const std::string& strategy) {
  const ScratchFolder folder;
  std::vector<std::string> words{"plan",
                                 part.front(),
                                 "--strategy=" + strategy,
                                 "--quiet",
                                 "--accept=out-of-reach",
                                 "--output=" + folder.path("program")};
  words.insert(words.end(), part.begin() + 1, part.end());
  const auto result = run_clearcut(words);
  const auto names = folder.names();
  return names.empty() ? result.err : read_file(folder.path("program"));
}

void expect_the_same(const std::vector<std::string>& part, const std::string& strategy) {
  const std::string here = program(part, strategy);
  const PlainProcessor plain;
  EXPECT_EQ(here == program(part, strategy), true) << part.front() << " " << strategy;
}

TEST(AnyProcessor, TheSameProgramOfExamples) {
  const std::string examples = std::string(CLEARCUT_SOURCE_DIR) + "/examples/";
  for (const char* strategy : {"adaptive", "contour"}) {
    expect_the_same({examples + "fishhead.p21", "--stepdown=50"}, strategy);
    expect_the_same({examples + "bracket.dxf", "--tool=endmill:6", "--post=heidenhain"}, strategy);
  }
}

TEST(AnyProcessor, TheSameProgramOfRandomParts) {
  Random random(22);
  const ScratchFolder folder;
  for (int i = 0; i < test_support::random_count(12); ++i) {
    const std::string name = std::to_string(i) + ".json";
    const std::string file =
        folder.file(name, post::write_outline_json(test_support::random_part(random, 6)));
    expect_the_same({file, "--tool=endmill:6"}, i % 2 == 0 ? "adaptive" : "auto");
  }
}

}  // namespace
}  // namespace clearcut
