// The parts of the page common to all jobs: the files of viewer/, embedded by the build
// (cmake/ClearcutViewer.cmake).
#pragma once

namespace clearcut::report {

/// Rules of style; colours are variables written by html() from the palette.
extern const char* const kHtmlStyle;
/// Elements of the body; filled by the script.
extern const char* const kHtmlBody;
/// The player. Reads the JSON of html_data() from the element "job".
extern const char* const kHtmlScript;

}  // namespace clearcut::report
