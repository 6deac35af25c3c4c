// The only folder in which the server stores files.
#pragma once

#include <memory>
#include <string>

namespace clearcut::serve {

/// A new folder not readable by other users. It is removed with this object, and also if this process is killed: at once
/// by a separate process that waits for this, on Windows by the next server. Must be made before the first thread.
class SessionFolder {
 public:
  SessionFolder();
  ~SessionFolder();
  SessionFolder(const SessionFolder&) = delete;
  SessionFolder& operator=(const SessionFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  struct Watch;
  std::string path_;
  std::unique_ptr<Watch> watch_;  ///< notices any end of this process
};

}  // namespace clearcut::serve
