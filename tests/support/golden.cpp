#include "support/golden.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "base/file.h"
#include "post/post.h"
#include "support/programs.h"

namespace clearcut::test_support {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  return fs::path(CLEARCUT_SOURCE_DIR) / "tests/golden/examples";
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// By the names of programs.
std::map<std::string, std::string> digests() {
  std::map<std::string, std::string> all;
  std::ifstream file(folder() / "digests.txt");
  for (std::string digest, name; file >> digest >> name;) all[name] = digest;
  return all;
}

void keep_digest(const std::string& name, const std::string& digest) {
  auto all = digests();
  all[name] = digest;
  std::string text;
  for (const auto& [of, one] : all) text += one + "  " + of + "\n";
  write(folder() / "digests.txt", text);
}

}  // namespace

std::string ending_in_tests(const std::string& dialect) {
  const std::string customary = post::file_extension_of(dialect);
  return customary == ".h" ? ".H" : customary;
}

std::string difference_from_golden(const std::string& name, const std::string& program, bool as_text) {
  const bool is_update = std::getenv("CLEARCUT_UPDATE_GOLDEN") != nullptr;
  if (as_text) {
    if (is_update) write(folder() / name, program);
    return first_difference(program, read_file((folder() / name).string()));
  }
  const std::string digest = sha256_hex(program);
  if (is_update) keep_digest(name, digest);
  const auto all = digests();
  const auto found = all.find(name);
  if (found != all.end() && found->second == digest) return "";
  const fs::path kept = fs::path(CLEARCUT_BINARY_DIR) / "golden" / name;
  write(kept, program);
  return name + " is not the golden program; this one is kept as " + kept.string();
}

}  // namespace clearcut::test_support
