// Files of other programs that are not read: named for what they are, with what to do instead.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::read {

/// What the content unmistakably is, of the kinds that are not read, whatever the file is called: "a zip archive"; "" for none.
std::string_view foreign_content(std::string_view text, const std::string& file_name);

/// Throws InputError where the content is unmistakably of a kind that is not read, whatever the file is called.
void refuse_foreign_content(std::string_view text, const std::string& file_name);

/// Throws InputError where the file's name says that it is of a kind that is not read.
void refuse_foreign_name(const std::string& file_name);

}  // namespace clearcut::read
