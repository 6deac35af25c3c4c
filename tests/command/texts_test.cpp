// docs/texts.md: the commands that it names run, and its last column says no more than they hold.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "base/file.h"
#include "base/text.h"
#include "support/command.h"

namespace clearcut::test_support {
namespace {

/// A row of one of the page's tables.
struct Item {
  std::string where;  ///< in the text
  std::string what;
  std::string command;  ///< "" where there is none
  std::string agreement;
};

std::vector<Item> items_of_the_texts() {
  std::vector<Item> items;
  std::istringstream page(read_file(CLEARCUT_SOURCE_DIR "/docs/texts.md"));
  const std::regex row(R"(\| (.*) \| (.*) \| (?:`clearcut ([^`]*)` )?\| ([a-z ]+) \|)");
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, row) && match[4] != "agreement")
      items.push_back({match[1], match[2], match[3], match[4]});
  return items;
}

/// The command's words; its files are in the scratch folder, the examples in the source folder.
std::vector<std::string> arguments_of(const std::string& command, const ScratchFolder& folder) {
  std::vector<std::string> words = split(command, ' ');
  for (std::string& word : words) {
    if (word.starts_with("examples/"))
      word = std::string(CLEARCUT_SOURCE_DIR) + "/" + word;
    else
      for (const char* end : {".edges", ".p21", ".ngc", ".svg", ".html", ".json", ".txt"})
        if (word.ends_with(end)) word = folder.path(word);
  }
  if (words.front() == "study")
    for (const char* brief : {"--runs", "2", "--generations", "20", "--side", "4"}) words.emplace_back(brief);
  return words;
}

/// What shows that an item happens: a place in what its command says or writes.
struct Sign {
  const char* item;     ///< where it is in the text
  const char* file;     ///< "": what is printed
  const char* pattern;  ///< a regular expression that is found there; after a "!" one that is not
};

