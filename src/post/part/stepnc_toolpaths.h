// The moves of a section as a TOOLPATH_LIST of ISO 14649-10.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "model/move.h"
#include "post/part/p21_text.h"
#include "post/part/stepnc_features.h"

namespace clearcut::post {

/// The origin of the frame for the toolpaths of a feature; its axes are parallel to those of the workpiece.
struct PathOrigin {
  Vec2 plan;
  double z = 0;
};

/// Writes sections as CUTTER_LOCATION_TRAJECTORYs: polylines and trimmed circles; helices as polylines within 1 um
/// whose name describes the helix. Rapids are NON_CONTACT with the speed RAPID; every feed has its own technology.
/// Reading gives the same moves.
class ToolpathWriter {
 public:
  ToolpathWriter(P21Writer& out, const P21Common& common, double safe_z)
      : out_(out), common_(common), safe_z_(safe_z) {}

  /// The TOOLPATH_LIST; "$" if there is no move below the safe height. `spindle`: from the operation's technology.
  std::string write(const Section& section, const PathOrigin& origin, const std::string& spindle);

 private:
  std::string point(const PathOrigin& origin, Vec2 at, double z);
  std::string polyline(const PathOrigin& origin, const std::vector<Move>& moves, std::size_t first,
                       std::size_t last);
  std::string helix(const PathOrigin& origin, const Move& move);
  std::string arc(const PathOrigin& origin, const Move& move);
  std::string curve(const PathOrigin& origin, const std::vector<Move>& moves);
  std::string technology(MmPerMin feed, const std::string& spindle);

  P21Writer& out_;
  const P21Common& common_;
  double safe_z_;
  std::map<std::pair<double, std::string>, std::string> technologies_;
};

/// The text of a feed, mm/min, in m/s, reading back to the same number.
std::string p21_feed(MmPerMin feed);

}  // namespace clearcut::post
