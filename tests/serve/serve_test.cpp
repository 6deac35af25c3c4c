// clearcut serve as browsers, programs and strangers meet it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <thread>

#include "base/file.h"
#include "serve/server_process.h"

namespace clearcut {
namespace {

using nlohmann::json;
using test_support::answer_to;
using test_support::fetched;
using test_support::form_of;
using test_support::posted;
using test_support::ScratchFolder;
using test_support::ServerProcess;
using test_support::soon;
using test_support::state_at_end;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2})";
const std::string kOptions = "--tool endmill:6 --strategy contour --accept out-of-reach";
/// Minutes of work: a small cutter on a large pocket.
const std::string kLarge = R"({"name": "large", "units": "mm",
  "outer": [[0,0,0.1],[400,0,0.2],[400,300,0.1],[0,300,0.3]], "islands": [[[200,150,1],[150,150,1]]],
  "top": 0, "depth": 5})";

TEST(Serve, ShowsThePageAndDescribesItsRoutes) {
  const ServerProcess server;
  auto client = server.client();
  const auto page = client.Get("/");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_THAT(page->body, HasSubstr("<!doctype html>"));
  EXPECT_THAT(page->get_header_value("Content-Security-Policy"), HasSubstr("default-src 'none'"));
  EXPECT_THAT(fetched(server, "/app.js"), HasSubstr("EventSource"));
  EXPECT_THAT(fetched(server, "/options"), HasSubstr("--stepdown"));
  const auto unknown = client.Get("/etc/passwd");
  EXPECT_EQ(unknown->status, 404);
  EXPECT_THAT(unknown->body, HasSubstr("error"));
}

/// Every route of the description is there, and answers as it says.
TEST(Serve, DescriptionHoldsForEveryRoute) {
  const ServerProcess server;
  auto client = server.client();
  const auto description = json::parse(fetched(server, "/openapi.json"));
  EXPECT_EQ(description.at("openapi"), "3.1.0");
  int count = 0;
  for (const auto& [path, methods] : description.at("paths").items()) {
    std::string place = std::regex_replace(path, std::regex("\\{id\\}"), std::string(32, '0'));
    place = std::regex_replace(place, std::regex("\\{setup\\}"), "2");
    for (const auto& [method, operation] : methods.items()) {
      ++count;
      const auto answer = method == "get"      ? client.Get(place)
                          : method == "delete" ? client.Delete(place)
                                               : client.Post(place, "x", "text/plain");
      ASSERT_TRUE(answer) << method << " " << path;
      EXPECT_TRUE(operation.at("responses").contains(std::to_string(answer->status)))
          << method << " " << path << " answers " << answer->status;
      EXPECT_THAT(answer->body, Not(HasSubstr("nothing of that name"))) << path;
    }
  }
  EXPECT_EQ(count, 26);
}

/// Runs the command in a folder with the part, as the server does.
void plan_by_command(const ScratchFolder& folder, const std::string& options) {
  folder.file("square.json", kSquare);
  std::filesystem::create_directory(folder.path("results"));
  const std::string line = "cd " + folder.path("") + " && COLUMNS=100 " + CLEARCUT_COMMAND +
                           " plan square.json " + options +
                           " --output=results/program.ngc --certificate=results/certificate.json"
                           " --svg=results/picture.svg --report=results/report.html "
                           "--setup-sheet=results/setup-sheet.html >results/text.txt 2>/dev/null";
  ASSERT_EQ(std::system(line.c_str()), 0);
}

TEST(Serve, PlansWithTheCommandsOwnBytes) {
  const ServerProcess server;
  const std::string id = posted(server, form_of("square.json", kSquare, kOptions));
  const json state = state_at_end(server, id);
  EXPECT_EQ(state.at("state"), "done") << state.dump();
  EXPECT_EQ(state.at("verdict"), "CLEAN");
  EXPECT_EQ(state.at("exit_code"), 0);
  const ScratchFolder folder;
  plan_by_command(folder, "--tool=endmill:6 --strategy=contour --accept=out-of-reach");
  for (const auto& [name, file] : std::map<std::string, std::string>{{"program", "program.ngc"},
                                                                     {"certificate", "certificate.json"},
                                                                     {"report", "report.html"},
                                                                     {"picture", "picture.svg"},
                                                                     {"setup-sheet", "setup-sheet.html"},
                                                                     {"text", "text.txt"}}) {
    const std::string result = fetched(server, state.at("results").at(name));
    EXPECT_EQ(result, read_file(folder.path("results/" + file))) << name;
    EXPECT_THAT(result, Not(HasSubstr("clearcut-serve-"))) << name;
  }
}

