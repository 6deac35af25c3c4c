#include "read/job/project_file.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "options/copies_options.h"
#include "options/row.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

using Json = nlohmann::json;

constexpr int kProjectVersion = 1;

Json project_json(const std::string& path) {
  Json json = Json::parse(read_file(path), nullptr, false);
  if (!json.is_object() || json.value("clearcut", Json()) != "project")
    throw InputError(path, "is no project file; the page writes one with Save");
  if (json.value("version", Json()) != kProjectVersion)
    throw InputError(path,
                     "is a project file of another version; open and save it with the page of this one");
  return json;
}

/// The values of an option: texts, or none for a flag.
std::vector<std::string> values_of_option(const Json& json, const std::string& place) {
  std::vector<std::string> values;
  if (!json.is_array()) throw InputError(place, "must be a list of texts");
  for (const Json& one : json) {
    if (!one.is_string()) throw InputError(place, "must be a list of texts");
    values.push_back(one.get<std::string>());
  }
  return values;
}

}  // namespace

bool is_project_name(const std::string& path) {
  return path.ends_with(kProjectEnding);
}

ProjectFile read_project(const std::string& path) {
  const Json json = project_json(path);
  const Json plan = json.value("plan", Json());
  if (!plan.is_object() || !plan.value("input", Json()).is_string())
    throw InputError(path, "names no part to plan; choose one in the page and save it again");
  ProjectFile project;
  project.file = path;
  project.input = path + "/" + plan["input"].get<std::string>();
  if (!is_file(project.input))
    throw InputError(path, "does not hold its part '" + printable(plan["input"].get<std::string>()) +
                               "'; save the project again");
  const Json options = plan.value("options", Json::object());
  for (const auto& [name, values] : options.items()) {
    const std::string place = path + ": option '" + printable(name) + "'";
    const Row* row = row_named(name);
    if (row == nullptr) throw InputError(place, "is none; clearcut plan --help all lists those there are");
    std::vector<std::string> texts = values_of_option(values, place);
    if ((row->kind == ValueKind::kFlag) != texts.empty())
      throw InputError(place, texts.empty() ? "needs a value" : "takes no value");
    if (row->kind == ValueKind::kFile || row->kind == ValueKind::kFiles) {
      for (std::string& text : texts)
        if (is_file(path + "/" + text) || is_file(path + "/" + nested_file(text).value_or(NestedFile{}).file))
          text = path + "/" + text;
    }
    project.options[name] = std::move(texts);
  }
  return project;
}

}  // namespace clearcut::read
