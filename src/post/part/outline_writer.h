// Outline JSON: a part's features as read_outline_json reads them again; see docs/input.md.
#pragma once

#include <string>

#include "model/part.h"

namespace clearcut::post {

/// One pocket for every region of every feature, in order of the workplan, with kind, tops, depths and
/// slopes, and the stock. Tools and operations have no place in this format. Numbers are written so that they read
/// back equal (bulges lose at most the last digits). mm.
std::string write_outline_json(const Part& part);

}  // namespace clearcut::post
