// Stands in for session_folder.cpp on Windows, where the temporary folder is the user's own. No process can wait here for the
// end of this one and be sure to outlive it, so a killed server's folder is removed by the next: whose file `alive` nobody holds open.
#include <clearcut/error.h>
#include <windows.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "process/own_process.h"
#include "process/windows_job.h"
#include "serve/works/session_folder.h"
#include "serve/works/work_list.h"

namespace clearcut::serve {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kName = "clearcut-serve-";

void remove_folders_of_killed_servers(const fs::path& all) {
  std::error_code ignored;
  for (const auto& one : fs::directory_iterator(all, ignored)) {
    if (!one.path().filename().string().starts_with(kName)) continue;
    fs::remove(one.path() / "alive", ignored);  // fails while its server runs
    if (!fs::exists(one.path() / "alive", ignored)) fs::remove_all(one.path(), ignored);
  }
}

}  // namespace

struct SessionFolder::Watch {
  explicit Watch(const fs::path& file)
      : alive(CreateFileW(file.c_str(), GENERIC_WRITE, FILE_SHARE_READ, nullptr, CREATE_NEW,
                          FILE_ATTRIBUTE_NORMAL, nullptr)) {}
  process::Handle alive;
};

SessionFolder::SessionFolder() {
  std::error_code failed;
  const fs::path all = fs::temp_directory_path(failed);
  remove_folders_of_killed_servers(all);
  const fs::path folder = all / (std::string(kName) + new_id());
  fs::create_directory(folder, failed);
  path_ = folder.generic_string();
  watch_ = std::make_unique<Watch>(folder / "alive");
  if (!watch_->alive.is_open())
    throw InputError("the folder for temporary files", "cannot be used; set TMP to one that has room");
}

SessionFolder::~SessionFolder() {
  watch_.reset();
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace clearcut::serve
