#include "read/common/file_kind.h"

#include <cstddef>

namespace clearcut::read {

FileKind kind_of_content(std::string_view text) {
  const std::string_view head = text.substr(0, 4096);
  const std::size_t first = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos) return FileKind::kUnknown;
  if (head.substr(first, 12) == "ISO-10303-21") return FileKind::kStep;
  if (head[first] == '{') return FileKind::kJson;
  if (head.substr(first, 3) == "M48") return FileKind::kExcellon;
  if (head.find("%FSLA") != std::string_view::npos || head.find("%FSTA") != std::string_view::npos)
    return FileKind::kGerber;
  if (head.find("<svg") != std::string_view::npos) return FileKind::kSvg;
  // After comments; in an SVG it may be the beginning of a path's line.
  if (head.find("\nM48") != std::string_view::npos || head.find("\rM48") != std::string_view::npos)
    return FileKind::kExcellon;
  if (head.find("SECTION") != std::string_view::npos) return FileKind::kDxf;
  return FileKind::kUnknown;
}

}  // namespace clearcut::read
