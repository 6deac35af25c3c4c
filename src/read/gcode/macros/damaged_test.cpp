// Damaged programs with macros: read in bounded time, or refused with their place.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "base/random.h"
#include "read/gcode/gcode.h"

namespace clearcut::read::gcode {
namespace {

/// More by hand: CLEARCUT_DAMAGED_PROGRAMS=100000.
int damaged_asked() {
  const char* const asked = std::getenv("CLEARCUT_DAMAGED_PROGRAMS");
  return asked ? std::atoi(asked) : 600;
}

std::string with_damage(std::string text, Random& random) {
  constexpr std::string_view kPieces = "GMXYZO#[]<>=*/+-.0123456789%\n ()PLNIFDE";
  for (std::uint64_t n = 1 + random.below(4); n > 0 && !text.empty(); --n) {
    const std::size_t at = random.below(text.size());
    switch (random.below(4)) {
      case 0:
        text[at] = kPieces[random.below(kPieces.size())];
        break;
      case 1:
        text.insert(at, 1, kPieces[random.below(kPieces.size())]);
        break;
      case 2:
        text.erase(at, 1 + random.below(10));
        break;
      default:
        text.insert(at, text.substr(random.below(text.size()), random.below(40)));
    }
  }
  return text;
}

TEST(DamagedMacros, AreReadOrRefusedInBoundedTime) {
  std::vector<std::string> texts;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(CLEARCUT_SOURCE_DIR) / "tests/corpus/macro"))
    texts.push_back(read_file(entry.path().string()));
  ASSERT_GT(texts.size(), 3U);
  std::sort(texts.begin(), texts.end());
  constexpr Dialect kDialects[] = {Dialect::kLinuxCnc, Dialect::kFanuc, Dialect::kHaas, Dialect::kMach4};
  Random random(98);
  int read = 0, refused = 0;
  for (int n = damaged_asked(); n > 0; --n) {
    ReadControllerOptions options;
    if (random.below(2) == 0) options.dialect = kDialects[random.below(4)];
    options.most_lines = 2000;
    const std::string text = with_damage(texts[random.below(texts.size())], random);
    options.subprograms = [&](const std::string&) { return std::optional<std::string>(text); };
    try {
      const Program program = read_gcode(text, "damaged", options);
      for (const Section& section : program.toolpath.sections)
        for (const Move& move : section.moves) ASSERT_TRUE(std::isfinite(move.length())) << text;
      ++read;
    } catch (const InputError& error) {
      ASSERT_NE(std::string(error.what()).find(':'), std::string::npos) << error.what();
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 20);
  EXPECT_GT(refused, 20);
}

TEST(MacroCorpus, ProgramsAreReadAsTheyStand) {
  const auto load = [](const char* name) {
    const std::filesystem::path path =
        std::filesystem::path(CLEARCUT_SOURCE_DIR) / "tests/corpus/macro" / name;
    return read_gcode(read_file(path.string()), name);
  };
  for (const auto& [name, dialect] :
       {std::pair{"bolt_circle.ngc", Dialect::kLinuxCnc}, std::pair{"steps.ngc", Dialect::kLinuxCnc},
        std::pair{"macro.nc", Dialect::kFanuc}, std::pair{"local.nc", Dialect::kHaas}}) {
    SCOPED_TRACE(name);
    const Program program = load(name);
    EXPECT_EQ(program.dialect, dialect);
    EXPECT_TRUE(program.ended);
    EXPECT_FALSE(program.toolpath.sections.empty());
  }
}

}  // namespace
}  // namespace clearcut::read::gcode
