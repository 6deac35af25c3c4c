#include "studies/reproduce/reproduce.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "studies/fishhead.h"
#include "studies/reproduce/page/reproduction_page.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

/// Tables dearer than this, in seconds of a core, are not made in tests.
constexpr double kQuick = 3;
/// Those that take no longer are formulas, whose every printed cell agrees or is explained by the print itself.
constexpr double kOfFormulas = 0.1;

/// Each table is made once for all tests.
const Reproduction& made(const ReproducibleTable& table) {
  static std::map<std::string, Reproduction> all;
  const auto found = all.find(table.name);
  return found != all.end() ? found->second : all.emplace(table.name, table.make()).first->second;
}

/// One figure and nothing else.
bool is_number(const std::string& text) {
  return text.find_first_not_of("0123456789.") == std::string::npos;
}

TEST(Reproduction, CellsAgreeToThePrintedDigit) {
  EXPECT_EQ(beside(0.5434, 0.543, 3).compared.at(0).agreement, Agreement::kAgrees);
  EXPECT_EQ(beside(0.5436, 0.543, 3).compared.at(0).agreement, Agreement::kDiffers);
  EXPECT_EQ(beside(0.5436, 0.543, 3, {"why", 0.01}).compared.at(0).agreement, Agreement::kExplained);
  EXPECT_EQ(beside(0.5436, 0.543, 3, {"why", 0.001}).compared.at(0).agreement, Agreement::kDiffers);
  EXPECT_EQ(beside(0.5436, 0.543, 3).text, "0.544 (differs)");
}

/// A word says what was done: the system ran, a formula was evaluated, printed figures were added up.
TEST(Reproduction, ThreeWordsForFiguresThatAreThePrintedOnes) {
  EXPECT_EQ(computed(0.5434, 0.543, 3).compared.at(0).agreement, Agreement::kComputed);
  EXPECT_EQ(computed(0.5436, 0.543, 3).compared.at(0).agreement, Agreement::kDiffers);
  EXPECT_EQ(of_print(2395 + 25282, 27677, 0).compared.at(0).agreement, Agreement::kPrinted);
  EXPECT_EQ(of_print(2395 + 25282, 27729, 0).compared.at(0).agreement, Agreement::kDiffers);
  EXPECT_EQ(of_print(2395 + 25282, 27729, 0, {"why", 0.01}).compared.at(0).agreement, Agreement::kExplained);
  for (const Agreement one : kAgreements) EXPECT_EQ(is_same(one), one < Agreement::kExplained);
}

int decimals_of(const std::string& printed) {
  const auto point = printed.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(printed.size() - point) - 1;
}

/// A figure that agrees no longer does so where the last printed digit is one more or less. Returns the number of changes.
int expect_that_the_last_digit_turns_every_cell(const Reproduction& table) {
  int changes = 0;
  for (const Compared& one : table.compared) {
    if (!is_same(one.agreement) || !is_number(one.printed)) continue;
    const int decimals = decimals_of(one.printed);
    const double last = std::pow(10.0, -decimals), printed = std::stod(one.printed);
    for (const double turned : {printed + last, printed - last}) {
      const Cell cell = beside(std::stod(one.ours), turned, decimals);
      EXPECT_EQ(cell.compared.front().agreement, Agreement::kDiffers) << one.printed;
      ++changes;
    }
  }
  return changes;
}

void expect_a_reason_for_every_difference(const Reproduction& table) {
  for (const Compared& one : table.compared)
    EXPECT_EQ(one.reason.empty(), is_same(one.agreement)) << one.printed;
}

/// From its heading to the next.
std::string section_of(const std::string& page, const std::string& table) {
  const auto begin = page.find("<h2 id=\"" + table + "\"");
  if (begin == std::string::npos) return "";
  return page.substr(begin, std::min(page.find("<h2", begin + 1), page.find("</body>", begin)) - begin);
}

/// The printed figures of the cells of a section, in its order.
std::vector<std::string> printed_in(const std::string& section) {
  std::vector<std::string> printed;
  const std::regex title("title=\"printed ([^\"]*)\"");
  for (std::sregex_iterator at(section.begin(), section.end(), title), end; at != end; ++at)
    printed.push_back((*at)[1]);
  return printed;
}

/// Cell by cell, notes and reasons too; of those that hold seconds the printed cells.
void expect_that_the_page_holds(const ReproducibleTable& table, const std::string& page) {
  const std::string written =
      section_of(reproduction_page({{table.name, table.place, made(table)}}), table.name);
  const std::string there = section_of(page, table.name);
  ASSERT_FALSE(written.empty());
  const bool holds_seconds = table.name == "lattices" || table.name == "grid";
  if (holds_seconds) {
    EXPECT_EQ(printed_in(there), printed_in(written));
  } else {
    EXPECT_EQ(there, written);
  }
}

