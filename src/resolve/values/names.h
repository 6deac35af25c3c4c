// The names by which options and files choose: the one place that turns them into values.
#pragma once

#include <string>

#include "model/options/feed_rule.h"
#include "model/options/strategy_entry.h"
#include "model/part.h"

namespace clearcut::resolve {

/// The row of a strategy; null for "auto". Throws InputError at `place` that lists the names there are.
const StrategyEntry* strategy_named(const std::string& name, const StrategyTable& strategies,
                                    const std::string& place);

/// What a strategy that a STEP-NC file names is here: "contour_parallel" is "contour". "" where there is none like it.
std::string strategy_of_stepnc(const std::string& name);

/// "helix", "ramp", "zigzag", "plunge". Throws InputError at `place`.
EntryKind entry_named(const std::string& name, const std::string& place);
const char* name_of(EntryKind entry);

/// "climb", "conventional". Throws InputError at `place`.
CutDirection direction_named(const std::string& name, const std::string& place);
/// "off", "flood", "mist", "both".
Coolant coolant_named(const std::string& name, const std::string& place);
const char* name_of(CutDirection direction);
/// "chip", "removal". Throws InputError at `place`.
FeedBy feed_by_named(const std::string& name, const std::string& place);
const char* name_of(FeedBy by);

/// "inside-out", "outside-in". Throws InputError at `place`.
ContourOrder order_named(const std::string& name, const std::string& place);
const char* name_of(ContourOrder order);

const char* name_of(Finish finish);

/// "square", "triangular". Throws InputError at `place`.
TabShape tab_shape_named(const std::string& name, const std::string& place);
const char* name_of(TabShape shape);

/// What the texts print, or ours: "bisector" or "shortest" passages, a "corner" or "round" contours at reflex corners, the "published" grid or "ours", the "published" solver or the
/// "modern" one; true for what is printed. Throw InputError at `place`.
bool is_bisector_passage(const std::string& name, const std::string& place);
bool is_reflex_corner(const std::string& name, const std::string& place);
bool is_published_grid(const std::string& name, const std::string& place);
bool is_published_solver(const std::string& name, const std::string& place);

}  // namespace clearcut::resolve
