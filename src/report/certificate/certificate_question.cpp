#include "report/certificate/certificate_question.h"

#include <array>
#include <cmath>

#include "base/files/digest.h"
#include "model/tool.h"

namespace clearcut::report {
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
  json["assumptions"] = kAssumptions;
  return json;
}

std::string seal_of(Json certificate) {
  certificate.erase("seal");
  return sha256_hex(certificate.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace clearcut::report
