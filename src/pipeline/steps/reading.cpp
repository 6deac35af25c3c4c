#include "pipeline/steps/reading.h"

#include "read/gcode/gcode.h"
#include "resolve/prepare.h"
#include "resolve/work_plan.h"

namespace clearcut::pipeline {
namespace {

read::gcode::CompensationValues compensation_values(std::vector<Tool> tools, const ShopOptions& shop) {
  resolve::number_tools(tools);
  read::gcode::CompensationValues values;
  for (const Tool& tool : tools) values.radii.try_emplace(tool.number, tool.radius());
  if (tools.size() == 1) values.only_radius = tools.front().radius();
  values.is_stated = shop.compensation.has_value();
  if (resolve::writes_wear(shop)) values.wear = 0;
  return values;
}

}  // namespace

read::gcode::ReadControllerOptions reading_of(const resolve::PlanOptions& options,
                                              const std::vector<Tool>& tools, const std::string& file) {
  read::gcode::ReadControllerOptions reading;
  reading.home_z = home_z(options.machine);
  reading.places = options.machine.places;
  reading.subprograms = read::gcode::files_beside(file);
  reading.compensation = compensation_values(tools, options.shop);
  return reading;
}

}  // namespace clearcut::pipeline
