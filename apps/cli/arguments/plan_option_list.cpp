// Which options there are, and what help says of them.
#include <clearcut/plan.h>
#include <fmt/ranges.h>

#include "arguments/plan_arguments.h"
#include "arguments/quantities.h"
#include "arguments/suggest.h"

namespace clearcut::cli {

void PlanArguments::add_part_options(CLI::App& command, const std::string& input_name) {
  command.option_defaults()->group("Input");
  if (input_name == "INPUT") {
    command.add_option("INPUT", input_, "Part: .p21 .stp .step .stpnc .dxf .svg .json .edges .toml")
        ->required()
        ->type_name("FILE");
  } else {
    command.add_option(input_name, input_, "Part the program is for")->required()->type_name("FILE");
  }
  command.add_option(
      "--origin", zero_,
      "Zero of the program: corner or centre of the top of the block, or X,Y,Z (default: the file's)");
  command.add_option("--setup", setup_.number, "Which set-up of a job that has several (from 1)")
      ->check(CLI::Range(1, 100));
  command
      .add_option(
          "--earlier-setup", setup_.earlier_programs,
          "Programs of the set-ups before that one, in order (repeatable): its stock is what they leave")
      ->type_name("FILE");
  command.add_option("--unit", unit_, "Unit of a drawing that names none: mm, cm, m, inch, px")
      ->check(for_example({"mm", "cm", "m", "inch", "px"}));
  command.add_option("--layer", layers_, "Layer of a drawing to read (repeatable; default all)");
  command.add_option("--top", top_, "Z of the top of the material for outlines and drawings, mm (default 0)")
      ->transform(as_length());
  command.add_option("--depth", depth_, "Depth of every outline of a drawing, mm")->transform(as_length());
  add_drawing_options(command);
  command
      .add_option(
          "--stock-from", stock_.from,
          "What it is made of: a solid (.step) in the same coordinates, or the program that has run before")
      ->type_name("FILE");
  command.add_flag("--mirror", mirror_, "Mirror a drawing left to right, as it looks from below");
  command.option_defaults()->group("Solids");
  command.add_option(
      "--up", solid_.up,
      "Side of a solid that looks up: +Z, -Z, +X, -X, +Y, -Y, or face12 for a flat face of `info`");
  command.add_option("--turn", solid_.turn_deg,
                     "Turn of a solid about the vertical, degrees counter-clockwise seen from above");
  command.add_option("--body", solid_.body, "Body of an assembly to make: its name or number, or all");
  command
      .add_option("--breakthrough", solid_.breakthrough,
                  "How far through cuts go below the material, mm (default 0.5; profiles of drawings 0)")
      ->check(CLI::NonNegativeNumber);
}

void PlanArguments::add_drawing_options(CLI::App& command) {
  command.option_defaults()->group("Drawings");
  command.add_option(
      "--op", operations_,
      "KIND:SELECTION, what outlines of a drawing are for: pocket, step, profile, inside, drill, engrave, "
      "tslot, vcarve, isolate, chamfer, face, island or ignore, with a depth as in profile_d6; the selection "
      "is a layer, a colour, outer or numbers of `info` (repeatable)");
  command
      .add_option(
          "--tabs", tabs_.count,
          "Tabs that hold what a profile, or a line through the material, cuts free, of each (default none)")
      ->check(CLI::Range(0, 100));
  command
      .add_option("--tab-spacing", tabs_.spacing,
                  "Instead of --tabs: as many as it takes that none is farther from the next along the "
                  "outline, mm")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--tab-at", tabs_.at,
                  "Instead of --tabs: X,Y of a tab, mm, within 5 mm of the outline (repeatable)")
      ->allow_extra_args(false);
  command
      .add_option("--tab-shape", tabs_.shape,
                  "Of tabs: square (default), or triangular, which the cutter rises over without a stop")
      ->check(one_of({"square", "triangular"}));
  command.add_option("--tab-width", tabs_.width, "Of tabs along the outline, mm (default 4)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--tab-height", tabs_.height,
                  "Of tabs over the underside of the material, mm (default 2, at most half the depth)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--skin", tabs_.skin,
                  "Material that profiles leave under themselves instead of tabs, mm (default none)")
      ->check(CLI::PositiveNumber);
  command.add_option("--scale", scale_, "Factor for a drawing's size (default 1)")
      ->check(CLI::PositiveNumber);
  command.add_option("--join-gap", join_gap_, "Gaps in outlines that are closed, mm (default 0.01)")
      ->check(CLI::Range(1e-6, 10.0));
  command.add_option("--strokes", strokes_, "Strokes of an SVG: lines (default) or areas as wide as drawn")
      ->check(one_of({"lines", "areas"}));
  command
      .add_option("--text", text_, "Text of a drawing: skip (default) or outlines of its letters, by fonts")
      ->check(one_of({"skip", "outlines"}));
  command.add_option("--open-curves", open_curves_, "Open lines of a drawing: refuse (default) or skip")
      ->check(one_of({"refuse", "skip"}));
}

