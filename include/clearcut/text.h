// Numbers and tables as text, without locale.
#pragma once

#include "base/text.h"
#include "report/words/text_table.h"

namespace clearcut {

using report::fitted;
using report::markdown;
using report::plain;
using report::TextTable;
using report::wrapped;

}  // namespace clearcut
