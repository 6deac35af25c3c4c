// Symbols
//
//   f_z    feed per tooth, mm            feed / (n z)
//   a_e    width of cut, mm              sum of R (sin b - sin a) over the engagement arcs [a, b]
//   h_m    mean thickness of chips, mm   f_z a_e / (R phi): the mean of f_z cos over the engagement phi
//   k_c    specific force, N/mm2         kc1.1 h_m^-mc [kienzle1957]
//   Q      material removed, mm3/min     a_p a_e feed;  power k_c Q, tangential force power / cutting speed
//   T      tool life, min                (C / v_c)^(1/n) [groover2013]
#include <algorithm>

#include "base/elementary.h"
#include "verify/engagement/load.h"

namespace clearcut::verify {
namespace {

/// mm. Thinner chips rub: their specific force equals that at this thickness.
constexpr double kThinnestChip = 0.002;
/// Share of the tangential force pressing on the wall.
constexpr double kNormalShare = 0.5;
constexpr double kLargestDeflection = 0.02;  // mm; smaller deflections are not reported
constexpr double kThickestWall = 20;         // mm; thicker walls are not considered
constexpr std::size_t kMostWalls = 3000;

double width_of_cut(const stock::CutterEngagement& contact, double radius) {
  double width = 0;
  for (const stock::AngleInterval& arc : contact.angles.intervals())
    width += radius * (base::sin(arc.from + arc.width()) - base::sin(arc.from));
  return std::max(0.0, width);
}

/// mm; deflection of a cantilever plate as broad as high: 4 F h^2 / (E t^3).
double deflection_of(double thickness, double height, double force, double elasticity) {
  return 4 * force * height * height / (elasticity * thickness * thickness * thickness);
}

/// mm from the middle of a wall through the solid to the next wall, and the height common to both.
ThinWall behind(const Wall& wall, const std::vector<Wall>& walls) {
  const Vec2 p = wall.edge.at(0.5);
  const Vec2 inwards = -left_of(wall.edge.tangent_at(0.5));
  const Edge ray = Edge::line(p + inwards * 1e-4, p + inwards * kThickestWall);
  ThinWall found{kThickestWall, 0, 0, {p, wall.z_low, 0}};
  for (const Wall& other : walls) {
    if (&other == &wall || !other.edge.box().overlaps(ray.box().grown(1e-6))) continue;
    for (const Vec2 q : intersections(ray, other.edge)) {
      const double height = std::min(wall.z_high, other.z_high) - std::max(wall.z_low, other.z_low);
      if (distance(p, q) >= found.thickness_mm || height <= 0) continue;
      found.thickness_mm = distance(p, q);
      found.height_mm = height;
    }
  }
  return found;
}

}  // namespace

void add_forces(CheckedMove& checked, const CutSample& sample, const WorkMaterial& material) {
  const double feed = checked.move->feed.mm_per_min(), radius = checked.radius();
  if (checked.rpm <= 0 || feed <= 0 || checked.tool->teeth <= 0 || sample.contact.angle <= 0) return;
  if (!checked.load.forces) checked.load.forces = CuttingLoad{};
  CuttingLoad& load = *checked.load.forces;
  const double per_tooth = feed / (checked.rpm * checked.tool->teeth);
  const double width = width_of_cut(sample.contact, radius);
  const double chip = std::max(kThinnestChip, per_tooth * width / (radius * sample.contact.angle));
  const double specific = material.kc11 * base::pow(chip, -material.mc);
  const double speed = kPi * 2 * radius * checked.rpm / 1000;                       // m/min
  const double power = specific * sample.axial * width * feed / 60000;              // W
  const double force = power * 60 / speed;                                          // N
  const double life = base::pow(material.taylor_c / speed, 1 / material.taylor_n);  // min
  load.energy_j += specific * sample.axial * width * sample.length / 1000;
  load.removed_mm3 += sample.axial * width * sample.length;
  load.wear += sample.length / feed * sample.contact.angle / (2 * kPi) / life;
  load.max_power_w = std::max(load.max_power_w, power);
  checked.load.force_mm_n += force * sample.length;
  if (force <= load.max_force_n) return;
  load.max_force_n = force;
  load.max_force_at = sample.at;
}

std::optional<ThinWall> thinnest_wall(const FinishedPart& part, double force, const WorkMaterial& material) {
  std::optional<ThinWall> worst;
  if (part.walls().size() > kMostWalls) return worst;
  for (const Wall& wall : part.walls()) {
    ThinWall found = behind(wall, part.walls());
    if (found.height_mm <= 0) continue;
    found.deflection_mm =
        deflection_of(found.thickness_mm, found.height_mm, kNormalShare * force, material.elasticity);
    const double least = worst ? worst->deflection_mm : kLargestDeflection;
    if (found.deflection_mm > least) worst = found;
  }
  return worst;
}

}  // namespace clearcut::verify
