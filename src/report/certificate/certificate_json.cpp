#include "report/certificate/certificate_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/file.h"
#include "model/tool.h"

namespace clearcut::report {

nlohmann::ordered_json condition_json(const Condition& condition) {
  nlohmann::ordered_json json;
  json["name"] = condition.name;
  json["text"] = condition.text;
  json["line"] = condition.line;
  json["met_by"] = condition.met_by;
  return json;
}

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kAssumptions[] = {
    ("cutters are cylinders of their stated diameter; rounded ends count by their flat part on floors and by "
     "their full radius at walls"),
    "tool, holder, work and machine do not bend, and the spindle runs true",
    "holders, shanks and clamps are looked at where the question states them, as cylinders and blocks",
    "the work's zero is where G54 or the active datum lies, and the stock is as stated",
    "the control holds the length of each tool under its own number",
    "the tool stands above the work when the program begins",
    "rapids run straight in all axes"};

Json optional(const std::optional<double>& value) {
  return value ? certificate_number(*value) : Json(nullptr);
}

Json feed(const std::optional<MmPerMin>& value) {
  return value ? certificate_number(value->mm_per_min()) : Json(nullptr);
}

/// Null if the tool does not state it.
Json edges_of(const Tool& one) {
  if (!one.high_speed_steel) return nullptr;
  return *one.high_speed_steel ? "hss" : "carbide";
}

Json tool(const Tool& one) {
  Json json;
  json["number"] = one.number;
  json["name"] = one.name;
  json["kind"] = name_of(one.kind);
  json["diameter_mm"] = certificate_number(one.diameter);
  json["corner_radius_mm"] = certificate_number(one.corner_radius);
  json["teeth"] = one.teeth;
  json["flute_length_mm"] = optional(one.flute_length);
  json["max_spindle_rpm"] = optional(one.max_spindle_rpm);
  json["center_cutting"] = one.center_cutting;
  json["tip_angle_deg"] = one.tip_angle ? certificate_number(one.tip_angle->degrees()) : Json(nullptr);
  json["tip_diameter_mm"] = certificate_number(one.tip_diameter);
  json["pitch_mm"] = certificate_number(one.pitch);
  json["left_hand"] = one.left_hand;
  json["floating"] = one.floating;
  json["edges"] = edges_of(one);
  json["coated"] = one.coated;
  if (one.shank_diameter > 0) json["shank_diameter_mm"] = certificate_number(one.shank_diameter);
  if (one.stickout) {
    json["stickout_mm"] = certificate_number(*one.stickout);
    json["holder_diameter_mm"] = certificate_number(one.holder_diameter);
  }
  return json;
}

Json stock(const std::optional<Stock>& one) {
  if (!one) return nullptr;
  Json json;
  json["x"] = {certificate_number(one->plan.min.x), certificate_number(one->plan.max.x)};
  json["y"] = {certificate_number(one->plan.min.y), certificate_number(one->plan.max.y)};
  json["z"] = {certificate_number(one->z_bottom), certificate_number(one->z_top)};
  return json;
}

Json keep_out(const KeepOut& one) {
  Json json;
  json["x"] = {certificate_number(one.plan.min.x), certificate_number(one.plan.max.x)};
  json["y"] = {certificate_number(one.plan.min.y), certificate_number(one.plan.max.y)};
  json["z"] = {certificate_number(one.bottom_z), certificate_number(one.top_z)};
  return json;
}

Json step(const Part& part, const Workingstep& one) {
  const Feature& feature_cut = feature_of(part, one);
  const Operation& operation = one.operation;
  Json json;
  json["feature"] = feature_cut.name;
  json["kind"] = name_of(feature_cut.kind);
  json["tool_number"] = tool_of(part, one).number;
  json["top_z"] = certificate_number(feature_cut.top_z);
  json["floor_z"] = certificate_number(feature_cut.floor_z);
  json["allowance_mm"] = certificate_number(operation.allowance_side);
  json["allowance_floor_mm"] = certificate_number(operation.allowance_floor);
  json["stepdown_mm"] = optional(operation.stepdown);
  json["scallop_mm"] = optional(operation.scallop);
  json["feed_mm_per_min"] = feed(operation.cutting.feed);
  json["plunge_feed_mm_per_min"] = feed(operation.cutting.plunge_feed);
  json["spindle_rpm"] = optional(operation.cutting.spindle_rpm);
  json["clockwise"] = operation.cutting.spindle_clockwise;
  return json;
}

Json travel(const Machine& machine) {
  if (!machine.travel) return nullptr;
  Json json;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const auto& range = (*machine.travel)[axis];
    json[std::string(1, "xyz"[axis])] = {certificate_number(range[0]), certificate_number(range[1])};
  }
  return json;
}

