#include "read/job/machine_library.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>

#include "base/error.h"
#include "base/text.h"
#include "base/units.h"

namespace clearcut::read {
namespace {

/// A value with its line.
struct Said {
  double value = 0;
  int line = 0;
};

/// Walks the lines of a text: `use(line without blanks, number)`.
template <class Use>
void for_lines(std::string_view text, Use use) {
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    use(stripped(text.substr(0, end)), ++number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// Settings of a control by name; messages name the file.
class SettingTable {
 public:
  explicit SettingTable(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void fail(int line, const std::string& what) const {
    throw InputError(line > 0 ? file_ + ":" + std::to_string(line) : file_, what);
  }

  /// Adds a setting with the number at the beginning of `text`.
  void add(const std::string& name, std::string_view text, int line) {
    text = stripped(text);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool ends = end == text.data() + text.size() || !std::isalnum(static_cast<unsigned char>(*end));
    if (error != std::errc() || !std::isfinite(value) || !ends)
      fail(line, name + " is '" + std::string(text) + "', which is no number; correct it");
    values_[name] = {value, line};
  }

  const Said* find(const std::string& name) const {
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }

  /// A value above zero, if stated.
  const Said* positive(const std::string& name) const {
    const Said* said = find(name);
    if (said && said->value <= 0) fail(said->line, name + " must be above zero; correct it");
    return said;
  }

  /// A value above zero that is required.
  const Said& needed(const std::string& name, const std::string& what) const {
    const Said* said = positive(name);
    if (!said) fail(0, name + " is missing: " + what + "; give all settings of the control");
    return *said;
  }

 private:
  std::string file_;
  std::map<std::string, Said> values_;
};

AxisValues needed_of_axes(const SettingTable& table, const std::array<std::string, 3>& names,
                          const std::string& what, double unit) {
  AxisValues values{};
  for (std::size_t axis = 0; axis < 3; ++axis) values[axis] = table.needed(names[axis], what).value * unit;
  return values;
}

/// Notes the line of a value of the machine.
void note_line(MachineSettings& settings, const char* key, const Said& said) {
  settings.lines.emplace_back(key, said.line);
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// "$110=5000.000" or "$110 = 5000 (x max rate, mm/min)": the name, and the text after the equals sign.
std::optional<std::pair<std::string, std::string_view>> grbl_setting(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (line.size() < 3 || line[0] != '$' || equals == std::string_view::npos) return std::nullopt;
  const std::string_view name = stripped(line.substr(0, equals));
  if (name.size() < 2 || !std::all_of(name.begin() + 1, name.end(), is_digit)) return std::nullopt;
  return std::pair{std::string(name), line.substr(equals + 1)};
}

/// Grbl's maximum of the S word if never set: it is no information on the spindle.
constexpr double kUnsetSpindle = 1000;

MachineSettings grbl_machine(const SettingTable& table) {
  MachineSettings settings;
  Machine& machine = settings.machine;
  machine.name = "Grbl settings";
  machine.planner = MotionPlanner::kGrbl;
  if (const Said* laser = table.find("$32"); laser && laser->value == 1)
    table.fail(laser->line,
               "$32=1 is laser mode, in which the spindle stops at every rapid; set $32=0 for milling");
  set_axis_speeds(machine,
                  needed_of_axes(table, {"$110", "$111", "$112"}, "the greatest speed of an axis", 1));
  set_axis_accelerations(machine,
                         needed_of_axes(table, {"$120", "$121", "$122"}, "the acceleration of an axis", 1));
  note_line(settings, "rapid", *table.find("$110"));
  note_line(settings, "acceleration", *table.find("$120"));
  if (const Said* deviation = table.positive("$11")) {
    machine.junction_deviation = deviation->value;
    note_line(settings, "junction-deviation", *deviation);
  }
  if (const Said* tolerance = table.positive("$12")) machine.arc_tolerance = tolerance->value;
  if (const Said* rpm = table.positive("$30"); rpm && rpm->value != kUnsetSpindle) {
    machine.max_spindle_rpm = rpm->value;
    note_line(settings, "max-spindle", *rpm);
  }
  if (const Said* rpm = table.find("$31"); rpm && rpm->value > 0) {
    machine.min_spindle_rpm = rpm->value;
    note_line(settings, "min-spindle", *rpm);
  }
  return settings;
}

std::optional<MachineSettings> read_grbl(std::string_view text, const std::string& file) {
  SettingTable table(file);
  bool found = false;
  for_lines(text, [&](std::string_view line, int number) {
    const auto setting = grbl_setting(line);
    if (!setting) return;
    found = true;
    table.add(setting->first, setting->second, number);
  });
  if (!found) return std::nullopt;
  return grbl_machine(table);
}

/// Sections with used numbers; others contain words.
bool is_linuxcnc_section(std::string_view name) {
  return name == "TRAJ" || name.starts_with("AXIS_") || name.starts_with("JOINT_") || name == "SPINDLE_0" ||
         name == "EMCMOT";
}

constexpr const char* kLinuxCncNumbers[] = {"MAX_VELOCITY", "MAX_ACCELERATION", "MAX_LINEAR_VELOCITY",
                                            "MAX_FORWARD_VELOCITY", "MIN_FORWARD_VELOCITY"};

/// Units a second of one axis: the smaller value of [AXIS_] and [JOINT_].
double linuxcnc_axis(const SettingTable& table, std::size_t axis, const std::string& key) {
  const std::string of_axis = std::string("[AXIS_") + "XYZ"[axis] + "]" + key;
  const std::string of_joint = "[JOINT_" + std::to_string(axis) + "]" + key;
  const Said *a = table.positive(of_axis), *b = table.positive(of_joint);
  if (a && b) return std::min(a->value, b->value);
  return (a ? *a : b ? *b : table.needed(of_axis, "what the axis can do")).value;
}

std::optional<MachineSettings> read_linuxcnc(std::string_view text, const std::string& file) {
  SettingTable table(file);
  std::string section, name = "LinuxCNC";
  bool found = false, inch = false;
  for_lines(text, [&](std::string_view line, int number) {
    if (line.empty() || line[0] == '#' || line[0] == ';') return;
    if (line[0] == '[') {
      section = std::string(line.substr(1, line.find(']') - 1));
      found = found || section == "TRAJ" || section == "EMCMOT" || section == "KINS";
      return;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return;
    const std::string key(stripped(line.substr(0, equals)));
    const std::string_view value = stripped(line.substr(equals + 1));
    if (section == "EMC" && key == "MACHINE") name = std::string(value);
    if (section == "TRAJ" && key == "LINEAR_UNITS")
      inch = value == "inch" || value == "in" || value == "imperial";
    const auto* const last = std::end(kLinuxCncNumbers);
    if (is_linuxcnc_section(section) && std::find(std::begin(kLinuxCncNumbers), last, key) != last)
      table.add("[" + section + "]" + key, value, number);
  });
  if (!found) return std::nullopt;
  const double unit = inch ? kMmPerInch : 1;
  MachineSettings settings;
  Machine& machine = settings.machine;
  machine.name = name;
  machine.planner = MotionPlanner::kLinuxCnc;
  const Said* const path = table.positive("[TRAJ]MAX_LINEAR_VELOCITY");
  AxisValues speeds{}, accelerations{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double speed = linuxcnc_axis(table, axis, "MAX_VELOCITY");
    speeds[axis] = (path ? std::min(path->value, speed) : speed) * unit * 60;
    accelerations[axis] = linuxcnc_axis(table, axis, "MAX_ACCELERATION") * unit;
  }
  set_axis_speeds(machine, speeds);
  set_axis_accelerations(machine, accelerations);
  if (const Said* rpm = table.positive("[SPINDLE_0]MAX_FORWARD_VELOCITY")) {
    machine.max_spindle_rpm = rpm->value;
    note_line(settings, "max-spindle", *rpm);
  }
  if (const Said* rpm = table.find("[SPINDLE_0]MIN_FORWARD_VELOCITY"); rpm && rpm->value > 0)
    machine.min_spindle_rpm = rpm->value;
  for (const auto& [key, setting] :
       {std::pair{"rapid", "MAX_VELOCITY"}, {"acceleration", "MAX_ACCELERATION"}}) {
    const Said* said = table.find(std::string("[AXIS_X]") + setting);
    if (!said) said = table.find(std::string("[JOINT_0]") + setting);
    if (said) note_line(settings, key, *said);
  }
  return settings;
}

/// "echo:  M203 X500.00 Y500.00 Z5.00": the words of a line, each a letter and its number.
void add_marlin_words(SettingTable& table, const std::string& code, std::string_view words, int line) {
  while (!words.empty()) {
    words = stripped(words);
    if (words.empty() || words[0] == ';') return;
    const std::size_t end = std::min(words.find_first_of(" \t;"), words.size());
    table.add(code + " " + words[0], words.substr(1, end - 1), line);
    words.remove_prefix(end);
  }
}

std::optional<MachineSettings> read_marlin(std::string_view text, const std::string& file) {
  SettingTable table(file);
  bool found = false;
  for_lines(text, [&](std::string_view line, int number) {
    if (line.starts_with("echo:")) line = stripped(line.substr(5));
    if (line.starts_with("G20"))
      table.fail(number, "G20: the settings are in inches; send G21, then M503 again");
    for (const char* code : {"M201", "M203", "M204", "M205"}) {
      if (!line.starts_with(code) || line.size() < 5 || line[4] != ' ') continue;
      found = found || line.starts_with("M20");
      add_marlin_words(table, code, line.substr(5), number);
    }
  });
  if (!found) return std::nullopt;
  MachineSettings settings;
  Machine& machine = settings.machine;
  machine.name = "Marlin settings";
  machine.planner = MotionPlanner::kMarlin;
  set_axis_speeds(machine,
                  needed_of_axes(table, {"M203 X", "M203 Y", "M203 Z"}, "the greatest speed of an axis", 60));
  const AxisValues most =
      needed_of_axes(table, {"M201 X", "M201 Y", "M201 Z"}, "the acceleration of an axis", 1);
  set_axis_accelerations(machine, most);
  note_line(settings, "rapid", *table.find("M203 X"));
  note_line(settings, "acceleration", *table.find("M201 X"));
  // M204 P applies to printing moves, and so to the feed moves of a mill.
  if (const Said* path = table.positive("M204 P"))
    machine.acceleration = std::min(machine.acceleration, path->value);
  if (const Said* deviation = table.positive("M205 J")) {
    machine.junction_deviation = deviation->value;
    note_line(settings, "junction-deviation", *deviation);
  } else if (table.find("M205 X")) {
    machine.speed_jump = needed_of_axes(table, {"M205 X", "M205 Y", "M205 Z"},
                                        "by how much an axis may change its speed at once", 1);
  }
  return settings;
}

}  // namespace

void set_axis_speeds(Machine& machine, const AxisValues& mm_per_min) {
  machine.axis_rapid = mm_per_min;
  machine.rapid = MmPerMin::of(std::min(mm_per_min[0], mm_per_min[1]));
}

void set_axis_accelerations(Machine& machine, const AxisValues& mm_per_s2) {
  machine.axis_acceleration = mm_per_s2;
  machine.acceleration = std::min(mm_per_s2[0], mm_per_s2[1]);
}

std::optional<MachineSettings> read_machine_settings(std::string_view text, const std::string& file_name) {
  for (const auto& read : {read_grbl, read_linuxcnc, read_marlin})
    if (auto settings = read(text, file_name)) return settings;
  return std::nullopt;
}

namespace {

constexpr std::string_view kGrblDefaults = "gnea/grbl grbl/defaults.h (Grbl 1.1)";
constexpr std::string_view kOpenBuilds = "OpenBuilds CONTROL app/js/grbl-defaults.js";
constexpr std::string_view kSienci = "Sienci gSender eepromFiles";
constexpr std::string_view kLinuxCncConfigs = "LinuxCNC sample-configs/by_machine";
constexpr std::string_view kHaas = "haascnc.com, specifications of the model";

constexpr AxisValues all(double value) {
  return {value, value, value};
}
constexpr AxisValues axes(double x_y, double z) {
  return {x_y, x_y, z};
}
/// mm/min of inches a second, and mm/s2 of inches a second squared.
constexpr double ips(double inches) {
  return inches * kMmPerInch * 60;
}
constexpr double ips2(double inches) {
  return inches * kMmPerInch;
}

}  // namespace

const std::vector<LibraryMachine>& machine_library() {
  using enum MotionPlanner;
  static const std::vector<LibraryMachine> machines{
      {"bobscnc-e3", "BobsCNC E3", kGrbl, axes(10000, 500), axes(500, 300), 0.01, 0, 0, 0, kGrblDefaults},
      {"bobscnc-e4", "BobsCNC E4", kGrbl, axes(10000, 500), axes(500, 300), 0.01, 0, 0, 0, kGrblDefaults},
      {"cbeam", "OpenBuilds C-Beam Machine", kGrbl, all(1000), all(100), 0.02, 0, 0, 0, kOpenBuilds},
      {"cbeam-xl", "OpenBuilds C-Beam XL", kGrbl, all(1000), all(100), 0.02, 0, 0, 0, kOpenBuilds},
      {"cooltool-basic540", "CoolTool Basic 540", kLinuxCnc, axes(1200, 900), all(20), 0.01, 0, 0, 0,
       kLinuxCncConfigs},
      {"haas-mini-mill", "Haas Mini Mill", kJerkLimited, all(15200), {}, 0.01, 0, 6000, 5600, kHaas},
      {"haas-tm-1", "Haas TM-1", kJerkLimited, all(5100), {}, 0.01, 0, 4000, 5600, kHaas},
      {"haas-vf-2", "Haas VF-2", kJerkLimited, all(25400), {}, 0.01, 0, 8100, 22400, kHaas},
      {"lead-1010", "OpenBuilds LEAD 1010", kGrbl, all(2500), all(150), 0.02, 0, 0, 0, kOpenBuilds},
      {"longmill-mk1", "Sienci LongMill MK1 30x30", kGrbl, axes(4000, 3000), axes(750, 500), 0.01, 0, 30000,
       0, kSienci},
      {"longmill-mk2", "Sienci LongMill MK2 30x30", kGrbl, axes(4000, 3000), axes(750, 500), 0.01, 10000,
       30000, 0, kSienci},
      {"mill-one", "Sienci Mill One V3", kGrbl, axes(1800, 600), axes(30, 15), 0.01, 0, 0, 0, kSienci},
      {"minimill", "OpenBuilds MiniMill", kGrbl, all(1500), all(50), 0.01, 0, 0, 0, kOpenBuilds},
      {"pcnc-1100", "Tormach PCNC 1100 series II", kLinuxCnc, axes(ips(1.5), ips(1.083)),
       axes(ips2(9), ips2(6)), 0.01, 0, 0, 0, kLinuxCncConfigs},
      {"pcnc-770", "Tormach PCNC 770", kLinuxCnc, axes(ips(2.25), ips(1.666)), axes(ips2(15), ips2(10)), 0.01,
       0, 0, 0, kLinuxCncConfigs},
      {"pocketnc-fr4", "Pocket NC FR4", kGrbl, all(300), all(30), 0.01, 0, 7000, 0, kGrblDefaults},
      {"shapeoko-1", "Shapeoko (first)", kGrbl, all(1000), all(15), 0.02, 0, 0, 0, kGrblDefaults},
      {"shapeoko-2", "Shapeoko 2", kGrbl, axes(5000, 500), axes(250, 50), 0.02, 0, 0, 0, kGrblDefaults},
      {"shapeoko-3", "Carbide 3D Shapeoko 3", kGrbl, all(5000), all(400), 0.02, 0, 0, 0, kGrblDefaults},
      {"sherline-5400", "Sherline 5400 with Grbl", kGrbl, all(635), all(50), 0.01, 0, 2800, 0, kGrblDefaults},
      {"smithy-1240", "Smithy 1240", kLinuxCnc, all(ips(5)), all(ips2(7.5)), 0.01, 0, 4000, 0,
       kLinuxCncConfigs},
      {"sphinx-1050", "OpenBuilds Sphinx 1050", kGrbl, all(2500), all(150), 0.02, 0, 0, 0, kOpenBuilds},
      {"sphinx-55", "OpenBuilds Sphinx 55", kGrbl, all(2500), all(150), 0.02, 0, 0, 0, kOpenBuilds},
      {"workbee-1010", "OpenBuilds WorkBee 1010", kGrbl, all(2500), all(150), 0.02, 0, 0, 0, kOpenBuilds},
      {"workbee-1510", "OpenBuilds WorkBee 1510", kGrbl, axes(10000, 2500), all(150), 0.02, 0, 0, 0,
       kOpenBuilds},
      {"x-carve-1000", "Inventables X-Carve 1000 mm", kGrbl, axes(8000, 500), axes(500, 50), 0.02, 0, 0, 0,
       kGrblDefaults},
      {"x-carve-500", "Inventables X-Carve 500 mm", kGrbl, axes(8000, 500), axes(500, 50), 0.02, 0, 0, 0,
       kGrblDefaults},
      {"zen-7x7", "Zen Toolworks 7x7", kGrbl, all(6000), all(600), 0.02, 0, 0, 0, kGrblDefaults},
  };
  return machines;
}

std::optional<Machine> library_machine(std::string_view name) {
  const auto& machines = machine_library();
  const auto found = std::find_if(machines.begin(), machines.end(),
                                  [&](const LibraryMachine& one) { return one.name == name; });
  if (found == machines.end()) return std::nullopt;
  Machine machine;
  machine.name = std::string(found->title);
  machine.planner = found->planner;
  machine.junction_deviation = found->junction_deviation;
  set_axis_speeds(machine, found->speed);
  if (found->acceleration[0] > 0) set_axis_accelerations(machine, found->acceleration);
  if (found->min_rpm > 0) machine.min_spindle_rpm = found->min_rpm;
  if (found->max_rpm > 0) machine.max_spindle_rpm = found->max_rpm;
  if (found->power_w > 0) machine.spindle_power_w = found->power_w;
  return machine;
}

}  // namespace clearcut::read
