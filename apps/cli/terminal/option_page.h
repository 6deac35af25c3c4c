// The table of all options of a plan, as a page of the documentation.
#pragma once

#include <string>

namespace clearcut::cli {

/// Markdown, one row an option, made from the options' table.
std::string options_page();

}  // namespace clearcut::cli