Json of_axes(const std::optional<AxisValues>& values) {
  if (!values) return nullptr;
  Json list = Json::array();
  for (const double value : *values) list.push_back(certificate_number(value));
  return list;
}

Json machine(const Machine& one) {
  Json json;
  json["name"] = one.name;
  json["planner"] = one.planner ? Json(name_of(*one.planner)) : Json(nullptr);
  json["axis_rapid_mm_per_min"] = of_axes(one.axis_rapid);
  json["axis_acceleration_mm_per_s2"] = of_axes(one.axis_acceleration);
  json["jerk_mm_per_s3"] = optional(one.jerk);
  json["rapid_mm_per_min"] = certificate_number(one.rapid.mm_per_min());
  json["acceleration_mm_per_s2"] = certificate_number(one.acceleration);
  json["junction_deviation_mm"] = certificate_number(one.junction_deviation);
  json["max_spindle_rpm"] = optional(one.max_spindle_rpm);
  json["min_spindle_rpm"] = optional(one.min_spindle_rpm);
  json["spindle_power_w"] = optional(one.spindle_power_w);
  json["spindle_torque_nm"] = optional(one.spindle_torque_nm);
  json["max_feed_mm_per_min"] = feed(one.max_feed);
  json["travel_mm"] = travel(one);
  json["spindle_wait_s"] = certificate_number(one.spindle_wait_s);
  json["tool_change_s"] = certificate_number(one.tool_change_s);
  json["path_tolerance_mm"] = optional(one.path_tolerance);
  json["places_known"] = one.places.has_value();
  return json;
}

Json limits(const CertificateInfo& info) {
  Json json;
  json["uncut_mm"] = certificate_number(info.tolerances.uncut);
  json["gouge_mm"] = certificate_number(info.tolerances.gouge);
  json["fit_mm"] = certificate_number(info.tolerances.fit);
  json["join_gap_mm"] = certificate_number(info.tolerances.join_gap);
  json["engagement_deg"] = optional(info.engagement_limit_deg);
  return json;
}

const char* name_of_severity(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kRepair:
      return "repair";
    case Severity::kWarning:
      return "warning";
    case Severity::kSkipped:
      return "skipped";
  }
  return "note";
}

