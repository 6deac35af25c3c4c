// Accepts connections and gives each a thread for its one request.
#pragma once

#include <httplib.h>

#include "serve/connections/connection.h"

namespace clearcut::serve {

/// The library's server, with Clearcut's own connections. Silent, slow or numerous clients cannot block others: if
/// all threads are in use, the oldest connection waiting for its client is closed.
class Listener : public httplib::Server {
 public:
  Listener();
  /// Ends the server without waiting for clients. Called from another thread.
  void end();

 private:
  bool process_and_close_socket(socket_t socket) override;

  WaitingConnections waiting_;
};

}  // namespace clearcut::serve
