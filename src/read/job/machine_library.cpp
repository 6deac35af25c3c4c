#include "read/job/machine_library.h"

#include <algorithm>

#include "base/inch.h"
#include "read/job/machine_settings.h"

namespace clearcut::read {
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
