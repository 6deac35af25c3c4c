// What a plan or a check leaves to be fetched: names in addresses, files in its folder, media types.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::serve {

struct ResultKind {
  const char* name;    ///< in addresses, and of its file
  const char* ending;  ///< of its file, with the dot
  const char* type;    ///< media type
  const char* what;    ///< in a sentence
  bool is_numbered;    ///< jobs of several set-ups have one for each: "program-2"
};

std::span<const ResultKind> result_kinds();

/// Of a name in an address, "program" or "program-2"; null where nothing is called so.
const ResultKind* kind_of_result(std::string_view name);

/// Its file, within the folder of results. `kind` is that of `name`.
std::string file_of_result(const ResultKind& kind, std::string_view name);

/// Names of the results that there are in a folder, in the order of result_kinds(), set-up by set-up.
std::vector<std::string> results_in(const std::filesystem::path& folder);

}  // namespace clearcut::serve