const Sign kSigns[] = {
    // CPO-kappa
    {"§ I", "", "loops +[0-9]"},
    {"§ I", "", "bisectors +[0-9]"},
    {"§ II, fig. 1, alg. 1", "a.txt", "1.8301 6.8301"},
    {"§ II, eq. 1 to 3, fig. 2", "a.txt", "46.4645 26.4645 55.0000 35.0000\n"},
    {"§ II, eq. 2, reflex corners", "a.txt", "\n25.0000 15.0000 25.0000 35.0000\n"},
    {"§ II, eq. 2, by other methods", "a.txt", "! G0[23]\n"},
    {"§ II, eq. 2, by other methods", "", "verdict: CLEAN"},
    {"§ III A, alg. 2, fig. 3", "a.txt", "\n55.0000 32.9289 52.9289 35.0000\n"},
    {"§ III A, alg. 2, fig. 3", "a.txt",
     "\n46.4645 13.5355 46.4645 26.4645\n46.4645 26.4645 13.5355 26.4645\n"},
    {"§ III B, alg. 3, fig. 4", "a.txt", "offset step 8.5355 6.4017\n"},
    {"§ III C, eq. 4 to 6, figs. 5, 6", "a.txt", "coefficient 0.8536 residual F 0.0000\n"},
    {"§ III C, eq. 4 to 6, figs. 5, 6", "a.json", "\"coefficient\": 0.8535"},
    {"§ IV A, figs. 7, 8", "a.svg", "<path"},
    {"§ IV A, figs. 7, 8", "a.html", "<canvas"},
    {"fig. 9 (a)", "", "268.4[0-9]+ mm2 within reach is left uncut"},
    {"fig. 9 (b)", "", "verdict: CLEAN"},
    {"fig. 9 (b)", "a.txt", "# total length 2195.3550\n"},
    {"§ VI, any polygon", "", "120.1[0-9]+ mm2 within reach is left uncut"},
    {"§ VI, any polygon, corrected", "", "verdict: CLEAN"},
    {"fig. 10, from outline to program", "a.txt", "# total length 373.4802\n"},
    {"§ IV B", "a.ngc", "G0?1 "},
    // CPO-rho
    {"§§ 1, 2.1, eq. 1, figs. 1, 2, 4", "", "pwid +[0-9]"},
    {"§§ 1, 2.1, eq. 1, figs. 1, 2, 4", "", "double +[0-9]"},
    {"eq. 2, fig. 5", "a.txt", "G03\n"},
    {"eq. 3, fig. 6", "a.txt", "20.0000 20.0000 5.0000 35.0000\n"},
    {"§ 3.1, eq. 4 to 7, fig. 7, app. A, B, fig. 13", "a.txt",
     "\n5.0000 14.0000 14.0000 5.0000 14.0000 14.0000 G03\n"},
    {"§ 3.1, eq. 4 to 7, fig. 7, app. A, B, fig. 13", "a.txt", "\n14.0000 14.0000 46.0000 14.0000\n"},
    {"§ 3.2, eq. 8, fig. 8", "", "rho_opt 0.7828 from the smallest angle, 90.00 degrees"},
    {"§ 3.2, a single smallest angle", "a.txt", "smallest angle 40.0000 coefficient 0.7151 "},
    {"§ 3.2, a single smallest angle", "a.txt", "\n30.0000 [0-9.]+ 30.0000 [0-9.]+\n"},
    {"§ 4, eq. 9", "a.txt", "eq. 9 [0-9.]+ s: sum L [0-9.]+ mm, V_f 1000 mm/min, nd [0-9]+, tau 0.177 s"},
    {"§ 4, eq. 9", "a.json", "\"published_discontinuities\": [0-9]+"},
    {"§ 4, sets of cutters", "", "endmill 6 +[*]? +2 +1942 +194 "},
    {"§ 4, sets of cutters", "", "fastest sequence"},
    {"§ 5", "a.ngc", "X55 Y"},
    {"figs. 11, 12 (b)", "a.txt", "coefficient 0.7187 "},
    {"figs. 11, 12 (b)", "a.txt", "\n13.8564 8.0000 86.1436 8.0000\n"},
    {"figs. 11, 12 (b)", "", "verdict: CONDITIONAL"},
    {"fig. 12 (a)", "", "30.2[0-9]+ mm2 within reach is left uncut"},
    {"§ 6, tool life", "", "\nrho .* 119 +yes"},
    {"§ 6, tool life", "", "\nfixed .* 138 +NO"},
    // Grid
    {"§§ I, II, figs. 1, 2, decision maker", "", "element +squares +reduced"},
    {"§ II, figs. 3 to 8", "", "element 1 +441 +81 "},
    {"§ II, figs. 3 to 8", "", "element 2 +31 "},
    {"§ II, figs. 3 to 8", "", "element 3 +21 "},
    {"§ III, figs. 9 to 21", "", "middle +[0-9]+ +[0-9]+ +[0-9]+\\.[0-9] "},
    {"§ III, figs. 9 to 21", "a.svg", "squares</text>"},
    {"figs. 23, 24", "", "south +[0-9]+ +[0-9]+ "},
    {"§§ IV, V", "", "on all squares, and on those that the reduction keeps"},
    {"§§ IV, V", "", "middle +[0-9]+ +[0-9.]+ +[0-9.]+ +[0-9]+ +[0-9.]+ +[0-9.]+\n"},
    {"the working screen", "a.html", "onvergence"},
    // Tour
    {"ch. 1, 2, §§ 3.1 to 3.2, figs. 2-3 to 2-5", "", "zigzag +[0-9]"},
    {"ch. 1, 2, §§ 3.1 to 3.2, figs. 2-3 to 2-5", "", "spiral +[0-9]"},
    {"§§ 3.3.1, 3.3.2, 4.2.1, fig. 3-1", "", "step WS POCKET6 -> POCKET6"},
    {"§ 4.2, essential data", "", "^NOT MACHINED: NO_STRATEGY\n"},
    {"§ 4.2.1, strategies named in the file", "", "CONTOUR_SPIRAL"},
    {"§ 4.2.1, strategies named in the file", "", "BIDIRECTIONAL_MILLING"},
    {"§§ 3.3.3, 3.3.4, figs. 3-2 to 3-6", "", "element 2 +[0-9]+ +[0-9]+ "},
    {"§ 4.2.2, eq. 4.1 to 4.7, figs. 4-1 to 4-3", "a.ngc", "! ?G0?[23] "},
    {"§ 4.2.3, figs. 4-4 to 4-6", "a.txt", "\n30.0000 15.0000 25.0000 20.0000 30.0000 20.0000 G02\n"},
    {"§ 4.2.4, eq. 4.8, figs. 4-7, 4-8, 4-11", "a.txt",
     "\n(5|15|25|35|45|55).0000 [0-9.]+ (5|15|25|35|45|55).0000 "},
    {"§ 4.2.4, eq. 4.8, figs. 4-7, 4-8, 4-11", "", "uncut: plate: "},
    {"§ 4.2.4, eq. 4.8, figs. 4-7, 4-8, 4-11", "",
     "plate: what stays here is left by the rule of the published grid"},
    {"§ 4.2.4, eq. 4.8, figs. 4-7, 4-8, 4-11", "a.ngc", "\\(RIM OF THE PUBLISHED GRID: PLATE\\)"},
    {"§ 4.2.5, eq. 4.9, 4.10, figs. 4-9, 4-10", "",
     "scallop: 0.500 mm at most on the drafted walls of POCKET3"},
    {"§ 3.5, eq. 3.1 to 3.3, § 3.10", "", "length 8, .*bound 8 .*gap 0.0000 %.* exact"},
    {"§ 3.6.1, figs. 3-7 to 3-9", "", "length 99, .*gap 0.0000 %"},
    {"§§ 3.4, 3.7, 3.8, 4.1, 4.3.1", "", "genetic, tournament, cx, inversion"},
    {"§ 3.6.2, fig. 3-10", "", "genetic, roulette, erx, nearest"},
    {"§ 4.3, figs. 4-13, 4-17", "", "uncut: plate: "},
    {"§ 4.3.2, fig. 4-14", "", "\n50 +2 "},
    {"§ 4.3.2, neighbours", "", "\n48 +2 "},
    {"§ 4.3.3, eq. 4.11, 4.12, fig. 4-15", "", "\nroulette +2 "},
    {"§ 4.3.3, fig. 4-16", "", "\nerx +2 "},
    {"§ 4.3.3, fig. 4-16", "", "\nscx +2 "},
    {"§ 4.3.3, eq. 4.13, 4.14, fig. 4-18", "", "\nnearest +2 "},
    {"§ 4.3.3, eq. 4.13, 4.14, fig. 4-18", "", "\nscramble +2 "},
    {"§ 3.9, sensitivity", "", "\npopulation \\* 2 +2 .* [0-9]+\n"},
    {"§ 3.9, rates of crossover", "", "\n0.8 +2 "},
    {"§ 3.9, rates of mutation", "", "\n0.2 +2 "},
    {"§ 4.4, fig. 4-19", "", "verdict: CLEAN"},
    {"§ 4.4, fig. 4-19", "a.ngc", "\nX47.9641 F1000\nY15.509\nX12.0359\nY24.491\n"},
    {"§ 4.4.1, eq. 4.15, fig. 4-20", "", "length 35, .*gap 0.0000 %"},
    {"§ 4.4.2, figs. 4-21 to 4-23", "", "turns 10, .*gap 0.0000 %"},
    {"§ 4.4.2, eq. 4.16 to 4.20, figs. 4-24 to 4-26", "", "angle 900, .*gap 0.0000 %"},
    {"§ 4.4.3, eq. 4.21, figs. 4-12, 4-27 to 4-31", "", ": 36 points, engagement [0-9.]+, "},
    {"eq. 4.22", "", "engagement-inverse [0-9.]+, "},
    {"§§ 5.1, 5.2, figs. 5-1 to 5-4, app. 9.1", "", "PLANAR_FACE4  planar_face"},
    {"§ 6.2.1, eq. 5.1, figs. 6-1, 6-2", "", "\n30 +2 "},
    {"fig. 6-3", "", "\n30 +2 "},
    {"§ 6.2.2, figs. 6-4, 6-5", "", "\nall +2 "},
    {"§ 6.3.2, figs. 6-11, 6-13", "", "turns 18, .*gap 0.0000 %"},
    {"§ 6.3.2, figs. 6-12, 6-14", "", "angle 1620, .*gap 0.0000 %"},
    {"§ 7.6, tools that are no prisms", "", "condition out-of-reach: plate: .* which ends in a ball"},
    {"§ 7.6, open boundaries", "", "verdict: CLEAN"},
    {"§ 7.6, open boundaries", "a.ngc", "\nX-22 Y18.5\n"},  // the part begins at X0
    {"§ 7.6, when to stop", "", "bound 459 .*gap 0.0000 %"},
    {"§ 8.4.1", "", "adaptive +[0-9.]+ +[0-9.]+ +[0-9.]+ +kept"},
    {"§ 8.4.1", "", "contour 0.45 +[0-9.]+ +[0-9.]+ +[0-9.]+ +worse"},
    {"§ 8.4.3, additive", "a.json", "\"cover_proven\": true"},
    {"§ 8.4.3, additive", "a.ngc", "\nG1 X[0-9.]+ Y[0-9.]+ E[0-9.]+"},
};

