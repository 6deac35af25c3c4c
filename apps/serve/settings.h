// Start settings of the server, and its limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace clearcut::serve {

struct Settings {
  std::string command;               ///< path of `clearcut`
  std::string listen = "127.0.0.1";  ///< address
  int port = 0;                      ///< 0: any free one
  std::vector<std::string> hosts;    ///< further names of the server
  int jobs = 1;                      ///< plans and checks at once
  double seconds = 600;              ///< for one of them
  /// Memory limit of one job; 0: the machine's memory divided by `jobs`.
  std::uint64_t bytes = 0;
  std::size_t upload = 32U << 20;         ///< bytes of one request
  double keep_seconds = 900;              ///< lifetime of results neither fetched nor dropped
  std::size_t most_waiting = 64;          ///< waiting plans and checks
  std::size_t most_kept = 200;            ///< number of kept results; the oldest is removed first
  std::size_t most_followers = 64;        ///< connections following a plan
  std::uint64_t file_bytes = 2ULL << 30;  ///< greatest size of each result
};

/// Settings from the JSON passed by `clearcut serve`. Throws InputError if an entry is of the wrong kind.
Settings settings_of(const std::string& json);

/// Whether the address is this machine's own.
bool is_loopback(const std::string& address);

}  // namespace clearcut::serve
