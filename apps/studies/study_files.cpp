#include "study_files.h"

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include "terminal/output.h"

namespace clearcut::cli {

namespace fs = std::filesystem;

StudyProgress::StudyProgress(const StudyCommand& command, int done, int total) {
  if (command.quiet || !is_watched()) return;
  const bool keeps = !command.csv.empty() && command.csv != "-";
  line_.emplace(keeps ? "Ctrl-C stops; runs that are done are kept." : kStops);
  show(done, total);
}

void StudyProgress::show(int done, int total) {
  if (line_) line_->count(static_cast<std::size_t>(done), static_cast<std::size_t>(total), "runs");
}

RowFile::RowFile(const StudyCommand& command, const studies::GeneticStudy& study)
    : command_(command), study_(study), is_file_(!command.csv.empty() && command.csv != "-") {}

std::string RowFile::begin() const {
  if (!is_file_) return "";
  const std::string before = fs::exists(command_.csv) ? read_file(command_.csv) : "";
  const auto rows = studies::study_rows(study_, command_.options, before);
  std::string complete = studies::study_csv(study_, command_.options, rows);
  if (complete != before) write_outputs({{command_.csv, complete}}, {});
  return complete;
}

void RowFile::append(const std::string& lines) const {
  if (!is_file_) return;
  const int file = open(command_.csv.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const ssize_t written = file < 0 ? -1 : ::write(file, lines.data(), lines.size());
  if (file >= 0) close(file);
  if (written != static_cast<ssize_t>(lines.size()))
    throw InputError(command_.csv, "cannot be appended to; see that it is writable and the disk not full");
}

std::vector<std::string> StateFolder::names() const {
  std::vector<std::string> all;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder_, none)) all.push_back(entry.path().filename());
  std::sort(all.begin(), all.end());
  return all;
}

std::optional<std::string> StateFolder::read(const std::string& name) const {
  const fs::path path = folder_ / name;
  if (!fs::exists(path)) return {};
  return read_file(path);
}

void StateFolder::write(const std::string& name, const std::string& text) {
  std::error_code error;
  fs::create_directories(folder_, error);
  write_files({{folder_ / name, text}});
}

void StateFolder::erase(const std::string& name) {
  std::error_code ignored;
  fs::remove(folder_ / name, ignored);
  fs::remove(folder_, ignored);  // if this was the last one
}

}  // namespace clearcut::cli
