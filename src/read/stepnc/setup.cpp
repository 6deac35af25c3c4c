#include "read/stepnc/setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text.h"
#include "read/stepnc/executables.h"

namespace clearcut::read::stepnc {

namespace {

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

/// The set-up that a step is cut in: that of its workplan, else that of the step before.
struct SetupOfStep {
  OrderedStep step;
  std::size_t setup = 0;
};

Vec3 offset_of(const Node& mounted) {
  const auto offset = mounted.ref(2);
  if (!offset) return {};
  const std::vector<double> by = offset->lengths(0);
  if (by.size() != 3) offset->fail("its shift has not three numbers; give x, y and z");
  return {by[0], by[1], by[2]};
}

bool is_box_kept(const Frame& frame) {
  for (const Vec3& axis : {frame.x, frame.y, frame.z})
    if (std::abs(axis.x * axis.y) + std::abs(axis.y * axis.z) + std::abs(axis.x * axis.z) > 1e-9)
      return false;
  return true;
}

std::optional<Node> mounted_in(const Node& setup, const std::optional<Node>& workpiece) {
  const std::vector<Node> all = setup.refs(3);
  for (const Node& one : all) {
    const auto mounted = one.sound_ref(0);
    if (workpiece && mounted && mounted->id() == workpiece->id()) return one;
  }
  return all.empty() ? std::nullopt : std::optional(all.front());
}

ProgramSetup setup_of(const std::optional<Node>& node, const std::optional<Node>& workpiece) {
  ProgramSetup setup{node, std::nullopt, {}, {}, {}};
  if (!node) return setup;
  if (!node->is("SETUP")) node->fail("a SETUP is needed here; correct the reference");
  const Frame origin = frame_of(node->ref(1));
  if (!is_upright(origin)) node->fail("the set-up is tilted; only set-ups with Z upwards can be machined");
  setup.lies = origin;
  setup.mounted = mounted_in(*node, workpiece);
  if (setup.mounted) {
    const Frame frame = frame_of(setup.mounted->ref(1));
    if (!is_upright(frame) && !is_box_kept(composed(origin, frame)))
      setup.mounted->fail(
          "the workpiece is tilted in its set-up; only turns by right angles can be machined");
    const Vec3 by = offset_of(*setup.mounted);
    setup.place = {frame.origin.x + by.x, frame.origin.y + by.y, frame.origin.z + by.z};
    setup.lies = composed(origin, frame);
  }
  setup.lies.origin = {};
  return setup;
}

bool lies_the_same(const ProgramSetup& a, const ProgramSetup& b) {
  const auto same = [](const std::optional<Node>& x, const std::optional<Node>& y) {
    return x.has_value() == y.has_value() && (!x || x->id() == y->id());
  };
  return same(a.node, b.node) || (same(a.mounted, b.mounted) && a.mounted && a.lies.x == b.lies.x &&
                                  a.lies.z == b.lies.z && a.place == b.place);
}

/// Gives each step its set-up; a set-up ends where the next step has another.
std::vector<SetupOfStep> divide(std::vector<OrderedStep> steps, Program& program) {
  std::vector<SetupOfStep> divided;
  for (OrderedStep& step : steps) {
    const bool first = program.setups.empty();
    if (first || step.setup) {
      ProgramSetup own = setup_of(step.setup, program.workpiece);
      if (!first && !program.setups.back().node) {
        program.setups.back() = own;  // the steps before named none
      } else if (first || !lies_the_same(program.setups.back(), own)) {
        program.setups.push_back(std::move(own));
      }
    }
    divided.push_back({std::move(step), program.setups.size() - 1});
  }
  return divided;
}

/// A block that would stand aslant keeps the workpiece's axes.
void choose_axes(std::vector<ProgramSetup>& setups) {
  for (ProgramSetup& setup : setups)
    if (is_box_kept(setup.lies) && (setups.size() > 1 || !is_upright(setup.lies))) setup.turn = setup.lies;
}

void read_project(Program& program, const std::vector<Node>& projects, Context& context) {
  if (projects.empty()) return;
  if (projects.size() > 1)
    context.diagnostics.doubt(context.file.place(projects[1].line()), kNotFollowed,
                              projects[1].label() + " '" + projects[1].text(0) +
                                  "' is not followed: of several projects the first is carried out");
  program.name = projects[0].text(0);
  const auto workpieces = projects[0].refs(2);
  if (!workpieces.empty()) program.workpiece = workpieces[0];
  if (workpieces.size() > 1)
    context.warn("more than one workpiece; the first is the one machined", projects[0]);
  for (std::size_t i = 1; i < workpieces.size(); ++i) context.said(workpieces[i]);
}

/// A workpiece that no project names is that of the first feature.
void find_workpiece(Program& program, const std::vector<OrderedStep>& steps) {
  for (const OrderedStep& step : steps) {
    if (program.workpiece) return;
    const auto feature = step.node.sound_ref(2);
    if (feature) program.workpiece = feature->sound_ref(1);
  }
}

[[noreturn]] void refuse_empty(const Node& plan) {
  const std::vector<Node> elements = plan.refs(1);
  if (elements.empty()) plan.fail("the workplan holds no machining workingstep; there is nothing to make");
  plan.fail("none of its elements is carried out: " + elements[0].label() +
            " is no machining workingstep and no workplan; there is nothing to make");
}

}  // namespace

Program read_program(Context& context, int number) {
  Program program;
  const std::vector<Node> projects = nodes_called(context.file, "PROJECT");
  read_project(program, projects, context);
  const bool has_plan = !projects.empty() && !projects[0].unset(1);
  const Node plan = has_plan ? projects[0].needed_ref(1, "main workplan") : main_workplan(context);
  if (!has_plan) context.note("no project names its main workplan; this one is carried out", plan);
  WorkOrder order = work_order(plan, context);
  if (order.steps.empty()) refuse_empty(plan);
  find_workpiece(program, order.steps);
  const std::vector<SetupOfStep> divided = divide(std::move(order.steps), program);
  choose_axes(program.setups);
  if (number < 0 || number > static_cast<int>(program.setups.size()))
    throw InputError(context.file.name, "it has no set-up " + std::to_string(number) + ", but " +
                                            std::to_string(program.setups.size()));
  if (number > 0) program.setup = static_cast<std::size_t>(number - 1);
  for (const SetupOfStep& one : divided) {
    if (number == 0 || one.setup == program.setup)
      program.steps.push_back(one.step);
    else
      context.said(one.step.node);
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

Extent block_extent(const Node& block, const Frame& turn, Context& context) {
  const Frame frame = composed(turn, frame_of(block.ref(1)));
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
Extent cylinder_extent(const Node& cylinder, const Frame& turn) {
  const Frame frame = composed(turn, frame_of(cylinder.ref(1)));
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
    extent = block_extent(*geometry, program.chosen().turn, context);
  } else if (geometry->is("RIGHT_CIRCULAR_CYLINDER")) {
    extent = cylinder_extent(*geometry, program.chosen().turn);
    context.note("round stock; its bounding box is taken", *geometry);
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

std::string place_text(Vec3 at) {
  return "x " + trimmed(at.x, 3) + ", y " + trimmed(at.y, 3) + ", z " + trimmed(at.z, 3);
}

/// Where the operator finds the program's zero and axes.
void tell_place(const ProgramSetup& setup, Context& context) {
  if (!setup.node) return;
  Frame mounted = setup.lies;
  mounted.origin = setup.place;
  const Frame origin = frame_of(setup.node->ref(1));
  if (is_identity(origin) && is_identity(mounted)) return;
  std::string text =
      "program zero is the workpiece's origin; its place on the machine is for the operator to set: " +
      place_text(setup.place) + " in the set-up, whose origin is " + place_text(origin.origin) +
      " of the machine";
  if (!is_identity({{}, mounted.x, mounted.y, mounted.z}))
    text += "; the workpiece's x lies along (" + trimmed(mounted.x.x, 6) + ", " + trimmed(mounted.x.y, 6) +
            ", " + trimmed(mounted.x.z, 6) + "), its z along (" + trimmed(mounted.z.x, 6) + ", " +
            trimmed(mounted.z.y, 6) + ", " + trimmed(mounted.z.z, 6) + ")";
  context.warn(text, *setup.node);
}

}  // namespace

std::optional<double> read_clearance(const Program& program, Context& context) {
  const ProgramSetup& setup = program.chosen();
  tell_place(setup, context);
  std::optional<double> highest;
  const auto raise = [&](const Node& plane) {
    const double z = plane_height(plane) - setup.place.z;
    if (std::abs(z) < 1e6) highest = std::max(highest.value_or(z), z);
  };
  if (setup.node)
    if (const auto plane = setup.node->ref(2)) raise(*plane);
  for (const OrderedStep& step : program.steps) {
    try {
      if (const auto plane = step.node.ref(1)) raise(*plane);
    } catch (const InputError&) {
      context.note("its security plane cannot be read; that of the set-up holds", step.node);
    }
  }
  return highest;
}

namespace {

/// mm. How far off the workpiece a clamp may touch it.
constexpr double kOnWorkpiece = 0.01;

KeepOut keep_out_of(const Extent& extent) {
  return {{{extent.min.x, extent.min.y}, {extent.max.x, extent.max.y}}, extent.min.z, extent.max.z};
}

bool lies_on(const Stock& stock, Vec3 point) {
  return stock.plan.grown(kOnWorkpiece).contains({point.x, point.y}) &&
         point.z > stock.z_bottom - kOnWorkpiece && point.z < stock.z_top + kOnWorkpiece;
}

void add_clamps(const Program& program, const std::optional<Stock>& stock, Context& context,
                std::vector<KeepOut>& out) {
  if (!program.workpiece) return;
  for (const Node& clamp : program.workpiece->refs(6)) {
    const Vec3 point = program.chosen().turn.point(location_of(clamp));
    if (stock && !lies_on(*stock, point)) {
      context.warn("the clamping position does not lie on the workpiece (" + place_text(point) +
                       "); the tool is not kept out of it",
                   clamp);
      continue;
    }
    context.warn("a clamp stands at " + place_text(point) +
                     "; how large it is is not stated: the tool is kept out of that point alone",
                 clamp);
    out.push_back({{{point.x, point.y}, {point.x, point.y}}, point.z, point.z});
  }
}

void add_restricted_area(const Node& area, const Program& program, Context& context,
                         std::vector<KeepOut>& out) {
  if (area.is("BLOCK")) {
    out.push_back(keep_out_of(block_extent(area, program.chosen().turn, context)));
  } else if (area.is("RIGHT_CIRCULAR_CYLINDER")) {
    out.push_back(keep_out_of(cylinder_extent(area, program.chosen().turn)));
  } else {
    context.said(area);
    return context.diagnostics.doubt(context.file.place(area.line()), kNotFollowed,
                                     area.label() +
                                         " is a restricted area that cannot be read; the tool may come into "
                                         "it: give a BLOCK");
  }
  const KeepOut& block = out.back();
  context.note("the tool is kept out of the restricted area, in the workpiece's coordinates: x " +
                   trimmed(block.plan.min.x, 3) + " to " + trimmed(block.plan.max.x, 3) + ", y " +
                   trimmed(block.plan.min.y, 3) + " to " + trimmed(block.plan.max.y, 3) + ", z " +
                   trimmed(block.bottom_z, 3) + " to " + trimmed(block.top_z, 3),
               area);
}

}  // namespace

std::vector<KeepOut> read_keep_outs(const Program& program, const std::optional<Stock>& stock,
                                    Context& context) {
  std::vector<KeepOut> keep_outs;
  add_clamps(program, stock, context, keep_outs);
  if (!program.chosen().mounted) return keep_outs;
  // The standard has one; a list of them is read as well.
  for (const Node& area : program.chosen().mounted->refs(3))
    add_restricted_area(area, program, context, keep_outs);
  for (const Node& instruction : program.chosen().mounted->refs(4)) {
    const std::string document = instruction.text(1);
    context.warn("the set-up's instruction: " + instruction.text(0) +
                     (document.empty() ? "" : " (see " + document + ")"),
                 instruction);
  }
  return keep_outs;
}

void check_schema(const P21File& file) {
  const auto has = [&](std::string_view part) {
    return std::any_of(file.schemas.begin(), file.schemas.end(),
                       [&](const std::string& schema) { return schema.find(part) != std::string::npos; });
  };
  if (is_ap238(file)) {
    const std::size_t steps = nodes_called(file, "MACHINING_WORKINGSTEP").size();
    throw InputError(file.name,
                     "an AP238 file (INTEGRATED_CNC_SCHEMA), a different data model from ISO 14649; "
                     "export the program as ISO 14649 (ARM) STEP-NC" +
                         (steps == 0 ? ""
                                     : "; it holds " + std::to_string(steps) +
                                           " workingsteps, which `clearcut info` lists"));
  }
  for (const std::string_view solid :
       {"AUTOMOTIVE_DESIGN", "CONFIG_CONTROL_DESIGN", "AP203", "AP214", "AP242"})
    if (has(solid))
      throw InputError(file.name,
                       "a STEP solid (" + file.schemas[0] + "), not a STEP-NC program; read it as a solid");
}

}  // namespace clearcut::read::stepnc
