// The table of options: names, ranges, defaults, sentences, and where each has an effect. Every way to state options walks it.
#pragma once

#include "clearcut/part.h"
#include "options/idle.h"
#include "options/plan_options.h"
#include "options/row.h"
