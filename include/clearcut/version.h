// The version of the library: kVersion as text, CLEARCUT_VERSION_MAJOR, _MINOR and _PATCH as numbers.
#pragma once

#include "base/version.h"
