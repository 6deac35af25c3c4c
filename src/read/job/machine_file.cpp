#include "read/job/machine_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "read/job/machine_library.h"

namespace clearcut::read {
namespace {

constexpr double kLargestProgramNumber = 99999;
constexpr std::size_t kLargestMachineFile = std::size_t{1} << 20;

std::array<std::array<double, 2>, 3> travel_of(DataSection section) {
  std::array<std::array<double, 2>, 3> travel{};
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto range = section.range(axes[i]);
    if (!range) section.fail(std::string(axes[i]) + " is missing; add " + axes[i] + " = [low, high]");
    travel[i] = *range;
  }
  section.refuse_unknown();
  return travel;
}

std::optional<std::array<double, 3>> place_of(DataSection& section, const std::string& key) {
  const std::vector<double> numbers = section.numbers(key);
  if (numbers.empty()) return std::nullopt;
  if (numbers.size() != 3) section.fail_at(key, "must be three numbers: [x, y, z]");
  return std::array<double, 3>{numbers[0], numbers[1], numbers[2]};
}

/// Values of a control by their numbers.
using ParameterValues = std::map<int, double>;

/// LinuxCNC's file of parameters: a number and its value on each line. Throws InputError("file:line", ...) for other lines.
ParameterValues parameters_in(const std::string& file) {
  ParameterValues values;
  std::istringstream text(read_file(file, kLargestMachineFile));
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::istringstream words(line);
    std::string key, value, more;
    if (!(words >> key)) continue;
    words >> value >> more;
    const auto index = plain_number(key), amount = plain_number(value);
    if (!index || !amount || !more.empty() || *index != std::floor(*index) || std::abs(*index) > 1e5)
      throw InputError(file + ":" + std::to_string(number),
                       "is no parameter: its number and its value, as LinuxCNC writes them");
    values[static_cast<int>(*index)] = *amount;
  }
  return values;
}

/// The parameters from `first` on that hold X, Y and Z, in the file's unit of mm.
std::optional<std::array<double, 3>> place_in(const ParameterValues& values, int first) {
  std::array<double, 3> place{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto found = values.find(first + axis);
    if (found == values.end()) return std::nullopt;
    place[static_cast<std::size_t>(axis)] = found->second;
  }
  return place;
}

/// First of the parameters in which LinuxCNC keeps a place that [places] names; 0: it keeps none.
int first_parameter_of(const std::string& key) {
  constexpr std::pair<std::string_view, int> kFirst[] = {
      {"g28", 5161}, {"g30", 5181}, {"g54", 5221},   {"g55", 5241},   {"g56", 5261},  {"g57", 5281},
      {"g58", 5301}, {"g59", 5321}, {"g59.1", 5341}, {"g59.2", 5361}, {"g59.3", 5381}};
  for (const auto& [name, first] : kFirst)
    if (name == key) return first;
  return 0;
}

/// Where LinuxCNC keeps by how many degrees the axes of G54 to G59.3 are turned.
constexpr int kFirstRotation = 5230, kLastRotation = 5390, kParametersOfOffset = 20;

/// The file that parameters = "linuxcnc.var" names, beside the file that names it.
ParameterValues stated_parameters(DataSection& section) {
  const auto name = section.text("parameters");
  if (!name) return {};
  const std::string place = section.place_of("parameters");
  const std::filesystem::path named_in(place.substr(0, place.rfind(':')));
  ParameterValues values = parameters_in((named_in.parent_path() / *name).generic_string());
  const auto shifted = values.find(5210);
  if (shifted != values.end() && shifted->second != 0)
    section.fail_at(
        "parameters",
        "a shift by G92 was in force when the file was written (5210 is not 0); clear it by G92.1");
  for (int turned = kFirstRotation; turned <= kLastRotation; turned += kParametersOfOffset) {
    const auto angle = values.find(turned);
    if (angle != values.end() && angle->second != 0)
      section.fail_at("parameters", std::to_string(turned) +
                                        " turns the axes of a work offset, which is not read; set the offset "
                                        "without a rotation (G10 L2 R0)");
  }
  return values;
}

