#include "terminal/json_tables.h"

#include <clearcut/error.h>
#include <clearcut/options.h>
#include <clearcut/report.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "terminal/option_table.h"

namespace clearcut::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Rounded as in the certificate, so that the same question gives the same bytes; non-numbers are null.
Json number(double value) {
  constexpr double kUnit = 1e6;
  return std::isfinite(value) ? Json(std::round(value * kUnit) / kUnit) : Json();
}

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? number(*value) : Json();
}

Json box_json(const Box& box) {
  if (box.empty()) return nullptr;
  return {{"x", {number(box.min.x), number(box.max.x)}}, {"y", {number(box.min.y), number(box.max.y)}}};
}

std::string printed(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Json run_json(const StrategyRun& run, bool fastest) {
  Json json{{"strategy", run.strategy}, {"planned", run.figures.has_value()}};
  if (!run.figures) {
    json["refusal"] = run.refusal;
    return json;
  }
  const auto& f = *run.figures;
  json["clean"] = f.clean;
  json["fastest"] = fastest;
  json["feed_mm"] = number(f.feed_mm);
  json["lower_bound_mm"] = number(f.lower_bound_mm);
  json["retracts"] = f.retracts;
  json["time_s"] = number(f.time_s);
  json["published_time_s"] = number(run.published.seconds());
  json["uncut_thickness_mm"] = number(f.uncut_thickness_mm);
  json["uncut_mm2"] = number(f.uncut_mm2);
  json["gouge_mm"] = number(f.gouge_mm);
  json["engagement_max_deg"] = number(f.engagement.max_deg);
  json["engagement_mean_deg"] = number(f.engagement.mean_deg);
  return json;
}

Json tool_json(const Tool& tool) {
  return {{"number", tool.number},
          {"kind", name_of(tool.kind)},
          {"diameter_mm", number(tool.diameter)},
          {"teeth", tool.teeth},
          {"name", tool.name}};
}

Json tool_run_json(const ToolRun& run, bool fastest, bool best) {
  Json json{{"tool", tool_json(run.tool)}, {"fits", run.fits}};
  if (!run.fits) {
    json["refusal"] = run.refusal;
    return json;
  }
  json["clean"] = run.clean;
  json["fastest"] = fastest;
  json["best"] = best;
  json["spindle_rpm"] = number(run.spindle_rpm);
  json["feed_mm_per_min"] = number(run.feed_mm_per_min);
  json["feed_mm"] = number(run.feed_mm);
  json["time_s"] = number(run.time_s);
  json["published_time_s"] = number(run.published_s);
  json["unreachable_mm2"] = number(run.unreachable_mm2);
  json["climb_mm"] = number(run.figures.engagement.climb_mm);
  json["conventional_mm"] = number(run.figures.engagement.conventional_mm);
  if (const auto& load = run.figures.load) {
    json["max_force_n"] = number(load->max_force_n);
    json["energy_j"] = number(load->energy_j);
    json["wear"] = number(load->wear);
  }
  return json;
}

/// null: open, any cutter fits.
Json cutter_json(double diameter) {
  return diameter > kOpenReach / 2 ? Json() : number(diameter);
}

/// The loops of all regions, to be filled by the even-odd rule.
std::string path_of_regions(const Regions& regions) {
  std::string path;
  for (const Region& region : regions) {
    path += svg_path(region.outer());
    for (const Loop& island : region.islands()) path += svg_path(island);
  }
  return path;
}

Json feature_json(const Feature& feature, double largest_cutter) {
  std::size_t islands = 0;
  for (const auto& region : feature.target) islands += region.islands().size();
  return {{"name", feature.name},
          {"kind", name_of(feature.kind)},
          {"source", feature.source},
          {"top_z", number(feature.top_z)},
          {"floor_z", number(feature.floor_z)},
          {"extent_mm", box_json(box(feature.target))},
          {"area_mm2", number(area(feature.target))},
          {"path", path_of_regions(feature.target)},
          {"regions", feature.target.size()},
          {"islands", islands},
          {"largest_cutter_mm", cutter_json(largest_cutter)}};
}

/// Outlines beyond so many are listed without their curves.
constexpr int kDrawnOutlines = 2000;

Json outline_json(const OutlineSummary& one) {
  return {{"number", one.number},
          {"layer", one.layer},
          {"extent_mm", box_json(one.box)},
          {"diameter_mm", or_null(one.diameter)},
          {"path", one.number <= kDrawnOutlines ? Json(svg_path(one.loop)) : Json()},
          {"area_mm2", number(one.area)},
          {"within", one.within > 0 ? Json(one.within) : Json()},
          {"depth_mm", or_null(one.depth)},
          {"role", one.role},
          {"says_role", one.says_role}};
}

Json found_json(const Diagnostics& diagnostics) {
  Json found = Json::array();
  for (const auto& item : diagnostics.items()) {
    const char* kind = item.severity == Severity::kNote      ? "note"
                       : item.severity == Severity::kRepair  ? "repair"
                       : item.severity == Severity::kWarning ? "warning"
                                                             : "skipped";
    found.push_back({{"kind", kind}, {"where", item.where}, {"what", item.what}});
  }
  return found;
}

Json stock_json(const Part& part) {
  if (!part.stock) return nullptr;
  return {{"extent_mm", box_json(part.stock->plan)},
          {"z_bottom", number(part.stock->z_bottom)},
          {"z_top", number(part.stock->z_top)}};
}

Json info_json(const PartInfo& info) {
  const Part& part = info.part;
  Json json{{"schema", "clearcut-info-1"}, {"part", part.name}, {"source_file", part.source_file}};
  json["stock"] = stock_json(part);
  for (const char* list : {"tools", "features", "workingsteps", "outlines"}) json[list] = Json::array();
  for (const Tool& tool : part.tools) json["tools"].push_back(tool_json(tool));
  const std::vector<double> cutters = largest_cutters(part, Tolerances{});
  for (std::size_t i = 0; i < cutters.size(); ++i)
    json["features"].push_back(feature_json(part.features[i], cutters[i]));
  for (const auto& step : part.workplan)
    json["workingsteps"].push_back({{"name", step.name}, {"feature", feature_of(part, step).name}});
  for (const auto& one : info.overview.outlines) json["outlines"].push_back(outline_json(one));
  json["asks"] = info.asks;
  json["answers"] = Json::array();
  for (const auto& one : info.overview.answers)
    json["answers"].push_back({{"option", one.option}, {"value", one.value}});
  json["found"] = found_json(part.diagnostics);
  return json;
}

}  // namespace

