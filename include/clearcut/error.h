// What is thrown (InputError, NothingToMachine, Cancelled, InternalError), and what is collected (Diagnostics).
#pragma once

#include "base/diagnostics.h"
#include "base/error.h"
#include "base/progress.h"
#include "model/results/nothing_to_machine.h"
