#include "serve/schemas.h"

namespace clearcut::serve {
namespace {

Json described(const char* type, const char* what) {
  return {{"type", type}, {"description", what}};
}

Json list_of(const char* what) {
  return {{"type", "array"}, {"items", {{"type", "string"}}}, {"description", what}};
}

Json reference(const char* name) {
  return {{"$ref", std::string("#/components/schemas/") + name}};
}

/// Nothing but these properties.
Json object(const Json& properties, const std::vector<std::string>& required) {
  return {{"type", "object"},
          {"properties", properties},
          {"required", required},
          {"additionalProperties", false}};
}

Json progress_of_plan() {
  return object({{"stage", {{"type", "string"}, {"enum", {"planning", "certifying"}}}},
                 {"done", described("integer", "candidates that are planned; of certifying, pieces of work")},
                 {"most", described("integer", "how many there may be")},
                 {"left_s", described("number", "s left, of planning at most; absent: not known")}},
                {"stage", "done", "most"});
}

Json progress_of_comparison() {
  return object({{"stage", {{"type", "string"}, {"const", "counting"}}},
                 {"things", described("string", "what is counted: strategies")},
                 {"done", described("integer", "that are planned and certified")},
                 {"most", described("integer", "how many there are")},
                 {"left_s", described("number", "s left, about; absent: not known")}},
                {"stage", "things", "done", "most"});
}

Json progress_of_search() {
  return object({{"stage", {{"type", "string"}, {"const", "searching"}}},
                 {"best", described("number", "of the objective, so far")},
                 {"found_s", described("number", "after which it was found")},
                 {"left_s", described("number", "s left at most")}},
                {"stage", "best", "found_s", "left_s"});
}

/// Fields of every answer about work.
Json work() {
  return {{"state", {{"type", "string"}, {"enum", {"waiting", "running", "done", "failed", "cancelled"}}}},
          {"ahead", described("integer", "plans before it, while it waits")},
          {"progress", reference("Progress")},
          {"seconds", described("number", "since it began, or from its beginning to its end")},
          {"exit_code", described("integer", "of the command, at the end")},
          {"message", described("string", "why it failed")},
          {"messages", list_of("what was noticed, at the end")}};
}

Json state() {
  Json properties = work();
  properties["id"] = described("string", "name of the plan");
  properties["verdict"] = described("string",
                                    "CLEAN, CONDITIONAL or FAULTY, perhaps with AS FAR AS CAN BE SAID "
                                    "WITHOUT A PART; of a tour and a comparison empty");
  properties["results"] = {{"type", "object"},
                           {"additionalProperties", {{"type", "string"}}},
                           {"description", "addresses of the results by their names"}};
  return properties;
}

Json info() {
  Json properties = work();
  properties["info"] = {{"type", {"object", "null"}}, {"description", "what `clearcut info --json` prints"}};
  return object(properties, {"state", "info"});
}

}  // namespace

Json schemas() {
  return {{"Error", object({{"error", described("string", "one line that says what to do")}}, {"error"})},
          {"Queued", object({{"id", described("string", "name of the plan")},
                             {"status", described("string", "address of its state")},
                             {"events", described("string", "address of its events")},
                             {"command", list_of("words of the command that does it")}},
                            {"id", "status", "events", "command"})},
          {"Gone", object({{"state", {{"const", "cancelled"}, {"type", "string"}}}}, {"state"})},
          {"Progress", {{"oneOf", {progress_of_plan(), progress_of_comparison(), progress_of_search()}}}},
          {"State", object(state(), {"id", "state"})},
          {"Info", info()}};
}

}  // namespace clearcut::serve
