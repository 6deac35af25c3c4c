#include "report/certificate/question_relations.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/tolerances.h"
#include "model/machine.h"
#include "report/certificate/certificate_json.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;

/// Share of a value that its text may be rounded by.
constexpr double kOfText = 1e-3;
/// Index of values that belong to no workingstep.
constexpr int kOfWhole = -1;

/// Number with which a text begins; nothing if it begins with none.
std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end == text.data()) return std::nullopt;
  return value;
}

std::string item(const char* list, std::size_t i, const char* name) {
  return std::string("/") + list + "/" + std::to_string(i) + "/" + name;
}

/// Every workingstep of the question has one entry among the features, in the same order.
void check_workplan(const Json& certificate, Sentences& out) {
  if (is_without_part(certificate)) return;
  const Json& steps = field_at(certificate, "question/workplan");
  const Json& features = field_at(certificate, "features");
  if (features.size() != steps.size())
    out.push_back("/features: are " + std::to_string(features.size()) + ", and the workplan has " +
                  std::to_string(steps.size()) + " workingsteps");
  for (std::size_t i = 0; i < std::min(features.size(), steps.size()); ++i) {
    if (number_at(features[i], "workingstep", kOfWhole) != static_cast<double>(i))
      out.push_back(item("features", i, "workingstep") + ": is not its place in the workplan");
    if (text_at(features[i], "name") != text_at(steps[i], "feature"))
      out.push_back(item("features", i, "name") + ": is not that of the workplan");
    if (field_at(features[i], "tool_number") != field_at(steps[i], "tool_number"))
      out.push_back(item("features", i, "tool_number") + ": is not that of the workplan");
    if (number_at(steps[i], "floor_z") > number_at(steps[i], "top_z") + kLastDigit)
      out.push_back("/question" + item("workplan", i, "floor_z") + ": is above top_z");
  }
}

void check_tools(const Json& certificate, Sentences& out) {
  std::map<int, double> diameters;
  const Json& tools = field_at(certificate, "question/tools");
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const int number = static_cast<int>(number_at(tools[i], "number"));
    if (!diameters.emplace(number, number_at(tools[i], "diameter_mm")).second)
      out.push_back("/question" + item("tools", i, "number") + ": comes twice");
  }
  const Json& features = field_at(certificate, "features");
  for (std::size_t i = 0; i < features.size(); ++i) {
    const auto tool = diameters.find(static_cast<int>(number_at(features[i], "tool_number")));
    // A program may call a tool that is not given, which is a fault.
    if (tool == diameters.end() && !is_without_part(certificate))
      out.push_back(item("features", i, "tool_number") + ": is that of no tool");
    if (tool != diameters.end() &&
        std::abs(number_at(features[i], "tool_diameter") - tool->second) > kLastDigit)
      out.push_back(item("features", i, "tool_diameter") + ": is not that of its tool");
  }
}

/// Values that a plan decided, by workingstep and name.
using Values = std::map<std::pair<int, std::string>, std::string>;

Values values_of(const Json& certificate, Sentences& out) {
  Values values;
  const Json& list = field_at(certificate, "values");
  const auto steps = static_cast<double>(field_at(certificate, "question/workplan").size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double step = number_at(list[i], "workingstep", kOfWhole);
    if (step >= steps) out.push_back(item("values", i, "workingstep") + ": is beyond the workplan");
    const auto key = std::pair(static_cast<int>(step), text_at(list[i], "name"));
    if (!values.emplace(key, text_at(list[i], "value")).second)
      out.push_back(item("values", i, "name") + ": comes twice for its workingstep");
  }
  return values;
}

/// A field that repeats a decided value.
struct Repeated {
  const char* field;
  const char* value;
};
constexpr Repeated kOfStep[] = {{"feed_mm_per_min", "feed"},   {"plunge_feed_mm_per_min", "plunge-feed"},
                                {"spindle_rpm", "spindle"},    {"stepdown_mm", "stepdown"},
                                {"allowance_mm", "allowance"}, {"allowance_floor_mm", "allowance-floor"},
                                {"scallop_mm", "scallop"}};
