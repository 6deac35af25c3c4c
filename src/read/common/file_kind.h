// Kind of a part's file.
#pragma once

#include <string_view>

namespace clearcut::read {

enum class FileKind { kStep, kDxf, kSvg, kJson, kEdges, kJob, kGerber, kExcellon, kUnknown };

/// Kind by the first bytes, for files without a known extension. Never lengths and angles or a job: these have no
/// mark.
FileKind kind_of_content(std::string_view text);

}  // namespace clearcut::read
