// The server's answers hold what its description says of them, and nothing else.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "serve/server_process.h"

namespace clearcut {
namespace {

using nlohmann::json;
using test_support::form_of;
using test_support::ServerProcess;
using test_support::state_at_end;

const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2})";

bool has_type(const json& value, const json& types) {
  if (types.is_array())
    return std::any_of(types.begin(), types.end(), [&](const json& type) { return has_type(value, type); });
  const std::string type = types;
  return type == "object"    ? value.is_object()
         : type == "array"   ? value.is_array()
         : type == "string"  ? value.is_string()
         : type == "integer" ? value.is_number_integer()
         : type == "null"    ? value.is_null()
                             : value.is_number();
}

/// Where `value` departs from `rule`, "" where it does not. Knows the words that the description uses.
std::string fault(const json& all, const json& rule, const json& value, const std::string& at) {
  if (rule.contains("$ref"))
    return fault(all, all.at(json::json_pointer(rule.at("$ref").get<std::string>().substr(1))), value, at);
  if (rule.contains("oneOf")) {
    const json& ways = rule.at("oneOf");
    const auto fits = [&](const json& way) { return fault(all, way, value, at).empty(); };
    return std::count_if(ways.begin(), ways.end(), fits) == 1 ? "" : at + ": " + value.dump();
  }
  if (!has_type(value, rule.at("type"))) return at + ": " + value.dump();
  if (rule.contains("const") && value != rule.at("const")) return at + ": " + value.dump();
  if (rule.contains("enum") &&
      std::find(rule.at("enum").begin(), rule.at("enum").end(), value) == rule.at("enum").end())
    return at + ": " + value.dump();
  for (const json& name : rule.value("required", json::array()))
    if (!value.contains(name)) return at + ": without " + name.get<std::string>();
  if (!value.is_object() || !rule.contains("properties")) return "";
  for (const auto& [name, member] : value.items()) {
    if (!rule.at("properties").contains(name)) return at + "/" + name + ": not described";
    if (const std::string inner = fault(all, rule.at("properties").at(name), member, at + "/" + name);
        !inner.empty())
      return inner;
  }
  return "";
}

class Description : public ::testing::Test {
 protected:
  Description() : all_(json::parse(client().Get("/openapi.json")->body)) {}
  httplib::Client client() const {
    auto client = server_.client();
    client.set_read_timeout(300);
    return client;
  }
  /// Of an answer to that route.
  void expect_described(const std::string& method, const std::string& path, const httplib::Result& answer) {
    ASSERT_TRUE(answer) << path;
    const json& content = all_.at("paths").at(path).at(method).at("responses");
    const json& rule =
        content.at(std::to_string(answer->status)).at("content").at("application/json").at("schema");
    EXPECT_EQ(fault(all_, rule, json::parse(answer->body), path), "") << answer->body;
  }
  void expect_events_described(const std::string& events) {
    const json& state = all_.at("components").at("schemas").at("State");
    std::istringstream lines(events);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("data: ")) continue;
      EXPECT_EQ(fault(all_, state, json::parse(line.substr(6)), "event"), "") << line;
    }
  }

  ServerProcess server_;
  json all_;
};

TEST_F(Description, HoldsForElementsAndTours) {
  auto client = this->client();
  const httplib::MultipartFormDataItems lattice{{"lattice", "13x12", "", ""},
                                                {"options", "--solver published --time 2 --closed", "", ""}};
  for (const auto& [path, form] : std::vector<std::pair<std::string, httplib::MultipartFormDataItems>>{
           {"/elements", {{"options", "--pocket 0,0,20,16:depth=2 --tool endmill:6", "", ""}}},
           {"/tour", lattice}}) {
    const auto queued = client.Post(path, form);
    expect_described("post", path, queued);
    const std::string id = json::parse(queued->body).at("id");
    const auto events = client.Get("/plan/" + id + "/events");
    ASSERT_TRUE(events);
    expect_events_described(events->body);
    expect_described("get", "/plan/{id}", client.Get("/plan/" + id));
  }
}

TEST_F(Description, HoldsForPlans) {
  auto client = this->client();
  const auto queued = client.Post("/plan", form_of("square.json", kSquare, "--tool endmill:6"));
  expect_described("post", "/plan", queued);
  const std::string id = json::parse(queued->body).at("id");
  expect_described("get", "/plan/{id}", client.Get("/plan/" + id));
  const json last = state_at_end(server_, id);
  EXPECT_EQ(fault(all_, all_.at("components").at("schemas").at("State"), last, "event"), "") << last.dump();
  expect_described("get", "/plan/{id}", client.Get("/plan/" + id));
  expect_described("delete", "/plan/{id}", client.Delete("/plan/" + id));
  expect_described("get", "/plan/{id}", client.Get("/plan/" + id));
  expect_described("post", "/plan",
                   client.Post("/plan", form_of("square.json", kSquare, "--no-such-option")));
}

TEST_F(Description, HoldsForQuestions) {
  auto client = this->client();
  auto form = form_of("square.json", kSquare, "--tool endmill:6");
  form.push_back(
      {"program", "G21 G90 G17 G54\nT1 M6\nG0 X-20 Y25\nG0 Z-1\nM30\n", "square.ngc", "text/plain"});
  const auto queued = client.Post("/check", form);
  expect_described("post", "/check", queued);
  state_at_end(server_, json::parse(queued->body).at("id"));
  expect_described("get", "/plan/{id}",
                   client.Get(json::parse(queued->body).at("status").get<std::string>()));
  expect_described("post", "/info", client.Post("/info", form_of("square.json", kSquare, "")));
  expect_described("post", "/info", client.Post("/info", form_of("square.json", "{", "")));
}

TEST_F(Description, WouldSayWhatIsNotDescribed) {
  const json& state = all_.at("components").at("schemas").at("State");
  EXPECT_EQ(fault(all_, state, {{"id", "a"}, {"state", "done"}}, ""), "");
  EXPECT_EQ(fault(all_, state, {{"id", "a"}}, ""), ": without state");
  EXPECT_EQ(fault(all_, state, {{"id", "a"}, {"state", "late"}}, ""), "/state: \"late\"");
  EXPECT_EQ(fault(all_, state, {{"id", 3}, {"state", "done"}}, ""), "/id: 3");
  EXPECT_EQ(fault(all_, state, {{"id", "a"}, {"state", "done"}, {"more", 1}}, ""), "/more: not described");
}

}  // namespace
}  // namespace clearcut