/// A block that is milled from two sides: results are numbered, and the verdict is the worst.
TEST(Serve, PlansEverySetUpOfAJob) {
  const ServerProcess server;
  const std::string job =
      "[part]\nfile = \"square.json\"\n[stock]\nx = [-5, 55]\ny = [-5, 55]\nz = [-20, 0]\n"
      "[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 6\n[plan]\nstrategy = \"contour\"\n"
      "[[setup]]\nup = \"+Z\"\norigin = \"corner\"\n[[setup]]\nup = \"-Z\"\norigin = \"corner\"\n";
  httplib::MultipartFormDataItems form = form_of("twice.toml", job, "--accept out-of-reach");
  form.push_back({"file", kSquare, "square.json", "application/octet-stream"});
  const json state = state_at_end(server, posted(server, form));
  ASSERT_EQ(state.at("state"), "done") << state.dump();
  EXPECT_THAT(state.at("verdict").get<std::string>(), AnyOf("CLEAN", "CONDITIONAL"));
  for (const char* kind : {"program", "certificate", "report", "picture"}) {
    EXPECT_FALSE(state.at("results").contains(kind));
    const std::string first = fetched(server, state.at("results").at(std::string(kind) + "-1"));
    const std::string second = fetched(server, state.at("results").at(std::string(kind) + "-2"));
    EXPECT_NE(first, second) << kind;
  }
  EXPECT_TRUE(state.at("results").contains("setup-sheet"));
  EXPECT_FALSE(state.at("results").contains("program-3"));
}

TEST(Serve, TwentyClientsPlanAtOnce) {
  const ServerProcess server({"--jobs", "2"});
  std::vector<std::string> programs(20);
  {
    std::vector<std::jthread> clients;
    for (auto& program : programs)
      clients.emplace_back([&] {
        try {
          const json state = state_at_end(server, posted(server, form_of("square.json", kSquare, kOptions)));
          program =
              state.at("state") == "done" ? fetched(server, state.at("results").at("program")) : state.dump();
        } catch (const std::exception& error) {
          program = error.what();
        }
      });
  }
  EXPECT_THAT(programs.front(), HasSubstr("G1"));
  for (const auto& program : programs) EXPECT_EQ(program, programs.front());
}

TEST(Serve, ChecksAProgram) {
  const ServerProcess server;
  const ScratchFolder folder;
  plan_by_command(folder, kOptions);
  const std::string program = read_file(folder.path("results/program.ngc"));
  const auto checked = [&](const std::string& text) {
    auto form = form_of("square.json", kSquare, "--tool endmill:6 --accept out-of-reach");
    form.push_back({"program", text, "square.ngc", "text/plain"});
    return state_at_end(server, posted(server, form, "/check"));
  };
  EXPECT_EQ(checked(program).value("verdict", ""), "CLEAN");
  const json wrong =
      checked("G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 Z5\nG0 X-20 Y25\nG0 Z-1\nG1 X70 F900\nG0 Z5\nM30\n");
  EXPECT_EQ(wrong.value("verdict", ""), "FAULTY") << wrong.dump();
  EXPECT_FALSE(json::parse(fetched(server, wrong.at("results").at("certificate"))).at("faults").empty());
}

/// Seconds of work: a plunging spiral of many small steps through a block, and a block for it.
httplib::MultipartFormDataItems long_check() {
  std::string program = "G21 G90 G17 G54\nT1 M6\nS5000 M3\nG0 Z5\nG0 X0 Y0\nG1 Z-1 F300\n";
  for (int i = 0; i < 60000; ++i)
    program += fmt::format("G1 X{:.3f} Y{:.3f} F900\n", 0.004 * i, (i % 2 == 0 ? 1 : -1) * 0.0012 * i);
  return {{"program", program + "G0 Z5\nM5\nM2\n", "long.ngc", "text/plain"},
          {"options", "--tool endmill:6 --stock=-10:260,-90:90,-5:0 --dialect linuxcnc", "", ""}};
}

