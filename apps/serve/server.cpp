#include "serve/server.h"

#include <clearcut/error.h>

#include <chrono>
#include <regex>
#include <thread>

#include "serve/connections/guard.h"
#include "serve/connections/socket.h"
#include "serve/upload.h"

namespace clearcut::serve {
namespace {

using httplib::Request;
using httplib::Response;
using Answered = httplib::Server::HandlerResponse;

constexpr int kWaiting = 128;  // connections not accepted yet
constexpr std::size_t kMostHeaders = 100;

/// "/plan/([0-9a-f]{32})/program-([1-9][0-9]?)"
std::string pattern_of(const std::string& path) {
  const std::string with_id = std::regex_replace(path, std::regex("\\{id\\}"), "([0-9a-f]{32})");
  return std::regex_replace(with_id, std::regex("\\{setup\\}"), "([1-9][0-9]?)");
}

/// The page is its own and loads nothing from elsewhere; nothing stays in the browser's store.
httplib::Headers usual_headers() {
  return {{"X-Content-Type-Options", "nosniff"},
          {"Referrer-Policy", "no-referrer"},
          {"Cache-Control", "no-store"},
          {"Cross-Origin-Resource-Policy", "same-origin"}};
}

const char* const kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
    "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

}  // namespace

Server::Server(Service& service) : service_(service) {
  limit();
  guard();
  add_routes();
}

void Server::limit() {
  server_.set_payload_max_length(service_.settings.upload + (1U << 16));  // headers of the form's fields
  server_.set_default_headers(usual_headers());
}

void Server::guard() {
  const bool is_open = !is_loopback(service_.settings.listen);
  server_.set_pre_routing_handler([this, is_open](const Request& request, Response& response) {
    const Caller caller{request.get_header_value("Host"), request.get_header_value("Origin"),
                        request.get_header_value("Sec-Fetch-Site"), request.path == "/",
                        request.get_header_value_count("Host")};
    const auto refused = refusal_of(caller, service_.settings.hosts, is_open);
    if (refused) answer_refusal(response, 403, *refused);
    if (!refused && request.headers.size() > kMostHeaders)
      answer_refusal(response, 431, "the request has more headers than any browser sends");
    else if (!refused && request.has_header("Range"))
      answer_refusal(response, 416, "parts of a file are not served");
    return response.status > 0 ? Answered::Handled : Answered::Unhandled;
  });
  server_.set_error_handler([](const Request&, Response& response) {
    if (!response.body.empty()) return;
    const bool unknown = response.status == 404;
    answer_refusal(response, response.status,
                   unknown ? "there is nothing of that name; GET /openapi.json lists what there is"
                   : response.status == 413 ? kTooLarge
                                            : "the request cannot be used");
  });
  server_.set_exception_handler([](const Request&, Response& response, std::exception_ptr) {
    answer_refusal(response, 500, "internal fault of the server");
  });
  server_.set_post_routing_handler([](const Request&, Response& response) {
    if (!response.has_header("Content-Security-Policy"))
      response.set_header("Content-Security-Policy", kPagePolicy);
  });
}

void Server::add_routes() {
  for (const Route& route : routes()) {
    const std::string pattern = pattern_of(route.path);
    const auto call = [this, &route](const Request& request, Response& response) {
      route.handler(service_, request, response);
    };
    if (route.reader) {
      server_.Post(pattern, [this, &route](const Request& request, Response& response,
                                           const httplib::ContentReader& content) {
        route.reader(service_, request, response, content);
      });
    } else if (route.method == "GET") {
      server_.Get(pattern, call);
    } else {
      server_.Delete(pattern, call);
    }
  }
}

int Server::bind() {
  const Settings& settings = service_.settings;
  socket_t socket = INVALID_SOCKET;
  server_.set_socket_options([&](socket_t made) {
    httplib::default_socket_options(made);
    socket = made;
  });
  int port = settings.port;
  if (port == 0) {
    port = server_.bind_to_any_port(settings.listen);
  } else if (!server_.bind_to_port(settings.listen, port)) {
    port = -1;
  }
  // The library lets five connections wait to be accepted; further ones would be refused.
  if (port > 0 && ::listen(socket, kWaiting) == 0) return port;
  throw InputError("--port", "cannot be listened on (" + settings.listen + ", " +
                                 std::to_string(settings.port) +
                                 "); another program may have it: name another, or 0 for any");
}

void Server::run() {
  server_.listen_after_bind();
}

void Server::stop() {
  for (int i = 0; i < 1000 && !server_.is_running(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  service_.works.stop();
  server_.end();
}

}  // namespace clearcut::serve
