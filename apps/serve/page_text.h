// The page for people, as the files in page/ are.
#pragma once

namespace clearcut::serve {

extern const char* const kPageHtml;
extern const char* const kPageStyle;
extern const char* const kPageScript;

}  // namespace clearcut::serve
