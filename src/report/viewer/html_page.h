// The parts of the page that are the same for every job: the files of viewer/, embedded by the build
// (cmake/ClearcutViewer.cmake).
#pragma once

namespace clearcut::report {

/// Rules of style; colours are the variables that html() writes from the palette.
extern const char* const kHtmlStyle;
/// Elements of the body; filled by the script.
extern const char* const kHtmlBody;
/// The player. Reads the JSON of html_data() from the element "job".
extern const char* const kHtmlScript;

}  // namespace clearcut::report
