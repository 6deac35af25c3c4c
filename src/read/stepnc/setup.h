// Project, set-ups and stock: what the work is done on, and how high the tool must rise.
#pragma once

#include "model/part.h"
#include "read/stepnc/shapes/placement.h"

namespace clearcut::read::stepnc {

/// A workingstep in the order of the workplan.
struct Program {
  std::string name;
  std::vector<Node> workingsteps;
  std::vector<Node> workplans;
  std::optional<Node> workpiece;
};

/// The workplan's elements with nested workplans in place; what is not a machining workingstep is reported as
/// skipped. Throws InputError where there is no workplan, or it contains itself.
Program read_program(Context& context);

/// Block or bounding box of the raw piece (else of the workpiece) in workpiece coordinates; nothing where the
/// file gives none.
std::optional<Stock> read_stock(const Program& program, Context& context);

/// Highest security plane in workpiece coordinates. Throws InputError for tilted set-ups.
std::optional<double> read_clearance(const Program& program, Context& context);

/// Throws InputError for files of other schemas, naming what they are.
void check_schema(const P21File& file);

}  // namespace clearcut::read::stepnc
