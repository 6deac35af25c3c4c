// Unsupported files of other programs: named by kind, with an alternative.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::read {

/// The unsupported kind unmistakably recognised from the content, for any file name: "a zip archive"; "" for none.
std::string_view foreign_content(std::string_view text, const std::string& file_name);

/// Throws InputError if the content is unmistakably of an unsupported kind, for any file name.
void refuse_foreign_content(std::string_view text, const std::string& file_name);

/// Throws InputError if the file's name is that of an unsupported kind.
void refuse_foreign_name(const std::string& file_name);

}  // namespace clearcut::read
