#include "report/certificate/certificate_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/error.h"
#include "model/results/findings.h"
#include "report/certificate/certificate_json.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(std::string_view text) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    throw InputError("certificate",
                     "is no JSON object; name the file that --certificate or --json has written");
  return json;
}

/// Removes the field at `path`; if the path passes a list, in every item.
void take_out(Json& json, std::string_view path) {
  const std::size_t end = path.find('/', 1);
  const std::string name(path.substr(1, end - 1));
  if (name == "*") {
    for (Json& item : json) take_out(item, path.substr(end));
  } else if (json.is_object() && json.contains(name)) {
    if (end == std::string_view::npos) {
      json.erase(name);
    } else {
      take_out(json.at(name), path.substr(end));
    }
  }
}

}  // namespace

std::vector<std::string> certificate_faults(std::string_view certificate) {
  return schema_faults(Json::parse(certificate, nullptr, false), Json::parse(certificate_schema()));
}

bool seal_holds(std::string_view certificate) {
  const Json json = Json::parse(certificate, nullptr, false);
  return json.is_object() && json.contains("seal") && json.at("seal") == seal_of(json);
}

std::vector<std::string> certificate_differences(std::string_view before, std::string_view now,
                                                 const std::set<std::string>& left_out) {
  Json first = parsed(before), second = parsed(now);
  for (const std::string& path : left_out) {
    take_out(first, path);
    take_out(second, path);
  }
  return differences(first, second);
}

// Combinations impossible in true findings: rules over a certificate's own fields, a row each.

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNoPart = " AS FAR AS CAN BE SAID WITHOUT A PART";
/// Degrees by which the engagement may exceed its limit without a fault, and the rounding of digits.
constexpr double kDegreesOver = 2.01;

/// The field `name` of `json`; null if there is none.
const Json& field(const Json& json, const char* name) {
  static const Json kNull;
  return json.is_object() && json.contains(name) ? json.at(name) : kNull;
}

double number_in(const Json& json, const char* name, double otherwise) {
  const Json& value = field(json, name);
  return value.is_number() ? value.get<double>() : otherwise;
}

bool has_fault(const Json& certificate, std::initializer_list<FaultKind> kinds) {
  const Json& faults = field(certificate, "faults");
  return std::any_of(faults.begin(), faults.end(), [&](const Json& fault) {
    return std::any_of(kinds.begin(), kinds.end(),
                       [&](FaultKind kind) { return field(fault, "kind") == name_of(kind); });
  });
}

bool has_open_condition(const Json& certificate) {
  const Json& conditions = field(certificate, "conditions");
  return std::any_of(conditions.begin(), conditions.end(),
                     [](const Json& one) { return field(one, "met_by") == ""; });
}

using Sentences = std::vector<std::string>;

void check_verdict(const Json& certificate, Sentences& out) {
  const std::string verdict = field(certificate, "verdict").get<std::string>();
  const bool no_part = !field(certificate, "not_asked").is_null();
  const Verdict follows = !field(certificate, "faults").empty() ? Verdict::kFaulty
                          : has_open_condition(certificate)     ? Verdict::kConditional
                                                                : Verdict::kClean;
  std::string wanted = name_of(follows);
  if (no_part && follows != Verdict::kFaulty) wanted += kNoPart;
  const std::string plain = name_of(follows);
  if (verdict != wanted && !(follows == Verdict::kFaulty && verdict == plain + std::string(kNoPart)))
    out.push_back("/verdict: is \"" + verdict + "\" where its faults and conditions make it \"" + wanted +
                  "\"");
  // Without a part no program is clean.
  const bool is_clean = field(certificate, "clean") == true, may_be = follows == Verdict::kClean;
  if (is_clean ? !may_be : may_be && !no_part)
    out.push_back("/clean: is " + std::string(is_clean ? "true" : "false") +
                  ", and the verdict that follows is " + plain);
}

/// A figure for which a value beyond its limit requires a fault.
struct LimitRow {
  const char* figure;
  const char* limit;  ///< key in question/limits of the certificate; "": the limit is 0
  std::array<FaultKind, 3> faults;
};
constexpr LimitRow kLimits[] = {
    {"gouge_mm", "gouge_mm", {FaultKind::kGouge, FaultKind::kGouge, FaultKind::kGouge}},
    {"uncut_thickness_mm", "uncut_mm", {FaultKind::kUncut, FaultKind::kNothingCut, FaultKind::kUncut}},
    {"rapid_in_material",
     "",
     {FaultKind::kRapidInMaterial, FaultKind::kRapidInMaterial, FaultKind::kRapidInMaterial}}};

