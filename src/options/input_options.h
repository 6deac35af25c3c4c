// Options on a part's input file and on the material of the part. Absent values are left to the file.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline options {

/// Lengths in mm. Texts are as given by the user; the readers interpret them.
struct InputOptions {
  std::optional<std::string> origin;  ///< "corner", "centre" or "X,Y,Z"
  std::optional<int> setup;           ///< number of the set-up of a job, from 1
  std::vector<std::string> earlier_setups;
  std::optional<std::string> unit;
  std::vector<std::string> layers;
  std::vector<std::string> operations;  ///< "KIND:SELECTION"
  std::optional<double> top, depth;
  std::optional<std::string> stock_from;
  bool mirror = false;
  std::optional<double> scale, join_gap;
  std::optional<std::string> strokes, text, open_curves;
  std::optional<bool> find_arcs;
  std::optional<std::string> up, body;
  std::optional<double> turn_deg;
  std::optional<double> breakthrough;
  std::optional<double> clearance_z;
  std::vector<std::string> tools;  ///< "endmill:6"
  std::optional<std::string> tool_library;
  std::optional<std::string> machine_file, machine_kind;
  std::vector<std::string> predrilled, keep_outs;
  std::optional<std::string> after;
};

}  // namespace clearcut::inline options