void PlanArguments::add_tool_list_options(CLI::App& command) {
  command.option_defaults()->group("Tools");
  command.add_option(
      "--tool", tools_,
      "KIND:DIAMETER, then any of :T3 :60deg :tip=0.2 :flutes=2 :corner=0.5 :length=20 :shank=8 "
      ":stickout=30 :holder=40 :max_spindle=12000 :hss :carbide :coated :name=N :noplunge; "
      "kinds: "
      "endmill, facemill, bullnose, ball, drill, reamer, vbit, chamfer, spotdrill, tap, threadmill, "
      "boringbar, counterbore, tapered (:taper=5deg), tslot (repeatable)");
  command.add_option("--tools", tool_library_, "Tool library: .fctb .fctl .tbl .json .toml")
      ->type_name("FILE");
}

void PlanArguments::add_tool_options(CLI::App& command) {
  add_tool_list_options(command);
  command.option_defaults()->group("Machine");
  command.add_option("--machine", machine_file_, "Machine file (.toml): limits, acceleration, rapid")
      ->type_name("FILE");
  command
      .add_option("--machine-kind", machine_kind_,
                  "router or mill: speeds and power that are usual, where the machine states none")
      ->check(one_of(read::machine_kinds()));
  command.add_option("--accept", accept_,
                     "Condition that holds at the machine, by its name (repeatable): g55, blending, ...");
  command.add_option(
      "--keep-out", keep_outs_,
      "Block where a clamp is, as ranges LOW:HIGH of X, Y and Z: -10:15,20:40,-20:12; coming there is "
      "a fault (repeatable)");
  command.add_option("--acceleration", acceleration_, "Acceleration of the machine, mm/s2 (default 500)");
  command.add_option("--junction-deviation", junction_deviation_,
                     "Junction deviation of the machine, mm (default 0.01)");
  command.add_option("--rapid", rapid_feed_, "Rapid feed of the machine, mm/min (default 5000)")
      ->transform(as_feed());
  command.option_defaults()->group("Limits");
  command
      .add_option("--stepdown", cutting_.stepdown,
                  "Depth of one layer, mm (default: from the cutter; --explain says it)")
      ->transform(as_length());
  command.add_option("--allowance", cutting_.allowance, "Stock to leave on walls, mm (default 0)")
      ->transform(as_length());
  command
      .add_option("--allowance-floor", cutting_.allowance_floor, "Stock to leave on floors, mm (default 0)")
      ->transform(as_length());
  command.add_option("--engagement", cutting_.engagement,
                     "Largest engagement angle of the cutter, degrees (default: no limit)");
  command
      .add_option("--material", shop_.material,
                  "Of the work, for feeds and speeds, forces and wear (default: none): " +
                      fmt::format("{}", fmt::join(work_material_names(), ", ")))
      ->check(one_of(work_material_names()));
  command.option_defaults()->group("Search");
  command.add_option("--threads", threads_, "Threads; 0: all cores (default 0)");
}