TEST(Serve, SaysHowFarACheckIsAndCancelsIt) {
  const ServerProcess server;
  auto client = server.client();
  const std::string id = posted(server, long_check(), "/check");
  json state;
  const auto asked = [&] { return state = json::parse(fetched(server, "/plan/" + id)); };
  EXPECT_TRUE(soon([&] { return asked().contains("progress"); })) << state.dump();
  EXPECT_EQ(state.at("state"), "running") << state.dump();
  EXPECT_EQ(state.at("progress").at("stage"), "certifying") << state.dump();
  EXPECT_EQ(client.Delete("/plan/" + id)->status, 200);
  EXPECT_EQ(client.Get("/plan/" + id)->status, 404);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
}

TEST(Serve, ChecksAProgramWithoutItsPart) {
  const ServerProcess server;
  const std::string program =
      "G21 G90 G17 G54 G61\nT1 M6\nG43\nS5000 M3\nG0 X25 Y25\nG0 Z5\nG1 Z-1 F100\nG1 X40 F900\nG0 "
      "Z5\nM5\nM2\n";
  const httplib::MultipartFormDataItems form{
      {"program", program, "alone.ngc", "text/plain"},
      {"options", "--tool endmill:6 --stock 50,50,5 --dialect linuxcnc", "", ""}};
  const json state = state_at_end(server, posted(server, form, "/check"));
  EXPECT_EQ(state.value("verdict", ""), "CLEAN AS FAR AS CAN BE SAID WITHOUT A PART") << state.dump();
  const json certificate = json::parse(fetched(server, state.at("results").at("certificate")));
  EXPECT_FALSE(certificate.at("clean"));
  EXPECT_TRUE(certificate.at("gouge_mm").is_null());
  EXPECT_THAT(fetched(server, state.at("results").at("report")), HasSubstr("not asked"));
}

TEST(Serve, SaysWhatAPartHolds) {
  const ServerProcess server;
  auto client = server.client();
  const auto info = client.Post("/info", form_of("square.json", kSquare, ""));
  ASSERT_TRUE(info);
  EXPECT_EQ(info->status, 200);
  const json said = json::parse(info->body);
  EXPECT_EQ(said.at("state"), "done") << said.dump();
  EXPECT_EQ(said.at("info").at("schema"), "clearcut-info-1");
  EXPECT_THAT(info->body, Not(HasSubstr("clearcut-serve-")));
  const auto broken = client.Post("/info", form_of("square.json", "{", ""));
  EXPECT_THAT(json::parse(broken->body).value("message", ""), HasSubstr("square.json"));
  EXPECT_EQ(client.Post("/info", form_of("square.json", kSquare, "--json"))->status, 400);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
}

TEST(Serve, ComparesStrategies) {
  const ServerProcess server;
  const auto form = form_of("square.json", kSquare, "--tool endmill:6 --accept out-of-reach");
  const json state = state_at_end(server, posted(server, form, "/compare"));
  EXPECT_EQ(state.at("state"), "done") << state.dump();
  const json compared = json::parse(fetched(server, state.at("results").at("text")));
  EXPECT_EQ(compared.at("schema"), "clearcut-compare-1");
  EXPECT_GT(compared.at("strategies").size(), 2U);
}

TEST(Serve, SaysHowFarAComparisonIsAndCancelsIt) {
  const ServerProcess server;
  auto client = server.client();
  const std::string id = posted(server, form_of("large.json", kLarge, "--tool endmill:2"), "/compare");
  json state;
  const auto asked = [&] { return state = json::parse(fetched(server, "/plan/" + id)); };
  EXPECT_TRUE(soon([&] { return asked().contains("progress"); })) << state.dump();
  EXPECT_EQ(state.at("progress").at("things"), "strategies") << state.dump();
  EXPECT_EQ(client.Delete("/plan/" + id)->status, 200);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
}

struct Refused {
  httplib::MultipartFormDataItems form;
  std::string says;
};

