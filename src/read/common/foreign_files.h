// Kind of a part's file, and unsupported files of other programs: named by kind, with an alternative.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::read {

enum class FileKind { kStep, kDxf, kSvg, kJson, kEdges, kJob, kGerber, kExcellon, kUnknown };

/// Kind by the first bytes, for files without a known extension. Never lengths and angles or a job: these have no
/// mark.
FileKind kind_of_content(std::string_view text);

/// The unsupported kind unmistakably recognised from the content, for any file name: "a zip archive"; "" for none.
std::string_view foreign_content(std::string_view text, const std::string& file_name);

/// Throws InputError if the content is unmistakably of an unsupported kind, for any file name.
void refuse_foreign_content(std::string_view text, const std::string& file_name);

/// Throws InputError if the file's name is that of an unsupported kind.
void refuse_foreign_name(const std::string& file_name);

}  // namespace clearcut::read
