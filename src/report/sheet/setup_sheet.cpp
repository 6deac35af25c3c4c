#include "report/sheet/setup_sheet.h"

#include <algorithm>
#include <cmath>

#include "base/inch.h"
#include "base/text/format.h"
#include "base/text/xml_text.h"
#include "model/section_names.h"
#include "report/picture/palette.h"
#include "report/picture/plan_picture.h"
#include "report/sheet/sheet_facts.h"
#include "report/text.h"

namespace clearcut::report {
namespace {

/// Page units of the picture.
constexpr double kPictureWidth = 900, kPictureHeight = 460;
/// Page units: half the length of the cross that marks X0 Y0.
constexpr double kZeroMark = 16;

constexpr const char* kStyle = R"(
:root { font: 15px/1.35 system-ui, sans-serif; color: #1c2733; background: #fff; }
body { max-width: 62rem; margin: 1.2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin: 0; } h2 { font-size: 1rem; margin: 1rem 0 .3rem; }
table { border-collapse: collapse; width: 100%; } th, td { padding: .2rem .5rem; text-align: left; }
th { font-weight: 600; border-bottom: 2px solid #66727f; } td { border-bottom: 1px solid #d5dbe1; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
.verdict { font-weight: 700; } .CLEAN { color: #11703d; } .CONDITIONAL { color: #8a5300; } .FAULTY { color: #b3131f; }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; } .facts dt { color: #55606b; } .facts dd { margin: 0; }
.by-hand { display: grid; grid-template-columns: repeat(4, 1fr); gap: 1rem; margin-top: 1.2rem; }
.by-hand span { border-bottom: 1px solid #1c2733; padding-bottom: 1.2rem; color: #55606b; }
svg { width: 100%; height: auto; max-height: 42vh; } ul { margin: 0; padding-left: 1.2rem; }
.scroll { overflow-x: auto; }
@media print {
  :root { font-size: 10.5px; line-height: 1.25; } body { margin: 0; padding: 0; max-width: none; } h2 { margin: .6rem 0 .1rem; }
  th, td { padding: .1rem .4rem; } tr, li { break-inside: avoid; } svg { max-height: 21vh; } .by-hand span { padding-bottom: 1rem; }
  @page { margin: 10mm; }
}
)";

/// A page element by element; every text is escaped by the writer.
class Sheet {
 public:
  Sheet(const Part& part, const Toolpath& toolpath, const Findings& findings, const SetupSheetInfo& info)
      : part_(part), toolpath_(toolpath), findings_(findings), info_(info) {}

  std::string body() {
    title();
    facts();
    picture();
    tools();
    operations();
    notes();
    lines_by_hand();
    return page_.str();
  }

 private:
  double unit_mm() const { return info_.inch ? kMmPerInch : 1; }
  std::string unit() const { return info_.inch ? "in" : "mm"; }
  std::string number(double mm) const { return trimmed(mm / unit_mm(), info_.inch ? 4 : 3); }
  std::string length(double mm) const { return number(mm) + " " + unit(); }
  std::string range(double low, double high) const { return number(low) + " to " + length(high); }

  void title() {
    const std::string verdict = name_of(verdict_of(findings_));
    page_.words("h1", part_.name.empty() ? "part" : part_.name);
    page_.open("p", {});
    page_.words("span", verdict, {{"class", "verdict " + verdict}});
    page_.words("span", " " + info_.program_name + " for " + info_.dialect + ", " +
                            clock_time(findings_.all.time_s) + " in all");
    page_.close();
  }

  void fact(const std::string& name, const std::string& value) {
    page_.words("dt", name);
    page_.words("dd", value);
  }

  void facts() {
    const Extents cuts = extents_of(toolpath_, false), all = extents_of(toolpath_, true);
    page_.open("dl", {{"class", "facts"}});
    if (part_.stock) {
      const Stock& stock = *part_.stock;
      fact("Stock", number(stock.plan.width()) + " x " + number(stock.plan.height()) + " x " +
                        length(stock.z_top - stock.z_bottom) + "; X " +
                        range(stock.plan.min.x, stock.plan.max.x) + ", Y " +
                        range(stock.plan.min.y, stock.plan.max.y) + ", Z " +
                        range(stock.z_bottom, stock.z_top));
      fact("Zero, " + info_.work_offset, zero_on(stock, unit_mm(), unit()));
    } else {
      fact("Stock", "not stated: material all round the outlines, its top at Z " + length(part_.top_z()));
      fact("Zero, " + info_.work_offset, "the origin of the drawing");
    }
    if (!all.plan.empty()) {
      if (!cuts.plan.empty())
        fact("Tool centres at the feed", "X " + range(cuts.plan.min.x, cuts.plan.max.x) + ", Y " +
                                             range(cuts.plan.min.y, cuts.plan.max.y) + ", Z " +
                                             range(cuts.low, cuts.high));
      fact("All motion", "X " + range(all.plan.min.x, all.plan.max.x) + ", Y " +
                             range(all.plan.min.y, all.plan.max.y) + ", Z " + range(all.low, all.high));
    }
    fact("Tool changes", std::to_string(tool_changes(toolpath_)) + " after the first tool");
    page_.close();
  }

  void picture() {
    const Job job{part_, toolpath_, findings_};
    const PlanView view{{0, 0}, kPictureWidth, kPictureHeight, world_of(job)};
    page_.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                       {"viewBox", "0 0 " + svg_number(kPictureWidth) + " " + svg_number(kPictureHeight)},
                       {"role", "img"},
                       {"aria-label", "The part from above with its zero"}});
    draw_overview(page_, view, job);
    const Vec2 zero = view.page({0, 0});
    const SvgWriter::Attributes style{
        {"stroke", palette::kBad}, {"stroke-width", "3"}, {"fill", "none"}, {"class", "zero"}};
    PathData cross;
    cross.add(Edge::line(zero - Vec2{kZeroMark, 0}, zero + Vec2{kZeroMark, 0}));
    cross.add(Edge::line(zero - Vec2{0, kZeroMark}, zero + Vec2{0, kZeroMark}));
    SvgWriter::Attributes attributes{{"d", cross.text()}};
    attributes.insert(attributes.end(), style.begin(), style.end());
    page_.leaf("path", attributes);
    page_.close();
  }

  void heading(const std::vector<std::pair<std::string, bool>>& columns) {
    page_.open("div", {{"class", "scroll"}});
    page_.open("table", {});
    page_.open("thead", {});
    page_.open("tr", {});
    for (const auto& [name, is_number] : columns)
      page_.words("th", name, is_number ? SvgWriter::Attributes{{"class", "n"}} : SvgWriter::Attributes{});
    page_.close();
    page_.close();
    page_.open("tbody", {});
  }
  void row(const std::vector<std::string>& cells, std::size_t words) {
    page_.open("tr", {});
    for (std::size_t i = 0; i < cells.size(); ++i)
      page_.words("td", cells[i],
                  i < words ? SvgWriter::Attributes{} : SvgWriter::Attributes{{"class", "n"}});
    page_.close();
  }
  void end_table() {
    for (int i = 0; i < 3; ++i) page_.close();
  }

  void tools() {
    page_.words("h2", "Tools");
    heading({{"T", false},
             {"Tool", false},
             {"Diameter", true},
             {"Corner radius", true},
             {"Teeth", true},
             {"Flutes", true},
             {"Stickout, at least", true},
             {"Coolant", true},
             {"Time", true}});
    for (const int called : tools_called(toolpath_)) {
      const Tool* const tool = tool_numbered(part_.tools, called);
      const std::string name = "T" + std::to_string(called);
      if (tool == nullptr) {
        row({name, "not described", "", "", "", "", "", coolant_of_tool(toolpath_, called), ""}, 2);
        continue;
      }
      const bool named = !tool->name.empty() && tool->name != name;
      row({name, name_of(tool->kind) + angle_of(*tool) + (named ? ", " + tool->name : ""),
           length(tool->diameter), length(tool->corner_radius), std::to_string(tool->teeth),
           tool->flute_length ? length(*tool->flute_length) : "not stated",
           length(stickout_of(part_, toolpath_, called)), coolant_of_tool(toolpath_, called),
           clock_time(time_of_tool(findings_, called))},
          2);
    }
    end_table();
  }

  std::string feeds_of(const Operation& operation) const {
    if (!operation.cutting.feed) return "";
    std::string text = trimmed(operation.cutting.feed->mm_per_min() / unit_mm(), info_.inch ? 2 : 0);
    if (operation.cutting.plunge_feed)
      text += " / " + trimmed(operation.cutting.plunge_feed->mm_per_min() / unit_mm(), info_.inch ? 2 : 0);
    return text;
  }

  void operations() {
    page_.words("h2", "Operations");
    heading({{"", false},
             {"Feature", false},
             {"T", false},
             {"Z from", true},
             {"Z to", true},
             {"Layers", true},
             {"rpm", true},
             {"Feed / plunge, " + unit() + "/min", true},
             {"Left on walls, floor", true},
             {"Time", true}});
    int place = 0;
    const SectionNames names(part_);
    for (const FeatureFindings& one : in_order_of_cutting(findings_, toolpath_)) {
      const Workingstep& step = part_.workplan[static_cast<std::size_t>(one.workingstep)];
      const Feature& feature = feature_of(part_, step);
      const Operation& operation = step.operation;
      row({std::to_string(++place), names.of(one.workingstep), "T" + std::to_string(one.tool_number),
           number(feature.top_z), number(feature.floor_z), std::to_string(one.layers.size()),
           operation.cutting.spindle_rpm ? trimmed(*operation.cutting.spindle_rpm, 0) : "",
           feeds_of(operation), number(operation.allowance_side) + ", " + number(operation.allowance_floor),
           clock_time(one.figures.time_s)},
          3);
    }
    end_table();
  }

  void notes() {
    std::vector<std::string> lines;
    for (const Fault& fault : findings_.faults) lines.push_back("FAULT: " + fault.text);
    for (const Condition& one : findings_.conditions)
      lines.push_back((one.met_by.empty() ? "Must hold at the machine, " : "Holds (" + one.met_by + "), ") +
                      one.name + ": " + one.text);
    for (const auto& item : part_.diagnostics.items()) {
      if (item.severity == Severity::kWarning) lines.push_back(item.where + ": " + item.what);
    }
    if (lines.empty()) return;
    page_.words("h2", "Notes");
    page_.open("ul", {});
    for (const std::string& line : lines) page_.words("li", line);
    page_.close();
  }

  void lines_by_hand() {
    page_.open("div", {{"class", "by-hand"}});
    for (const char* name : {"Machine", "Holding", "Set up by", "Date"}) page_.words("span", name);
    page_.close();
  }

  const Part& part_;
  const Toolpath& toolpath_;
  const Findings& findings_;
  const SetupSheetInfo& info_;
  SvgWriter page_;
};

}  // namespace

std::string setup_sheet(const Part& part, const Toolpath& toolpath, const Findings& findings,
                        const SetupSheetInfo& info) {
  const std::string title = xml_escaped(part.name.empty() ? "part" : part.name);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>Set-up: " +
         title + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n" +
         Sheet(part, toolpath, findings, info).body() + "</body>\n</html>\n";
}

std::string joined_setup_sheets(const std::vector<std::string>& sheets) {
  const std::string begin = "<body>\n", end = "</body>\n";
  std::string page = sheets.front().substr(0, sheets.front().find(begin) + begin.size());
  for (const std::string& sheet : sheets) {
    const std::size_t from = sheet.find(begin) + begin.size();
    page += "<section style=\"break-after: page\">\n" + sheet.substr(from, sheet.rfind(end) - from) +
            "</section>\n";
  }
  return page + end + "</html>\n";
}

}  // namespace clearcut::report