/// Figure 9's star keeps its reflex corners: six similar stars without an arc, as the program cuts them.
TEST(Reproduction, ContoursAreDrawnAsTheyArePlanned) {
  const Reproduction& captions = made(reproducible_table("captions"));
  ASSERT_EQ(captions.figures.size(), 3U);
  EXPECT_EQ(captions.figures[0].svg.find('A'), std::string::npos) << "an arc in a path";
}

TEST(Reproduction, AWholeTableIsAsGoodAsItsWorstCell) {
  Reproduction result;
  result.add({"a", beside(1, 1, 0)});
  EXPECT_EQ(result.agreement(), Agreement::kAgrees);
  result.add({"b", beside(2, 1, 0, {"another machine", 1})});
  EXPECT_EQ(result.agreement(), Agreement::kExplained);
  result.add({beside(2, 1, 0)});
  EXPECT_EQ(result.agreement(), Agreement::kDiffers);
  EXPECT_EQ(result.summary(), "3 printed cells: 1 agree, 0 computed, 0 sums of print, 1 explained, 1 differ");
  EXPECT_EQ(result.compared.at(1).row, 1u);
  EXPECT_EQ(result.compared.at(1).column, 1u);
}

TEST(Reproduction, TablesAreReadBackAsTheyWereWritten) {
  Reproduction result;
  result.table.title = "title";
  result.table.columns = {{"name", Align::kLeft}, {"value"}};
  result.add({"a", beside(1, 1, 0)});
  result.add_rule();
  result.add({"b", beside(2, 1, 0, {"another machine", 1})});
  result.figures.push_back({"caption < 1", "<svg></svg>"});
  const std::string json = reproduction_json({{"one", "somewhere", result}});
  const auto read = read_reproduction_json(json, "t.json");
  EXPECT_EQ(reproduction_json(read), json);
  EXPECT_EQ(reproduction_page(read), reproduction_page({{"one", "somewhere", result}}));
  EXPECT_EQ(read.at(0).reproduction.compared.at(1).row, 2u);
  EXPECT_NE(reproduction_page(read).find("<figure><svg></svg><figcaption>caption &lt; 1</figcaption>"),
            std::string::npos);
  EXPECT_THROW(read_reproduction_json("{}x", "t.json"), InputError);
  EXPECT_THROW(read_reproduction_json("[{}]", "t.json"), InputError);
}

/// A cell agrees to its printed digit; were every constant behind a table 1 % larger or smaller, some cell would differ.
TEST(Reproduction, AChangeOfOnePerCentShowsInEveryTableThatAgrees) {
  int tables = 0;
  for (const auto& table : reproducible_tables()) {
    if (table.cost_s > kOfFormulas) continue;
    if (std::string(table.name) == "claims") continue;  // stated to whole per cents
    const Reproduction& figures = made(table);
    for (const double factor : {0.99, 1.01}) {
      int differ = 0, cells = 0;
      for (const Compared& one : figures.compared) {
        if (!is_number(one.printed)) continue;
        ++cells;
        const Cell changed =
            beside(factor * std::stod(one.ours), std::stod(one.printed), decimals_of(one.printed));
        differ += is_same(changed.compared.front().agreement) ? 0 : 1;
      }
      EXPECT_GE(2 * differ, cells) << table.name << " " << factor;
    }
    ++tables;
  }
  EXPECT_GE(tables, 4);
}

/// A table that was broken off is taken up: the runs that are there are not made again, and give the same figures to the bit.
TEST(TableRuns, AreTakenUpAgain) {
  std::string kept;
  std::vector<std::string> said;
  TableWatch watch;
  watch.append = [&](const std::string& line) { kept += line; };
  watch.say = [&](const std::string& text) { said.push_back(text); };
  const auto words = [](const RunFigures& figures) { return std::to_string(figures.size()); };
  const RunFigures one{1.0 / 3, 1e-300, -0.1, 25282}, two{2.0 / 3};
  TableRuns first(watch, 2);
  EXPECT_EQ(first.run(
                "spiral, seed 1", [&] { return one; }, words),
            one);
  EXPECT_EQ(first.run(
                "spiral, seed 2", [&] { return two; }, words),
            two);

  watch.kept = kept.substr(0, kept.size() - 1);  // broken off in the last line
  kept.clear();
  std::size_t done = 0;
  watch.count = [&](std::size_t so_many, std::size_t) { done = so_many; };
  TableRuns again(watch, 2);
  const auto never = []() -> RunFigures { throw std::logic_error("made again"); };
  EXPECT_EQ(again.run("spiral, seed 1", never, words), one);
  EXPECT_EQ(kept, "");
  EXPECT_EQ(again.run(
                "spiral, seed 2", [&] { return two; }, words),
            two);
  EXPECT_NE(kept, "");
  EXPECT_EQ(done, 2u);
  EXPECT_EQ(said.at(2), "spiral, seed 1: 4 (kept)");
}

