// clearcut serve under load that nobody asked for: noise, slow clients, requests that break off. What it takes of memory stays
// bounded, and whoever asks properly is served meanwhile. Every server of a test has to end without a leak (ServerProcess).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <random>
#include <string>
#include <thread>

#include "serve/server_process.h"

namespace clearcut {
namespace {

using nlohmann::json;
using test_support::answer_to;
using test_support::form_of;
using test_support::OpenRequest;
using test_support::posted;
using test_support::ServerProcess;
using test_support::soon;
using test_support::state_at_end;
using ::testing::HasSubstr;

const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2})";
const std::string kOptions = "--tool endmill:6 --strategy contour --accept out-of-reach";
const std::string kForm = "Host: localhost\r\nContent-Type: multipart/form-data; boundary=b\r\n";
const std::string kFile = "--b\r\nContent-Disposition: form-data; name=\"part\"; filename=\"a.json\"\r\n\r\n";

/// Bytes that a server may hold more after noise than before. A sanitizer's own books grow with every thread and allocation.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kMostGrowth = 128U << 20;
#else
constexpr std::size_t kMostGrowth = 32U << 20;
#endif

/// Plans, and forgets the plan again.
void expect_plans(const ServerProcess& server) {
  const std::string id = posted(server, form_of("square.json", kSquare, kOptions));
  EXPECT_EQ(state_at_end(server, id).at("verdict"), "CLEAN");
  auto client = server.client();
  EXPECT_EQ(client.Delete("/plan/" + id)->status, 200);
}

/// The starts of requests of every kind, which bytes of chance follow.
std::vector<std::string> starts() {
  std::string many;
  for (int i = 0; i < 300; ++i) many += "X-Of-No-Use: 1\r\n";
  return {"",
          "GET ",
          "GET / HTTP/1.1\r\n",
          "GET /plan/../../etc/passwd HTTP/1.1\r\nHost: localhost\r\n\r\n",
          "GET /plan/%2e%2e%2f%00/program HTTP/1.1\r\nHost: localhost\r\n\r\n",
          "DELETE /plan/" + std::string(32, 'f') + " HTTP/1.1\r\nHost: localhost\r\n",
          "POST /plan HTTP/1.1\r\nHost: localhost\r\n",
          "POST /plan HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nffffffffff\r\n",
          "POST /plan HTTP/1.1\r\n" + kForm + "Content-Length: 300\r\n\r\n--b\r\n",
          "POST /info HTTP/1.1\r\n" + kForm + "Content-Length: 260\r\n\r\n" + kFile,
          "GET / HTTP/1.1\r\nHost: localhost\r\n" + many};
}

void send_noise(int port, unsigned seed, int requests) {
  static const std::vector<std::string> known = starts();
  std::mt19937 random(seed);
  for (int i = 0; i < requests; ++i) {
    std::string bytes = known[random() % known.size()];
    const std::size_t size = random() % 300;
    for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(random() % 256);
    answer_to(port, bytes + "\r\n\r\n", true);
  }
}

/// From several clients at once.
void send_noise_together(int port, unsigned seed, int requests) {
  constexpr int kClients = 8;
  std::vector<std::jthread> clients;
  for (unsigned k = 0; k < kClients; ++k)
    clients.emplace_back([=] { send_noise(port, seed + k, requests / kClients); });
}

TEST(ServeLoad, StandsTenThousandRequestsOfNoise) {
  const ServerProcess server;
  send_noise_together(server.port(), 7, 2000);
  const std::size_t before = server.resident_bytes();
  send_noise_together(server.port(), 107, 8000);
  EXPECT_LT(server.resident_bytes(), before + kMostGrowth);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
  expect_plans(server);
}

