// The controllers whose programs are read.
#pragma once

namespace clearcut::inline model {

/// A controller whose programs are read. docs/adding-a-controller.md tells how one is added.
enum class Dialect : unsigned char {
  kLinuxCnc,
  kGrbl,
  kFanuc,
  kHaas,
  kHeidenhain,
  kMach3,
  kMach4,
  kMarlin,
  kSiemens,
  kMazak,
  kTormach,
  kOkuma
};

}  // namespace clearcut::inline model
