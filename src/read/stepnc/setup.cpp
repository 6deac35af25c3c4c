#include "read/stepnc/setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text/format.h"

namespace clearcut::read::stepnc {

namespace {

constexpr int kDeepestPlan = 64;                // nesting of workplans
constexpr std::size_t kMostElements = 100'000;  // workplan elements after expansion

class Collector {
 public:
  Collector(Program& program, Context& context) : program_(program), context_(context) {}

  void collect(const Node& element, int depth) {
    if (depth > kDeepestPlan)
      element.fail("workplans are nested more than 64 deep (or in a circle); flatten them");
    if (++elements_ > kMostElements) element.fail("more than 100000 workplan elements; split the program");
    if (element.is("WORKPLAN")) {
      program_.workplans.push_back(element);
      for (const Node& inner : element.refs(1)) collect(inner, depth + 1);
    } else if (element.is("NON_SEQUENTIAL")) {
      context_.note("elements in any order are cut in the order written", element);
      for (const Node& inner : element.refs(1)) collect(inner, depth + 1);
    } else if (element.is("MACHINING_WORKINGSTEP")) {
      program_.workingsteps.push_back(element);
    } else {
      context_.diagnostics.skip(
          context_.file.place(element.line()),
          element.label() + " is left out: only machining workingsteps are carried out");
    }
  }

