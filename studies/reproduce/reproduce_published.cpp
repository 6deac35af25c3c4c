#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/run.h"
#include "studies/fishhead.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

/// Student's t for 95 % on both sides, of two degrees of freedom.
constexpr double kStudent = 4.303;

/// A way of travel of table 6.5, with what the text prints for it; "" where it prints nothing.
struct Travel {
  const char* name;
  /// Among paths of equal turns or angle the shorter one; the text does not print its weights.
  const char* objective;
  double feed, rapid, total;
  double turns, angle;  ///< 0: not printed
};
constexpr Travel kTravels[] = {{"bidirectional", "20:turns,1:length", 25282, 2395, 27729, 423, 0},
                               {"spiral", "0.2:angle,1:length", 24103, 1838, 25941, 0, 34686}};

/// Of the printed figure: what another grid and other layers of the same kind may make of it.
constexpr double kMostExplained = 0.25;

constexpr const char* kAll = "all";
constexpr std::size_t kQuantities = 8;  ///< of a feature: the columns of the table

void append_figures(RunFigures& to, const Figures& figures) {
  for (const double one : {figures.feed_mm, figures.rapid_mm, figures.feed_mm + figures.rapid_mm,
                           static_cast<double>(figures.turns), figures.turn_angle_deg, figures.time_s,
                           figures.uncut_mm2, static_cast<double>(figures.rapid_in_material)})
    to.push_back(one);
}

/// The quantities of every feature in the order of work, those of the whole program last.
RunFigures planned(const Part& part, const char* objective, bool is_published, std::uint64_t seed) {
  PlanOptions options = options_of_the_published_job();
  options.objective = objective;
  options.seed = seed;
  options.published.solver = VisitSolver{is_published, {}};
  const auto result = pipeline::plan_part(part, options);
  RunFigures figures;
  for (const Workingstep& step : part.workplan) {
    const std::string& name = feature_of(part, step).name;
    const auto& found = result.findings.features;
    const auto at =
        std::find_if(found.begin(), found.end(), [&](const auto& feature) { return feature.name == name; });
    append_figures(figures, at == found.end() ? Figures() : at->figures);
  }
  append_figures(figures, result.findings.all);
  return figures;
}

std::string published_in_words(const RunFigures& figures) {
  const double* all = figures.data() + figures.size() - kQuantities;
  return fmt::format("{:.0f} mm of feed, {:.0f} turns, {:.0f} deg, {:.0f} s", all[0], all[3], all[4], all[5]);
}

std::string mean_text(const std::vector<RunFigures>& runs, std::size_t at) {
  if (runs.size() != kFishheadSeeds) return fmt::format("{:.0f}", runs.front()[at]);
  const auto [mean, interval] = mean_of_seeds({runs[0][at], runs[1][at], runs[2][at]});
  return fmt::format("{:.0f} +- {:.0f}", mean, interval);
}

/// Beside what is printed of the whole part by the text's algorithm.
Cell beside_print(const std::string& ours, double printed) {
  if (printed <= 0) return ours;
  const bool is_near = std::abs(std::stod(ours) - printed) <= kMostExplained * printed;
  return beside(ours, fmt::format("{:.0f}", printed), is_near ? Agreement::kExplained : Agreement::kDiffers,
                "the text states neither its grid nor its layers: half a diameter in every layer of 2 mm is "
                "some 60 m of feed whatever the order");
}

void add_row(Reproduction& result, const std::string& name, const char* by,
             const std::vector<RunFigures>& runs, std::size_t feature, const Travel* printed) {
  const std::array<double, kQuantities> print = printed ? std::array<double, kQuantities>{printed->feed,
                                                                                          printed->rapid,
                                                                                          printed->total,
                                                                                          printed->turns,
                                                                                          printed->angle,
                                                                                          0,
                                                                                          0}
                                                        : std::array<double, kQuantities>{};
  std::vector<Cell> cells{name, by};
  for (std::size_t i = 0; i < kQuantities; ++i)
    cells.push_back(beside_print(mean_text(runs, feature * kQuantities + i), print[i]));
  result.add(cells);
}

