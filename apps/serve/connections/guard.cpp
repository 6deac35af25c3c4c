#include "serve/connections/guard.h"

#include <algorithm>
#include <cctype>

#include "serve/connections/socket.h"
#include "serve/settings.h"

namespace clearcut::serve {
namespace {

/// "localhost" of "localhost:8080", "::1" of "[::1]:8080", in small letters; "" if there is none.
std::string name_of_host(const std::string& host) {
  std::string name = host.substr(0, host.find(':'));
  std::string port = name.size() < host.size() ? host.substr(name.size()) : "";
  if (host.starts_with("[")) {
    const auto end = host.find(']');
    if (end == std::string::npos) return "";
    name = host.substr(1, end - 1);
    port = host.substr(end + 1);
  }
  const bool is_port = port.empty() || (port.size() > 1 && port.front() == ':' &&
                                        std::all_of(port.begin() + 1, port.end(),
                                                    [](unsigned char c) { return std::isdigit(c) != 0; }));
  if (!is_port) return "";
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

bool is_address(const std::string& name) {
  in6_addr place{};
  return inet_pton(AF_INET, name.c_str(), &place) == 1 || inet_pton(AF_INET6, name.c_str(), &place) == 1;
}

}  // namespace

std::optional<std::string> refusal_of(const Caller& caller, const std::vector<std::string>& names,
                                      bool is_open) {
  if (caller.hosts > 1) return "the request has several Host lines; send one";
  const std::string name = name_of_host(caller.host);
  const bool is_own = name == "localhost" || (is_address(name) && (is_open || is_loopback(name))) ||
                      std::find(names.begin(), names.end(), name) != names.end();
  if (name.empty() || !is_own)
    return "this server does not go by the name in Host; open the address that it printed, or start it with "
           "--host NAME";
  if (!caller.origin.empty() && caller.origin != "http://" + caller.host &&
      caller.origin != "https://" + caller.host)
    return "requests from pages of other sites are refused (Origin)";
  // "same-site" are pages of another port of this machine.
  const bool is_own_page = caller.site.empty() || caller.site == "same-origin" || caller.site == "none";
  if (!is_own_page && !caller.is_page)
    return "requests from pages of other sites are refused (Sec-Fetch-Site)";
  return std::nullopt;
}

}  // namespace clearcut::serve