/// No request names a file of the machine, by whatever way.
TEST(Serve, RefusesWhatItMustNotDo) {
  const ServerProcess server;
  auto client = server.client();
  const auto square = [](const std::string& options) { return form_of("square.json", kSquare, options); };
  for (const Refused& one : std::vector<Refused>{
           {form_of("../square.json", kSquare, ""), "plain name"},
           {form_of("/etc/square.json", kSquare, ""), "plain name"},
           {form_of("..\\square.json", kSquare, ""), "plain name"},
           {form_of(".bashrc", kSquare, ""), "plain name"},
           {form_of("-o.json", kSquare, ""), "plain name"},
           {form_of("results", kSquare, ""), "plain name"},
           {square("--tools /etc/passwd"), "was not sent"},
           {square("--machine=../../machine.toml"), "was not sent"},
           {square("--after square.ngc"), "was not sent"},
           {square("--nest 200x100 --nest-with /etc/passwd:2"), "was not sent"},
           {square("--output /tmp/x.ngc"), "not for the server"},
           {square("--svg=x.svg"), "not for the server"},
           {square("-o x.ngc"), "no option"},
           {square("/etc/passwd"), "no option"},
           {square("--nonsense 3"), "no option"},
           {square("--help"), "not for the server"},
           {square("--tool 'endmill:6"), "quote"},
           {form_of("job.toml", "[part]\nfile = \"/etc/passwd\"\n", ""), "job.toml:2"},
           {form_of("job.toml", "[machine]\nfile = '../m.toml'  # mm/min\n", ""), "plain names"},
           {form_of("job.toml", "tools.\"library\" = \"\\u002fx.tbl\"\n", ""), "plain names"},
           {form_of("job.toml", "[plan]\nafter = \"#/../x.ngc\"\n", ""), "plain names"},
           {form_of("job.toml", "[plan]\nafter = \"\"\"\n/etc/passwd\"\"\"\n", ""), "several lines"},
           {{{"options", "", "", ""}}, "part is missing"},
           {{{"picture", "x", "x.png", ""}}, "no field"}}) {
    const auto answer = client.Post("/plan", one.form);
    ASSERT_TRUE(answer) << one.says;
    EXPECT_EQ(answer->status, 400) << answer->body;
    EXPECT_THAT(json::parse(answer->body).value("error", ""), HasSubstr(one.says));
  }
  EXPECT_EQ(server.files_of_plans(), 0U);
}

/// A job may name what came with it.
TEST(Serve, PlansAJobWithTheFilesItNames) {
  const ServerProcess server;
  const std::string job =
      "# Feeds are mm/min.\n[part]\nfile = \"square.json\"  # an outline, not /etc\n"
      "[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 6\n[output]\nprogram = \"x.ngc\"\nreport = "
      "\"x.html\"\n";
  auto form = form_of("job.toml", job, "--accept out-of-reach");
  form.push_back({"file", kSquare, "square.json", "application/json"});
  const json state = state_at_end(server, posted(server, form));
  EXPECT_EQ(state.at("state"), "done") << state.dump();
  EXPECT_EQ(state.value("verdict", ""), "CLEAN");
}

TEST(Serve, SaysWhyAPartCannotBePlanned) {
  const ServerProcess server;
  const json state = state_at_end(server, posted(server, form_of("square.json", "{", kOptions)));
  EXPECT_EQ(state.at("state"), "failed");
  EXPECT_EQ(state.at("exit_code"), 2);
  EXPECT_THAT(state.value("message", ""), HasSubstr("square.json"));
  EXPECT_THAT(state.dump(), Not(HasSubstr("clearcut-serve-")));
}