std::string strategies_json(const Part& part, const std::vector<StrategyRun>& runs) {
  const StrategyRun* best = fastest_clean(runs);
  Json json{{"schema", "clearcut-compare-1"}, {"part", part.name}, {"strategies", Json::array()}};
  for (const auto& run : runs) json["strategies"].push_back(run_json(run, &run == best));
  return printed(json);
}

std::string tools_json(const Part& part, const ToolComparison& comparison) {
  const ToolRun* best = best_tool(comparison);
  const ToolRun* fastest = fastest_clean(comparison.runs);
  Json json{
      {"schema", "clearcut-tools-1"}, {"part", part.name}, {"tools", Json::array()}, {"sequence", nullptr}};
  for (const auto& run : comparison.runs)
    json["tools"].push_back(tool_run_json(run, &run == fastest, &run == best));
  if (comparison.sequence) {
    Json tools = Json::array();
    for (const Tool& tool : comparison.sequence->tools) tools.push_back(tool_json(tool));
    json["sequence"] = {{"tools", tools}, {"time_s", number(comparison.sequence->time_s)}};
  }
  return printed(json);
}

std::string infos_json(const std::vector<PartInfo>& infos) {
  if (infos.size() == 1) return printed(info_json(infos.front()));
  Json json{{"schema", "clearcut-info-1"}, {"setups", Json::array()}};
  for (const PartInfo& info : infos) json["setups"].push_back(info_json(info));
  return printed(json);
}

namespace {

/// The equivalent in a job: table and key, whether the key means the opposite, and whether the value is a number.
/// Null if a job has no key for it.
Json job_key_json(const OptionText& option) {
  const Row* row = option.positional ? nullptr : row_named(option.names.back().substr(2));
  if (!row || row->table == JobTable::kNone) return nullptr;
  return {{"table", name_of(row->table)},
          {"key", row->job_key()},
          {"opposite", row->key_is_opposite},
          {"number", is_number(row->kind) || row->kind == ValueKind::kSeed}};
}

}  // namespace

namespace {

/// What a page needs to give an option its place: whom it is for, and what its numbers are counted in.
Json place_json(const OptionText& option) {
  static constexpr std::array kLevels{"first", "rest", "research"};
  const Row* row = option.positional ? nullptr : row_named(option.names.back().substr(2));
  if (!row) return nullptr;
  return {{"level", kLevels.at(static_cast<std::size_t>(row->level))},
          {"choice", row->kind == ValueKind::kChoice},
          {"unit", row->counted_in()},
          {"default", row->fallback},
          {"operations", row->is_of_operations}};
}

}  // namespace

std::string options_json(const CLI::App& app) {
  Json all = Json::object();
  for (const CommandText& command : commands_of(app)) {
    Json options = Json::array();
    for (const OptionText& option : command.options)
      options.push_back({{"names", option.names},
                         {"value", option.value},
                         {"help", option.help},
                         {"group", option.group},
                         {"values", option.values},
                         {"many", option.many},
                         {"file", option.file},
                         {"positional", option.positional},
                         {"job", job_key_json(option)},
                         {"place", place_json(option)}});
    all[command.name] = options;
  }
  return all.dump(1);
}

}  // namespace clearcut::cli
