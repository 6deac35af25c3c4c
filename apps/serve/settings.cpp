#include "serve/settings.h"

#include <clearcut/error.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "process/own_process.h"

namespace clearcut::serve {

Settings settings_of(const std::string& text) {
  Settings out;
  try {
    const auto json = nlohmann::json::parse(text);
    json.at("command").get_to(out.command);
    out.listen = json.value("listen", out.listen);
    out.port = json.value("port", out.port);
    out.hosts = json.value("hosts", out.hosts);
    out.jobs = json.value("jobs", 0);
    out.seconds = json.value("seconds", out.seconds);
    out.bytes = json.value("bytes", out.bytes);
    out.upload = json.value("upload", out.upload);
    out.keep_seconds = json.value("keep_seconds", out.keep_seconds);
  } catch (const nlohmann::json::exception&) {
    throw InputError("clearcut-serve", "is run by `clearcut serve`; run that");
  }
  if (out.jobs < 1) out.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (out.bytes == 0) out.bytes = process::memory_share(out.jobs);
  return out;
}

bool is_loopback(const std::string& address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

}  // namespace clearcut::serve