 private:
  Program& program_;
  Context& context_;
  std::size_t elements_ = 0;
};

/// The workplan that no other contains.
Node main_workplan(Context& context) {
  const std::vector<Node> plans = nodes_called(context.file, "WORKPLAN");
  if (plans.empty())
    throw InputError(context.file.name, "no PROJECT and no WORKPLAN; this is not a STEP-NC program");
  std::vector<std::uint64_t> nested;
  for (const Node& plan : plans)
    for (const Node& element : plan.refs(1)) nested.push_back(element.id());
  std::sort(nested.begin(), nested.end());
  for (const Node& plan : plans)
    if (!std::binary_search(nested.begin(), nested.end(), plan.id())) return plan;
  plans.front().fail("the workplans contain one another in a circle; correct them");
}

/// Files of other kinds state units; who writes them here may have meant inches.
void warn_of_units(Context& context) {
  for (const P21Entity& entity : context.file.entities) {
    if (entity.records == 1) continue;
    const Node unit(context.file, entity);
    if (unit.keyword().find("CONVERSION_BASED_UNIT") != std::string::npos &&
        unit.keyword().find("LENGTH_UNIT") != std::string::npos)
      context.warn(
          "this unit is not used: lengths of ISO 14649 programs are mm; convert them if they are not", unit);
  }
}

}  // namespace

Program read_program(Context& context) {
  Program program;
  const std::vector<Node> projects = nodes_called(context.file, "PROJECT");
  warn_of_units(context);
  if (projects.size() > 1) context.warn("more than one project; only the first is carried out", projects[1]);
  const bool has_plan = !projects.empty() && !projects[0].unset(1);
  if (!projects.empty()) {
    program.name = projects[0].text(0);
    const auto workpieces = projects[0].refs(2);
    if (!workpieces.empty()) program.workpiece = workpieces[0];
    if (workpieces.size() > 1)
      context.warn("more than one workpiece; the first is the one machined", projects[0]);
  }
  const Node plan = has_plan ? projects[0].needed_ref(1, "main workplan") : main_workplan(context);
  if (!has_plan) context.note("no project names its main workplan; this one is carried out", plan);
  Collector(program, context).collect(plan, 0);
  const std::vector<Node> elements = plan.refs(1);
  if (program.workingsteps.empty() && !elements.empty())
    plan.fail("none of its elements is carried out: " + elements[0].label() +
              " is no machining workingstep and no workplan; there is nothing to make");
  if (program.workingsteps.empty())
    plan.fail("the workplan holds no machining workingstep; there is nothing to make");
  for (const Node& step : program.workingsteps) {
    if (program.workpiece) break;
    const auto feature = step.sound_ref(2);
    if (feature) program.workpiece = feature->sound_ref(1);
  }
  return program;
}

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

struct Extent {
  Vec3 min{kFar, kFar, kFar};
  Vec3 max{-kFar, -kFar, -kFar};
  void add(Vec3 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
};

Extent block_extent(const Node& block, Context& context) {
  const Frame frame = frame_of(block.ref(1));
  const Vec3 size{block.needed_length(2, "x size"), block.needed_length(3, "y size"),
                  block.needed_length(4, "z size")};
  Extent extent;
  for (int corner = 0; corner < 8; ++corner)
    extent.add(
        frame.point({(corner & 1) ? size.x : 0, (corner & 2) ? size.y : 0, (corner & 4) ? size.z : 0}));
  const double turned =
      std::abs(frame.x.x * frame.x.y) + std::abs(frame.x.y * frame.x.z) + std::abs(frame.x.x * frame.x.z);
  if (turned > 1e-9) context.note("the block is turned; its bounding box is taken as the stock", block);
  return extent;
}

/// Bounding box of a cylinder along any axis.
Extent cylinder_extent(const Node& cylinder, Context& context) {
  const Frame frame = frame_of(cylinder.ref(1));
  const double height = cylinder.needed_length(2, "height");
  const double radius = cylinder.needed_length(3, "radius");
  const auto across = [&](double a) { return radius * std::sqrt(std::max(0.0, 1 - a * a)); };
  const Vec3 r{across(frame.z.x), across(frame.z.y), across(frame.z.z)};
  Extent extent;
  for (const double h : {0.0, height}) {
    const Vec3 c = frame.point({0, 0, h});
    extent.add({c.x - r.x, c.y - r.y, c.z - r.z});
    extent.add({c.x + r.x, c.y + r.y, c.z + r.z});
  }
  context.note("round stock; its bounding box is taken", cylinder);
  return extent;
}

}  // namespace

std::optional<Stock> read_stock(const Program& program, Context& context) {
  if (!program.workpiece) return std::nullopt;
  const auto raw = program.workpiece->ref(3);
  const auto geometry = raw && !raw->unset(5) ? raw->ref(5) : program.workpiece->ref(5);
  if (!geometry) return std::nullopt;
  Extent extent;
  if (geometry->is("BLOCK")) {
    extent = block_extent(*geometry, context);
  } else if (geometry->is("RIGHT_CIRCULAR_CYLINDER")) {
    extent = cylinder_extent(*geometry, context);
  } else {
    context.warn("bounding geometry of this kind is not read; give the workpiece a BLOCK", *geometry);
    return std::nullopt;
  }
  Stock stock{{{extent.min.x, extent.min.y}, {extent.max.x, extent.max.y}}, extent.min.z, extent.max.z};
  if (!(stock.plan.width() > 0 && stock.plan.height() > 0 && stock.z_top > stock.z_bottom))
    geometry->fail("the stock has no size; correct it");
  return stock;
}

namespace {

/// z of a plane in its own frame of reference.
double plane_height(const Node& plane) {
  const auto position = plane.ref(1);
  return position ? frame_of(position).origin.z : 0.0;
}

/// Frame of the workpiece in a set-up's coordinates.
Frame workpiece_frame(const Node& setup) {
  const Frame origin = frame_of(setup.ref(1));
  if (!is_upright(origin)) setup.fail("the set-up is tilted; only set-ups with Z upwards can be machined");
  const auto mounted = setup.refs(3);
  if (mounted.empty()) return {};
  const Frame frame = frame_of(mounted[0].ref(1));
  if (!is_upright(frame))
    mounted[0].fail("the workpiece is tilted in its set-up; only Z upwards can be machined");
  return frame;
}

}  // namespace

std::optional<double> read_clearance(const Program& program, Context& context) {
  std::optional<double> highest;
  Frame workpiece;
  bool first = true;
  const auto raise = [&](const Node& plane) {
    const double z = plane_height(plane) - workpiece.origin.z;
    if (std::abs(z) < 1e6) highest = std::max(highest.value_or(z), z);
  };
  for (const Node& plan : program.workplans) {
    const auto setup = plan.ref(3);
    if (!setup) continue;
    if (!setup->is("SETUP")) setup->fail("a SETUP is needed here; correct the reference");
    workpiece = workpiece_frame(*setup);
    const Frame origin = frame_of(setup->ref(1));
    if (first && !is_identity(composed(origin, workpiece)))
      context.note(
          "program zero is the workpiece's origin; its place on the machine is for the operator to set",
          *setup);
    first = false;
    if (const auto plane = setup->ref(2)) raise(*plane);
  }
  for (const Node& step : program.workingsteps) {
    try {
      if (const auto plane = step.ref(1)) raise(*plane);
    } catch (const InputError&) {
      context.note("its security plane cannot be read; that of the set-up holds", step);
    }
  }
  return highest;
}

void check_schema(const P21File& file) {
  const auto has = [&](std::string_view part) {
    return std::any_of(file.schemas.begin(), file.schemas.end(),
                       [&](const std::string& schema) { return schema.find(part) != std::string::npos; });
  };
  if (has("INTEGRATED_CNC_SCHEMA"))
    throw InputError(file.name,
                     "an AP238 file (INTEGRATED_CNC_SCHEMA), a different data model from ISO 14649; "
                     "export the program as ISO 14649 (ARM) STEP-NC");
  for (const std::string_view solid :
       {"AUTOMOTIVE_DESIGN", "CONFIG_CONTROL_DESIGN", "AP203", "AP214", "AP242"})
    if (has(solid))
      throw InputError(file.name,
                       "a STEP solid (" + file.schemas[0] + "), not a STEP-NC program; read it as a solid");
}

}  // namespace clearcut::read::stepnc