/// Layers of 2 mm, as the text has it, on a grid of half the diameter.
TEST(PublishedFishhead, IsPlannedInThePrintedLayers) {
  const PlanOptions options = options_of_the_published_job();
  EXPECT_EQ(options.stepdown, 2);
  EXPECT_EQ(options.stepover, "0.5");
  EXPECT_TRUE(options.published.published_grid);
}

/// 4.303 sigma / sqrt(3).
TEST(PublishedFishhead, MeanOfThreeSeedsAndItsInterval) {
  const auto [mean, interval] = mean_of_seeds({1, 2, 3});
  EXPECT_NEAR(mean, 2, 1e-12);
  EXPECT_NEAR(interval, 2.4843, 1e-4);
}

/// Runs of the whole table that are kept, so that none is made: every quantity of the whole part is `share` times the printed feed.
std::string kept_runs_of_fishhead(double share) {
  std::string lines;
  TableWatch writing;
  writing.append = [&](const std::string& line) { lines += line; };
  TableRuns runs(writing, 8);
  const std::size_t figures = 8 * (fishhead(false, {}).workplan.size() + 1);
  for (const auto& [travel, feed] : {std::pair("bidirectional", 25282.0), std::pair("spiral", 24103.0)}) {
    for (const char* by : {"ours, seed 1", "published, seed 1", "published, seed 2", "published, seed 3"})
      runs.run(
          std::string(travel) + ", " + by, [&] { return RunFigures(figures, share * feed); },
          [](const RunFigures&) { return std::string(); });
  }
  return lines;
}

/// A quarter of the printed figure is explained by another grid and other layers, more is not.
TEST(PublishedFishhead, ExplainsUpToAQuarter) {
  for (const auto& [share, explained] : {std::pair(1.2495, 2), std::pair(1.2505, 0)}) {
    TableWatch watch;
    watch.kept = kept_runs_of_fishhead(share);
    int feeds = 0;
    for (const Compared& cell : published_fishhead_table(watch).compared)
      feeds +=
          (cell.printed == "25282" || cell.printed == "24103") && cell.agreement == Agreement::kExplained;
    EXPECT_EQ(feeds, explained) << share;
  }
}

/// docs/texts.md: name of a table -> what its last column says.
std::map<std::string, std::string> documented_agreement() {
  std::map<std::string, std::string> said;
  std::istringstream page(read_file(CLEARCUT_SOURCE_DIR "/docs/texts.md"));
  const std::regex row(R"(.*`clearcut reproduce ([a-z0-9-]+)` \| ([a-z ]+) \|)");
  std::smatch match;
  for (std::string line; std::getline(page, line);)
    if (std::regex_match(line, match, row)) said[match[1]] = match[2];
  return said;
}

TEST(Texts, EveryTableIsOnThePageOfTheTexts) {
  const auto said = documented_agreement();
  for (const auto& table : reproducible_tables()) EXPECT_EQ(said.count(table.name), 1u) << table.name;
  for (const auto& [name, agreement] : said) EXPECT_EQ(reproducible_table(name).name, name);
}

