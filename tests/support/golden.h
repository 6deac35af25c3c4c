// Programs of the examples that must not change: some as text, all others by their digests.
#pragma once

#include <string>

namespace clearcut::test_support {

/// Of the programs of a controller in the folders of tests: ".H" where the customary one, Klartext's ".h", is that of a C header.
std::string ending_in_tests(const std::string& dialect);

/// "" where `program` is the golden one, else what differs. `name` is the file's in tests/golden/examples: "bracket/haas-mm.nc". As text
/// it stands there; otherwise its SHA-256 is a line of digests.txt there, and a program that differs is kept in the folder golden
/// of the build to be looked at. Where CLEARCUT_UPDATE_GOLDEN is set, writes what is golden from now on; run one process then.
std::string difference_from_golden(const std::string& name, const std::string& program, bool as_text);

}  // namespace clearcut::test_support
