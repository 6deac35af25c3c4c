// Files uploaded with a request.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace clearcut::serve {

/// Why a request is not served.
struct Refusal {
  int status = 400;  ///< HTTP status
  std::string text;
};

inline constexpr const char* kTooLarge =
    "the request is larger than this server takes; start it with a larger --upload";

/// Throws Refusal for anything other than a plain file name: folders, names with a dot or dash in front, unprintable
/// letters.
void check_name(const std::string& name);

/// Takes the fields of a form (multipart/form-data) as they arrive: files are written to a separate folder at once,
/// so that memory does not grow with them. The folder around it is removed with this object unless taken.
class Upload {
 public:
  /// Throws Refusal if `bytes` are exceeded or the time is over.
  Upload(std::filesystem::path folder, std::size_t bytes);
  ~Upload();
  Upload(const Upload&) = delete;
  Upload& operator=(const Upload&) = delete;

  /// A field begins; `file_name` is "" for fields other than files.
  void begin(const std::string& field, const std::string& file_name);
  void add(const char* data, std::size_t size);
  void finish();

  /// Name of the file of a field, "" if not sent.
  std::string file_of(const std::string& field) const;
  /// Text of a field other than a file.
  std::string text_of(const std::string& field) const;
  const std::set<std::string>& files() const { return files_; }
  const std::filesystem::path& folder() const { return folder_; }
  /// The folder is the caller's now.
  std::filesystem::path take();

 private:
  std::filesystem::path folder_;
  std::size_t left_;
  bool is_taken_ = false;
  std::ofstream file_;
  std::string* text_ = nullptr;
  std::map<std::string, std::string> file_of_field_, text_of_field_;
  std::set<std::string> files_;
};

}  // namespace clearcut::serve
