#include "report/certificate/certificate_check.h"

#include <set>

#include "base/error.h"
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

}  // namespace clearcut::report
