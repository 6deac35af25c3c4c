#include "serve/routes.h"

#include <clearcut/version.h>

#include <map>

#include "serve/page_text.h"
#include "serve/works/result_files.h"

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

namespace {

using httplib::Request;
using httplib::Response;

const std::vector<std::pair<int, std::string>> kUpload{{400, "the request cannot be used; the text says why"},
                                                       {413, "larger than this server takes"},
                                                       {503, "too much is going on; try again later"}};

std::vector<std::pair<int, std::string>> with_upload(std::vector<std::pair<int, std::string>> answers) {
  answers.insert(answers.end(), kUpload.begin(), kUpload.end());
  return answers;
}

Route file_route(const std::string& path, const std::string& summary, const char* text,
                 const std::string& type) {
  Route route{"GET", path, summary, {}, {{200, summary}}, type, {}, {}};
  route.handler = [text, type](Service&, const Request&, Response& response) {
    response.set_content(text, type);
  };
  return route;
}

std::vector<Route> result_routes() {
  const std::pair<int, std::string> unknown{404, "no plan of that name, or no such result"};
  std::vector<Route> out;
  const auto add = [&](const ResultKind& kind, const std::string& path, const std::string& what) {
    out.push_back({"GET", path, what, {}, {{200, what}, unknown}, kind.type, get_result, {}});
  };
  for (const ResultKind& kind : result_kinds()) {
    const std::string path = std::string("/plan/{id}/") + kind.name;
    add(kind, path, kind.what);
    if (kind.is_numbered) add(kind, path + "-{setup}", std::string(kind.what) + " of one of several set-ups");
  }
  return out;
}

/// A text stored or made by the service.
Route text_route(const std::string& path, const std::string& summary,
                 std::function<std::string(Service&)> text) {
  Route route{"GET", path, summary, {}, {{200, summary}}, "application/json", {}, {}};
  route.handler = [text = std::move(text)](Service& service, const Request&, Response& response) {
    response.set_content(text(service), "application/json");
  };
  return route;
}

/// Routes of requests with results fetched like those of a plan.
std::vector<Route> grid_and_tour_routes() {
  std::vector<Route> out;
  for (const auto& [path, what, form, reader] :
       {std::tuple{"/elements", "Plan design elements on a grid: a job of them, or elements as options",
                   std::vector<std::string>{"job", "options"}, &post_elements},
        std::tuple{"/tour", "Order points: a TSPLIB file, or a lattice such as 30x20",
                   std::vector<std::string>{"points", "lattice", "options"}, &post_tour}})
    out.push_back(
        {"POST",
         path,
         what,
         form,
         with_upload({{202, "queued; where its state, its events and its results are, as of a plan"}}),
         "application/json",
         {},
         reader,
         "Queued",
         false});
  return out;
}

std::vector<Route> plan_routes() {
  const std::pair<int, std::string> unknown{404, "no plan of that name"};
  const std::string json = "application/json";
  std::vector<Route> out;
  out.push_back(
      {"POST",
       "/plan",
       "Plan a part: its file, further files that it or the options name, options as on the command line",
       {"part", "file", "options"},
       with_upload({{202, "queued; where its state and events are"}}),
       json,
       {},
       post_plan,
       "Queued"});
  out.push_back({"GET",
                 "/plan/{id}",
                 "State of a plan",
                 {},
                 {{200, "the state"}, unknown},
                 json,
                 get_plan,
                 {},
                 "State"});
  out.push_back({"DELETE",
                 "/plan/{id}",
                 "Cancel a plan and forget it",
                 {},
                 {{200, "gone"}, unknown},
                 json,
                 drop_plan,
                 {},
                 "Gone"});
  out.push_back(
      {"GET",
       "/plan/{id}/events",
       "The state whenever it changes, as server-sent events, until the end",
       {},
       {{200, "events"}, unknown, {503, "too many connections follow plans; ask for the state instead"}},
       "text/event-stream",
       get_events,
       {},
       "State"});
  return out;
}

std::vector<Route> all_routes() {
  std::vector<Route> out;
  out.push_back(file_route("/", "The page for people", kPageHtml, "text/html; charset=utf-8"));
  out.push_back(file_route("/app.js", "Its script", kPageScript, "text/javascript; charset=utf-8"));
  out.push_back(file_route("/app.css", "Its style", kPageStyle, "text/css; charset=utf-8"));
  out.push_back(text_route("/openapi.json", "This description", [](Service&) { return openapi_json(); }));
  out.push_back(text_route("/options", "Options of every command, as the command line takes them",
                           [](Service& service) { return service.options; }));
  for (auto& route : plan_routes()) out.push_back(std::move(route));
  for (auto& route : grid_and_tour_routes()) out.push_back(std::move(route));
  for (auto& route : result_routes()) out.push_back(std::move(route));
  out.push_back(
      {"POST",
       "/check",
       "Check any program against the part it is for, or without one",
       {"program", "part", "file", "options"},
       with_upload({{202, "queued; where its state, its events and its results are, as of a plan"}}),
       "application/json",
       {},
       post_check,
       "Queued"});
  out.push_back(
      {"POST",
       "/compare",
       "Plan and certify a part by all strategies that fit it; its result `text` is their JSON",
       {"part", "file", "options"},
       with_upload({{202, "queued; where its state, its events and its results are, as of a plan"}}),
       "application/json",
       {},
       post_compare,
       "Queued"});
  out.push_back({"POST",
                 "/info",
                 "What a part holds: outlines and what they are for, features, what was mended",
                 {"part", "file", "options"},
                 with_upload({{200, "state, and the JSON of the command under info"}}),
                 "application/json",
                 {},
                 post_info,
                 "Info"});
  return out;
}

Json form_of(const Route& route) {
  const Json file{{"type", "string"}, {"format", "binary"}}, files{{"type", "array"}, {"items", file}},
      text{{"type", "string"}};
  Json fields = Json::object();
  for (const auto& field : route.form)
    fields[field] = field == "options" || field == "lattice" ? text : field == "file" ? files : file;
  Json schema{{"type", "object"}, {"properties", fields}};
  if (route.needs_first) schema["required"] = Json::array({route.form.front()});
  return {{"required", true}, {"content", {{"multipart/form-data", {{"schema", schema}}}}}};
}

Json operation_of(const Route& route) {
  Json answers = Json::object();
  for (const auto& [status, text] : route.answers) {
    const bool is_good = status < 300;
    const std::string schema = is_good ? route.schema : "Error";
    const Json content =
        schema.empty() ? Json::object() : Json{{"schema", {{"$ref", "#/components/schemas/" + schema}}}};
    answers[std::to_string(status)] = {
        {"description", text},
        {"content", {{is_good ? route.type.substr(0, route.type.find(';')) : "application/json", content}}}};
  }
  Json operation{{"summary", route.summary}, {"responses", answers}};
  for (const char* name : {"id", "setup"}) {
    if (route.path.find("{" + std::string(name) + "}") == std::string::npos) continue;
    operation["parameters"].push_back(
        {{"name", name}, {"in", "path"}, {"required", true}, {"schema", {{"type", "string"}}}});
  }
  if (!route.form.empty()) operation["requestBody"] = form_of(route);
  return operation;
}

}  // namespace

const std::vector<Route>& routes() {
  static const std::vector<Route> all = all_routes();
  return all;
}

std::string openapi_json() {
  Json paths = Json::object();
  for (const Route& route : routes()) {
    std::string method = route.method;
    for (char& c : method) c = static_cast<char>(std::tolower(c));
    paths[route.path][method] = operation_of(route);
  }
  const Json all{{"openapi", "3.1.0"},
                 {"info", {{"title", "clearcut serve"}, {"version", kVersion}}},
                 {"paths", paths},
                 {"components", {{"schemas", schemas()}}}};
  return all.dump(1) + "\n";
}

void answer_json(Response& response, int status, const Json& json) {
  response.status = status;
  response.set_content(json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n", "application/json");
}

void answer_refusal(Response& response, int status, const std::string& text) {
  answer_json(response, status, {{"error", text}});
}

}  // namespace clearcut::serve
