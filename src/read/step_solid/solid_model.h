// The faces of a solid as seen along the tool's axis (-Z), all data of the CAD kernel needed for reading a solid; as
// bytes to pass from one process to another of the same program.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::read {

/// Direction of the outward normals of a face.
enum class Facing {
  kUp,       ///< no normal points down, and some point up
  kDown,     ///< no normal points up, and some point down
  kUpright,  ///< all normals are level: a vertical wall
  kMixed     ///< some normals point up, others down
};

/// The middle of the foot of a vertical plane facing along X or Y.
struct WallFront {
  Vec2 outward;  ///< unit
  Vec2 before;   ///< a point 0.01 mm before the middle of the wall's foot
};

struct SolidFace {
  int number = 0;       ///< in order of the file, from 1
  std::string surface;  ///< "plane", "cylinder", ...
  Facing facing = Facing::kUpright;
  bool level = false;  ///< a horizontal plane, at z_low = z_high
  double z_low = 0;
  double z_high = 0;
  Box plan;
  /// Its edges in plan view, in no order, the face on their left seen from outside. Vertical edges are left
  /// out. Only for upward faces. For a partly upward face, the shadow of this part: counter-clockwise triangles that
  /// may overlap; their outer edge is within kCurveTolerance of the shadow's.
  std::vector<Path> outline;
  std::optional<WallFront> front;
  /// Radians between the face and the vertical; only for upward planes and vertical cones, else 0.
  double lean = 0;
  /// mm; radius of the face's swept circle, or of the ball, if the face rises with it from level to vertical: a
  /// hollow fillet. 0 for all others.
  double fillet = 0;
  /// For faces with a lean: their edges at z_low in plan view, in the sense of `outline`.
  std::vector<Path> foot;
};

/// One solid of the file.
struct SolidBody {
  std::string name;   ///< the product's name, or the body's own if a product has several; "" for none
  double width = 0;   ///< mm along X, in the solid's orientation
  double depth = 0;   ///< mm along Y
  double height = 0;  ///< mm along Z
};

/// All flat faces of one direction.
struct FlatSide {
  std::string up;   ///< value of ReadOptions::up that turns them up: "+X" or "face12"
  double area = 0;  ///< mm2
  int heights = 0;  ///< different heights along their direction
  double lean = 0;  ///< degrees between their direction and +Z, in the file
  /// mm; from the outermost of them to the outermost of the opposite direction, 0 if there are none.
  double thickness = 0;
};

struct SolidModel {
  std::vector<SolidFace> faces;
  Box plan;
  double z_bottom = 0;
  double z_top = 0;
  /// In the order of the file. If there are several and none is chosen, faces and box are left out.
  std::vector<SolidBody> bodies;
  std::vector<FlatSide> sides;  ///< largest first
};

/// The chosen solid of a file, and its orientation; see ReadOptions.
struct SolidChoice {
  std::string up;    ///< "+Z", ..., "face12"; "" as in the file
  double turn = 0;   ///< degrees
  std::string body;  ///< name, number from 1, or "all"; "" for the only one
};

/// Whether this build has the component for reading solids.
bool solids_can_be_read();

/// Reads the solids of a STEP file (AP203, AP214, AP242), units turned to mm.
///
/// Error   lines and circles are exact, other curves within kCurveTolerance of their lines and arcs.
/// Throws  InputError, one line, if the file contains no solid, the kernel refuses it, the choice matches no body or
///         face, or the component is absent.
/// Cost    that of the kernel: about 0.1 ms a face and more for free surfaces.
SolidModel load_solid(std::string_view text, const std::string& file_name, const SolidChoice& choice);

std::string bytes_of(const SolidModel& solid);
/// The inverse. Only for bytes made by bytes_of.
SolidModel model_from_bytes(const std::string& bytes);

}  // namespace clearcut::read
