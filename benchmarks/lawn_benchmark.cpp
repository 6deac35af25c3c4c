// Covering tours of the public lawn-mowing instances: length over the published one, and above the lower bound.
//
//   lawn_benchmark instances.json [SECONDS [closed|open [FIRST [COUNT]]]]
//
// The file is a list of objects with "id", "rings" (outer and holes), "tour" (the published length; the disc has a diameter
// of 1). The clock ends a search; SECONDS as "20M" are 20 million steps, which make runs repeat exactly. Each path is
// checked three times: by the search's own proof, by a raster of the area, and as a program by the verification. FIRST and
// COUNT are a part of the instances, so that a long run can be made in parts.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "base/file.h"
#include "geometry/route/legal_area.h"
#include "plan/cover/shortest_cover.h"
#include "read/common/data_value.h"
#include "verify/coverage/length_bound.h"
#include "verify/test_program.h"
#include "verify/verify.h"

namespace {

using namespace clearcut;

constexpr double kRadius = 0.5;

struct Instance {
  std::string id;
  Region area;
  double published = 0;
};

Instance instance_of(const read::DataValue& value) {
  std::vector<Loop> loops;
  for (const read::DataValue& ring : value.find("rings")->items) {
    std::vector<Vec2> points;
    for (const read::DataValue& point : ring.items)
      points.push_back({point.items[0].number, point.items[1].number});
    if (points.front() == points.back()) points.pop_back();
    loops.push_back(loop_from_points(points));
  }
  Loop outer = std::move(loops.front());
  loops.erase(loops.begin());
  return {value.find("id")->text, Region::from_valid_loops(std::move(outer), std::move(loops)),
          value.find("tour")->number};
}

plan::cover::CoverEffort effort_of(const std::string& text) {
  plan::cover::CoverEffort effort;
  const double number = std::atof(text.c_str());
  if (text.back() == 'M') {
    effort.steps = static_cast<std::uint64_t>(number * 1e6);
  } else {
    effort.steps = std::numeric_limits<std::uint64_t>::max() / 2;
    effort.seconds = number;
  }
  return effort;
}

/// Whether no point of a raster of the area, nor of its boundary, is farther than the radius from the path.
bool raster_is_cleared(const Region& area, const std::vector<Vec2>& line) {
  const LegalArea inside({area});
  const auto is_cleared = [&](Vec2 p) {
    for (std::size_t i = 1; i < line.size(); ++i)
      if (distance(Edge::line(line[i - 1], line[i]), p) <= kRadius * (1 + 1e-7)) return true;
    return false;
  };
  constexpr double kPitch = 0.037;
  const Box around = box(Regions{area});
  for (double y = around.min.y; y <= around.max.y; y += kPitch)
    for (double x = around.min.x; x <= around.max.x; x += kPitch)
      if (inside.contains({x, y}) && !is_cleared({x, y})) return false;
  for (const Edge& edge : area.edges())
    for (double along = 0; along < edge.length(); along += kPitch / 3)
      if (!is_cleared(edge.at(along / edge.length()))) return false;
  return true;
}

Loop scaled(const Loop& loop, double scale) {
  std::vector<Vec2> points;
  for (const Edge& edge : loop) points.push_back(scale * edge.from);
  return loop_from_points(points);
}

/// Whether the path, with a cutter of 20 mm, is a clean program for the area as an open pocket.
bool is_verified(const Region& area, const std::vector<Vec2>& line) {
  constexpr double kScale = 20;
  std::vector<Loop> islands;
  for (const Loop& island : area.islands()) islands.push_back(scaled(island, kScale));
  const Regions outline{Region::from_valid_loops(scaled(area.outer(), kScale), std::move(islands))};
  Part part = testing::pocket_part(outline, 2 * kRadius * kScale, -1);
  const Box around = box(outline).grown(4 * kScale);
  part.features[0].allowed = testing::rectangle(around.min.x, around.min.y, around.max.x, around.max.y);
  testing::Writer writer;
  writer.enter(kScale * line.front(), 0, -1);
  for (const Vec2 p : line) writer.feed(kScale * p);
  return verify::verify_program(part, writer.done(), {}).all.clean;
}

const char* word(bool yes) {
  return yes ? "yes" : "NO";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "lawn_benchmark instances.json [SECONDS [closed|open [FIRST [COUNT]]]]\n");
    return 2;
  }
  const auto argument = [&](int i, const char* fallback) {
    return std::string(argc > i ? argv[i] : fallback);
  };
  const plan::cover::CoverEffort effort = effort_of(argument(2, "30"));
  const bool closed = argument(3, "closed") == "closed";
  const std::string file = argv[1];
  const read::DataValue root = read::parse_json(read_file(file), file);
  const auto first = static_cast<std::size_t>(std::atoi(argument(4, "0").c_str()));
  const auto count = static_cast<std::size_t>(std::atoi(argument(5, "1000000").c_str()));
  fmt::print("{:44} {:>9} {:>9} {:>7} {:>7} {:>8} {:>7} {:6} {:6} {}\n", "instance", "published", "length",
             "ratio", "bound+%", "corners", "s", "proven", "raster", "verified");
  double sum = 0, gaps = 0;
  int done = 0, shorter = 0;
  for (std::size_t i = first; i < root.items.size() && i < first + count; ++i) {
    const Instance instance = instance_of(root.items[i]);
    const auto began = std::chrono::steady_clock::now();
    plan::cover::CoverTask task;
    task.area = {instance.area};
    task.radius = kRadius;
    task.closed = closed;
    const plan::cover::CoverResult result = plan::cover::shortest_cover(task, effort);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    const double bound = verify::length_bound({task.area, task.radius, task.closed, 1, 0}).mm;
    const double ratio = result.length / instance.published, gap = 100 * (result.length / bound - 1);
    std::vector<Vec2> line = result.points;
    if (closed) line.push_back(line.front());
    fmt::print("{:44} {:9.3f} {:9.3f} {:7.4f} {:7.1f} {:8} {:7.1f} {:6} {:6} {}\n", instance.id,
               instance.published, result.length, ratio, gap, result.points.size(), seconds,
               word(result.proven), word(raster_is_cleared(instance.area, line)),
               word(is_verified(instance.area, line)));
    std::fflush(stdout);
    sum += std::log(ratio);
    gaps += gap;
    ++done;
    shorter += ratio < 1 ? 1 : 0;
  }
  if (done > 0)
    fmt::print("{} instances: geometric mean {:.4f}, {} shorter, mean {:.1f} % above the bound\n", done,
               std::exp(sum / done), shorter, gaps / done);
}
