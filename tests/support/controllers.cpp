#include "support/controllers.h"

#include <stdexcept>

namespace clearcut::test_support {

namespace {

constexpr std::string_view kStoredHome = " G91 G28 Z0 G28 X0 Y0 G90";
constexpr std::string_view kReferenceHome = " G91 G28 Z0. G28 X0. Y0. G90";

}  // namespace

std::span<const Controller> controllers() {
  static const std::vector<Controller> rows{
      {.name = "linuxcnc",
       .line_length = 255,
       .work_offsets = {"G55", "G59", "G59.1", "G59.3"},
       .work_offsets_said = "it has G54 to G59, G59.1 to G59.3",
       .home = kStoredHome,
       .home_condition = "g28-home",
       .pecks = "G83"},
      {.name = "grbl",
       .line_length = 79,
       .junction_deviation = true,
       .never = {"M6", "G43", "G64", "G61", "%", "H"},
       .mist_condition = "m7",
       .work_offsets = {"G55", "G59"},
       .work_offsets_said = "it has G54 to G59",
       .home = kStoredHome,
       .home_condition = "g28-home"},
      {.name = "fanuc",
       .always_point = true,
       .never = {"G91.1", "G64"},
       .mist_condition = "m7",
       .work_offsets = {"G55", "G59", "G54.1 P1", "G54.1 P99", "G54.1 P300"},
       .work_offsets_said = "it has G54 to G59, G54.1 P1 to P300",
       .home = kReferenceHome,
       .pecks = "G83"},
      {.name = "haas",
       .always_point = true,
       .never = {"G91.1", "G64", "G28", "M7"},
       .mist_condition = "m83",
       .work_offsets = {"G55", "G59", "G54.1 P1", "G54.1 P99", "G154 P1", "G154 P99"},
       .work_offsets_said = "it has G54 to G59, G154 P1 to P99, G54.1 P1 to P99",
       .home = " G53 G0 Z0. G53 G0 X0. Y0.",
       .pecks = "G83"},
      {.name = "heidenhain",
       .mist_condition = "m7",
       .work_offsets_said = "its zero is the preset that is active; leave it out",
       .home = " L Z+0 R0 FMAX M91 L X+0 Y+0 R0 FMAX M91",
       .home_condition = "m91"},
      {.name = "mach3",
       .never = {"%"},
       .work_offsets = {"G55", "G59", "G59 P7", "G59 P254"},
       .work_offsets_said = "it has G54 to G59, G59 P7 to P254",
       .home = kStoredHome,
       .home_condition = "g28-home",
       .pecks = "G83"},
      {.name = "mach4",
       .work_offsets = {"G55", "G59", "G54.1 P1", "G54.1 P99"},
       .work_offsets_said = "it has G54 to G59, G54.1 P1 to P248",
       .home = kStoredHome,
       .home_condition = "g28-home",
       .pecks = "G83"},
      {.name = "marlin",
       .line_length = 96,
       .junction_deviation = true,
       .never = {"M6", "M30", "G28", "G43", "G54", "G21", "T", "(", "%"},
       .mist_condition = "m7",
       .work_offsets_said = "its programs have no work offsets; leave it out",
       .of_tools = {"tool-by-hand"}},
      {.name = "siemens",
       .never = {"%", "(", "G2 R", "G43", "G49", "G80", "G61", "G28", "G21", "G20", "H"},
       .mist_condition = "m7",
       .work_offsets = {"G55", "G505", "G599"},
       .work_offsets_said = "it has G54 to G57, G505 to G599",
       .home = " SUPA G0 Z0 D0 SUPA G0 X0 Y0 D0",
       .pecks = "CYCLE83"},
      {.name = "mazak",
       .always_point = true,
       .never = {"G91.1", "G64", "M29"},
       .mist_condition = "m7",
       .work_offsets = {"G55", "G59", "G54.1 P1", "G54.1 P99", "G54.1 P300"},
       .work_offsets_said = "it has G54 to G59, G54.1 P1 to P300",
       .home = kReferenceHome,
       .pecks = "G83"},
      {.name = "tormach",
       .line_length = 255,
       .never = {"%", "G61", "M29"},
       .work_offsets = {"G55", "G59", "G59.1", "G59.3"},
       .work_offsets_said = "it has G54 to G59, G59.1 to G59.3",
       .home = kStoredHome,
       .home_condition = "g28-home",
       .pecks = "G83"},
      {.name = "okuma",
       .always_point = true,
       .never = {"G43", "G49", "G53", "G54", "G64", "G91", "G28", "G81", "G98", "M29", "P"},
       .mist_condition = "m7",
       .work_offsets = {"G15 H2", "G15 H200"},
       .work_offsets_said = "it has G15 H1 to H200",
       .home = " G30 P1",
       .home_condition = "g30-home"},
      {.name = "grblhal",
       .line_length = 255,
       .junction_deviation = true,
       .never = {"G43", "G64", "%", "H", "M29", "G84", "G41"},
       .mist_condition = "m7",
       .work_offsets = {"G55", "G59", "G59.1", "G59.3"},
       .work_offsets_said = "it has G54 to G59, G59.1 to G59.3",
       .home = kStoredHome,
       .home_condition = "g28-home",
       .of_tools = {"m6", "tool-by-hand"},
       .pecks = "G83"},
  };
  return rows;
}

const Controller& controller_named(std::string_view name) {
  for (const Controller& one : controllers())
    if (one.name == name) return one;
  throw std::invalid_argument("no such controller: " + std::string(name));
}

std::span<const std::string_view> all_work_offsets() {
  static constexpr std::string_view kOffsets[] = {
      "G55",      "G59",    "G59.1",    "G59.3", "G54.1 P1", "G54.1 P99", "G54.1 P300", "G154 P1",
      "G154 P99", "G59 P7", "G59 P254", "G505",  "G599",     "G15 H2",    "G15 H200"};
  return kOffsets;
}

}  // namespace clearcut::test_support
