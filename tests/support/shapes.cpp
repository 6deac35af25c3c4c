#include "support/shapes.h"

#include <algorithm>
#include <cctype>

#include "base/file.h"
#include "geometry/edge.h"
#include "post/part/part_writers.h"
#include "read/outline/outline_reader.h"
#include "studies/fishhead.h"
#include "support/data.h"

namespace clearcut::test_support {
namespace {

/// The feature alone: the material above it is gone, and a closed pocket stands in no block.
ShapeFile shape_of(const std::string& name, const Feature& feature, const std::optional<Stock>& stock) {
  Part part;
  part.name = name;
  if (feature.kind != FeatureKind::kClosedPocket) part.stock = stock;
  if (part.stock) part.stock->z_top = feature.top_z;
  part.features = {feature};
  part.workplan = {{feature.name, "", 0, {}}};
  return {name, post::write_outline_json(part)};
}

ShapeFile pocket(const std::string& name, const std::vector<Vec2>& outer,
                 const std::vector<Loop>& islands = {}) {
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(outer), islands)};
  feature.floor_z = -2;
  return shape_of(name, feature, std::nullopt);
}

std::vector<Vec2> star(int points, double outer, double inner) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 2 * points; ++i)
    corners.push_back(direction_of(kPi * i / points) * (i % 2 == 0 ? outer : inner));
  return corners;
}

std::vector<ShapeFile> fishhead_shapes() {
  std::vector<ShapeFile> shapes;
  for (const bool sloped : {false, true}) {
    const Part part = studies::fishhead(sloped, {});
    for (const Feature& feature : part.features) {
      if (sloped && feature.wall_slope == Radians()) continue;
      std::string name = (sloped ? "fishhead_sloped_" : "fishhead_") + feature.name;
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
      shapes.push_back(shape_of(name, feature, part.stock));
    }
  }
  return shapes;
}

}  // namespace

std::vector<ShapeFile> own_shapes() {
  std::vector<ShapeFile> shapes = fishhead_shapes();
  const std::vector<Vec2> island{{40, 20}, {60, 20}, {60, 40}, {40, 40}};
  Loop clockwise = loop_from_points(std::vector<Vec2>(island.rbegin(), island.rend()));
  shapes.push_back(pocket("square50", {{0, 0}, {50, 0}, {50, 50}, {0, 50}}));
  shapes.push_back(pocket("triangle80", {{0, 0}, {80, 0}, {40, 40 * std::sqrt(3.0)}}));
  shapes.push_back(pocket("star6", star(6, 45, 25)));
  shapes.push_back(pocket("dumbbell", {{0, 0},
                                       {30, 0},
                                       {30, 9},
                                       {60, 9},
                                       {60, 0},
                                       {90, 0},
                                       {90, 30},
                                       {60, 30},
                                       {60, 21},
                                       {30, 21},
                                       {30, 30},
                                       {0, 30}}));
  shapes.push_back(pocket("rect100x60_island", {{0, 0}, {100, 0}, {100, 60}, {0, 60}}, {clockwise}));
  return shapes;
}

std::vector<ShapeFile> all_shapes() {
  std::vector<ShapeFile> shapes = own_shapes();
  const auto data = data_folder();
  if (!data) return shapes;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(*data / "shapes"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const std::string name = file.stem().string();
    const auto same = [&](const ShapeFile& shape) { return shape.name == name; };
    if (std::none_of(shapes.begin(), shapes.end(), same)) shapes.push_back({name, read_file(file.string())});
  }
  return shapes;
}

Part part_of(const ShapeFile& shape) {
  return read::read_outline_json(shape.text, shape.name + ".json", Tolerances{});
}

}  // namespace clearcut::test_support
