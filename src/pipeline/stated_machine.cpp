#include "pipeline/stated_machine.h"

#include "read/job/machine_file.h"

namespace clearcut::pipeline {

Machine with_typed(Machine machine, const TypedMachine& typed) {
  if (typed.kind) read::fill_machine_kind(machine, *typed.kind);
  if (typed.is_typed("acceleration")) {
    machine.acceleration = typed.values.acceleration;
    machine.axis_acceleration.reset();
  }
  if (typed.is_typed("junction-deviation")) machine.junction_deviation = typed.values.junction_deviation;
  if (typed.is_typed("rapid")) {
    machine.rapid = typed.values.rapid;
    machine.axis_rapid.reset();
  }
  return machine;
}

void accept_what_is_held(const Sources& of_machine, PlanOptions& options) {
  if (of_machine.find("holding")) options.accept.emplace_back("loose-part");
}

}  // namespace clearcut::pipeline