void add_travel(Reproduction& result, const Travel& travel, const Part& part, TableRuns& runs) {
  const auto run = [&](bool is_published, std::uint64_t seed) {
    const std::string name =
        fmt::format("{}, {}, seed {}", travel.name, is_published ? "published" : "ours", seed);
    return runs.run(
        name, [&] { return planned(part, travel.objective, is_published, seed); }, published_in_words);
  };
  runs.tell(fmt::format("{}, printed: {:.0f} mm of feed, {}", travel.name, travel.feed,
                        travel.turns > 0 ? fmt::format("{:.0f} turns", travel.turns)
                                         : fmt::format("{:.0f} deg", travel.angle)));
  const auto text = [](double value) { return value > 0 ? fmt::format("{:.0f}", value) : ""; };
  result.add({travel.name, "printed", text(travel.feed), text(travel.rapid), text(travel.total),
              text(travel.turns), text(travel.angle), "", "", ""});
  const std::vector<RunFigures> ours{run(false, 1)};
  std::vector<RunFigures> published;
  for (std::uint64_t seed = 1; seed <= kFishheadSeeds; ++seed) published.push_back(run(true, seed));
  const std::size_t features = part.workplan.size();
  for (std::size_t i = 0; i <= features; ++i) {
    const std::string name = i < features ? feature_of(part, part.workplan[i]).name : kAll;
    add_row(result, name, "published", published, i, i < features ? nullptr : &travel);
    add_row(result, name, "ours", ours, i, nullptr);
  }
}

}  // namespace

PlanOptions options_of_the_published_job() {
  PlanOptions options;
  options.strategy = "tour";
  options.stepover = "0.5";
  options.stepdown = 2;
  options.published.published_grid = true;
  return options;
}

std::pair<double, double> mean_of_seeds(const std::array<double, kFishheadSeeds>& values) {
  double mean = 0, squares = 0;
  for (const double value : values) mean += value / kFishheadSeeds;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, kStudent * std::sqrt(squares / (kFishheadSeeds - 1) / kFishheadSeeds)};
}

Reproduction published_fishhead_table(const TableWatch& watch) {
  const Part part = fishhead(false, {});
  TableRuns runs(watch, std::size(kTravels) * (kFishheadSeeds + 1));
  Reproduction result;
  result.table.title =
      "Tour table 6.5 by programs: the fishhead on the published grid (50 %), layers of 2 mm";
  result.table.columns = {{"feature", Align::kLeft},
                          {"order by", Align::kLeft},
                          {"feed, mm"},
                          {"rapid"},
                          {"total"},
                          {"turns"},
                          {"angle, deg"},
                          {"time, s"},
                          {"left uncut, mm2"},
                          {"rapids in material"}};
  for (const Travel& travel : kTravels) {
    if (&travel != kTravels) result.table.add_rule();
    add_travel(result, travel, part, runs);
  }
  result.table.notes.push_back(fmt::format(
      "published: mean of {} seeds and its 95 % interval (Student's t); ours: one seed, the same grid",
      kFishheadSeeds));
  result.table.notes.push_back(
      "every program is checked, and none is clean: the grid leaves a rim, over which rapids of later layers "
      "and "
      "features end; what of it stands in their way below is fed through");
  result.table.notes.push_back(
      "POCKET6 is not machined by either, which program and certificate say: the cutter's centre has 4 mm "
      "there, and no "
      "point of the grid lies in them");
  result.table.notes.push_back(
      "clearcut plan examples/fishhead.p21 --strategy tour --stepover 0.5 --stepdown 2 --grid published "
      "--solver published --objective 20:turns,1:length");
  return result;
}

}  // namespace clearcut::studies