/// In the machine's own coordinates. Without all of them no condition is met, so each is required. What is not stated here is taken from the
/// file of parameters that the section names.
MachinePlaces places_of(DataSection section) {
  const ParameterValues parameters = stated_parameters(section);
  const auto known = [&](const std::string& key) {
    const auto place = place_of(section, key);
    return place ? place : place_in(parameters, first_parameter_of(key));
  };
  const auto needed = [&](const std::string& key) {
    const auto place = known(key);
    if (!place) section.fail(key + " is missing; add " + key + " = [x, y, z]");
    return *place;
  };
  MachinePlaces places;
  places.start = needed("start");
  places.reference = needed("g28");
  places.second_reference = needed("g30");
  const char* const systems[] = {"g54", "g55", "g56", "g57", "g58", "g59", "g59.1", "g59.2", "g59.3"};
  constexpr std::size_t kNeeded = 6;
  std::size_t stated = kNeeded;
  for (std::size_t i = 0; i < places.origins.size(); ++i) {
    const auto place = i < kNeeded ? needed(systems[i]) : known(systems[i]);
    if (place && stated < i)
      needed(systems[stated]);  // they are stated in order, so that a count identifies them
    if (place && i >= kNeeded) stated = i + 1;
    places.origins[i] = place.value_or(places.origins[0]);
  }
  places.stated_origins = static_cast<int>(stated);
  section.refuse_unknown();
  return places;
}

/// One number for all axes, or [x, y, z].
std::optional<AxisValues> axes_of(DataSection& section, const std::string& key) {
  if (!section.is_list(key)) return std::nullopt;
  const std::vector<double> numbers = section.numbers(key);
  if (numbers.size() != 3) section.fail_at(key, "must be one number or three: [x, y, z]");
  for (const double number : numbers)
    if (number <= 0) section.fail_at(key, "must be above zero for every axis");
  return AxisValues{numbers[0], numbers[1], numbers[2]};
}

void take_motion(DataSection& section, Machine& machine) {
  if (const auto speeds = axes_of(section, "rapid")) {
    set_axis_speeds(machine, *speeds);
  } else if (const auto rapid = section.positive("rapid")) {
    machine.rapid = MmPerMin::of(*rapid);
    machine.axis_rapid.reset();
  }
  if (const auto accelerations = axes_of(section, "acceleration")) {
    set_axis_accelerations(machine, *accelerations);
  } else if (const auto acceleration = section.positive("acceleration")) {
    machine.acceleration = *acceleration;
    machine.axis_acceleration.reset();
  }
  if (const auto deviation = section.positive("junction_deviation")) machine.junction_deviation = *deviation;
  if (const auto planner = section.choice("planner", motion_planner_names()))
    machine.planner = static_cast<MotionPlanner>(*planner);
  if (const auto jerk = section.positive("jerk")) machine.jerk = *jerk;
  if (const auto jump = axes_of(section, "speed_jump")) machine.speed_jump = *jump;
  if (const auto tolerance = section.positive("arc_tolerance")) machine.arc_tolerance = *tolerance;
}

/// The text of a machine file; nothing for a name of the library.
std::optional<std::string> text_of(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file) && !is_file(file)) {
    if (library_machine(file.string())) return std::nullopt;
    throw InputError(file.string(),
                     "no such file, and no machine of that name; 'clearcut machines' lists "
                     "those that are known");
  }
  return read_file(file.string(), kLargestMachineFile);
}

}  // namespace

namespace {

/// Usual values for a kind of machine, used if the machine states none.
struct KindOfMachine {
  std::string_view name;
  double min_rpm, max_rpm;
  double power_w;                       ///< at the cutter, lasting
  std::optional<double> max_feed = {};  ///< mm/min, of cuts
  std::optional<double> force_n = {};   ///< sideways
  MachineStiffness stiffness = MachineStiffness::kStiff;
};

// Sources are listed in docs/feeds.md.
const std::vector<KindOfMachine>& kinds_of_machines() {
  static const std::vector<KindOfMachine> kinds{
      {"router", 8000, 24000, 450, 3000, 80, MachineStiffness::kHobby},
      {"industrial-router", 6000, 24000, 6000, 15000},
      {"mill", 60, 6000, 1500},
  };
  return kinds;
}

template <typename Value, typename Usual>
void fill(std::optional<Value>& value, const Usual& usual) {
  if (!value) value = usual;
}

}  // namespace

std::vector<std::string> machine_kinds() {
  std::vector<std::string> names;
  for (const KindOfMachine& kind : kinds_of_machines()) names.emplace_back(kind.name);
  return names;
}

void fill_machine_kind(Machine& machine, const std::string& kind) {
  const auto& kinds = kinds_of_machines();
  const auto usual =
      std::find_if(kinds.begin(), kinds.end(), [&](const KindOfMachine& one) { return one.name == kind; });
  if (usual == kinds.end()) return;
  fill(machine.min_spindle_rpm, usual->min_rpm);
  fill(machine.max_spindle_rpm, usual->max_rpm);
  if (!machine.spindle_torque_nm) fill(machine.spindle_power_w, usual->power_w);
  if (usual->max_feed) fill(machine.max_feed, MmPerMin::of(*usual->max_feed));
  if (usual->force_n) fill(machine.cutting_force_n, *usual->force_n);
  machine.stiffness = usual->stiffness;
}

