#include "model/findings.h"

namespace clearcut::inline model {

const char* name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::kUncut:
      return "uncut";
    case FaultKind::kGouge:
      return "gouge";
    case FaultKind::kRapidInMaterial:
      return "rapid in material";
    case FaultKind::kPlungeTooFast:
      return "plunge too fast";
    case FaultKind::kTooDeep:
      return "too deep";
    case FaultKind::kOutsideTravel:
      return "outside travel";
    case FaultKind::kNoFeed:
      return "no feed";
    case FaultKind::kNothingCut:
      return "nothing cut";
    case FaultKind::kWrongTool:
      return "wrong tool";
    case FaultKind::kMissingTab:
      return "missing tab";
    case FaultKind::kTabHeight:
      return "tab height";
  }
  return "unknown";
}

}  // namespace clearcut::inline model
