// The options of a request: as on the command line, and no way to a file of this machine.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::serve {

/// One option of a command, as `clearcut generate options` says it.
struct KnownOption {
  std::vector<std::string> names;  ///< "-o", "--output"
  bool takes_value = false;
  bool takes_many = false;
  bool is_file = false;
  bool is_refused = false;  ///< names a result, which the server chooses, or is no work at all
};

/// Of one command, from that JSON. Throws InputError for other text.
std::vector<KnownOption> known_options(std::string_view json, const std::string& command);

/// Words as a shell takes them apart: blanks part them, quotes hold them together. Throws InputError for a quote that stays open.
std::vector<std::string> words_of(std::string_view text);

/// The words as the command is called with, each option with its value in one: "--tool=endmill:6". Throws InputError for words
/// that are no option of the command, for options that the server sets, and where a file is named that is not one of `files`.
std::vector<std::string> checked_words(const std::vector<std::string>& words,
                                       const std::vector<KnownOption>& options,
                                       const std::set<std::string>& files);

/// Throws InputError where a job (TOML) could name a file in another folder: a slash or a backslash outside of its comments, or
/// a text of several lines, in which comments cannot be told.
void check_job(const std::string& text, const std::string& name);

}  // namespace clearcut::serve