/// The page's own `sed`.
std::string without_a_depth(std::string program) {
  const auto pocket = program.find("POCKET('NO_STRATEGY'");
  const std::string depth = "#22,";
  program.replace(program.find(depth, pocket), depth.size(), "$,");
  return program;
}

TEST(TextsPage, KnowsFourTexts) {
  const auto items = items_of_the_texts();
  EXPECT_GE(items.size(), 102u);
  for (const Item& item : items) {
    EXPECT_THAT(item.agreement, ::testing::AnyOf("agrees", "computed", "printed", "explained", "differs",
                                                 "runs", "not built"))
        << item.where;
    EXPECT_EQ(item.command.empty(), item.agreement == "not built") << item.where;
  }
}

std::string docs_page(const std::string& name) {
  return read_file(CLEARCUT_SOURCE_DIR "/docs/" + name, 1 << 20);
}

/// What a text numbers, by kind; ranges as the page writes them.
struct Numbered {
  const char* heading;
  const char* kind;
  const char* numbers;
};

const Numbered kNumbered[] = {
    {"CPO-κ", "§", "I, II, III A, III B, III C, IV A, IV B, V, VI"},
    {"CPO-κ", "alg", "1 to 3"},
    {"CPO-κ", "eq", "1 to 6"},
    {"CPO-κ", "fig", "1 to 14"},
    {"CPO-κ", "table", "1"},
    {"CPO-ρ", "§", "1, 2.1, 3.1, 3.2, 4, 5, 6"},
    {"CPO-ρ", "app", "A, B"},
    {"CPO-ρ", "eq", "1 to 9"},
    {"CPO-ρ", "fig", "1 to 13"},
    {"CPO-ρ", "table", "1 to 3"},
    {"Grid", "§", "I, II, III, IV, V"},
    {"Grid", "fig", "1 to 24"},
    {"Grid", "table", "1"},
    {"Tour", "§",
     "1, 2, 3.1, 3.2, 3.3.1 to 3.3.4, 3.4, 3.5, 3.6.1 to 3.6.3, 3.7 to 3.10, 4.1, 4.2.1 to 4.2.5, 4.3.1 to "
     "4.3.3, 4.4.1 to 4.4.3, 5.1, 5.2, 5.3.1, 5.3.2, 5.4, 6.1, 6.2.1 to 6.2.3, 6.3.1 to 6.3.4, 6.4.1 to "
     "6.4.4, 6.5, 7.1 to 7.6, 8.1 to 8.3, 8.4.1 to 8.4.4"},
    {"Tour", "app", "9.1"},
    {"Tour", "eq", "3.1 to 3.3, 4.1 to 4.22, 5.1"},
    {"Tour", "fig", "1-1, 1-2, 2-1 to 2-5, 3-1 to 3-10, 4-1 to 4-31, 5-1 to 5-7, 6-1 to 6-21, 8-1"},
    {"Tour", "table", "3.1, 6.1 to 6.6"}};