constexpr Repeated kOfQuestion[] = {{"machine/rapid_mm_per_min", "rapid"},
                                    {"machine/acceleration_mm_per_s2", "acceleration"},
                                    {"machine/junction_deviation_mm", "junction-deviation"},
                                    {"machine/max_spindle_rpm", "max-spindle"},
                                    {"machine/min_spindle_rpm", "min-spindle"},
                                    {"machine/spindle_power_w", "spindle-power"},
                                    {"machine/spindle_torque_nm", "spindle-torque"},
                                    {"machine/max_feed_mm_per_min", "max-feed"},
                                    {"limits/engagement_deg", "engagement"},
                                    {"limits/uncut_mm", "tolerance-uncut"},
                                    {"limits/gouge_mm", "tolerance-gouge"},
                                    {"limits/fit_mm", "tolerance-fit"}};

/// Whether plans list the value only where it is stated.
bool is_listed_when_stated(std::string_view value) {
  return value == "min-spindle" || value == "spindle-power" || value == "spindle-torque";
}

/// Whether a field and the text of a value are the same number, or none.
bool are_same(const Json& field, const std::string& text) {
  const std::optional<double> value = number_in(text);
  if (!value || !field.is_number()) return !value && !field.is_number();
  const double own = field.get<double>();
  return std::abs(own - *value) <= kOfText * std::max(std::abs(own), 1e-3);
}

/// "T3 endmill 6", as the values of a plan have it, without the digits that texts round.
bool is_tool(const Json& tool, const std::string& text) {
  const std::string name = "T" + field_at(tool, "number").dump() + " " + text_at(tool, "kind") + " ";
  return text.starts_with(name) && are_same(field_at(tool, "diameter_mm"), text.substr(name.size()));
}

/// The tool of a workingstep and its direction of rotation.
void check_words(const Json& json, const Json& tools, const Values& values, int step, const std::string& at,
                 Sentences& out) {
  const auto tool = values.find({step, "tool"}), clockwise = values.find({step, "spindle-clockwise"});
  const auto is_so = [&](const Json& one) {
    return field_at(one, "number") == field_at(json, "tool_number") && is_tool(one, tool->second);
  };
  if (tool != values.end() && std::none_of(tools.begin(), tools.end(), is_so))
    out.push_back(at + "tool_number: is not the tool that was decided, " + tool->second);
  if (clockwise != values.end() && (clockwise->second == "yes") != (field_at(json, "clockwise") == true))
    out.push_back(at + "clockwise: is not the direction that was decided");
}

/// Values of a plan that are not listed, such as those of steps with stated toolpaths, are not looked at.
void check_values(const Json& certificate, const Values& values, Sentences& out) {
  const auto check = [&](const Json& json, const Repeated& row, int step, const std::string& at) {
    const auto value = values.find({step, row.value});
    // Speeds of several axes have one text, and a field of their own.
    if (value == values.end() || value->second.find('/') != std::string::npos) return;
    if (!are_same(field_at(json, row.field), value->second))
      out.push_back(at + row.field + ": is not the value \"" + row.value + "\" that was decided, " +
                    value->second);
  };
  const Json& question = field_at(certificate, "question");
  for (const Repeated& row : kOfQuestion) check(question, row, kOfWhole, "/question/");
  check(certificate, {"seed", "seed"}, kOfWhole, "/");
  const Json& steps = field_at(question, "workplan");
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string at = "/question" + item("workplan", i, "");
    const int step = static_cast<int>(i);
    for (const Repeated& row : kOfStep) check(steps[i], row, step, at);
    check_words(steps[i], field_at(question, "tools"), values, step, at, out);
  }
  if (text_at(question, "command") != "plan") return;
  const auto post = values.find({kOfWhole, "post"});
  if (post != values.end() && post->second != text_at(certificate, "program/dialect"))
    out.push_back("/program/dialect: is not the control that was decided, " + post->second);
  for (const Repeated& row : kOfQuestion) {
    if (values.count({kOfWhole, row.value}) == 0 && !is_listed_when_stated(row.value))
      out.push_back(std::string("/values: have no ") + row.value + ", which every plan decides");
  }
}

/// The argument behind the last `option`; nothing if it is not among the arguments.
std::optional<std::string> argument_of(const Json& arguments, const std::string& option) {
  std::optional<std::string> value;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string one = arguments[i].is_string() ? arguments[i].get<std::string>() : "";
    if (one == option && i + 1 < arguments.size() && arguments[i + 1].is_string())
      value = arguments[i + 1].get<std::string>();
    if (one.starts_with(option + "=")) value = one.substr(option.size() + 1);
  }
  return value;
}

