#include "read/read_part.h"

#include "base/files/file.h"
#include "read/job/job_file.h"

namespace clearcut::read {

Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  if (!is_job_file(file_name)) return read_part_file(text, file_name, options);
  refuse_what_is_no_part(text, file_name);
  const ReadOptions own = completed(options);
  return as_asked(part_of_job(read_job_text(text, file_name), own), own, file_name);
}

Part read_part(const std::filesystem::path& file, const ReadOptions& options) {
  return read_part_text(read_file(file.string(), kLargestPart), file.string(), options);
}

}  // namespace clearcut::read
