// What the server was started with, and how much it takes on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace clearcut::serve {

struct Settings {
  std::string command;                    ///< path of `clearcut`
  std::string listen = "127.0.0.1";       ///< address
  int port = 0;                           ///< 0: any that is free
  std::vector<std::string> hosts;         ///< further names that it is called by
  int jobs = 1;                           ///< plans and checks at once
  double seconds = 600;                   ///< for one of them
  std::uint64_t bytes = 0;                ///< of memory, for one of them; 0: the machine's by `jobs`
  std::size_t upload = 32U << 20;         ///< bytes of one request
  double keep_seconds = 900;              ///< results that nobody fetched or dropped
  std::size_t most_waiting = 64;          ///< plans and checks that wait for their turn
  std::size_t most_kept = 200;            ///< results; the oldest goes first
  std::size_t most_followers = 64;        ///< connections that follow a plan
  std::uint64_t file_bytes = 2ULL << 30;  ///< of each result
};

/// From the JSON that `clearcut serve` hands over. Throws InputError where an entry is of the wrong kind.
Settings settings_of(const std::string& json);

/// Whether the address is this machine's own.
bool is_loopback(const std::string& address);

}  // namespace clearcut::serve
