// Runs the command as a user would.
#pragma once

#include <string>
#include <vector>

namespace clearcut::test_support {

struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the built `clearcut` with these arguments, without a shell's interpretation of them.
CommandResult run_clearcut(const std::vector<std::string>& arguments);

/// A new empty folder that is removed with this object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  /// Writes a file in the folder and returns its path.
  std::string file(const std::string& name, const std::string& content) const;
  std::vector<std::string> names() const;

 private:
  std::string folder_;
};

}  // namespace clearcut::test_support
