// Features of a part as ISO 14649 feature entities.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/part.h"
#include "model/setup_place.h"
#include "post/part/p21_text.h"

namespace clearcut::post {

/// Entities shared by all features of a set-up.
struct P21Common {
  std::string workpiece;
  std::string z_axis;
  std::string x_axis;
  SetupPlace place = {};  ///< of the set-up; its coordinates are those of the features
};

/// Whether the axes of the set-up are not those of the workpiece.
bool is_turned(const P21Common& common);
/// The coordinates in the workpiece of a vector of the set-up.
SetupPlace::Row turned_back(const P21Common& common, const SetupPlace::Row& v);
/// "#12", an AXIS2_PLACEMENT_3D in the workpiece: at a point of the set-up, with the axes of the set-up.
std::string p21_place_in_workpiece(P21Writer& out, const P21Common& common, Vec2 at, double z);
/// "#12", an AXIS2_PLACEMENT_3D with the axes of the workpiece.
std::string p21_placement(P21Writer& out, const P21Common& common, Vec2 at, double z);
/// "#12", a level plane at z.
std::string p21_plane(P21Writer& out, const P21Common& common, const std::string& name, double z);

/// One region of a feature, to be written as one entity.
struct FeaturePiece {
  const Feature* feature = nullptr;
  const Region* region = nullptr;
  std::string name;
  const Tool* tool = nullptr;  ///< of its operations
  bool is_element = false;     ///< of a compound, which is placed in the workpiece
};

/// Whether the feature is a line that its cutter makes by its form: a slot with the cutter's section along the line.
bool is_grooved(const Feature& feature, const Tool& tool);
/// Whether it is a thread that a tap cuts: written as one, with an operation of its own.
bool is_tapped(const Feature& feature);
/// Whether it is a cone about a hole: written as a tapered hole, with an operation of its own.
bool is_countersunk(const Feature& feature);

/// Where the placement of its entity lies in plan: at the centre of round holes, else at zero.
Vec2 placement_of(const FeaturePiece& piece);

/// Writes the entity of `piece` and returns its reference. `operations` are the references of its operations.
std::string write_feature(P21Writer& out, const P21Common& common, const FeaturePiece& piece,
                          const std::optional<Stock>& stock, const std::vector<std::string>& operations);

}  // namespace clearcut::post
