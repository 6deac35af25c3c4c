#include "serve/works/work.h"

#include <clearcut/error.h>
#include <clearcut/file.h>

#include <fstream>

#include "serve/works/result_files.h"

namespace clearcut::serve {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostMessages = 200;
constexpr std::size_t kLargestCertificate = 128U << 20;

const std::string kOwnName = "clearcut: ";

std::string verdict_of_file(const fs::path& certificate) {
  const Json json = Json::parse(read_file(certificate.string(), kLargestCertificate), nullptr, false);
  return json.is_object() ? json.value("verdict", "") : "";
}

/// Greater is worse. A verdict without a part has more words.
int rank(std::string_view verdict) {
  if (verdict.starts_with("FAULTY")) return 3;
  if (verdict.starts_with("CONDITIONAL")) return 2;
  return verdict.empty() ? 0 : 1;
}

/// The worst of all certificates; "" if there is none.
std::string verdict_in(const fs::path& results) {
  std::string worst;
  for (const std::string& name : results_in(results)) {
    const ResultKind& kind = *kind_of_result(name);
    if (std::string_view(kind.name) != "certificate") continue;
    const std::string verdict = verdict_of_file(results / file_of_result(kind, name));
    if (rank(verdict) > rank(worst)) worst = verdict;
  }
  return worst;
}

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

WorkEnd end_of(const Work& work, int exit_code) {
  constexpr int kLastWithResults = 1;
  WorkEnd end;
  end.exit_code = exit_code;
  const bool has_results = exit_code <= kLastWithResults;
  if (has_results && work.has_verdict) end.verdict = verdict_in(work.folder / "results");
  if (has_results && (!work.has_verdict || !end.verdict.empty())) return end;
  end.state = WorkState::kFailed;
  end.message = work.messages.empty() ? "ended without a result" : work.messages.back();
  return end;
}

}  // namespace clearcut::serve