void PlanArguments::add_cutting_options(CLI::App& command) {
  add_strategy_options(command);
  add_shop_options(command);
  post_.add_options(command);
  add_search_options(command);
}

void PlanArguments::add_strategy_options(CLI::App& command) {
  command.option_defaults()->group("Strategy");
  command
      .add_option(
          "--strategy", cutting_.strategy,
          "auto (default), contour, zigzag, spiral, adaptive, tour, or a published method: lom, rho, second, "
          "lom-corrected, rho-corrected, fixed, loops, pwid, single, double, bisectors")
      ->check(one_of(strategy_names()));
  command
      .add_option(
          "--style", shop_.style,
          "machinist (default where --material is a metal): helix, 45 % stepover, climb, no full width; or "
          "fastest (default otherwise)")
      ->check(one_of({"machinist", "fastest"}));
  command
      .add_option("--stepover", cutting_.stepover,
                  "Distance of passes: fraction of the diameter, 3.5mm, lom, rho[:W], or several with "
                  "commas, one a contour")
      ->transform(as_stepover());
  command.add_option("--angle", cutting_.angle,
                     "Direction of zigzag lines against x, degrees (default: the fastest)");
  command
      .add_option("--direction", cutting_.direction,
                  "climb (default) or conventional; said, auto tries nothing that cuts both ways")
      ->check(one_of({"climb", "conventional"}));
  command.add_option("--order", cutting_.order, "Contours inside-out (default) or outside-in")
      ->check(one_of({"inside-out", "outside-in"}));
  command
      .add_option("--passage", passage_,
                  "From contour to contour: bisector (of a corner; default of published methods) or shortest")
      ->check(one_of({"bisector", "shortest"}));
  command.add_option("--start", cutting_.start,
                     "Where the cutting of contours begins, or adaptive clearing goes down: X,Y");
}

void PlanArguments::add_search_options(CLI::App& command) {
  command.option_defaults()->group("Search");
  command
      .add_option("--objective", cutting_.objective,
                  "Of the strategy tour: length, turns, angle, engagement, time (default), or weights "
                  "1:length,20:turns")
      ->check(for_example({"length", "turns", "angle", "engagement", "time"}));
  command
      .add_option("--grid", grid_,
                  "Of the strategy tour: ours, or published (Tour eq. 4.8; leaves what it leaves)")
      ->check(one_of({"ours", "published"}));
  command.add_option("--time", time_, "Longest search, s (default: as long as it gains)");
  command.add_option("--seed", seed_, "Seed of the search (default 1)")->check(is_seed());
  solver_.add_options(command);
  command.option_defaults()->group("Search");
}

void PlanArguments::add_feed_options(CLI::App& command) {
  command.option_defaults()->group("Feeds and speeds");
  command.add_option("--feed", cutting_.feed, "Cutting feed, mm/min (default: of the tool, else 1000)")
      ->transform(as_feed());
  command
      .add_option("--plunge-feed", cutting_.plunge_feed, "Plunge feed, mm/min (default: 30 % of the feed)")
      ->transform(as_feed());
  command
      .add_option("--ramp-feed", cutting_.ramp_feed,
                  "Feed on ramps and helices, mm/min (default: 50 % of the feed)")
      ->transform(as_feed());
  command
      .add_option("--slot-feed", cutting_.slot_feed,
                  "Feed where the cutter is in the material all round, mm/min (default: the feed)")
      ->transform(as_feed());
  command.add_option("--slot-angle", shop_.slot_angle_deg,
                     "Engagement above which the slot feed rules, degrees (default 150)");
  command.add_option("--lead-feed", lead_feed_, "Feed on leads, mm/min (default: the feed)")
      ->transform(as_feed());
  command.add_option("--link-feed", link_feed_, "Feed between passes at depth, mm/min (default: the feed)")
      ->transform(as_feed());
  command.add_option("--spindle", cutting_.spindle,
                     "Spindle speed, rpm (default: of the tool, else 100 m/min)");
  command
      .add_option("--coolant", cutting_.coolant,
                  "off, flood, mist, or both at once (default: of the tool or the part's file, else off)")
      ->check(one_of(coolant_names()));
}

