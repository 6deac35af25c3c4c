// Writes a part as outline JSON, as read_outline_json reads it again (see docs/input.md), and as a STEP-NC program:
// ISO 14649-10/-11 entities in an ISO 10303-21 file.
#pragma once

#include <string>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::post {

/// One pocket for every region of every feature, in order of the workplan, with kind, tops, depths and
/// slopes, and the stock. Tools and operations have no place in this format. Numbers are written so that they read
/// back equal (bulges lose at most the last digits). mm.
std::string write_outline_json(const Part& part);

/// Shape   one file: project, workplan in order, set-up with security plane and stock block, features, tools,
/// cutting
///         data. Depths relative to the feature (the standard), outlines counter-clockwise, arcs as trimmed
///         circles.
/// Units   m/s, 1/s (negative clockwise), mm, radians.
/// Error   numbers are shortest decimals that read back to the same double: vertices and tools are kept
/// exactly. Losses  a feature of several regions becomes several features ("name", "name (2)", ...); a slot that is
///         neither a rectangle nor rounded at both ends, and a non-rectangular step, become open pockets (closed if
///         they do not reach the stock's edge); Tool::center_cutting follows from the kind of tool; strategy names
///         unknown to the standard are left out. Values without a word in the standard (plunge feed, ramp feed, slot
///         feed, scallop height) are written into the property list of the machine functions.
/// Throws  InputError if a number is not finite, a workingstep has no tool, or a feature is a line to follow
///         (profiles, engraving). The same part gives the same bytes.
std::string write_stepnc(const Part& part);

/// The same with the toolpath of every workingstep: EXPLICIT_STRATEGY and a TOOLPATH_LIST, usable by readers
/// unchanged. The workingsteps are in the order of `toolpath`, followed by those it does not cut; a feature of
/// several regions is a compound. `toolpath`: planned for `part`, with workingsteps named by its sections; taken
/// before printing, so that printing it again gives the same digits.
std::string write_stepnc(const Part& part, const Toolpath& toolpath);

}  // namespace clearcut::post
