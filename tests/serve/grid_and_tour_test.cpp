// Design elements and tours, as clearcut serve takes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/file.h"
#include "serve/server_process.h"

namespace clearcut {
namespace {

using nlohmann::json;
using test_support::fetched;
using test_support::posted;
using test_support::ServerProcess;
using test_support::soon;
using test_support::state_at_end;
using ::testing::HasSubstr;
using ::testing::Not;

using Form = httplib::MultipartFormDataItems;

Form options_alone(const std::string& options) {
  return {{"options", options, "", ""}};
}

/// Points on a spiral as a TSPLIB file: no order of theirs is proven at once.
std::string spiral(int count) {
  std::string text = "NAME : spiral\nTYPE : TSP\nDIMENSION : " + std::to_string(count) +
                     "\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n";
  for (int i = 0; i < count; ++i) {
    const double turn = 2.4 * i, radius = 10 * std::sqrt(i + 1);
    text += std::to_string(i + 1) + " " + std::to_string(500 + radius * std::cos(turn)) + " " +
            std::to_string(500 + radius * std::sin(turn)) + "\n";
  }
  return text + "EOF\n";
}

TEST(ServeElements, PlansAJobAndGivesItsPage) {
  const ServerProcess server;
  const std::string job = read_file(CLEARCUT_SOURCE_DIR "/examples/five_pockets.toml");
  const json state = state_at_end(
      server,
      posted(server, {{"job", job, "five_pockets.toml", ""}, {"options", "--seed 3", "", ""}}, "/elements"));
  ASSERT_EQ(state.at("state"), "done") << state.dump();
  EXPECT_FALSE(state.at("verdict").get<std::string>().empty());
  const std::string page = fetched(server, state.at("results").at("report"));
  for (const char* holds : {"Activated, reduced, cut", "<td>middle</td><td>rectangle</td>", "onvergence"})
    EXPECT_THAT(page, HasSubstr(holds));
  EXPECT_THAT(page, Not(HasSubstr("clearcut-serve-")));
  EXPECT_THAT(fetched(server, state.at("results").at("program")), HasSubstr("G1"));
  EXPECT_THAT(fetched(server, state.at("results").at("points")), HasSubstr(","));
  EXPECT_TRUE(state.at("results").contains("certificate") && state.at("results").contains("picture"));
}

TEST(ServeElements, PlansElementsThatAreOptions) {
  const ServerProcess server;
  const std::string id = posted(
      server,
      options_alone(
          "--pocket 0,0,20,16:depth=2 --hole=-10,8,6:T2:depth=4 --tool endmill:6:T1 --tool endmill:4:T2 "
          "--solver published --generations 20 --post grbl"),
      "/elements");
  const json state = state_at_end(server, id);
  ASSERT_EQ(state.at("state"), "done") << state.dump();
  EXPECT_THAT(fetched(server, state.at("results").at("text")), HasSubstr("squares"));
}

TEST(ServeElements, RefusesWhatItMustNotDo) {
  const ServerProcess server;
  auto client = server.client();
  const std::string job = "name = \"x\"\n";
  for (const auto& [form, says] : std::vector<std::pair<Form, std::string>>{
           {{{"job", job, "../job.toml", ""}}, "plain name"},
           {{{"job", job, "-o.toml", ""}}, "plain name"},
           {{{"job", "[part]\nfile = \"/etc/passwd\"\n", "job.txt", ""}}, "job.txt:2"},
           {options_alone("/etc/passwd"), "no option"},
           {options_alone("--html /tmp/x.html"), "not for the server"},
           {options_alone("--points=x.csv"), "not for the server"},
           {{{"lathe", "x", "", ""}}, "no field"}}) {
    const auto answer = client.Post("/elements", form);
    ASSERT_TRUE(answer) << says;
    EXPECT_EQ(answer->status, 400) << answer->body;
    EXPECT_THAT(json::parse(answer->body).value("error", ""), HasSubstr(says));
  }
  const json state = state_at_end(server, posted(server, options_alone("--pocket 0,0,20"), "/elements"));
  EXPECT_EQ(state.at("state"), "failed");
  EXPECT_THAT(state.value("message", ""), HasSubstr("--pocket"));
  EXPECT_THAT(state.value("message", ""), Not(HasSubstr("\n")));
  EXPECT_TRUE(soon([&] { return server.files_of_plans() <= 4; }));  // what it said, until it is forgotten
}

TEST(ServeTour, OrdersALattice) {
  const ServerProcess server;
  const json state = state_at_end(
      server, posted(server, {{"lattice", "10x10", "", ""}, {"options", "--time 2", "", ""}}, "/tour"));
  ASSERT_EQ(state.at("state"), "done") << state.dump();
  EXPECT_EQ(state.at("verdict"), "");
  const json tour = json::parse(fetched(server, state.at("results").at("tour")));
  EXPECT_EQ(tour.at("objective"), 99);
  EXPECT_EQ(tour.at("tour").size(), 100U);
  EXPECT_EQ(tour.at("convergence").back().at(1), 99);
  EXPECT_THAT(fetched(server, state.at("results").at("picture")), HasSubstr("<svg"));
}

/// The best value is told while it falls, and the whole of its fall at the end.
TEST(ServeTour, TellsTheBestValueOfAFileSoFar) {
  const ServerProcess server;
  const std::string id =
      posted(server,
             {{"points", spiral(400), "spiral.tsp", ""},
              {"options", "--solver published --time 4 --objective 1:length,5:turns", "", ""}},
             "/tour");
  auto client = server.client();
  const auto events = client.Get("/plan/" + id + "/events");
  ASSERT_TRUE(events);
  EXPECT_THAT(events->body, HasSubstr(R"("stage":"searching","best":)"));
  const json state = state_at_end(server, id);
  ASSERT_EQ(state.at("state"), "done") << state.dump();
  const json convergence = json::parse(fetched(server, state.at("results").at("tour"))).at("convergence");
  ASSERT_GT(convergence.size(), 2U);
  ASSERT_LE(convergence.size(), 1000U);
  for (std::size_t i = 1; i < convergence.size(); ++i) {
    EXPECT_GE(convergence[i][0], convergence[i - 1][0]);
    EXPECT_LT(convergence[i][1], convergence[i - 1][1]);
  }
}

TEST(ServeTour, RefusesWhatItMustNotDo) {
  const ServerProcess server;
  auto client = server.client();
  for (const auto& [form, says] : std::vector<std::pair<Form, std::string>>{
           {{{"lattice", "/etc/passwd", "", ""}}, "COLUMNSxROWS"},
           {{{"lattice", "--help", "", ""}}, "COLUMNSxROWS"},
           {{{"lattice", "99999x9", "", ""}}, "COLUMNSxROWS"},
           {{{"points", spiral(9), "../p.tsp", ""}}, "plain name"},
           {{{"points", spiral(9), "p.tsp", ""}, {"lattice", "3x3", "", ""}}, "points"},
           {options_alone(""), "points"},
           {{{"lattice", "3x3", "", ""}, {"options", "--json /tmp/x", "", ""}}, "not for the server"}}) {
    const auto answer = client.Post("/tour", form);
    ASSERT_TRUE(answer) << says;
    EXPECT_EQ(answer->status, 400) << answer->body;
    EXPECT_THAT(json::parse(answer->body).value("error", ""), HasSubstr(says));
  }
  EXPECT_EQ(server.files_of_plans(), 0U);
  const json state = state_at_end(server, posted(server, {{"points", "no tour", "p.tsp", ""}}, "/tour"));
  EXPECT_EQ(state.at("state"), "failed");
  EXPECT_THAT(state.value("message", ""), HasSubstr("p.tsp"));
}

TEST(ServeTour, CancelsAndForgets) {
  const ServerProcess server;
  const std::string id = posted(
      server, {{"points", spiral(3000), "spiral.tsp", ""}, {"options", "--time 300", "", ""}}, "/tour");
  auto client = server.client();
  EXPECT_TRUE(soon([&] { return json::parse(client.Get("/plan/" + id)->body).contains("progress"); }));
  EXPECT_EQ(client.Delete("/plan/" + id)->status, 200);
  EXPECT_EQ(client.Get("/plan/" + id)->status, 404);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
}

}  // namespace
}  // namespace clearcut