void PlanArguments::add_shop_options(CLI::App& command) {
  add_entry_options(command);
  add_lead_options(command);
  add_feed_options(command);
  add_stage_options(command);
}

void PlanArguments::add_entry_options(CLI::App& command) {
  command.option_defaults()->group("Entry");
  command
      .add_option("--entry", cutting_.entry,
                  "helix, ramp, zigzag or plunge (default: plunge; helix in metal, under limited engagement, "
                  "and for mills that do not cut over their centre)")
      ->check(one_of({"helix", "ramp", "zigzag", "plunge"}));
  command.add_option("--entry-angle", cutting_.entry_angle,
                     "Steepest way down of a helix or ramp, degrees (default 3)");
  command.add_option("--helix-diameter", shop_.helix_widest, "Widest helix of the cutter's centre, mm")
      ->transform(as_length());
  command.add_option("--helix-min", shop_.helix_narrowest, "Narrowest helix, mm; below it: ramp")
      ->transform(as_length());
  add_predrilled_option(command);
  command.add_option("--clearance", clearance_z_, "Z of rapid travel, mm (default: above the material)")
      ->transform(as_length());
}

void PlanArguments::add_predrilled_option(CLI::App& command) {
  command.add_option("--predrilled", predrilled_, "X,Y:DIAMETER of a hole to enter by (repeatable)");
}

void PlanArguments::add_lead_options(CLI::App& command) {
  command.option_defaults()->group("Leads and links");
  command
      .add_option("--lead", cutting_.lead,
                  "Radius of the arcs into and out of passes along walls, mm (default: none)")
      ->transform(as_length());
  command.add_option("--lead-angle", cutting_.lead_angle,
                     "Lines of that length at this angle to the pass instead of arcs, degrees");
  command
      .add_option("--lead-overlap", shop_.lead_overlap,
                  "How far passes along walls run on over their start, mm (default 0)")
      ->transform(as_length());
  command
      .add_option("--overrun", shop_.overrun,
                  "How far beyond the edge of the material open sides are cut, mm (default 0)")
      ->transform(as_length());
  command.add_option("--link-lift", shop_.link_lift, "Lift between passes at depth, mm")
      ->transform(as_length());
}

void PlanArguments::add_stage_options(CLI::App& command) {
  add_steps_options(command);
  command
      .add_option(
          "--dogbones", shop_.dogbones,
          "Relief in inside corners of pockets and profiles, so that square parts fit: corner (along the "
          "bisector) or t-bone (along the longer wall; default: none)")
      ->check(one_of({"corner", "t-bone"}));
  command.add_option("--scallop", cutting_.scallop, "Steps that layers may leave on drafted walls, mm")
      ->transform(as_length());
}

void PlanArguments::add_steps_options(CLI::App& command) {
  command.option_defaults()->group("Rest and finishing");
  command.add_flag("--rest", rest_, "Use all mills given, larger first, each on what is left");
  command.add_option("--after", stock_.after, "Program that has run before: cut only what it left")
      ->type_name("FILE");
  command
      .add_option("--finish", shop_.finish,
                  "Finishing after everything else: walls, floor or all (default: none)")
      ->check(one_of({"walls", "floor", "all"}));
  command
      .add_option("--finish-stock", shop_.finish_stock, "Stock left on walls for finishing, mm (default 0.3)")
      ->transform(as_length());
  command
      .add_option("--finish-stock-floor", shop_.finish_stock_floor,
                  "Stock left on floors for finishing, mm (default 0.2)")
      ->transform(as_length());
  command.add_option("--finish-depths", shop_.finish_depths,
                     "In how many depths walls are finished (default 1)");
}

}  // namespace clearcut::cli