/// Whether options may come from elsewhere than from the arguments: from a job, a machine, or a program that calls the library.
bool has_other_options(const Json& certificate) {
  const Json& arguments = field_at(certificate, "question/arguments");
  if (arguments.empty() || argument_of(arguments, "--machine")) return true;
  const Json& inputs = field_at(certificate, "inputs");
  return std::any_of(inputs.begin(), inputs.end(), [](const Json& input) {
    return text_at(input, "role") != "part" && text_at(input, "role") != "program";
  });
}

/// A number of the question that an argument states, else its default.
struct Stated {
  const char* field;
  const char* option;  ///< "": only files state it
  Json otherwise;
};

std::vector<Stated> stated_by_arguments() {
  const Machine machine;
  return {{"limits/engagement_deg", "--engagement", nullptr},
          {"limits/join_gap_mm", "--join-gap", Tolerances().join_gap},
          {"machine/rapid_mm_per_min", "--rapid", machine.rapid.mm_per_min()},
          {"machine/acceleration_mm_per_s2", "--acceleration", machine.acceleration},
          {"machine/junction_deviation_mm", "--junction-deviation", machine.junction_deviation},
          {"machine/max_feed_mm_per_min", "", nullptr},
          {"machine/max_spindle_rpm", "", nullptr},
          {"machine/min_spindle_rpm", "", nullptr}};
}

void check_limits_of_all(const Json& limits, Sentences& out) {
  const Tolerances usual;
  const std::pair<const char*, double> stated[] = {
      {"uncut_mm", usual.uncut}, {"gouge_mm", usual.gouge}, {"fit_mm", usual.fit}};
  for (const auto& [name, value] : stated) {
    if (std::abs(number_at(limits, name, HUGE_VAL) - value) > kLastDigit)
      out.push_back(std::string("/question/limits/") + name + ": is " + field_at(limits, name).dump() +
                    ", and programs are held to " + Json(value).dump());
  }
}

void check_stated_limits(const Json& certificate, Sentences& out) {
  const Json& question = field_at(certificate, "question");
  check_limits_of_all(field_at(question, "limits"), out);
  const bool others_may_state = has_other_options(certificate);
  for (const Stated& one : stated_by_arguments()) {
    const Json& found = field_at(question, one.field);
    const std::optional<std::string> asked = argument_of(field_at(question, "arguments"), one.option);
    // Speeds of several axes have fields of their own.
    const bool is_of_axes = asked && asked->find(',') != std::string::npos;
    const bool is_so =
        is_of_axes || (asked ? are_same(found, *asked) : others_may_state || found == one.otherwise);
    if (!is_so)
      out.push_back(std::string("/question/") + one.field + ": is " + found.dump() +
                    ", which the arguments do not ask for");
  }
}

void check_stock(const Json& certificate, Sentences& out) {
  const Json& stock = field_at(certificate, "question/stock");
  if (stock.is_null()) return;
  for (const char* axis : {"x", "y", "z"}) {
    const Json& range = field_at(stock, axis);
    if (range.size() != 2 || !range[0].is_number() || !range[1].is_number() || range[0] >= range[1])
      out.push_back(std::string("/question/stock/") + axis + ": is no range");
  }
}

void check_accepted(const Json& certificate, Sentences& out) {
  Json met = Json::array();
  for (const Json& one : field_at(certificate, "conditions"))
    if (field_at(one, "met_by") != "") met.push_back(field_at(one, "name"));
  if (met != field_at(certificate, "question/accepted"))
    out.push_back("/question/accepted: are not the conditions that are met");
  if (field_at(certificate, "question/assumptions") != certificate_assumptions())
    out.push_back("/question/assumptions: are not those of the check");
}

/// Conditions are accepted by a name among the arguments.
void check_met(const Json& certificate, Sentences& out) {
  if (has_other_options(certificate)) return;
  const Json& arguments = field_at(certificate, "question/arguments");
  const auto is_argument = [&](const std::string& name) {
    return std::any_of(arguments.begin(), arguments.end(), [&](const Json& one) {
      return one.is_string() && one.get<std::string>().find(name) != std::string::npos;
    });
  };
  const Json& conditions = field_at(certificate, "conditions");
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (text_at(conditions[i], "met_by") == "accepted" && !is_argument(text_at(conditions[i], "name")))
      out.push_back(item("conditions", i, "met_by") + ": is accepted, which the arguments do not ask for");
  }
}

