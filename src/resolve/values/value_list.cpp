#include <filesystem>

#include "base/text.h"
#include "model/entry.h"
#include "resolve/values/names.h"

namespace clearcut::resolve {
namespace {

std::string text_of(MmPerMin feed) {
  return trimmed(feed.mm_per_min(), 3);
}

std::string text_of(bool flag) {
  return flag ? "yes" : "no";
}

/// Adds values to a list. A stated value has its source in `sources`, else its source is `unnamed`.
class List {
 public:
  List(std::vector<ResolvedValue>& all, int step) : all_(all), step_(step) {}

  void add(const char* name, std::string value, const char* unit, Source source) {
    all_.push_back({step_, name, std::move(value), unit, std::move(source)});
  }

 private:
  std::vector<ResolvedValue>& all_;
  int step_;
};

Source by_default(const std::string& what) {
  return {Origin::kDefault, "default: " + what};
}

/// The sources of one operation's values.
class OperationSources {
 public:
  OperationSources(const Sources& known, Source read_from, const PlanOptions& options)
      : known_(known), read_from_(std::move(read_from)), options_(options) {}

  bool knows(const char* name) const { return known_.find(name) != nullptr; }
  /// Source of a value that is always stated: a known source, or the input.
  Source of(const char* name) const {
    const Source* known = known_.find(name);
    return known ? *known : read_from_;
  }
  /// Source of a value that may be absent.
  Source of(const char* name, bool is_stated, Source otherwise) const {
    return is_stated ? of(name) : std::move(otherwise);
  }
  /// Source of a value stated only by options.
  Source of_options(const char* name, bool is_stated, Source otherwise) const {
    return is_stated ? source_of(options_, name) : std::move(otherwise);
  }

