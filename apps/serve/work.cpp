#include "serve/work.h"

#include <clearcut/error.h>
#include <clearcut/file.h>

#include <fstream>

namespace clearcut::serve {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostMessages = 200;
constexpr std::size_t kLargestCertificate = 128U << 20;

const std::string kOwnName = "clearcut: ";

}  // namespace

std::string name_of(WorkState state) {
  switch (state) {
    case WorkState::kWaiting:
      return "waiting";
    case WorkState::kRunning:
      return "running";
    case WorkState::kDone:
      return "done";
    case WorkState::kFailed:
      return "failed";
    case WorkState::kCancelled:
      return "cancelled";
  }
  return "failed";
}

Work::~Work() {
  std::error_code ignored;
  fs::remove_all(folder.parent_path(), ignored);
}

void ChildTalk::read(Json& progress, std::vector<std::string>& messages) {
  std::ifstream file(log_, std::ios::binary);
  if (!file) return;
  file.seekg(static_cast<std::streamoff>(at_));
  constexpr std::size_t kMost = 65536;
  std::string text(kMost, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  at_ += text.size();
  rest_ += text;
  for (std::size_t end = 0; (end = rest_.find('\n')) != std::string::npos; rest_.erase(0, end + 1)) {
    std::string line = rest_.substr(0, end);
    if (line.starts_with("{\"progress\"")) {
      const Json json = Json::parse(line, nullptr, false);
      if (!json.is_discarded()) progress = json.at("progress");
      continue;
    }
    if (line.starts_with(kOwnName)) line.erase(0, kOwnName.size());
    if (!line.empty() && messages.size() < kMostMessages) messages.push_back(line);
  }
}

WorkEnd end_of(const fs::path& folder, int exit_code, const std::vector<std::string>& messages) {
  constexpr int kLastWithResults = 1;
  WorkEnd end;
  end.exit_code = exit_code;
  const fs::path certificate = folder / "results" / "certificate.json";
  if (exit_code <= kLastWithResults && fs::exists(certificate)) {
    const Json json = Json::parse(read_file(certificate.string(), kLargestCertificate), nullptr, false);
    if (!json.is_discarded()) end.verdict = json.value("verdict", "");
    return end;
  }
  end.state = WorkState::kFailed;
  end.message = messages.empty() ? "ended without a result" : messages.back();
  return end;
}

}  // namespace clearcut::serve
