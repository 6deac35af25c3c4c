#include "serve/server_process.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace clearcut::test_support {
namespace {

/// "http://127.0.0.1:41873/"
int port_in(const std::string& line) {
  const auto colon = line.rfind(':');
  if (!line.starts_with("http://127.0.0.1:")) throw std::runtime_error("no address: " + line);
  return std::stoi(line.substr(colon + 1));
}

std::string first_line(int stream) {
  std::string line;
  for (char c = 0; ::read(stream, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

}  // namespace

ServerProcess::ServerProcess(const std::vector<std::string>& options) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::vector<std::string> words{CLEARCUT_COMMAND, "serve", "--port", "0"};
  words.insert(words.end(), options.begin(), options.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::setenv("TMPDIR", temporary_.path("").c_str(), 1);
    ::setenv("ASAN_OPTIONS", "quarantine_size_mb=8", 0);  // of memory given back; 256 would hide what grows
    ::dup2(ends[1], 1);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  const std::string line = first_line(ends[0]);
  ::close(ends[0]);
  port_ = port_in(line);
}

ServerProcess::~ServerProcess() {
  if (process_ > 0) {
    EXPECT_EQ(end(SIGTERM), 0) << "the server did not end well";
  }
}

httplib::Client ServerProcess::client() const {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(120);
  return client;
}

int ServerProcess::end(int signal) {
  int status = 0;
  ::kill(process_, signal);
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return status;
}

std::size_t ServerProcess::files_of_plans() const {
  std::size_t count = 0;
  std::error_code vanished;
  for (auto at = std::filesystem::recursive_directory_iterator(temporary_.path(""), vanished);
       at != std::filesystem::recursive_directory_iterator(); at.increment(vanished)) {
    if (at->is_regular_file(vanished) && at->path().filename() != "options.json") ++count;
  }
  return count;
}

std::size_t ServerProcess::resident_bytes() const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6)) * 1024;
  }
  throw std::runtime_error("the server is gone");
}

httplib::MultipartFormDataItems form_of(const std::string& part_name, const std::string& part,
                                        const std::string& options) {
  return {{"part", part, part_name, "application/octet-stream"}, {"options", options, "", ""}};
}

std::string posted(const ServerProcess& server, const httplib::MultipartFormDataItems& form,
                   const std::string& path) {
  auto client = server.client();
  const auto answer = client.Post(path, form);
  if (!answer || answer->status != 202) throw std::runtime_error(answer ? answer->body : "no answer");
  return nlohmann::json::parse(answer->body).at("id");
}

std::string fetched(const ServerProcess& server, const std::string& path) {
  auto client = server.client();
  const auto answer = client.Get(path);
  return answer && answer->status == 200 ? answer->body : "no answer to " + path;
}

nlohmann::json state_at_end(const ServerProcess& server, const std::string& id) {
  auto client = server.client();
  const auto events = client.Get("/plan/" + id + "/events");
  if (!events || events->status != 200) throw std::runtime_error("no events of " + id);
  nlohmann::json state;
  std::istringstream lines(events->body);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("data: ")) state = nlohmann::json::parse(line.substr(6));
  }
  return state;
}

OpenRequest::OpenRequest(int port, const std::string& bytes)
    : connection_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(connection_, reinterpret_cast<sockaddr*>(&place), sizeof place) != 0)
    throw std::runtime_error("no connection");
  send(bytes);
}

OpenRequest::~OpenRequest() {
  if (connection_ >= 0) ::close(connection_);
}

bool OpenRequest::send(const std::string& bytes) {
  return ::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

void OpenRequest::end() {
  ::shutdown(connection_, SHUT_WR);
}

std::string OpenRequest::rest(std::chrono::seconds longest) {
  std::string answer;
  std::array<char, 4096> buffer{};
  const auto until = std::chrono::steady_clock::now() + longest;
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    pollfd waits{connection_, POLLIN, 0};
    if (left.count() <= 0 || ::poll(&waits, 1, static_cast<int>(left.count())) <= 0)
      throw std::runtime_error("the server holds the connection");
    const ssize_t got = ::recv(connection_, buffer.data(), buffer.size(), 0);
    if (got <= 0) return answer;
    answer.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

std::string answer_to(int port, const std::string& bytes, bool ends) {
  OpenRequest request(port, bytes);
  if (ends) request.end();
  return request.rest(std::chrono::seconds(120));
}

}  // namespace clearcut::test_support