/// "4-1 to 4-3, 5" are "4-1", "4-2", "4-3" and "5"; what is no number ends the list.
std::vector<std::string> numbers_in(const std::string& list) {
  static const std::regex one(
      R"(^((?:[IVX]+(?: [A-C])?|[A-B]|[0-9][0-9.-]*)(?: \([ab]\))?)(?: to ([0-9.-]*[0-9]))?$)");
  std::vector<std::string> numbers;
  for (const std::string& part : split(list, ',')) {
    std::smatch match;
    const std::string text(stripped(part));
    if (!std::regex_match(text, match, one)) break;
    const std::string first = match[1], last = match[2];
    const auto digits = first.find_last_of(".-") + 1;
    if (last.empty()) {
      numbers.push_back(first.substr(0, first.find(" (")));
    } else {
      for (int k = std::stoi(first.substr(digits)); k <= std::stoi(last.substr(digits)); ++k)
        numbers.push_back(first.substr(0, digits) + std::to_string(k));
    }
  }
  return numbers;
}

/// Kind and number of all that the rows of a text name.
std::set<std::string> named_in(const std::string& heading) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/texts.md");
  const auto begin = page.find("\n## " + heading + ":"), end = page.find("\n## ", begin + 1);
  std::istringstream rows(page.substr(begin, end - begin));
  static const std::regex kind(R"(((?:§)+|ch\.|figs?\.|eq\.|alg\.|tables?|app\.) )");
  std::set<std::string> named;
  for (std::string line; std::getline(rows, line);) {
    if (!line.starts_with("| ")) continue;
    const std::string where = line.substr(2, line.find(" | ") - 2);
    for (std::sregex_iterator at(where.begin(), where.end(), kind), next, none; at != none; at = next) {
      next = std::next(at);
      std::string word = (*at)[1];
      word = word.starts_with("§") || word == "ch." ? "§"
                                                    : std::regex_replace(word, std::regex(R"(s?\.?$)"), "");
      const auto from = static_cast<std::size_t>(at->position() + at->length());
      const auto until = next == none ? where.size() : static_cast<std::size_t>(next->position());
      for (const std::string& number : numbers_in(where.substr(from, until - from)))
        named.insert(word + " " + number);
    }
  }
  return named;
}

