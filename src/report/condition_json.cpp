#include "report/condition_json.h"

namespace clearcut::report {

nlohmann::ordered_json condition_json(const Condition& condition) {
  nlohmann::ordered_json json;
  json["name"] = condition.name;
  json["text"] = condition.text;
  json["line"] = condition.line;
  json["met_by"] = condition.met_by;
  return json;
}

}  // namespace clearcut::report