/// Where a table differs its row says in how many cells of how many.
TEST(Texts, RowsThatDifferSayInHowManyCells) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/reproduced.html");
  std::istringstream texts(read_file(CLEARCUT_SOURCE_DIR "/docs/texts.md"));
  const std::regex row(
      R"(.* ([0-9]+ of [0-9]+) cells differ.*`clearcut reproduce ([a-z0-9-]+)` \| differs \|)");
  const std::regex summary(R"(([0-9]+) printed cells: .*? ([0-9]+) differ<)");
  std::smatch match, there;
  int compared = 0;
  for (std::string line; std::getline(texts, line);) {
    if (!line.ends_with("| differs |")) continue;
    ASSERT_TRUE(std::regex_match(line, match, row)) << line;
    const std::string section = section_of(page, match[2]);
    if (section.empty()) continue;  // of the long tables
    ASSERT_TRUE(std::regex_search(section, there, summary)) << match[2];
    EXPECT_EQ(match[1], there[2].str() + " of " + there[1].str()) << match[2];
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

/// CPO-rho table 3, by its own figures: at a step of 0.9 a loop over its segment is a matter of the angle alone, and stops do not make
/// up for the rest, as a segment has two.
TEST(Texts, NoRatioOfLoopsToSegmentsHasThePrintedTimes) {
  const auto& notes = made(reproducible_table("cutter-trend")).table.notes;
  static const std::regex stops(
      R"(no one ratio .* ([0-9]+) stops more .*, ([0-9.]+) for each of 10 corners of 6 contours, .* )"
      R"(loops ([0-9]+) more at R = 9, ([0-9.]+) for each of 10 corners of 1 contour; a segment has 2)");
  std::smatch match;
  ASSERT_TRUE(std::regex_match(notes.front(), match, stops)) << notes.front();
  EXPECT_EQ(std::stoi(match[1]), std::lround(60 * (17.23 - 15.46) / (2 * 0.177)));
  EXPECT_EQ(std::stoi(match[3]), std::lround(60 * (4.76 - 3.49) / (2 * 0.177)));
  for (const std::size_t at_a_corner : {2U, 4U}) EXPECT_GT(std::stod(match[at_a_corner]), 2);
}

/// Points of 5.3.2 and feed of table 6.5: (1096 - 1) 5 mm in each of five layers are more than all features take.
TEST(Texts, PrintedPointsAndPrintedFeedExcludeEachOther) {
  const std::string note = made(reproducible_table("points")).table.notes.back();
  EXPECT_NE(
      note.find(
          "the 5 layers of FACE2 take at least 27.4 m of feed in any order, and table 6.5 prints 25.3 m"),
      std::string::npos)
      << note;
}

/// All that holds of a table that takes no longer than a second or two, in one test, as each is made once for it.
TEST(Texts, QuickTablesAreAsThePagesSay) {
  const auto said = documented_agreement();
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/reproduced.html");
  int tables = 0, changes = 0;
  for (const auto& table : reproducible_tables()) {
    if (table.cost_s >= kQuick) continue;
    SCOPED_TRACE(table.name);
    ++tables;
    EXPECT_EQ(said.at(table.name), name_of(made(table).agreement()));
    expect_a_reason_for_every_difference(made(table));
    changes += expect_that_the_last_digit_turns_every_cell(made(table));
    expect_that_the_page_holds(table, page);
  }
  EXPECT_GE(tables, 8);
  EXPECT_GE(changes, 250);
}

/// The whole numbers in the rows that are print alone; others there follow from them.
std::vector<std::string> cells_of_print(const std::string& section) {
  std::vector<std::string> cells;
  const std::regex row("<tr>(<td>(?:printed|[a-z]+</td><td>printed).*?)</tr>"),
      cell("<td>([0-9]{2,})(?: [*])?</td>");
  for (std::sregex_iterator at(section.begin(), section.end(), row), end; at != end; ++at) {
    const std::string text = (*at)[1];
    for (std::sregex_iterator one(text.begin(), text.end(), cell); one != end; ++one)
      cells.push_back((*one)[1]);
  }
  return cells;
}

/// Longer tables are not made here: every printed figure that their page holds stands in the source that prints it.
TEST(Texts, PrintedFiguresOfLongTablesAreThoseOfTheirSources) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/reproduced.html");
  int figures = 0;
  for (const auto& [table, source] : {std::pair("fishhead", "reproduce_orders.cpp"),
                                      std::pair("fishhead-published", "reproduce_published.cpp"),
                                      std::pair("objectives", "reproduce_objectives.cpp")}) {
    const std::string folder = CLEARCUT_SOURCE_DIR "/studies/reproduce/";
    const std::string code = read_file(folder + source) + read_file(folder + "printed_figures.h");
    const std::string section = section_of(page, table);
    std::vector<std::string> printed = printed_in(section);
    for (const std::string& cell : cells_of_print(section)) printed.push_back(cell);
    EXPECT_FALSE(printed.empty()) << table;
    for (const std::string& figure : printed) {
      std::string shortest = std::regex_replace(figure, std::regex("[.]?0+$"), "");
      if (figure.find('.') == std::string::npos) shortest = figure;
      const std::regex number("(^|[^0-9.])" + std::regex_replace(shortest, std::regex("[.]"), "[.]") +
                              "([.]?0*)([^0-9.]|$)");
      EXPECT_TRUE(std::regex_search(code, number)) << table << ": " << figure;
      ++figures;
    }
  }
  EXPECT_GE(figures, 55);
}