/// Whether it, the whole that it is part of, or a part of it is named.
bool is_named(const std::set<std::string>& named, const std::string& one) {
  return std::any_of(named.begin(), named.end(), [&](const std::string& other) {
    const auto is_part = [](const std::string& part, const std::string& whole) {
      return part.starts_with(whole + ".") || part.starts_with(whole + " ");
    };
    return one == other || (one.starts_with("§") && (is_part(one, other) || is_part(other, one)));
  });
}

/// Every section, figure, table, equation and algorithm that a text numbers stands in a row, by which the page says how many they are.
TEST(TextsPage, NamesAllThatTheTextsNumber) {
  int all = 0;
  for (const Numbered& numbered : kNumbered) {
    const std::set<std::string> named = named_in(numbered.heading);
    for (const std::string& number : numbers_in(numbered.numbers)) {
      ++all;
      const std::string one = std::string(numbered.kind) + " " + number;
      EXPECT_TRUE(is_named(named, one)) << numbered.heading << ": " << one;
    }
  }
  EXPECT_NE(docs_page("texts.md").find(fmt::format("all {} sections, figures, tables, equations", all)),
            std::string::npos)
      << all;
}

/// The table of counts at the head of the page: the last row is that of all rows below.
TEST(TextsPage, CountsItsRows) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/texts.md");
  std::map<std::string, int> count;
  for (const Item& item : items_of_the_texts()) ++count[item.agreement];
  std::string row = "| all |";
  int all = 0;
  for (const char* word : {"agrees", "computed", "printed", "runs", "explained", "differs", "not built"}) {
    row += fmt::format(" {} |", count[word]);
    all += count[word];
  }
  EXPECT_NE(page.find(fmt::format("{} {} |", row, all)), std::string::npos) << row << all;
}

/// Every row has a sign, and all of its signs are there.
void expect_that_it_happens(const Item& item, const CommandResult& result, const ScratchFolder& folder) {
  int signs = 0;
  for (const Sign& sign : kSigns) {
    if (item.where != sign.item) continue;
    ++signs;
    const std::string file = sign.file;
    if (!file.empty() && !std::filesystem::exists(folder.path(file))) {
      ADD_FAILURE() << item.where << ": " << file << " is not written";
      continue;
    }
    const std::string text = file.empty() ? result.out + result.err : read_file(folder.path(file));
    const bool is_absent = *sign.pattern == '!';
    const std::regex pattern(sign.pattern + (is_absent ? 1 : 0));
    EXPECT_NE(std::regex_search(text, pattern), is_absent) << item.where << ": " << sign.pattern << " in\n"
                                                           << text.substr(0, 2000);
  }
  EXPECT_GT(signs, 0) << item.where << " has no sign that it happens";
}