const std::vector<std::string>& limits_of_kinds() {
  static const std::vector<std::string> limits{"min-spindle", "max-spindle", "spindle-power", "max-feed",
                                               "cutting-force"};
  return limits;
}

Machine machine_of_section(DataSection section, Machine base) {
  if (const auto name = section.text("name")) base.name = *name;
  take_motion(section, base);
  if (const auto rpm = section.positive("max_spindle")) base.max_spindle_rpm = rpm;
  if (const auto rpm = section.positive("min_spindle")) base.min_spindle_rpm = rpm;
  if (const auto power = section.positive("spindle_power")) base.spindle_power_w = power;
  if (const auto torque = section.positive("spindle_torque")) base.spindle_torque_nm = torque;
  if (const auto feed = section.positive("max_feed")) base.max_feed = MmPerMin::of(*feed);
  if (const auto force = section.positive("cutting_force")) base.cutting_force_n = force;
  if (const auto number = section.positive("program_number")) {
    if (*number != std::floor(*number) || *number > kLargestProgramNumber)
      section.fail_at("program_number", "must be a whole number from 1 to 99999");
    base.program_number = static_cast<int>(*number);
  }
  if (const auto kind = section.choice("kind", machine_kinds()))
    fill_machine_kind(base, machine_kinds()[*kind]);
  if (base.max_spindle_rpm && base.min_spindle_rpm && *base.min_spindle_rpm > *base.max_spindle_rpm)
    section.fail("min_spindle is above max_spindle; correct one of them");
  if (const auto wait = section.not_negative("spindle_wait")) base.spindle_wait_s = *wait;
  if (const auto change = section.not_negative("tool_change")) base.tool_change_s = *change;
  if (const auto tolerance = section.not_negative("path_tolerance")) base.path_tolerance = tolerance;
  if (const auto holding = section.text("holding"); holding && holding->empty())
    section.fail_at(
        "holding",
        "says nothing; name what holds parts that come loose (vacuum, tape, screws), or leave it out");
  if (const auto places = section.section("places")) base.places = places_of(*places);
  if (const auto travel = section.section("travel")) base.travel = travel_of(*travel);
  section.refuse_unknown();
  return base;
}

Sources key_sources(const DataValue& table, const std::string& file_name, Origin origin) {
  Sources out;
  for (const DataMember& member : table.members) {
    std::string name = member.key;
    std::replace(name.begin(), name.end(), '_', '-');
    out.set(name, {origin, file_name + ":" + std::to_string(member.value.line)});
  }
  return out;
}

Sources machine_sources_of(const DataValue& table, const std::string& file_name, Origin origin) {
  Sources out = key_sources(table, file_name, origin);
  if (const Source* name = out.find("name")) out.set("machine", Source(*name));
  if (const Source* kind = out.find("kind")) {
    const Source of_kind = *kind;
    for (const std::string& limit : limits_of_kinds())
      if (!out.find(limit)) out.set(limit, of_kind);
  }
  return out;
}

Sources machine_sources(const std::filesystem::path& file) {
  const auto text = text_of(file);
  Sources out;
  if (!text) {
    for (const char* key : {"machine", "planner", "rapid", "acceleration", "junction-deviation"})
      out.set(key, {Origin::kMachineFile, "library: " + file.string()});
    return out;
  }
  const auto settings = read_machine_settings(*text, file.string());
  if (!settings)
    return machine_sources_of(parse_toml(*text, file.string()), file.string(), Origin::kMachineFile);
  for (const char* key : {"machine", "planner"}) out.set(key, {Origin::kMachineFile, file.string()});
  for (const auto& [key, line] : settings->lines)
    out.set(key, {Origin::kMachineFile, file.string() + ":" + std::to_string(line)});
  return out;
}

Machine read_machine_text(std::string_view text, const std::string& file_name) {
  if (const auto settings = read_machine_settings(text, file_name)) return settings->machine;
  const DataValue root = parse_toml(text, file_name);
  return machine_of_section(DataSection(root, file_name, ""), Machine{});
}

Machine read_machine(const std::filesystem::path& file) {
  const auto text = text_of(file);
  return text ? read_machine_text(*text, file.string()) : *library_machine(file.string());
}

}  // namespace clearcut::read
