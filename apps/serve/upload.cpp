#include "serve/upload.h"

#include <algorithm>

namespace clearcut::serve {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostFiles = 50;
constexpr std::size_t kLongestName = 120;
constexpr std::size_t kLongestText = 16384;

const std::set<std::string> kFileFields{"part", "program", "job", "points", "file"};
const std::set<std::string> kTextFields{"options", "lattice"};

}  // namespace

void check_name(const std::string& name) {
  const bool has_control =
      std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 127; });
  const bool is_plain = !name.empty() && name.size() <= kLongestName &&
                        name.find_first_of("/\\") == std::string::npos && name.front() != '.' &&
                        name.front() != '-' && !has_control && name != "results";
  if (!is_plain)
    throw Refusal{400, "a file's name must be a plain name such as part.dxf, without folders, of at most " +
                           std::to_string(kLongestName) + " letters"};
}

Upload::Upload(fs::path folder, std::size_t bytes) : folder_(std::move(folder)), left_(bytes) {
  fs::create_directories(folder_ / "results");
}

Upload::~Upload() {
  if (is_taken_) return;
  file_.close();
  std::error_code ignored;
  fs::remove_all(folder_.parent_path(), ignored);
}

void Upload::begin(const std::string& field, const std::string& file_name) {
  finish();
  if (kTextFields.contains(field)) {
    text_ = &text_of_field_[field];
    return;
  }
  if (!kFileFields.contains(field))
    throw Refusal{400, "'" + field.substr(0, kLongestName) +
                           "' is no field; GET /openapi.json lists those of each request"};
  check_name(file_name);
  if (!files_.insert(file_name).second) throw Refusal{400, "two files have the same name: " + file_name};
  if (files_.size() > kMostFiles) throw Refusal{400, "too many files; at most " + std::to_string(kMostFiles)};
  if (field != "file" && !file_of_field_.emplace(field, file_name).second)
    throw Refusal{400, "one " + field + " at a time; send others as 'file'"};
  file_.open(folder_ / file_name, std::ios::binary);
}

void Upload::add(const char* data, std::size_t size) {
  if (size > left_) throw Refusal{413, kTooLarge};
  left_ -= size;
  if (text_ != nullptr) {
    if (text_->size() + size > kLongestText) throw Refusal{413, "options are longer than this server takes"};
    text_->append(data, size);
  } else if (file_.is_open()) {
    file_.write(data, static_cast<std::streamsize>(size));
    if (!file_) throw Refusal{507, "there is no room for the files"};
  }
}

void Upload::finish() {
  text_ = nullptr;
  if (!file_.is_open()) return;
  file_.close();
  if (!file_) throw Refusal{507, "there is no room for the files"};
}

std::string Upload::file_of(const std::string& field) const {
  const auto found = file_of_field_.find(field);
  return found == file_of_field_.end() ? "" : found->second;
}

std::string Upload::text_of(const std::string& field) const {
  const auto found = text_of_field_.find(field);
  return found == text_of_field_.end() ? "" : found->second;
}

fs::path Upload::take() {
  finish();
  is_taken_ = true;
  return folder_;
}

}  // namespace clearcut::serve