void check_limits(const Json& certificate, Sentences& out) {
  const Json& limits = field(field(certificate, "question"), "limits");
  for (const LimitRow& row : kLimits) {
    const double limit = *row.limit ? number_in(limits, row.limit, HUGE_VAL) : 0;
    const double found = number_in(certificate, row.figure, 0);
    if (found > limit && !has_fault(certificate, {row.faults[0], row.faults[1], row.faults[2]}))
      out.push_back("/" + std::string(row.figure) + ": is " + field(certificate, row.figure).dump() +
                    ", and no fault says so");
  }
  const Json& asked = field(limits, "engagement_deg");
  const double most = number_in(field(certificate, "engagement"), "max_deg", 0);
  if (asked.is_number() && most > asked.get<double>() + kDegreesOver &&
      !has_fault(certificate, {FaultKind::kOverEngagement}))
    out.push_back("/engagement/max_deg: is over the limit, and no fault says so");
}

/// Figures of the whole that are at least those of every feature or layer.
constexpr const char* kOfWhole[] = {"gouge_mm", "uncut_thickness_mm", "rapid_in_material", "max_axial_mm"};

void check_share(const Json& whole, const Json& share, const std::string& at, Sentences& out) {
  for (const char* figure : kOfWhole) {
    if (number_in(share, figure, 0) > number_in(whole, figure, HUGE_VAL))
      out.push_back(at + "/" + figure + ": is more than that of the whole");
  }
}

void check_features(const Json& certificate, Sentences& out) {
  std::set<std::string> faulty;
  for (const Json& fault : field(certificate, "faults"))
    if (field(fault, "feature").is_string()) faulty.insert(field(fault, "feature").get<std::string>());
  const Json& features = field(certificate, "features");
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Json& feature = features[i];
    const std::string at = "/features/" + std::to_string(i);
    check_share(certificate, feature, at, out);
    const Json& name = field(feature, "name");
    if (field(feature, "clean") == true && name.is_string() && faulty.count(name.get<std::string>()) > 0)
      out.push_back(at + "/clean: is true, and a fault names it");
    const Json& layers = field(feature, "layers");
    for (std::size_t k = 0; k < layers.size(); ++k)
      check_share(certificate, layers[k], at + "/layers/" + std::to_string(k), out);
  }
}

void check_basis(const Json& certificate, Sentences& out) {
  if (!field(certificate, "not_asked").is_null()) {
    for (const char* figure : {"gouge_mm", "uncut_thickness_mm"}) {
      if (!field(certificate, figure).is_null())
        out.push_back("/" + std::string(figure) + ": is a number, and was not asked");
    }
    return;
  }
  for (const char* figure : {"gouge_mm", "uncut_thickness_mm"}) {
    if (field(certificate, "clean") == true && !field(certificate, figure).is_number())
      out.push_back("/" + std::string(figure) + ": is no number, and was asked");
  }
  const Json& inputs = field(certificate, "inputs");
  if (inputs.empty()) out.push_back("/inputs: no file says what was to be made");
}

/// The key that an object of the text has twice; "" if there is none.
std::string doubled_key(std::string_view text) {
  std::vector<std::set<std::string>> open;
  std::string doubled;
  const auto look = [&](int /*depth*/, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.push_back({});
    if (event == Json::parse_event_t::object_end && !open.empty()) open.pop_back();
    if (event == Json::parse_event_t::key && !open.empty() &&
        !open.back().insert(parsed.get<std::string>()).second && doubled.empty())
      doubled = parsed.get<std::string>();
    return true;
  };
  return Json::parse(text, look, false).is_discarded() ? "" : doubled;
}

}  // namespace

std::vector<std::string> certificate_contradictions(std::string_view certificate) {
  Sentences out;
  const std::string doubled = doubled_key(certificate);
  if (!doubled.empty()) out.push_back("the key \"" + doubled + "\" comes twice in one object");
  const Json json = Json::parse(certificate, nullptr, false);
  check_verdict(json, out);
  check_limits(json, out);
  check_features(json, out);
  check_basis(json, out);
  return out;
}

}  // namespace clearcut::report