/// Tables are held by the tests of the studies; here everything else that the page names.
TEST(TextsPage, EveryCommandRuns) {
  const ScratchFolder folder;
  folder.file("part.edges", "name plate\ndepth 2\n60 90\n40 90\n60 90\n40 90\n");
  folder.file("triangle.edges", "name triangle\ndepth 2\n79.9861 60\n79.9861 60\n79.9861 60\n");
  folder.file("turned.edges", "name turned\norientation 30\ndepth 2\n60 90\n40 90\n60 90\n40 90\n");
  folder.file("chamfer.edges", "name cut corner\ndepth 2\n60 90\n35 135\n7.0711 135\n55 90\n40 90\n");
  folder.file("sharp.edges", "name sharp\ndepth 2\n60 70\n87.7141 40\n87.7141 70\n");
  folder.file("round.edges", "name round\ndepth 2\n60 90 14\n40 90 14\n60 90 14\n40 90 14\n");
  folder.file("angle.edges", "name angle\ndepth 2\n60 90\n20 90\n30 270\n20 90\n30 90\n40 90\n");
  std::string star = "name star\ndepth 2\n";
  for (int tip = 0; tip < 6; ++tip) star += "60 90\n60 210\n";
  folder.file("star.edges", star);
  folder.file("large.edges", "name large triangle\ndepth 2\n100 60\n100 60\n100 60\n");
  folder.file("no_depth.p21", without_a_depth(read_file(CLEARCUT_SOURCE_DIR "/examples/strategies.p21")));
  std::vector<std::string> commands;
  std::map<std::string, std::vector<Item>> items_of;  // some rows share a command
  for (const Item& item : items_of_the_texts()) {
    if (item.command.empty() || item.command.starts_with("reproduce ")) continue;
    if (items_of[item.command].empty()) commands.push_back(item.command);
    items_of[item.command].push_back(item);
  }
  for (const std::string& command : commands) {
    const CommandResult result = run_clearcut(arguments_of(command, folder));
    if (command.find("-o a.ngc") != std::string::npos) {
      EXPECT_TRUE(std::filesystem::exists(folder.path("a.ngc"))) << command << "\n" << result.err;
    }
    for (const Item& item : items_of[command]) {
      const bool says_why = item.what.find("exit 1") != std::string::npos;
      EXPECT_EQ(result.exit_code, says_why ? 1 : 0) << item.where << ": " << command << "\n" << result.err;
      EXPECT_EQ(item.agreement, "runs") << item.where;
      expect_that_it_happens(item, result, folder);
    }
    for (const auto& name : folder.names())
      if (name.starts_with("a.")) std::filesystem::remove(folder.path(name));
  }
  EXPECT_GE(commands.size(), 50u);
}

/// From its heading to the next.
std::string section_of(const std::string& page, const std::string& table) {
  const auto begin = page.find("<h2 id=\"" + table + "\"");
  if (begin == std::string::npos) return "";
  const auto end = std::min(page.find("<h2", begin + 1), page.find("</body>", begin));
  return page.substr(begin, end - begin);
}

/// The cells of every row of the tables in a section of HTML, without marks of agreement.
std::vector<std::vector<std::string>> rows_of_html(const std::string& section) {
  std::vector<std::vector<std::string>> rows;
  const std::regex row("<tr[^>]*>(.*?)</tr>"), cell("<td[^>]*>(.*?)</td>");
  for (std::sregex_iterator at(section.begin(), section.end(), row), end; at != end; ++at) {
    const std::string text = (*at)[1];
    rows.emplace_back();
    for (std::sregex_iterator one(text.begin(), text.end(), cell); one != end; ++one)
      rows.back().push_back(
          std::regex_replace(std::regex_replace((*one)[1].str(), std::regex(" [(]differs[)]"), ""),
                             std::regex(" [+]- "), " ± "));
  }
  return rows;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (const std::string& cell : split(line, '|')) cells.emplace_back(stripped(cell));
  return {cells.begin() + 1, cells.end() - 1};
}

/// The first row of a page that begins with these cells; empty if there is none.
std::vector<std::string> row_beginning(const std::string& page, const std::vector<std::string>& first) {
  for (const std::string& line : split(page, '\n')) {
    if (!line.starts_with("| ")) continue;
    const auto cells = cells_of(line);
    if (cells.size() > first.size() && std::equal(first.begin(), first.end(), cells.begin())) return cells;
  }
  return {};
}

