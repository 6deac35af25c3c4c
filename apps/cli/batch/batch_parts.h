// The parts of a batch: files, names of results, and keys of their dependencies.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clearcut::cli {

struct BatchPart {
  std::string file;                  ///< as given to `plan`
  std::vector<std::string> options;  ///< its own options, from its line of the list
  std::string name;                  ///< unique name of its results, below the output folder
};

/// The parts in a folder and the folders below it, by name, except in `output`; or those of a list: one part per
/// line, followed by its own options; '#' begins a comment; names are relative to the list. Throws InputError if
/// there are none.
std::vector<BatchPart> batch_parts(const std::string& folder_or_list, const std::string& output);

/// Key of all dependencies of a part's results: this program's version, the options, and the bytes of the part and of
/// every file named in options or a job.
std::string batch_key(const BatchPart& part, const std::vector<std::string>& options);

}  // namespace clearcut::cli
