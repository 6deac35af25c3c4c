#include <algorithm>

#include "report/certificate/certificate_schema.h"

namespace clearcut::report {
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