/// "23 237 mm" is 23237.
std::string figure_in(const std::string& cell) {
  return std::regex_replace(cell, std::regex("[^0-9.]"), "");
}

/// Percent of the moves within ten points of the target, of a row of figure 6-15.
std::string within_ten_points(const std::vector<std::string>& row) {
  const auto bin = static_cast<std::size_t>(std::stoi(row[0]) / 10 + 4);  // the one that ends at the target
  return std::to_string(std::stoi(row[bin]) + (bin + 1 < row.size() ? std::stoi(row[bin + 1]) : 0)) + " %";
}

TEST(TextsPage, TablesOfOtherPagesAreThoseOfThePageOfReproducedTables) {
  const std::string made = docs_page("reproduced.html"), tour = docs_page("tour.md"),
                    methods = docs_page("methods.md");
  int compared = 0;
  // CPO-kappa table 1: the totals.
  const std::string lengths = methods.substr(methods.find("| four-pointed star"));
  for (const auto& row : rows_of_html(section_of(made, "lengths"))) {
    if (row.size() < 8) continue;
    const std::string part = row[0] == "concave" ? lengths : lengths.substr(lengths.find("| quadrilateral"));
    EXPECT_EQ(row_beginning(part, {row[1]}), (std::vector<std::string>{row[1], row[6], row[7]}));
    ++compared;
  }
  // Table 6.5: readings of the grid.
  for (const auto& [reading, name] : {std::pair("D, layers that hold material", "ours, that reading"),
                                      std::pair("D, every 2 mm layer", "FACE3 from the top of the part")}) {
    const auto ours = row_beginning(tour, {name});
    ASSERT_EQ(ours.size(), 5U) << name;
    for (const auto& row : rows_of_html(section_of(made, "fishhead"))) {
      if (row.empty() || row[0] != reading) continue;
      for (const auto& [cell, column] : {std::pair(1, 1), std::pair(2, 4), std::pair(3, 5), std::pair(4, 8)})
        EXPECT_EQ(figure_in(ours[static_cast<std::size_t>(cell)]), row[static_cast<std::size_t>(column)])
            << name;
      ++compared;
    }
  }
  // Figure 6-15: mean engagement by both models.
  std::map<std::string, int> seen;
  for (const auto& row : rows_of_html(section_of(made, "tour-engagement"))) {
    if (row.size() < 15) continue;
    const auto ours = row_beginning(tour, {row[0]});
    ASSERT_EQ(ours.size(), 9U) << row[0];
    const int nth = seen[row[0]]++;  // raster and exact of eq. 4.8, then of the matched spacing
    const auto mean = static_cast<std::size_t>(nth < 2 ? 2 + nth : 4 + nth);
    EXPECT_EQ(ours[mean], row[4]) << row[0];
    if (row[3] == "exact") {
      EXPECT_EQ(ours[mean + 1], within_ten_points(row)) << row[0];
    }
    ++compared;
  }
  // Table 6.5 by programs.
  std::string strokes;
  for (const auto& row : rows_of_html(section_of(made, "fishhead-published"))) {
    if (row.size() < 10) continue;
    if (row[1] == "printed") strokes = row[0] + ", printed";
    if (row[1] != "printed" && row[0] != "all") continue;
    const auto from = tour.find("| " + strokes);
    ASSERT_NE(from, std::string::npos) << strokes;
    const std::string name = row[1] == "printed" ? strokes
                             : row[1] == "ours"  ? "ours, one seed"
                                                 : "published algorithm";
    auto cells = row_beginning(tour.substr(from), {name});
    ASSERT_EQ(cells.size(), 9U) << name;
    EXPECT_EQ(std::vector<std::string>(cells.begin() + 1, cells.end()),
              std::vector<std::string>(row.begin() + 2, row.end()))
        << strokes << ": " << name;
    ++compared;
  }
  EXPECT_EQ(compared, 14 + 2 + 20 + 6);
}