Json noticed(const Diagnostics& diagnostics) {
  Json list = Json::array();
  for (const Diagnostic& one : diagnostics.items()) {
    Json json;
    json["kind"] = name_of_severity(one.severity);
    json["where"] = one.where;
    json["what"] = one.what;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

Json certificate_number(double value) {
  if (!std::isfinite(value)) return nullptr;
  const double scaled = value * 1e6;
  if (std::abs(scaled) > 1e15) return value;
  return std::round(scaled) / 1e6 + 0.0;
}

Json certificate_question(const Part& part, const Findings& findings, const CertificateInfo& info) {
  Json json;
  json["command"] = info.command;
  json["arguments"] = info.arguments;
  json["tools"] = Json::array();
  for (const Tool& one : part.tools) json["tools"].push_back(tool(one));
  json["stock"] = stock(part.stock);
  for (const KeepOut& one : part.keep_outs) json["keep_outs"].push_back(keep_out(one));
  json["workplan"] = Json::array();
  for (const Workingstep& one : part.workplan) json["workplan"].push_back(step(part, one));
  json["limits"] = limits(info);
  json["machine"] = machine(info.machine);
  json["material"] = info.material ? Json(*info.material) : Json(nullptr);
  json["accepted"] = Json::array();
  for (const Condition& one : findings.conditions) {
    if (!one.met_by.empty()) json["accepted"].push_back(one.name);
  }
  json["noticed"] = noticed(part.diagnostics);
  json["assumptions"] = certificate_assumptions();
  return json;
}

Json certificate_assumptions() {
  return kAssumptions;
}

std::string seal_of(Json certificate) {
  certificate.erase("seal");
  return sha256_hex(certificate.dump(-1, ' ', false, Json::error_handler_t::replace));
}

namespace {

using Json = nlohmann::ordered_json;

bool has_type(const Json& json, const std::string& type) {
  if (type == "object") return json.is_object();
  if (type == "array") return json.is_array();
  if (type == "string") return json.is_string();
  if (type == "boolean") return json.is_boolean();
  if (type == "null") return json.is_null();
  if (type == "integer") return json.is_number_integer();
  return json.is_number();
}

bool is_digest(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

class Checker {
 public:
  explicit Checker(const Json& schema) : schema_(schema) {}

  void check(const Json& json, const Json& rule, const std::string& at) {
    if (rule.contains("$ref")) {
      const std::string name = rule.at("$ref").get<std::string>();
      check(json, schema_.at("$defs").at(name.substr(name.rfind('/') + 1)), at);
    }
    if (rule.contains("allOf")) {
      for (const Json& one : rule.at("allOf")) check(json, one, at);
    }
    check_value(json, rule, at);
    if (json.is_object()) check_members(json, rule, at);
    if (!json.is_array() || !rule.contains("items")) return;
    for (std::size_t i = 0; i < json.size(); ++i)
      check(json[i], rule.at("items"), at + "/" + std::to_string(i));
  }

  std::vector<std::string> take() { return std::move(faults_); }

 private:
  void fault(const std::string& at, const std::string& what) {
    faults_.push_back((at.empty() ? "/" : at) + ": " + what);
  }

  void check_value(const Json& json, const Json& rule, const std::string& at) {
    if (rule.contains("type")) {
      const Json types = rule.at("type").is_array() ? rule.at("type") : Json::array({rule.at("type")});
      const bool any = std::any_of(types.begin(), types.end(),
                                   [&](const Json& type) { return has_type(json, type.get<std::string>()); });
      if (!any) return fault(at, "must be " + types.dump());
    }
    if (rule.contains("enum")) {
      const Json& values = rule.at("enum");
      if (std::find(values.begin(), values.end(), json) == values.end())
        fault(at, "must be one of " + values.dump());
    }
    if (rule.contains("pattern") && json.is_string() && !is_digest(json.get<std::string>()))
      fault(at, "must be 64 hexadecimal digits");
    if (rule.contains("minimum") && json.is_number() && json.get<double>() < rule.at("minimum").get<double>())
      fault(at, "must be " + rule.at("minimum").dump() + " or more");
  }

  void check_members(const Json& json, const Json& rule, const std::string& at) {
    if (rule.contains("required")) {
      for (const Json& name : rule.at("required")) {
        if (!json.contains(name.get<std::string>())) fault(at + "/" + name.get<std::string>(), "is missing");
      }
    }
    if (!rule.contains("properties")) return;
    for (const auto& [name, inner] : rule.at("properties").items()) {
      if (json.contains(name)) check(json.at(name), inner, at + "/" + name);
    }
  }

  const Json& schema_;
  std::vector<std::string> faults_;
};

void compare(const Json& before, const Json& now, const std::string& at, std::vector<std::string>& out) {
  if (before == now) return;
  if (before.is_object() && now.is_object()) {
    for (const auto& [name, value] : before.items()) {
      if (now.contains(name)) {
        compare(value, now.at(name), at + "/" + name, out);
      } else {
        out.push_back(at + "/" + name + ": is not there any more");
      }
    }
    for (const auto& [name, value] : now.items()) {
      if (!before.contains(name)) out.push_back(at + "/" + name + ": is new");
    }
    return;
  }
  if (before.is_array() && now.is_array() && before.size() == now.size()) {
    for (std::size_t i = 0; i < before.size(); ++i)
      compare(before[i], now[i], at + "/" + std::to_string(i), out);
    return;
  }
  out.push_back(at + ": " + before.dump() + " is now " + now.dump());
}

}  // namespace

std::vector<std::string> schema_faults(const Json& json, const Json& schema) {
  Checker checker(schema);
  checker.check(json, schema, "");
  return checker.take();
}

std::vector<std::string> differences(const Json& before, const Json& now) {
  std::vector<std::string> out;
  compare(before, now, "", out);
  return out;
}

}  // namespace clearcut::report
