// The machine of a plan or of a check: from a file, a job, a library or a question, with single values typed besides it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "model/machine.h"
#include "options/typed_machine.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// `machine` with the usual values of the typed kind where it states none, and with the typed values, which go before those of single
/// axes.
Machine with_typed(Machine machine, const TypedMachine& typed);

/// A machine file, or a job's machine table, with the key `holding` states how loose parts are held, and so meets the condition
/// `loose-part`. `of_machine`: the sources of its values.
void accept_what_is_held(const Sources& of_machine, PlanOptions& options);

}  // namespace clearcut::pipeline
