// scripts/mutants.sh changes the constants of the published methods; a change whose text has gone proves nothing.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>
#include <string>

#include "base/file.h"

namespace clearcut::studies {
namespace {

TEST(Mutants, EveryTextThatIsChangedStandsInItsSource) {
  const std::string root = CLEARCUT_SOURCE_DIR "/";
  std::istringstream script(read_file(root + "scripts/mutants.sh"));
  const std::regex name(R"re(^(\w+)=(src/\S+)$)re");
  const std::regex mutant(R"re(^mutant (\S+) (?:'([^']*)'|"([^"]*)") .*)re");
  std::map<std::string, std::string> names, sources;
  std::smatch match;
  int mutants = 0;
  for (std::string line; std::getline(script, line);) {
    if (std::regex_match(line, match, name)) names["$" + match[1].str()] = match[2];
    if (!std::regex_match(line, match, mutant)) continue;
    const std::string file = names.contains(match[1]) ? names[match[1]] : match[1].str();
    const std::string text = match[2].matched ? match[2] : match[3];
    if (!sources.contains(file)) sources[file] = read_file(root + file);
    EXPECT_NE(sources[file].find(text), std::string::npos) << file << ": " << text;
    ++mutants;
  }
  EXPECT_GE(mutants, 40);
}

}  // namespace
}  // namespace clearcut::studies
