// Accepts connections and gives each a thread for its one request.
#pragma once

#include <httplib.h>

#include "serve/connections/connection.h"

namespace clearcut::serve {

/// The library's server, with connections of ours. Clients that are silent, that send or take a little now and then, or that come
/// in numbers cannot keep others out: where all threads are taken, the oldest connection that waits for its client makes room.
class Listener : public httplib::Server {
 public:
  Listener();
  /// Ends it, and does not wait for clients. From another thread.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;

  WaitingConnections waiting_;
};

}  // namespace clearcut::serve
