// A proof that others can check without this software: find_witness() gives what `clearcut-check PROGRAM PART WITNESS` needs.
#pragma once

#include "pipeline/witness/find_witness.h"

namespace clearcut {

using pipeline::check_witness;
using pipeline::checker_program;
using pipeline::claims_by_checker;
using pipeline::find_witness;
using pipeline::FoundWitness;
using pipeline::WitnessAnswer;
using pipeline::WitnessFeature;
using pipeline::WitnessQuestion;
using pipeline::WitnessTool;

}  // namespace clearcut