/// Files that are larger than allowed are not gathered in memory, nor kept on disk.
TEST(ServeLoad, KeepsNothingOfFilesThatAreTooLarge) {
  const ServerProcess server({"--upload", "1"});
  const std::size_t before = server.resident_bytes();
  const std::string large(8U << 20, 'x');
  {
    std::vector<std::jthread> clients;
    for (int k = 0; k < 20; ++k)
      clients.emplace_back([&] {
        auto client = server.client();
        const auto answer = client.Post("/plan", form_of("large.json", large, ""));
        EXPECT_TRUE(!answer || answer->status == 413);  // closed before the answer was read
      });
  }
  EXPECT_LT(server.resident_bytes(), before + kMostGrowth);
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
  expect_plans(server);
}

/// A form that breaks off at any byte is refused, and nothing of it stays.
TEST(ServeLoad, RefusesAFormThatBreaksOffAnywhere) {
  const ServerProcess server;
  const std::string body = kFile + kSquare +
                           "\r\n--b\r\nContent-Disposition: form-data; name=\"options\"\r\n\r\n" + kOptions +
                           "\r\n--b--\r\n";
  const std::string head = "POST /plan HTTP/1.1\r\n" + kForm +
                           "Content-Length: " + std::to_string(body.size()) + "\r\nConnection: close\r\n\r\n";
  for (std::size_t size = 0; size < body.size(); size += 7)
    EXPECT_THAT(answer_to(server.port(), head + body.substr(0, size), true), Not(HasSubstr(" 202 "))) << size;
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
  EXPECT_THAT(answer_to(server.port(), head + body), HasSubstr(" 202 "));
}

/// Twenty clients fall silent in the middle of a request: they are let go after ten seconds, the others served meanwhile.
TEST(ServeLoad, LetsGoOfSilentClientsAndServesOthersMeanwhile) {
  const ServerProcess server;
  std::vector<OpenRequest> silent;
  for (int k = 0; k < 20; ++k)
    silent.emplace_back(server.port(),
                        k % 2 ? "POST /plan HTTP/1.1\r\nHost: local"
                              : "POST /plan HTTP/1.1\r\n" + kForm + "Content-Length: 5000\r\n\r\n" + kFile);
  expect_plans(server);
  for (auto& one : silent) EXPECT_THAT(one.rest(std::chrono::seconds(20)), Not(HasSubstr(" 202 ")));
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
}

/// A client that sends a byte now and then never falls silent; a minute is all that a request may take.
TEST(ServeLoad, EndsAnUploadThatComesTooSlowly) {
  const ServerProcess server;
  OpenRequest slow(server.port(), "POST /plan HTTP/1.1\r\n" + kForm + "Content-Length: 5000\r\n\r\n" + kFile);
  const auto began = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - began < std::chrono::seconds(62) && slow.send(" "))
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_THAT(slow.rest(std::chrono::seconds(20)), HasSubstr("408"));
  EXPECT_TRUE(soon([&] { return server.files_of_plans() == 0; }));
  expect_plans(server);
}

/// More clients than the server has threads, each of which sends a letter of `beginning`'s rest now and then.
void expect_serves_beside_dripping(const std::string& beginning) {
  const ServerProcess server;
  std::vector<OpenRequest> dripping;
  for (int k = 0; k < 300; ++k) dripping.emplace_back(server.port(), beginning);
  std::jthread drips([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      for (auto& one : dripping) one.send("x");
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
  });
  const auto began = std::chrono::steady_clock::now();
  expect_plans(server);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(8));
}

TEST(ServeLoad, ServesOthersBesideClientsWhoseHeadersDrip) {
  expect_serves_beside_dripping("POST /plan HTTP/1.1\r\nHost: local");
}

TEST(ServeLoad, ServesOthersBesideClientsWhoseFilesDrip) {
  expect_serves_beside_dripping("POST /plan HTTP/1.1\r\n" + kForm + "Content-Length: 5000\r\n\r\n" + kFile);
}

/// Headers that never end are given up however steadily they come.
TEST(ServeLoad, EndsARequestWhoseHeadersDrip) {
  const ServerProcess server;
  OpenRequest slow(server.port(), "GET / HTTP/1.1\r\nX-Of-No-Use: ");
  const auto began = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - began < std::chrono::seconds(14) && slow.send("x"))
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(14));
}

}  // namespace
}  // namespace clearcut
