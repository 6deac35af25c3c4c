// What is thrown (InputError, Cancelled, InternalError), and what is collected (Diagnostics).
#pragma once

#include "base/diagnostics.h"
#include "base/error.h"
#include "base/progress.h"
