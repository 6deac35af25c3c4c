// Results of a plan or a check for download: names in addresses, files in its folder, media types.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::serve {

struct ResultKind {
  const char* name;    ///< in addresses, and of its file
  const char* ending;  ///< ending of its file, with the dot
  const char* type;    ///< media type
  const char* what;    ///< in a sentence
  bool is_numbered;    ///< jobs of several set-ups have one for each: "program-2"
};

std::span<const ResultKind> result_kinds();

/// The kind for a name in an address, "program" or "program-2"; null if unknown.
const ResultKind* kind_of_result(std::string_view name);

/// Its file, within the folder of results. `kind` must be the kind of `name`.
std::string file_of_result(const ResultKind& kind, std::string_view name);

/// Names of the existing results in a folder, in the order of result_kinds(), set-up by set-up.
std::vector<std::string> results_in(const std::filesystem::path& folder);

}  // namespace clearcut::serve
