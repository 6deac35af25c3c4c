// Clearcut's programs: own_program(), companion(); command_line() passes words to a program on Windows.
#pragma once

#include "base/programs.h"