 private:
  const Sources& known_;
  Source read_from_;
  const PlanOptions& options_;
};

std::string tool_text(const Tool& tool) {
  return "T" + std::to_string(tool.number) + " " + std::string(name_of(tool.kind)) + " " +
         trimmed(tool.diameter, 4);
}

void list_cutting(List& list, const ResolvedStep& step, const Operation& operation,
                  const OperationSources& sources, const ShopOptions& shop) {
  list.add("feed", text_of(step.feed), "mm/min", sources.of("feed"));
  list.add("plunge-feed", text_of(step.plunge_feed), "mm/min", sources.of("plunge-feed"));
  list.add("ramp-feed", text_of(step.ramp_feed), "mm/min", sources.of("ramp-feed"));
  list.add("lead-feed", text_of(step.lead_feed), "mm/min",
           sources.of_options("lead-feed", shop.lead_feed.has_value(), {Origin::kDerived, "the feed"}));
  list.add("slot-feed", text_of(step.slot_feed), "mm/min",
           sources.of("slot-feed", operation.cutting.slot_feed.has_value(), {Origin::kDerived, "the feed"}));
  list.add("spindle", trimmed(step.spindle_rpm, 3), "rpm", sources.of("spindle"));
  list.add("spindle-clockwise", text_of(step.spindle_clockwise), "",
           sources.of("spindle-clockwise", !step.spindle_clockwise, by_default("yes")));
  list.add("coolant", name_of(step.coolant), "",
           sources.of("coolant", operation.cutting.coolant.has_value(), by_default("off")));
}

void list_depths(List& list, const ResolvedStep& step, const Operation& operation,
                 const OperationSources& sources) {
  list.add("stepdown", trimmed(step.stepdown, 6), "mm", sources.of("stepdown"));
  const bool side = step.allowance_side != 0 || sources.knows("allowance");
  list.add("allowance", trimmed(step.allowance_side, 6), "mm",
           sources.of("allowance", side, by_default("0 mm")));
  const bool floor = step.allowance_floor != 0 || sources.knows("allowance-floor");
  list.add("allowance-floor", trimmed(step.allowance_floor, 6), "mm",
           sources.of("allowance-floor", floor, by_default("0 mm")));
  list.add("scallop", operation.scallop ? trimmed(*operation.scallop, 6) : "none",
           operation.scallop ? "mm" : "",
           sources.of("scallop", operation.scallop.has_value(), by_default("the stepdown alone counts")));
  list.add("crossing", trimmed(step.cross_z, 6), "mm",
           sources.of("retract", operation.retract_z.has_value(), by_default("2 mm over all that stands")));
}

void list_entry(List& list, const ResolvedStep& step, const Operation& operation, const Tool& tool,
                const OperationSources& sources, const ShopOptions& shop) {
  const std::string otherwise = step.entry == step.entry_at_limit ? "" : ", helix under limited engagement";
  list.add("entry", name_of(step.entry) + otherwise, "",
           sources.of("entry", operation.entry.has_value(),
                      by_default(tool.center_cutting ? "plunge, helix under limited engagement"
                                                     : "helix for cutters that cannot plunge")));
  list.add("entry-angle", trimmed(step.entry_angle.degrees(), 4), "deg",
           sources.of("entry-angle", operation.entry_angle.has_value(), by_default("3 deg")));
  const Source widest = shop.helix_widest ? sources.of_options("helix-diameter", true, {})
                                          : sources.of("entry-size", operation.entry_size.has_value(),
                                                       by_default("what each entry can use"));
  list.add("helix-diameter", step.helix_widest ? trimmed(*step.helix_widest, 6) : "any",
           step.helix_widest ? "mm" : "", widest);
  list.add("helix-min", step.helix_narrowest ? trimmed(*step.helix_narrowest, 6) : "0.2 diameters",
           step.helix_narrowest ? "mm" : "",
           sources.of_options("helix-min", step.helix_narrowest.has_value(), by_default("0.2 diameters")));
}

void list_leads(List& list, const ResolvedStep& step, const Operation& operation,
                const OperationSources& sources) {
  list.add("lead", trimmed(step.lead, 6), "mm",
           sources.of("lead", operation.lead.has_value(), by_default("none")));
  list.add("lead-angle", step.lead_angle ? trimmed(step.lead_angle->degrees(), 4) : "arcs",
           step.lead_angle ? "deg" : "",
           sources.of("lead-angle", operation.lead_angle.has_value(), by_default("arcs")));
}

/// Notes the stepover stated in the part's file if it is not used.
Source with_unused_stepover(Source source, const ResolvedStep& step, const Operation& operation) {
  if (!step.stepover.is_given() && operation.stepover)
    source.text += "; stated " + trimmed(*operation.stepover, 6) + " of the diameter is not used";
  return source;
}

void list_paths(List& list, const ResolvedStep& step, const Operation& operation,
                const OperationSources& sources, const PlanOptions& options) {
  list.add("direction", name_of(step.direction), "", sources.of("direction"));
  const Source angle = options.angle_deg ? source_of(options, "angle")
                                         : sources.of("angle", step.stroke_angle.has_value(),
                                                      by_default("the fastest, where lines run"));
  list.add("angle", step.stroke_angle ? trimmed(step.stroke_angle->degrees(), 4) : "fastest",
           step.stroke_angle ? "deg" : "", angle);
  list.add("passage",
           step.bisector_passages ? (*step.bisector_passages ? "bisector" : "shortest") : "by strategy", "",
           sources.of("passage", step.bisector_passages.has_value(), by_default("the strategy decides")));
  list.add("reflex", step.sharp_reflex ? (*step.sharp_reflex ? "corner" : "round") : "by strategy", "",
           sources.of("reflex", step.sharp_reflex.has_value(), by_default("the strategy decides")));
  list.add("grid", step.published_grid ? "published" : "ours", "",
           sources.of("grid", step.published_grid, by_default("ours")));
  list.add("solver", step.solver.is_published ? "published" : "modern", "",
           sources.of("solver", step.solver.is_published, by_default("modern")));
  list.add("rest", text_of(operation.rest), "",
           operation.rest ? Source{Origin::kDerived, "what earlier steps leave"} : by_default("no"));
}

class PlanList {
 public:
  PlanList(std::vector<ResolvedValue>& all, const PlanOptions& options) : list_(all, -1), options_(options) {}

