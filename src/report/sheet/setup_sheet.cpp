#include "report/sheet/setup_sheet.h"

#include "base/text.h"
#include "base/units.h"
#include "model/results/findings.h"
#include "model/section_names.h"
#include "report/picture/plan_marks.h"
#include "report/picture/plan_picture.h"
#include "report/picture/svg_writer.h"
#include "report/sheet/sheet_facts.h"
#include "report/words/text_table.h"

namespace clearcut::report {
namespace {

/// Page units of the picture.
constexpr double kPictureWidth = 900, kPictureHeight = 460;
/// Page units: half the length of the cross at X0 Y0.
constexpr double kZeroMark = 16;

/// Composes each part of the sheet.
class Composer {
 public:
  Composer(const Part& part, const Toolpath& toolpath, const Findings& findings, const SetupSheetInfo& info)
      : part_(part), toolpath_(toolpath), findings_(findings), info_(info) {}

  std::string headline() const {
    return info_.program_name + " for " + info_.dialect + ", " + clock_time(findings_.all.time_s) + " in all";
  }

  std::vector<SheetFact> facts() const {
    std::vector<SheetFact> facts = stock_facts();
    const Extents cuts = extents_of(toolpath_, false), all = extents_of(toolpath_, true);
    if (!all.plan.empty()) {
      if (!cuts.plan.empty()) facts.push_back({"Tool centres at the feed", text_of(cuts)});
      facts.push_back({"All motion", text_of(all)});
    }
    facts.push_back({"Tool changes", std::to_string(tool_changes(toolpath_)) + " after the first tool"});
    return facts;
  }

  std::string picture() const {
    SvgWriter svg;
    const Job job{part_, toolpath_, findings_};
    const PlanView view{{0, 0}, kPictureWidth, kPictureHeight, world_of(job)};
    svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                     {"viewBox", "0 0 " + svg_number(kPictureWidth) + " " + svg_number(kPictureHeight)},
                     {"role", "img"},
                     {"aria-label", "The part from above with its zero"}});
    draw_overview(svg, view, job, rows_of_features());
    const Vec2 zero = view.page({0, 0});
    PathData cross;
    cross.add(Edge::line(zero - Vec2{kZeroMark, 0}, zero + Vec2{kZeroMark, 0}));
    cross.add(Edge::line(zero - Vec2{0, kZeroMark}, zero + Vec2{0, kZeroMark}));
    svg.leaf("path", {{"d", cross.text()},
                      {"stroke", palette::kBad},
                      {"stroke-width", "3"},
                      {"fill", "none"},
                      {"class", "zero"}});
    svg.close();
    return svg.str();
  }

  SheetTable tools() const {
    SheetTable table{"Tools",
                     {{"T", false},
                      {"Tool", false},
                      {"Diameter", true},
                      {"Corner radius", true},
                      {"Teeth", true},
                      {"Flutes", true},
                      {"Stickout, at least", true},
                      {"Coolant", true},
                      {"Time", true}},
                     {}};
    for (const int called : tools_called(toolpath_)) table.rows.push_back(row_of_tool(called));
    return table;
  }

