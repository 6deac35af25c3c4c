// The parts of a batch: which files, what each result is called, and what its bytes depend on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clearcut::cli {

struct BatchPart {
  std::string file;                  ///< as it is given to `plan`
  std::vector<std::string> options;  ///< of its own, from its line of the list
  std::string name;                  ///< of its results, below the output folder; unique
};

/// The parts in a folder and the folders below it, by name, but for `output`; or those of a list: one part a line, options of its own after it,
/// '#' begins a comment, names are looked for beside the list. Throws InputError where there are none.
std::vector<BatchPart> batch_parts(const std::string& folder_or_list, const std::string& output);

/// Names everything that a part's results depend on: this program's version, the options, and the bytes of the part and of
/// every file that options or a job name.
std::string batch_key(const BatchPart& part, const std::vector<std::string>& options);

}  // namespace clearcut::cli