  void add(const char* name, std::string value, const char* unit, bool is_stated,
           const std::string& otherwise) {
    // Values of the options without std::optional count as stated if their source is known.
    const bool known = is_stated || options_.sources.find(name);
    list_.add(name, std::move(value), unit, known ? source_of(options_, name) : by_default(otherwise));
  }
  void add_of_machine(const char* name, std::string value, const char* unit) {
    const Source* source = options_.sources.find(name);
    list_.add(name, value, unit, source ? *source : by_default(value));
  }
  void add_clearance(const Part& part) {
    const Source* source = options_.sources.find("clearance");
    const Source otherwise =
        part.clearance_z ? Source{Origin::kPart, part.source_file} : by_default("10 mm over the top");
    list_.add("clearance", trimmed(part.safe_z(), 6), "mm", source ? *source : otherwise);
  }

 private:
  List list_;
  const PlanOptions& options_;
};

void list_search(PlanList& list, const ResolvedPlan& plan, const PlanOptions& options) {
  list.add("order", name_of(plan.order), "", options.outside_in, "inside-out");
  list.add("start", plan.start ? trimmed(plan.start->x, 4) + "," + trimmed(plan.start->y, 4) : "anywhere",
           plan.start ? "mm" : "", plan.start.has_value(), "anywhere");
  list.add("engagement", plan.engagement_deg ? trimmed(*plan.engagement_deg, 4) : "no limit",
           plan.engagement_deg ? "deg" : "", plan.engagement_deg.has_value(), "no limit");
  list.add("objective", options.objective, "", false, "time");
  list.add("time", plan.search_s ? trimmed(*plan.search_s, 4) : "by effort", plan.search_s ? "s" : "",
           plan.search_s.has_value(), "a fixed effort, the same on any machine");
  list.add("seed", std::to_string(plan.seed), "", plan.seed != 1, "1");
  list.add("threads", options.threads == 0 ? "all" : std::to_string(options.threads), "",
           options.threads != 0, "all cores; the result is the same");
}

/// Description of the initial stock of a plan.
std::string what_went_before(const std::optional<Toolpath>& earlier) {
  if (!earlier) return "none";
  const bool is_solid = std::any_of(earlier->sections.begin(), earlier->sections.end(),
                                    [](const Section& section) { return section.is_of_stock; });
  return is_solid ? "a solid" : "a program";
}

void list_shop(PlanList& list, const ResolvedPlan& plan, const ShopOptions& shop) {
  list.add("lead-overlap", trimmed(plan.lead_overlap, 6), "mm", shop.lead_overlap.has_value(), "0 mm");
  list.add("overrun", trimmed(plan.overrun, 6), "mm", shop.overrun.has_value(),
           shop.stock_oversize ? "the stock's oversize" : "0 mm");
  list.add("link-lift", trimmed(plan.link_lift, 6), "mm", shop.link_lift.has_value(), "0 mm");
  list.add("stock-oversize", trimmed(plan.stock_oversize, 6), "mm", shop.stock_oversize.has_value(), "0 mm");
  list.add("link-feed", plan.link_feed ? text_of(*plan.link_feed) : "the feed",
           plan.link_feed ? "mm/min" : "", shop.link_feed.has_value(),
           "the feed, rapid through cut material");
  list.add("slot-angle", trimmed(plan.slot_angle.degrees(), 4), "deg", shop.slot_angle_deg.has_value(),
           "150 deg");
  if (plan.margin) {
    list.add("margin-at-least", trimmed(plan.margin->at_least, 6), "mm", shop.margin_at_least.has_value(),
             "0 mm");
    list.add("margin-uncut", trimmed(plan.margin->bounds.uncut, 6), "mm", shop.margin_uncut.has_value(),
             "0.01 mm");
    list.add("margin-gouge", trimmed(plan.margin->bounds.gouge, 6), "mm", shop.margin_gouge.has_value(),
             "0.001 mm");
  }
  if (plan.feed_rule) {
    list.add("feed-by", name_of(plan.feed_rule->by), "", true, "");
    list.add("reference-engagement", trimmed(plan.feed_rule->reference.degrees(), 4), "deg",
             shop.reference_engagement_deg.has_value(), "90 deg");
    list.add("reference-feed", plan.feed_rule->feed ? text_of(*plan.feed_rule->feed) : "the feed",
             plan.feed_rule->feed ? "mm/min" : "", shop.reference_feed.has_value(), "the feed");
    list.add("feed-cap", plan.feed_rule->cap ? text_of(*plan.feed_rule->cap) : "twice the reference feed",
             plan.feed_rule->cap ? "mm/min" : "", shop.feed_cap.has_value(), "twice the reference feed");
  }
  list.add("rest", text_of(shop.rest.value_or(false)), "", shop.rest.has_value(), "no");
  list.add("finish", name_of(plan.finish), "", shop.finish.has_value(), "none");
  list.add("finish-steps", trimmed(shop.finish_steps.value_or(1), 0), "", shop.finish_steps.has_value(), "1");
  list.add("spring-passes", trimmed(shop.spring_passes.value_or(0), 0), "", shop.spring_passes.has_value(),
           "0");
  list.add("compensation", shop.compensation.value_or("none"), "", shop.compensation.has_value(), "none");
  if (plan.post.wear)
    list.add("wear-range", trimmed(plan.post.wear->range, 4), "mm", shop.wear_range.has_value(), "0.1 mm");
  list.add("dogbones", shop.dogbones.value_or("none"), "", shop.dogbones.has_value(), "none");
  list.add("material", shop.material.value_or("none"), "", shop.material.has_value(), "none: no forces");
  list.add("style", shop.is_machinist() ? "machinist" : "fastest", "", shop.style.has_value(),
           shop.is_machinist() ? "machinist: the work is a metal" : "fastest");
  list.add("after", what_went_before(plan.earlier), "", plan.earlier.has_value(), "none");
}

/// One value, or the values of X, Y and Z if the axes differ.
std::string of_axes(double all, const std::optional<AxisValues>& values) {
  if (!values) return trimmed(all, 3);
  return trimmed((*values)[0], 3) + " / " + trimmed((*values)[1], 3) + " / " + trimmed((*values)[2], 3);
}

void list_machine(PlanList& list, const Machine& machine) {
  list.add_of_machine("machine", machine.name, "");
  list.add_of_machine("planner", std::string(machine.planner ? name_of(*machine.planner) : "of the control"),
                      "");
  list.add_of_machine("rapid", of_axes(machine.rapid.mm_per_min(), machine.axis_rapid), "mm/min");
  list.add_of_machine("acceleration", of_axes(machine.acceleration, machine.axis_acceleration), "mm/s2");
  list.add_of_machine("junction-deviation", trimmed(machine.junction_deviation, 6), "mm");
  list.add_of_machine("max-spindle",
                      machine.max_spindle_rpm ? trimmed(*machine.max_spindle_rpm, 3) : "no limit",
                      machine.max_spindle_rpm ? "rpm" : "");
  if (machine.min_spindle_rpm)
    list.add_of_machine("min-spindle", trimmed(*machine.min_spindle_rpm, 3), "rpm");
  if (machine.spindle_power_w)
    list.add_of_machine("spindle-power", trimmed(*machine.spindle_power_w, 3), "W");
  if (machine.spindle_torque_nm)
    list.add_of_machine("spindle-torque", trimmed(*machine.spindle_torque_nm, 3), "Nm");
  list.add_of_machine("max-feed", machine.max_feed ? text_of(*machine.max_feed) : "no limit",
                      machine.max_feed ? "mm/min" : "");
  if (machine.cutting_force_n)
    list.add_of_machine("cutting-force", trimmed(*machine.cutting_force_n, 3), "N");
  list.add_of_machine("travel", machine.travel ? "limited" : "no limit", "");
}

void list_post(PlanList& list, const PostOptions& post) {
  list.add("post", post.dialect, "", false, "linuxcnc");
  list.add("inch", text_of(post.inch), "", post.inch, "no");
  list.add("work-offset", words_of(post.work_offset), "", post.work_offset != WorkOffset{}, "G54");
  const bool usual_end = post.end == EndPosition{};
  list.add("end-position", usual_end ? "usual" : name_of(post.end), "", !usual_end,
           "Z home on Fanuc and Haas, else the safe height");
  list.add("decimals", post.decimals ? std::to_string(*post.decimals) : "the controller's", "",
           post.decimals.has_value(), "what the controller resolves");
  list.add("arcs", text_of(post.arcs), "", !post.arcs, "yes");
  list.add("tool-change", text_of(post.tool_changer), "", !post.tool_changer, "yes");
  list.add("length-offset", text_of(post.length_offset), "", !post.length_offset, "yes");
  list.add("exact-stop", text_of(post.exact_stop), "", post.exact_stop, "no");
  list.add("corner-tolerance", trimmed(post.corner_tolerance.value_or(post.tol.gouge / 2), 6), "mm",
           post.corner_tolerance.has_value(), "half of the gouge tolerance");
  list.add("spindle-wait", post.spindle_wait ? trimmed(post.spindle_wait->seconds(), 3) : "the controller's",
           post.spindle_wait ? "s" : "", post.spindle_wait.has_value(), "by controller");
}

void list_tolerances(PlanList& list, const Tolerances& tol) {
  const Tolerances usual;
  const auto add = [&](const char* name, double value, double usually) {
    list.add(name, trimmed(value, 7), "mm", value != usually, trimmed(usually, 7) + " mm");
  };
  add("tolerance-uncut", tol.uncut, usual.uncut);
  add("tolerance-gouge", tol.gouge, usual.gouge);
  add("tolerance-chord", tol.chord, usual.chord);
  add("tolerance-fit", tol.fit, usual.fit);
}

}  // namespace

Source read_source(const Part& part, const Workingstep& step) {
  const std::string file = std::filesystem::path(part.source_file).filename().string();
  const std::string& place = step.operation.source.empty() ? step.source : step.operation.source;
  if (file.empty()) return {Origin::kPart, place.empty() ? "the part" : place};
  return {Origin::kPart, place.empty() ? file : file + " " + place};
}

void list_step(ResolvedPlan& plan, int index, const Sources& known, const PlanOptions& options) {
  const auto& planned = plan.part.workplan[static_cast<std::size_t>(index)];
  const ResolvedStep& step = plan.steps[static_cast<std::size_t>(index)];
  const Operation& operation = planned.operation;
  const Tool& tool = tool_of(plan.part, planned);
  const OperationSources sources(known, read_source(plan.part, planned), options);
  List list(plan.values, index);
  list.add("tool", tool_text(tool), "mm", sources.of("tool"));
  list.add("strategy", step.strategy ? step.strategy->name : "auto", "", sources.of("strategy"));
  list.add("stepover", step.stepover.is_given() ? step.stepover.text : "by strategy", "",
           with_unused_stepover(sources.of("stepover"), step, operation));
  list_cutting(list, step, operation, sources, options.shop);
  list_depths(list, step, operation, sources);
  list_paths(list, step, operation, sources, options);
  list_entry(list, step, operation, tool, sources, options.shop);
  list_leads(list, step, operation, sources);
}

void list_plan(ResolvedPlan& plan, const PlanOptions& options) {
  PlanList list(plan.values, options);
  list.add_clearance(plan.part);
  list_search(list, plan, options);
  list_shop(list, plan, options.shop);
  list_machine(list, plan.machine);
  list_post(list, plan.post);
  list_tolerances(list, plan.tol);
}

}  // namespace clearcut::resolve
