// The options of a request: as on the command line, but without access to files of this machine.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::serve {

/// One option of a command, from `clearcut generate options`.
struct KnownOption {
  std::vector<std::string> names;  ///< "-o", "--output"
  bool takes_value = false;
  bool takes_many = false;
  bool is_file = false;
  bool is_refused = false;  ///< names a result, which the server chooses, or requests no work
};

/// The options of one command, from that JSON. Throws InputError for other text.
std::vector<KnownOption> known_options(std::string_view json, const std::string& command);

/// Words separated as in a shell: by blanks, with quotes holding them together. Throws InputError for an unclosed
/// quote.
std::vector<std::string> words_of(std::string_view text);

/// The words for calling the command, each option with its value in one word: "--tool=endmill:6". Throws InputError
/// for words other than the command's options, for options set by the server, and for files outside of `files`.
std::vector<std::string> checked_words(const std::vector<std::string>& words,
                                       const std::vector<KnownOption>& options,
                                       const std::set<std::string>& files);

/// Throws InputError if a job (TOML) could name a file in another folder: a slash or a backslash outside of its
/// comments, or a text of several lines, in which comments cannot be recognised.
void check_job(const std::string& text, const std::string& name);

}  // namespace clearcut::serve
