#include "studies/reproduce/reproduce_published.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "pipeline/run.h"
#include "studies/fishhead.h"

namespace clearcut::studies {
namespace {

constexpr int kSeeds = 3;
/// Among paths of equal turns or angle the shorter one; the text does not print its weights.
constexpr const char *kBidirectional = "20:turns,1:length", *kSpiral = "0.2:angle,1:length";

struct Sample {
  double feed = 0, rapid = 0, total = 0, turns = 0, angle = 0, time = 0, uncut = 0;
};

Sample sample_of(const Figures& figures) {
  return {figures.feed_mm,
          figures.rapid_mm,
          figures.feed_mm + figures.rapid_mm,
          static_cast<double>(figures.turns),
          figures.turn_angle_deg,
          figures.time_s,
          figures.uncut_mm2};
}

/// Of one feature, or of all: one for each seed.
using Samples = std::vector<Sample>;

constexpr const char* kAll = "all";

/// By feature, in the order of work, the sums last.
struct Runs {
  std::vector<std::string> names;
  std::map<std::string, Samples> samples;
};

void run(const char* objective, bool is_published, std::uint64_t seed, Runs& runs) {
  resolve::PlanOptions options;
  options.strategy = "tour";
  options.stepover = "0.5";
  options.stepdown = 2;
  options.objective = objective;
  options.seed = seed;
  options.published.published_grid = true;
  options.published.solver = VisitSolver{is_published, {}};
  const auto result = pipeline::plan_part(fishhead(false, {}), options);
  for (const FeatureFindings& feature : result.findings.features) {
    if (runs.samples[feature.name].empty()) runs.names.push_back(feature.name);
    runs.samples[feature.name].push_back(sample_of(feature.figures));
  }
  runs.samples[kAll].push_back(sample_of(result.findings.all));
}

/// Mean and 3 sigma / sqrt(n), eq. 4.11.
std::string mean_text(const Samples& samples, double Sample::*member) {
  const auto n = static_cast<double>(samples.size());
  double mean = 0, squares = 0;
  for (const Sample& one : samples) mean += one.*member / n;
  for (const Sample& one : samples) squares += (one.*member - mean) * (one.*member - mean);
  if (samples.size() < 2) return fmt::format("{:.0f}", mean);
  return fmt::format("{:.0f} +- {:.0f}", mean, 3 * std::sqrt(squares / (n - 1) / n));
}

void add_row(Reproduction& result, const std::string& name, const char* by, const Samples& samples) {
  std::vector<Cell> cells{name, by};
  for (double Sample::*member : {&Sample::feed, &Sample::rapid, &Sample::total, &Sample::turns,
                                 &Sample::angle, &Sample::time, &Sample::uncut})
    cells.emplace_back(mean_text(samples, member));
  result.add(cells);
}

void add_objective(Reproduction& result, const char* objective) {
  Runs published, ours;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) run(objective, true, seed, published);
  run(objective, false, 1, ours);
  for (const std::string& name : published.names) {
    add_row(result, name, "published", published.samples[name]);
    add_row(result, name, "ours", ours.samples[name]);
  }
  add_row(result, kAll, "published", published.samples[kAll]);
  add_row(result, kAll, "ours", ours.samples[kAll]);
}

}  // namespace

Reproduction published_fishhead_table() {
  Reproduction result;
  result.table.title =
      "Tour table 6.5 by programs: the fishhead on the published grid (50 %), layers of 2 mm";
  result.table.columns = {{"feature", report::Align::kLeft},
                          {"order by", report::Align::kLeft},
                          {"feed, mm"},
                          {"rapid"},
                          {"total"},
                          {"turns"},
                          {"angle, deg"},
                          {"time, s"},
                          {"left uncut, mm2"}};
  result.add({"bidirectional", "printed", "25282", "2395", "27729", "423", "", "", ""});
  add_objective(result, kBidirectional);
  result.table.add_rule();
  result.add({"spiral", "printed", "24103", "1838", "25941", "", "34686", "", ""});
  add_objective(result, kSpiral);
  result.table.notes.push_back(fmt::format(
      "published: mean of {} seeds +- 3 sigma / sqrt(n) (eq. 4.11); ours: one seed, the same grid", kSeeds));
  result.table.notes.push_back(
      "every layer of every feature has a program, checked: the grid leaves a rim, which is the last column");
  result.table.notes.push_back(
      "clearcut plan examples/fishhead.p21 --strategy tour --stepover 0.5 --stepdown 2 --grid published "
      "--solver "
      "published --objective 20:turns,1:length");
  return result;
}

}  // namespace clearcut::studies
