// Combinations impossible in true findings: rules over a certificate's own fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/results/findings.h"
#include "report/certificate/certificate_check.h"
#include "report/certificate/certificate_fields.h"
#include "report/certificate/figure_relations.h"
#include "report/certificate/question_relations.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNoPart = " AS FAR AS CAN BE SAID WITHOUT A PART";

bool has_fault(const Json& certificate, std::initializer_list<FaultKind> kinds) {
  const Json& faults = field_at(certificate, "faults");
  return std::any_of(faults.begin(), faults.end(), [&](const Json& fault) {
    return std::any_of(kinds.begin(), kinds.end(),
                       [&](FaultKind kind) { return field_at(fault, "kind") == name_of(kind); });
  });
}

bool has_open_condition(const Json& certificate) {
  const Json& conditions = field_at(certificate, "conditions");
  return std::any_of(conditions.begin(), conditions.end(),
                     [](const Json& one) { return field_at(one, "met_by") == ""; });
}

void check_verdict(const Json& certificate, Sentences& out) {
  const std::string verdict = text_at(certificate, "verdict");
  const bool no_part = is_without_part(certificate);
  const Verdict follows = !field_at(certificate, "faults").empty() ? Verdict::kFaulty
                          : has_open_condition(certificate)        ? Verdict::kConditional
                                                                   : Verdict::kClean;
  std::string wanted = name_of(follows);
  if (no_part && follows != Verdict::kFaulty) wanted += kNoPart;
  const std::string plain = name_of(follows);
  if (verdict != wanted && !(follows == Verdict::kFaulty && verdict == plain + std::string(kNoPart)))
    out.push_back("/verdict: is \"" + verdict + "\" where its faults and conditions make it \"" + wanted +
                  "\"");
  // Without a part no program is clean.
  const bool is_clean = field_at(certificate, "clean") == true, may_be = follows == Verdict::kClean;
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

/// Whether the figure of the whole, a feature or a layer is beyond its limit.
bool is_beyond(const LimitRow& row, const Json& figures, const Json& certificate) {
  const double limit =
      *row.limit ? number_at(field_at(certificate, "question/limits"), row.limit, HUGE_VAL) : 0;
  return number_at(figures, row.figure) > limit;
}

void check_limits(const Json& certificate, Sentences& out) {
  for (const LimitRow& row : kLimits) {
    const std::string figure = "/" + std::string(row.figure) + ": is ";
    const bool is_said = has_fault(certificate, {row.faults[0], row.faults[1], row.faults[2]});
    if (is_beyond(row, certificate, certificate) && !is_said)
      out.push_back(figure + field_at(certificate, row.figure).dump() + ", and no fault says so");
  }
  const std::pair<FaultKind, const char*> said[] = {{FaultKind::kGouge, "gouge_mm"},
                                                    {FaultKind::kRapidInMaterial, "rapid_in_material"},
                                                    {FaultKind::kOverEngagement, "engagement/over_limit_mm"}};
  for (const auto& [kind, figure] : said) {
    if (has_fault(certificate, {kind}) && number_at(certificate, figure, HUGE_VAL) <= 0)
      out.push_back(std::string("/") + figure + ": is 0, and a fault says otherwise");
  }
  const Json& asked = field_at(certificate, "question/limits/engagement_deg");
  if (asked.is_number() &&
      number_at(certificate, "engagement/max_deg") > asked.get<double>() + kFreeEngagementDeg + kLastDigit &&
      !has_fault(certificate, {FaultKind::kOverEngagement}))
    out.push_back("/engagement/max_deg: is over the limit, and no fault says so");
}

bool is_within_limits(const Json& figures, const Json& certificate) {
  return std::none_of(std::begin(kLimits), std::end(kLimits),
                      [&](const LimitRow& row) { return is_beyond(row, figures, certificate); });
}

/// A clean feature is within all limits, and no fault names it; a layer is clean where it is within all limits.
void check_clean(const Json& certificate, Sentences& out) {
  std::set<std::string> faulty;
  for (const Json& fault : field_at(certificate, "faults")) faulty.insert(text_at(fault, "feature"));
  const Json& features = field_at(certificate, "features");
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Json& feature = features[i];
    const std::string at = "/features/" + std::to_string(i);
    const bool is_clean = field_at(feature, "clean") == true;
    if (is_clean && faulty.count(text_at(feature, "name")) > 0)
      out.push_back(at + "/clean: is true, and a fault names it");
    if (is_clean && !is_within_limits(feature, certificate))
      out.push_back(at + "/clean: is true, and a figure is beyond its limit");
    const Json& layers = field_at(feature, "layers");
    for (std::size_t k = 0; k < layers.size(); ++k) {
      const bool may_be = is_within_limits(layers[k], certificate) && !is_without_part(certificate);
      if ((field_at(layers[k], "clean") == true) != may_be)
        out.push_back(at + "/layers/" + std::to_string(k) + "/clean: does not follow from its figures");
    }
  }
}

void check_basis(const Json& certificate, Sentences& out) {
  if (is_without_part(certificate)) {
    for (const char* figure : {"gouge_mm", "uncut_thickness_mm"}) {
      if (!field_at(certificate, figure).is_null())
        out.push_back("/" + std::string(figure) + ": is a number, and was not asked");
    }
    return;
  }
  if (field_at(certificate, "inputs").empty()) out.push_back("/inputs: no file says what was to be made");
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
  check_clean(json, out);
  check_basis(json, out);
  check_figures(json, out);
  check_question(json, out);
  return out;
}

}  // namespace clearcut::report