  SheetTable operations() const {
    SheetTable table{"Operations",
                     {{"", false},
                      {"Feature", false},
                      {"T", false},
                      {"Z from", true},
                      {"Z to", true},
                      {"Layers", true},
                      {"rpm", true},
                      {"Feed / plunge, " + unit() + "/min", true},
                      {"Left on walls, floor", true},
                      {"Time", true}},
                     {}};
    const SectionNames names(part_);
    for (const FeatureFindings& one : in_order_of_cutting(findings_, toolpath_)) {
      std::vector<std::string> row = row_of_operation(one, names.of(one.workingstep));
      row.insert(row.begin(), std::to_string(table.rows.size() + 1));
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> lines;
    for (const Fault& fault : told_faults(findings_)) lines.push_back("FAULT: " + fault.text);
    for (const Condition& one : findings_.conditions)
      lines.push_back((one.met_by.empty() ? "Must hold at the machine, " : "Holds (" + one.met_by + "), ") +
                      one.name + ": " + one.text);
    for (const auto& item : part_.diagnostics.items()) {
      if (item.severity == Severity::kWarning) lines.push_back(item.where + ": " + item.what);
    }
    return lines;
  }

 private:
  double unit_mm() const { return info_.inch ? kMmPerInch : 1; }
  std::string unit() const { return info_.inch ? "in" : "mm"; }
  std::string number(double mm) const { return trimmed(mm / unit_mm(), info_.inch ? 4 : 3); }
  std::string length(double mm) const { return number(mm) + " " + unit(); }
  std::string range(double low, double high) const { return number(low) + " to " + length(high); }
  std::string text_of(const Extents& extents) const {
    const Box& plan = extents.plan;
    return "X " + range(plan.min.x, plan.max.x) + ", Y " + range(plan.min.y, plan.max.y) + ", Z " +
           range(extents.low, extents.high);
  }

  std::vector<SheetFact> stock_facts() const {
    const std::string zero = "Zero, " + info_.work_offset;
    if (!part_.stock)
      return {{"Stock", "not stated: material all round the outlines, its top at Z " + length(part_.top_z())},
              {zero, "the origin of the drawing"}};
    const Stock& stock = *part_.stock;
    return {{"Stock", number(stock.plan.width()) + " x " + number(stock.plan.height()) + " x " +
                          length(stock.z_top - stock.z_bottom) + "; " +
                          text_of({stock.plan, stock.z_bottom, stock.z_top})},
            {zero, zero_on(stock, unit_mm(), unit())}};
  }

  std::vector<std::string> row_of_tool(int called) const {
    const Tool* const tool = tool_numbered(part_.tools, called);
    const std::string name = "T" + std::to_string(called);
    if (tool == nullptr)
      return {name, "not described", "", "", "", "", "", coolant_of_tool(toolpath_, called), ""};
    const bool named = !tool->name.empty() && tool->name != name;
    return {name,
            name_of(tool->kind) + angle_of(*tool) + (named ? ", " + tool->name : ""),
            length(tool->diameter),
            length(tool->corner_radius),
            std::to_string(tool->teeth),
            tool->flute_length ? length(*tool->flute_length) : "not stated",
            length(stickout_of(part_, toolpath_, called)),
            coolant_of_tool(toolpath_, called),
            clock_time(time_of_tool(findings_, called))};
  }

  /// For each feature, its rows in the table of operations.
  std::vector<std::string> rows_of_features() const {
    std::vector<std::vector<int>> rows(part_.features.size());
    int row = 0;
    for (const FeatureFindings& one : in_order_of_cutting(findings_, toolpath_)) {
      const Workingstep& step = part_.workplan[static_cast<std::size_t>(one.workingstep)];
      rows[static_cast<std::size_t>(step.feature)].push_back(++row);
    }
    std::vector<std::string> texts;
    for (const std::vector<int>& of_feature : rows) texts.push_back(numbers_text(of_feature));
    return texts;
  }

  std::string feed(double mm_per_min) const { return trimmed(mm_per_min / unit_mm(), info_.inch ? 2 : 0); }
  std::string feed_range(const DrivenFeeds& feeds) const {
    if (feeds.low > feeds.high) return "";
    const std::string low = feed(feeds.low), high = feed(feeds.high);
    return low == high ? high : low + " to " + high;
  }
  /// Feeds as in the program: of cuts, and straight down.
  std::string feeds_of(int workingstep) const {
    const std::string cuts = feed_range(feeds_of_cuts(toolpath_, workingstep));
    const std::string plunges = feed_range(feeds_of_plunges(toolpath_, workingstep));
    return plunges.empty() ? cuts : (cuts.empty() ? "-" : cuts) + " / " + plunges;
  }

  std::vector<std::string> row_of_operation(const FeatureFindings& one, const std::string& name) const {
    const Workingstep& step = part_.workplan[static_cast<std::size_t>(one.workingstep)];
    const Feature& feature = feature_of(part_, step);
    const Operation& operation = step.operation;
    return {name,
            "T" + std::to_string(one.tool_number),
            number(feature.top_z),
            number(feature.floor_z),
            std::to_string(one.layers.size()),
            speeds_of(toolpath_, one.workingstep),
            feeds_of(one.workingstep),
            number(operation.allowance_side) + ", " + number(operation.allowance_floor),
            clock_time(one.figures.time_s)};
  }

  const Part& part_;
  const Toolpath& toolpath_;
  const Findings& findings_;
  const SetupSheetInfo& info_;
};

}  // namespace

SetupSheet compose_sheet(const Part& part, const Toolpath& toolpath, const Findings& findings,
                         const SetupSheetInfo& info) {
  const Composer composer(part, toolpath, findings, info);
  SetupSheet sheet;
  sheet.part = part.name.empty() ? "part" : part.name;
  sheet.verdict = name_of(verdict_of(findings));
  sheet.headline = composer.headline();
  sheet.facts = composer.facts();
  sheet.picture = composer.picture();
  sheet.tools = composer.tools();
  sheet.operations = composer.operations();
  sheet.notes = composer.notes();
  sheet.by_hand = {"Machine", "Holding", "Set up by", "Date"};
  return sheet;
}

}  // namespace clearcut::report
