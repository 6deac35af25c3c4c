// Every field of true certificates changed by itself, and sealed again: the rest of the certificate contradicts it, or nothing follows
// from it.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "pipeline/test_drawings.h"
#include "pipeline/texts.h"
#include "report/certificate/certificate_check.h"

namespace clearcut::pipeline {
namespace {

using Json = nlohmann::ordered_json;

/// Fields that no other field of a certificate repeats or bounds, by a piece of their paths ("*" for an index), and why nothing is lost.
struct FreeField {
  const char* piece;
  const char* why;
};
constexpr FreeField kFree[] = {
    {"_at/", "says where something is; nothing is judged by it"},
    {"/candidates", "tells of other strategies, and nothing of the program"},
    {"/retracts", "is not judged, and features have other moves between them than the whole"},
    {"/turn", "is not judged, and features of foreign programs have other moves between them"},
    {"/features/*/clean", "true is contradicted; false says less than is known"},
    {"/features/*/layers/*", "has no more than its feature; less is not judged"},
    {"/features/*/path_tolerance_mm", "has no more than the whole"},
    {"/features/*/uncut_thickness_mm", "has no more than the whole, which is judged"},
    {"/length_bound/closed", "is not judged"},
    {"/conditions/*/", "is a sentence, or the reason why a condition is met"},
    {"/inputs/*/", "names a file, which is found by its hash"},
    {"/program/", "names the program, which is found by its hash, or its control, which --again asks for"},
    {"/part", "is a name"},
    {"/source_file", "is a name"},
    {"/version", "is a name"},
    {"/seed", "of a checked program is not used"},
    {"/question/arguments/*", "is what --again asks again"},
    {"/question/command", "is what --again asks again"},
    {"/question/machine/", "follows from files, which --again reads"},
    {"/question/noticed/*", "tells of readers, which --again reads with"},
    {"/question/tools/*/", "follows from arguments and files, which --again reads"},
    {"/question/workplan/*/", "follows from arguments and files; of a plan it is among its values"},
    {"/values/*", "repeats the question, or tells of its origin"},
};

const FreeField* free_field(const std::string& pattern) {
  const auto* const found = std::find_if(std::begin(kFree), std::end(kFree), [&](const FreeField& row) {
    return pattern.find(row.piece) != std::string::npos;
  });
  return found == std::end(kFree) ? nullptr : found;
}

/// Paths of all fields, from the top down.
void list_paths(const Json& json, const Json::json_pointer& at, std::vector<Json::json_pointer>& paths) {
  if (!at.empty()) paths.push_back(at);
  if (json.is_object())
    for (const auto& [name, value] : json.items()) list_paths(value, at / name, paths);
  if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i) list_paths(json[i], at / i, paths);
}

/// The path with "*" for every index.
std::string pattern_of(const Json::json_pointer& path) {
  std::string pattern, text = path.to_string();
  std::size_t begin = 1;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    const std::string one = text.substr(begin, end - begin);
    pattern += "/" + (one.find_first_not_of("0123456789") == std::string::npos ? "*" : one);
    begin = end + 1;
  }
  return pattern;
}

/// The certificate with one field changed, in every way that a value of its type can be.
std::vector<Json> changed(const Json& json, const Json::json_pointer& path) {
  std::vector<Json> all;
  const auto put = [&](const Json& value) {
    all.push_back(json);
    all.back()[path] = value;
  };
  const Json& value = json[path];
  if (value.is_boolean()) put(!value.get<bool>());
  if (value.is_number_integer()) put(value.get<int>() + 1);
  if (value.is_number_float()) put(value.get<double>() * 1.5 + 1);
  if (value.is_number() && value != 0) put(value.is_number_integer() ? Json(0) : Json(0.0));
  if (value.is_string()) put(value.get<std::string>() + "x");
  if (!value.is_null()) put(nullptr);
  all.push_back(json);
  Json& holder = all.back()[path.parent_pointer()];
  if (holder.is_object())
    holder.erase(path.back());
  else
    holder.erase(static_cast<std::size_t>(std::stoul(path.back())));
  return all;
}

bool is_contradicted(const Json& certificate) {
  const std::string text = certificate.dump();
  return !report::certificate_contradictions(text).empty() || !report::certificate_faults(text).empty();
}

/// Of the fields with the same pattern, the first.
std::vector<Json::json_pointer> fields_of(const Json& certificate) {
  std::vector<Json::json_pointer> paths, some;
  list_paths(certificate, Json::json_pointer(), paths);
  std::set<std::string> seen;
  for (const Json::json_pointer& path : paths)
    if (path.back() != "seal" && seen.insert(pattern_of(path)).second) some.push_back(path);
  return some;
}

/// A pocket, a hole and a slot, of which the corners are out of reach and accepted.
Part sample() {
  return drawn(box("POCKET_D4", 0, 0, 24, 18) + box("POCKET_D2", 40, 0, 60, 8) +
               circle("DRILL_D3", {32, 9}, 2));
}

PlanOptions options_of_sample() {
  PlanOptions options = with({"endmill:6:T1", "drill:4:T2"});
  options.engagement_deg = 170;
  options.accept = {"out-of-reach"};
  return options;
}

CertificateBasis basis(const char* command) {
  return {command,
          {"sample.dxf", "--tool", "endmill:6:T1", "--tool", "drill:4:T2", "--engagement", "170", "--accept",
           "out-of-reach"},
          {{"part", "sample.dxf", std::string(64, 'a')}},
          "sample.ngc"};
}

/// The certificates of a plan and of the check of its program.
std::vector<Json> true_certificates() {
  const PlanOptions options = options_of_sample();
  const PlanResult planned = plan_part(sample(), options);
  const CheckResult checked = check_program(sample(), planned.program, "sample.ngc", options);
  return {Json::parse(write_certificate(planned, options, basis("plan"))),
          Json::parse(write_certificate(checked, options, basis("verify"), planned.program))};
}

TEST(CertificateMutations, EveryFieldIsContradictedOrFree) {
  std::set<const FreeField*> used;
  for (const Json& certificate : true_certificates()) {
    EXPECT_EQ(certificate["verdict"], "CLEAN");
    for (const std::string& one : report::certificate_contradictions(certificate.dump()))
      ADD_FAILURE() << one;
    for (const Json::json_pointer& path : fields_of(certificate)) {
      const std::vector<Json> all = changed(certificate, path);
      if (std::all_of(all.begin(), all.end(), is_contradicted)) continue;
      const FreeField* const row = free_field(pattern_of(path));
      EXPECT_NE(row, nullptr) << path.to_string();
      used.insert(row);
    }
  }
  for (const FreeField& row : kFree) EXPECT_EQ(used.count(&row), 1u) << row.piece;
}

}  // namespace
}  // namespace clearcut::pipeline
