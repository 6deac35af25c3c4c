#include "model/entry.h"

namespace clearcut::inline model {

const char* name_of(EntryKind entry) {
  switch (entry) {
    case EntryKind::kHelix:
      return "helix";
    case EntryKind::kRamp:
      return "ramp";
    case EntryKind::kZigzagRamp:
      return "zigzag";
    case EntryKind::kPlunge:
      break;
  }
  return "plunge";
}

}  // namespace clearcut::inline model
