// Project, set-ups and stock: what the work is done on, how it lies, and how high the tool must rise.
#pragma once

#include "model/part.h"
#include "read/stepnc/executables.h"
#include "read/stepnc/shapes/placement.h"

namespace clearcut::read::stepnc {

/// How the workpiece lies while the steps of one set-up are cut. Its program has the workpiece's origin as zero. Its axes are the set-up's where there
/// are several set-ups or the workpiece is turned over; else the workpiece's, along which the operator lays the machine's.
struct ProgramSetup {
  std::optional<Node> node;     ///< a SETUP; nothing where no workplan names one
  std::optional<Node> mounted;  ///< its WORKPIECE_SETUP
  Frame lies;                   ///< workpiece to set-up: a rotation about the origin
  Frame turn;                   ///< workpiece to program: the same, or none
  Vec3 place;                   ///< mm; of the workpiece's origin in the set-up
};

struct Program {
  std::string name;
  std::vector<OrderedStep> steps;    ///< of the chosen set-up, in order
  std::vector<ProgramSetup> setups;  ///< in the order in which they are cut
  std::size_t setup = 0;             ///< index of the chosen one
  std::optional<Node> workpiece;

  const ProgramSetup& chosen() const { return setups[setup]; }
};

/// The steps of set-up `number` (from 1), of all of them where it is 0: then as the first one lies. What of the workplan is not carried out
/// is reported. Throws InputError where there is no workplan, it contains itself, or there is nothing to make.
Program read_program(Context& context, int number);

/// Block or bounding box of the raw piece (else of the workpiece) in the program's coordinates; nothing where the
/// file gives none.
std::optional<Stock> read_stock(const Program& program, Context& context);

/// Highest security plane of the chosen set-up, in the program's coordinates. Throws InputError for tilted set-ups.
std::optional<double> read_clearance(const Program& program, Context& context);

/// Where clamps stand and what else of the set-up the tool has to keep out of, in the program's coordinates. `stock`: that of the part,
/// on which clamps lie. What the set-up says to the operator is reported.
std::vector<KeepOut> read_keep_outs(const Program& program, const std::optional<Stock>& stock,
                                    Context& context);

/// Throws InputError for files of other schemas, naming what they are.
void check_schema(const P21File& file);

}  // namespace clearcut::read::stepnc
