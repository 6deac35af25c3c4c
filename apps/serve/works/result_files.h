// The only folder in which the server stores files, and results of a plan or a check for download: names in
// addresses, files in its folder, media types.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::serve {

/// A new folder not readable by other users. It is removed with this object, and also if this process is killed: a
/// separate process waits for this. Must be made before the first thread.
class SessionFolder {
 public:
  SessionFolder();
  ~SessionFolder();
  SessionFolder(const SessionFolder&) = delete;
  SessionFolder& operator=(const SessionFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int alive_ = -1;  ///< closed at any end of this process
  pid_t remover_ = -1;
};

struct ResultKind {
  const char* name;    ///< in addresses, and of its file
  const char* ending;  ///< ending of its file, with the dot
  const char* type;    ///< media type
  const char* what;    ///< in a sentence
  bool is_numbered;    ///< jobs of several set-ups have one for each: "program-2"
};

std::span<const ResultKind> result_kinds();

/// The kind for a name in an address, "program" or "program-2"; null if unknown.
const ResultKind* kind_of_result(std::string_view name);

/// Its file, within the folder of results. `kind` must be the kind of `name`.
std::string file_of_result(const ResultKind& kind, std::string_view name);

/// Names of the existing results in a folder, in the order of result_kinds(), set-up by set-up.
std::vector<std::string> results_in(const std::filesystem::path& folder);

}  // namespace clearcut::serve
