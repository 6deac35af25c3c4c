// Accepted sockets: what differs between systems. The headers of the library bring the rest.
#pragma once

#include <httplib.h>

#include <chrono>
#include <cstddef>

namespace clearcut::serve {

enum class Direction : unsigned char { kInput, kOutput };

/// Prepares an accepted socket for the following functions.
void prepare_socket(socket_t socket);

/// Whether data can be received from, or sent to, the socket within this time.
bool is_ready(socket_t socket, Direction direction, std::chrono::milliseconds time);

/// Receives or sends what is possible without waiting; -1 for none. Receiving gives 0 at the end.
ssize_t receive_now(socket_t socket, char* data, std::size_t size);
ssize_t send_now(socket_t socket, const char* data, std::size_t size);

/// Whether the client has closed its side and everything from it was received.
bool has_ended(socket_t socket);

/// Ends both directions; whoever waits for the socket goes on.
void shut_socket(socket_t socket);
void close_socket(socket_t socket);

}  // namespace clearcut::serve
