// The font that tests of letters are written for.
#pragma once

#include "base/error.h"
#include "read/lettering/face.h"

namespace clearcut::read {

/// Whether DejaVu Sans can be read: the font and the libraries that read it are optional.
inline bool has_dejavu_sans() {
  try {
    return Face({{"DejaVu Sans"}}).family() == "DejaVu Sans";
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace clearcut::read

#define NEEDS_THE_FONT \
  if (!clearcut::read::has_dejavu_sans()) GTEST_SKIP() << "DejaVu Sans (fonts-dejavu-core) cannot be read"