/// The table of the algorithm in docs/tour.md takes half an hour: each of its rows has the print, and the number of runs, of its source.
TEST(Texts, TheTableOfTheAlgorithmHasTheRowsOfItsSource) {
  const std::string code = read_file(CLEARCUT_SOURCE_DIR "/studies/reproduce/reproduce_tour.cpp");
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/tour.md", 1 << 20);
  const std::regex row(
      R"re(\{"([a-z0-9.]+)", "([a-z]+)", ([0-9]+), "([0-9.]*)", ([0-9.]+), ([0-9]+), [0-9]+)re");
  int rows = 0;
  for (std::sregex_iterator at(code.begin(), code.end(), row), end; at != end; ++at, ++rows) {
    std::string points = (*at)[1];
    if (points.ends_with(".tsp")) {
      points.erase(points.size() - 4);
      std::transform(points.begin(), points.end(), points.begin(),
                     [](unsigned char c) { return std::toupper(c); });
    }
    const std::string print = std::regex_replace((*at)[5].str(), std::regex("[.]0$"), "(?:[.]0)?");
    std::string cells = "\n";
    for (const std::string& cell : {points, (*at)[2].str(), (*at)[3].str(), (*at)[4].str()})
      cells += "\\| *" + cell + " *";
    const std::regex there(cells + "\\| *" + print + " % [^|]*\\|[^|]*\\|[^|]*\\| *" + (*at)[6].str() +
                           " *\\|");
    EXPECT_TRUE(std::regex_search(page, there)) << (*at)[0];
  }
  EXPECT_EQ(rows, 9);
}

/// CPO-kappa table 1: the methods of either shape are in the printed order, kappa's path first.
TEST(Reproduction, MethodsOfTheTableOfLengthsAreInThePrintedOrder) {
  const Reproduction& table = made(reproducible_table("lengths"));
  std::map<std::string, std::map<double, std::string>> printed, ours;  // shape -> total -> method
  for (const auto& row : table.table.rows) {
    if (row.size() < 8 || row[6].empty()) continue;
    printed[row[0]][std::stod(row[6])] = row[1];
    ours[row[0]][std::stod(row[7])] = row[1];
  }
  const auto order = [](const std::map<double, std::string>& by_total) {
    std::vector<std::string> methods;
    for (const auto& [total, method] : by_total) methods.push_back(method);
    return methods;
  };
  ASSERT_EQ(printed.size(), 2U);
  for (const auto& [shape, by_total] : printed) {
    EXPECT_EQ(order(ours[shape]), order(by_total)) << shape;
    EXPECT_EQ(by_total.begin()->second, "proposed (lom)") << shape;
  }
}

/// "V_f = 76 mm/min as fitted ... at most 41 %" of the notes below a table.
std::string law_in(const Reproduction& table) {
  const std::regex law(
      "V_f = ([0-9]+) mm/min as fitted to all of them: relative residual [0-9]+ % [(][^)]*[)], at most "
      "[0-9]+ %");
  std::smatch found;
  for (const std::string& note : table.table.notes)
    if (std::regex_search(note, found, law)) return found[0];
  return "";
}

/// CPO-rho table 3 and its trend have one fitted feed, with its residual; the trend's second row is by it.
TEST(Reproduction, TableThreeAndItsTrendAreByOneFittedFeed) {
  const Reproduction &cutters = made(reproducible_table("cutters")),
                     &trend = made(reproducible_table("cutter-trend"));
  EXPECT_NE(law_in(cutters), "");
  EXPECT_EQ(law_in(trend), law_in(cutters));
  EXPECT_TRUE(law_in(trend).starts_with("V_f = " + trend.table.rows.at(1).at(0) + " mm/min"));
}

/// (20.46 - 13) / (20.46 - 10) (2.03 - 2 (1 + 10) 0.177 / 60) min.
TEST(Reproduction, TableThreeSaysThatNoConvexOutlineHasItsTimes) {
  const auto& notes = made(reproducible_table("cutters")).table.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.ends_with("up to 10 corners takes at least 1.40 min at R = 13, where 1.14 is printed");
  }));
}

TEST(Texts, CheapTablesComeFirst) {
  double before = 0;
  for (const auto& table : reproducible_tables()) {
    EXPECT_GE(table.is_long ? 1e9 : table.cost_s, before) << table.name;
    if (!table.is_long) before = table.cost_s;
  }
  EXPECT_LT(reproducible_tables().front().cost_s, 1);
}

}  // namespace
}  // namespace clearcut::studies