TEST(Serve, AnswersOwnNamesAndPagesAlone) {
  const ServerProcess server;
  auto client = server.client();
  const std::string own = "127.0.0.1:" + std::to_string(server.port());
  const auto status = [&](const httplib::Headers& headers) {
    return client.Get("/options", headers)->status;
  };
  EXPECT_EQ(status({{"Host", own}}), 200);
  EXPECT_EQ(status({{"Host", "localhost:8080"}}), 200);
  EXPECT_EQ(status({{"Host", own}, {"Origin", "http://" + own}}), 200);
  for (const char* host : {"evil.example", "evil.example:80", "127.0.0.1.evil.example",
                           "localhost.evil.example", "10.0.0.1", "[::2]", "localhost:x", "@localhost"})
    EXPECT_EQ(status({{"Host", host}}), 403) << host;
  for (const char* origin :
       {"http://evil.example", "null", "http://127.0.0.1:1", "https://evil.example:8080"})
    EXPECT_EQ(status({{"Host", own}, {"Origin", origin}}), 403) << origin;
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_EQ(status({{"Host", own}, {"Sec-Fetch-Site", site}}), 403) << site;
  for (const char* site : {"same-origin", "none"})
    EXPECT_EQ(status({{"Host", own}, {"Sec-Fetch-Site", site}}), 200) << site;
  EXPECT_THAT(
      answer_to(server.port(), "GET /options HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n"),
      HasSubstr("403"));
  EXPECT_EQ(status({{"Host", own}, {"Range", "bytes=0-1,0-1"}}), 416);
  httplib::Headers many{{"Host", own}};
  for (int i = 0; i < 200; ++i) many.emplace("X-Of-No-Use", "1");
  EXPECT_EQ(status(many), 431);
  EXPECT_THAT(answer_to(server.port(), "GET /options HTTP/1.1\r\n\r\n"), HasSubstr("403"));
  // What follows a refused request is no request.
  const std::string hidden = "GET /options HTTP/1.1\r\nHost: localhost\r\n\r\n";
  const std::string carrier =
      "POST /plan HTTP/1.1\r\nHost: localhost\r\nOrigin: http://evil.example\r\nContent-Type: text/plain\r\n";
  const std::string both = answer_to(
      server.port(), carrier + "Content-Length: " + std::to_string(hidden.size()) + "\r\n\r\n" + hidden);
  EXPECT_THAT(both, Not(HasSubstr("200 OK")));
  EXPECT_THAT(both, Not(HasSubstr("--stepdown")));
}

TEST(Serve, TakesNoLargeAndNoBrokenRequests) {
  const ServerProcess server({"--upload", "0.1"});
  auto client = server.client();
  const auto large = client.Post("/plan", form_of("large.json", std::string(200'000, 'x'), ""));
  // The connection may be closed before the answer is read.
  EXPECT_TRUE(!large || large->status == 413) << large->body;
  const std::string head =
      "POST /plan HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: multipart/form-data; boundary=b\r\n";
  const std::string start =
      "--b\r\nContent-Disposition: form-data; name=\"part\"; filename=\"a.json\"\r\n\r\n{";
  EXPECT_THAT(answer_to(server.port(), head + "Content-Length: 5000\r\n\r\n" + start, true),
              Not(HasSubstr("202")));
  EXPECT_THAT(answer_to(server.port(), head + "Content-Length: 999999999999\r\n\r\n" + start),
              HasSubstr("413"));
  EXPECT_THAT(answer_to(server.port(), "GET /" + std::string(20000, 'a') + " HTTP/1.1\r\n\r\n", true),
              Not(HasSubstr("200 OK")));
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
  EXPECT_EQ(state_at_end(server, posted(server, form_of("square.json", kSquare, kOptions))).at("verdict"),
            "CLEAN");
}

TEST(Serve, CancelsAPlanAndForgetsIt) {
  const ServerProcess server;
  const std::string id = posted(server, form_of("large.json", kLarge, "--tool endmill:1"));
  auto client = server.client();
  EXPECT_TRUE(soon([&] { return json::parse(client.Get("/plan/" + id)->body).contains("progress"); }));
  EXPECT_EQ(client.Delete("/plan/" + id)->status, 200);
  EXPECT_EQ(client.Get("/plan/" + id)->status, 404);
  EXPECT_EQ(client.Delete("/plan/" + id)->status, 404);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
}

TEST(Serve, LeavesNothingBehindWhenItEndsOrIsKilledWhilePlanning) {
  for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
    ServerProcess server;
    const std::string id = posted(server, form_of("large.json", kLarge, "--tool endmill:1"));
    auto client = server.client();
    EXPECT_TRUE(
        soon([&] { return json::parse(client.Get("/plan/" + id)->body).value("state", "") == "running"; }));
    EXPECT_GT(server.files_of_plans(), 0U);
    const int status = server.end(signal);
    if (signal != SIGKILL) {
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    }
    EXPECT_TRUE(soon([&] { return server.left_behind().empty(); })) << signal;
  }
}

}  // namespace
}  // namespace clearcut
