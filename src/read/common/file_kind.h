// Which kind of file a part is in.
#pragma once

#include <string_view>

namespace clearcut::read {

enum class FileKind { kStep, kDxf, kSvg, kJson, kEdges, kJob, kGerber, kExcellon, kUnknown };

/// What the first bytes say, for files without a telling name. Never lengths and angles or a job: these have no mark.
FileKind kind_of_content(std::string_view text);

}  // namespace clearcut::read