/// Table 6.4: of each grid the tour by all three objectives, and the gap of each objective alone.
TEST(TextsPage, TheTableOfObjectivesIsThatOfThePageOfReproducedTables) {
  const std::string made = docs_page("reproduced.html"), tour = docs_page("tour.md");
  std::map<std::string, std::map<std::string, std::vector<std::string>>> grids;
  for (const auto& row : rows_of_html(section_of(made, "objectives")))
    if (row.size() == 13 && row[0] != "printed")
      grids[std::regex_replace(row[0], std::regex("PLANAR_"), "")][row[2]] = row;
  EXPECT_EQ(grids.size(), 13U);
  for (auto& [grid, of] : grids) {
    std::vector<std::string> cells{grid, of["length"][1]};
    const auto& all = of["1 : 20 : 0.1"];
    if (all.empty())
      cells.resize(6);
    else
      cells.insert(cells.end(), {all[4] + " %", all[6] + " %", of["turns"][7], all[7]});
    for (const char* objective : {"length", "turns", "turn angle", "time"})
      cells.push_back(of[objective][10].empty() ? "none" : of[objective][10] + " %");
    EXPECT_EQ(row_beginning(tour, {grid, cells[1]}), cells);
  }
}

/// The instances of the benchmark in its order, all of its seeds, and the distance from the best known length that it compares with.
TEST(TextsPage, TheTableOfInstancesHoldsWhatTheBenchmarkRuns) {
  const std::string benchmark = read_file(CLEARCUT_SOURCE_DIR "/benchmarks/tour_benchmark.cpp");
  std::string tour = docs_page("tour.md");
  tour.erase(0, tour.find("<!-- instances: "));
  const std::regex instance(R"re(\{"([a-z0-9]+)", (\d+), \d+, (\d+)\})re");
  int compared = 0;
  for (std::sregex_iterator at(benchmark.begin(), benchmark.end(), instance), end; at != end; ++at) {
    const auto cells = row_beginning(tour, {(*at)[1]});
    ASSERT_EQ(cells.size(), 7U) << (*at)[1];
    const double best_known = std::stod((*at)[2]), length = std::stod(cells[2]);
    const std::string seeds = (*at)[3];
    EXPECT_GE(length, best_known) << cells[0];
    EXPECT_EQ(cells[3], length == best_known ? "0" : fmt::format("{:.4f} %", 100 * (length / best_known - 1)))
        << cells[0];
    EXPECT_EQ(cells[1].substr(cells[1].find(" of ")), " of " + seeds) << cells[0];
    EXPECT_EQ(cells[1] == seeds + " of " + seeds, length == best_known) << cells[0];
    ++compared;
  }
  EXPECT_EQ(compared, 8);
}

/// The last column of docs/texts.md, for the long tables too: what the program said when it wrote the page of tables.
TEST(TextsPage, TheLastColumnIsWhatThePageOfReproducedTablesHolds) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/reproduced.html");
  const std::regex row(
      "#([a-z0-9-]+)\">[a-z0-9-]+</a></td>((?:<td>\\d+</td>)*)<td class=\"([a-z]+)\">(\\d+)<");
  std::map<std::string, std::string> made;
  for (std::sregex_iterator at(page.begin(), page.end(), row), end; at != end; ++at) {
    const bool is_compared =
        (*at)[4] != "0" || (*at)[2].str().find_first_of("123456789") != std::string::npos;
    made[(*at)[1]] = is_compared ? (*at)[3].str() : "runs";
  }
  EXPECT_GE(made.size(), 8u);
  for (const Item& item : items_of_the_texts()) {
    if (!item.command.starts_with("reproduce ")) continue;
    const auto found = made.find(item.command.substr(10));
    if (found != made.end()) {
      EXPECT_EQ(item.agreement, found->second) << item.where;
    }
  }
}

/// A table that the file has is not made again.
TEST(TextsPage, ReproducedTablesAreTakenUpAgain) {
  const ScratchFolder folder;
  const std::string json = folder.path("t.json");
  ASSERT_EQ(run_clearcut({"reproduce", "captions", "--json", json}).exit_code, 0);
  std::string text = read_file(json);
  text.replace(text.find("Coefficients printed"), 12, "COEFFICIENTS");
  folder.file("t.json", text);
  const auto resumed = run_clearcut({"reproduce", "captions", "triangle", "--json", json, "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.out, ::testing::AllOf(::testing::HasSubstr("COEFFICIENTS printed"),
                                            ::testing::HasSubstr("CPO-kappa figure 10")));
  EXPECT_EQ(run_clearcut({"reproduce", "captions", "--resume"}).exit_code, 2);
}

}  // namespace
}  // namespace clearcut::test_support
