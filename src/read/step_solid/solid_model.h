// The faces of a solid as seen along the tool's axis (-Z): all that reading a solid needs of the CAD kernel.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::read {

/// Where the outside of a face looks.
enum class Facing {
  kUp,       ///< nowhere downwards, and upwards somewhere
  kDown,     ///< nowhere upwards, and downwards somewhere
  kUpright,  ///< sideways everywhere: a vertical wall
  kMixed     ///< upwards here and downwards there
};

/// The middle of an upright plane that looks along X or Y.
struct WallFront {
  Vec2 outward;  ///< unit
  Vec2 before;   ///< a point 0.01 mm before the wall's middle
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
  /// out. Only for faces that look up. Of a face that does so in part the shadow of that part: triangles that turn
  /// counter-clockwise and may overlap; their outer edge lies within kCurveTolerance of the shadow's.
  std::vector<Path> outline;
  std::optional<WallFront> front;
  double lean =
      0;  ///< radians between the face and the vertical; of planes and upright cones that look up, else 0
  /// mm; of the circle that the face is swept along, or of the ball, where it rises with it from level to upright: a hollow fillet. 0 for
  /// all others.
  double fillet = 0;
  std::vector<Path>
      foot;  ///< of faces with a lean: their edges at z_low in plan view, in the sense of `outline`
};

/// One solid of the file.
struct SolidBody {
  std::string name;   ///< the product's, or the body's own where a product has several; "" for none
  double width = 0;   ///< mm along X, as the solid lies
  double depth = 0;   ///< mm along Y
  double height = 0;  ///< mm along Z
};

/// All flat faces that look one way.
struct FlatSide {
  std::string up;   ///< what ReadOptions::up must say for them to look up: "+X" or "face12"
  double area = 0;  ///< mm2
  int heights = 0;  ///< different heights along their direction
  double lean = 0;  ///< degrees between their direction and +Z, as the file has it
  double thickness =
      0;  ///< mm; from the outermost of them to that of those which look the opposite way, 0 where there are none
};

struct SolidModel {
  std::vector<SolidFace> faces;
  Box plan;
  double z_bottom = 0;
  double z_top = 0;
  /// In the order of the file. Where there are several and none is chosen, faces and box are left out.
  std::vector<SolidBody> bodies;
  std::vector<FlatSide> sides;  ///< largest first
};

/// Which solid of a file is wanted, and how it lies; see ReadOptions.
struct SolidChoice {
  std::string up;    ///< "+Z", ..., "face12"; "" as it lies
  double turn = 0;   ///< degrees
  std::string body;  ///< name, number from 1, or "all"; "" for the only one
};

/// Whether this build has the component that reads solids.
bool solids_can_be_read();

/// Reads the solids of a STEP file (AP203, AP214, AP242), units turned to mm.
///
/// Error   lines and circles are exact, other curves within kCurveTolerance of their lines and arcs.
/// Throws  InputError, one line, where the file holds no solid, the kernel refuses it, the choice names no body or face,
///         or the component is absent.
/// Cost    that of the kernel: about 0.1 ms a face and more for free surfaces.
SolidModel load_solid(std::string_view text, const std::string& file_name, const SolidChoice& choice);

}  // namespace clearcut::read