void check_faults(const Json& certificate, Sentences& out) {
  std::set<std::string> kinds;
  const Json& faults = field_at(certificate, "faults");
  for (const Json& fault : faults) kinds.insert(text_at(fault, "kind"));
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Json& place = field_at(faults[i], "place");
    if (!place.is_null() && field_at(place, "line") != field_at(faults[i], "line"))
      out.push_back(item("faults", i, "line") + ": is not that of its place");
    const std::string cause = text_at(faults[i], "follows_from");
    if (!cause.empty() && kinds.count(cause) == 0)
      out.push_back(item("faults", i, "follows_from") + ": is no fault of the certificate");
  }
}

/// The strategy that was kept is one of the candidates, once.
void check_candidates(const Json& certificate, Sentences& out) {
  const Json& features = field_at(certificate, "features");
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Json& candidates = field_at(features[i], "candidates");
    if (!candidates.is_array() || candidates.empty()) continue;
    std::vector<std::string> kept;
    for (const Json& one : candidates)
      if (text_at(one, "outcome") == "kept") kept.push_back(text_at(one, "strategy"));
    // Holes and stated toolpaths are made without a strategy.
    const std::string wanted = kept.empty() ? "" : kept.front();
    if (kept.size() > 1 || wanted != text_at(features[i], "strategy"))
      out.push_back(item("features", i, "strategy") + ": is not the candidate that was kept");
  }
}

void check_margin(const Json& certificate, Sentences& out) {
  const Json& margin = field_at(certificate, "margin");
  const Json& features = field_at(margin, "features");
  if (!features.is_array() || features.empty()) return;
  double least = HUGE_VAL;
  for (const Json& one : features) least = std::min(least, number_at(one, "mm", HUGE_VAL));
  if (std::abs(number_at(margin, "mm", HUGE_VAL) - least) > kLastDigit)
    out.push_back("/margin/mm: is not the least of its features");
}

void check_copies(const Json& certificate, Sentences& out) {
  const Json& copies = field_at(certificate, "copies");
  if (!copies.is_object()) return;
  const double parts = number_at(copies, "parts"), clean = number_at(copies, "clean_parts");
  for (const char* name : {"clean_parts", "turned"}) {
    if (number_at(copies, name) > parts)
      out.push_back(std::string("/copies/") + name + ": is more than parts");
  }
  if (field_at(certificate, "clean") == true && clean != parts)
    out.push_back("/copies/clean_parts: is not all, and the program is clean");
  if (number_at(copies, "at_most", HUGE_VAL) < parts) out.push_back("/copies/at_most: is less than parts");
  const Json& kinds = field_at(copies, "kinds");
  for (const char* name : {"parts", "clean_parts", "turned"}) {
    double sum = 0;
    for (const Json& kind : kinds) sum += number_at(kind, name);
    if (!kinds.empty() && sum != number_at(copies, name))
      out.push_back(std::string("/copies/") + name + ": is not the sum of its kinds");
  }
  if (field_at(copies, "places").is_array() &&
      static_cast<double>(field_at(copies, "places").size()) != parts)
    out.push_back("/copies/places: are not as many as parts");
}

/// What is proved is a feature, and rests on a witness.
void check_proof(const Json& certificate, Sentences& out) {
  const Json& proved = field_at(certificate, "proved");
  if (!proved.is_array() || proved.empty()) return;
  if (text_at(certificate, "proof/witness_sha256").empty())
    out.push_back("/proof/witness_sha256: is missing, and features are proved");
  std::set<std::string> names;
  for (const Json& feature : field_at(certificate, "features")) names.insert(text_at(feature, "name"));
  for (const Json& one : proved) {
    if (!one.is_string() || names.count(one.get<std::string>()) == 0)
      out.push_back("/proved: " + one.dump() + " is no feature");
  }
}

}  // namespace

void check_question(const Json& certificate, Sentences& out) {
  const Values values = values_of(certificate, out);
  check_workplan(certificate, out);
  check_tools(certificate, out);
  check_values(certificate, values, out);
  check_stated_limits(certificate, out);
  check_stock(certificate, out);
  check_accepted(certificate, out);
  check_met(certificate, out);
  check_faults(certificate, out);
  check_candidates(certificate, out);
  check_margin(certificate, out);
  check_copies(certificate, out);
  check_proof(certificate, out);
}

}  // namespace clearcut::report
