#include "report/picture/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/text.h"
#include "model/results/findings.h"
#include "report/picture/job_view.h"
#include "report/picture/plan_picture.h"
#include "report/picture/svg_writer.h"
#include "report/words/text_table.h"

namespace clearcut::report {

namespace {

constexpr std::size_t kFeaturesListed = 18;
/// Open conditions that are listed, and lines for each.
constexpr std::size_t kConditionsListed = 8, kConditionLines = 4;
constexpr std::size_t kFaultsListed = 8;
constexpr double kLineHeight = 25;

std::string subtitle_of(const Part& part) {
  std::string text = part.source_file;
  if (part.stock) {
    text += fmt::format("{}stock {} x {} x {} mm", text.empty() ? "" : "  |  ",
                        trimmed(part.stock->plan.width(), 3), trimmed(part.stock->plan.height(), 3),
                        trimmed(part.stock->z_top - part.stock->z_bottom, 3));
  }
  for (const Tool& tool : part.tools) text += (text.empty() ? "" : "  |  ") + description_of(tool);
  return text;
}

std::string badge_words(const Findings& findings) {
  const auto counted = [](std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  switch (verdict_of(findings)) {
    case Verdict::kClean:
      return findings.without_part ? "no fault, no part" : "certified clean";
    case Verdict::kConditional:
      return "conditional: " + counted(open_conditions(findings).size(), "condition");
    case Verdict::kFaulty:
      break;
  }
  const std::size_t faults = told_faults(findings).size();
  return faults == 0 ? "not clean" : "faulty: " + counted(faults, "fault");
}

struct BadgeLook {
  const char* color;
  const char* mark;  ///< a line drawn from the middle of the left end
};
BadgeLook look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kClean:
      return {report::palette::kGood, "m0 0l6 7l11 -13"};
    case Verdict::kConditional:
      return {report::palette::kWarn, "m8 -8v9m0 7v0.1"};
    case Verdict::kFaulty:
      break;
  }
  return {report::palette::kBad, "m0 -6l12 12m0 -12l-12 12"};
}

void draw_verdict(SvgWriter& svg, const Findings& findings) {
  const BadgeLook look = look_of(verdict_of(findings));
  const std::string words = badge_words(findings);
  const double width = 62 + 10.8 * static_cast<double>(words.size());
  const double left = kPageWidth - kPageMargin - width;
  svg.leaf("rect", {{"x", svg_number(left)},
                    {"y", "36"},
                    {"width", svg_number(width)},
                    {"height", "40"},
                    {"rx", "20"},
                    {"fill", look.color}});
  svg.leaf("path", {{"d", fmt::format("M{} 56{}", svg_number(left + 19), look.mark)},
                    {"fill", "none"},
                    {"stroke", "#ffffff"},
                    {"stroke-width", "3"},
                    {"stroke-linecap", "round"}});
  svg.text({left + 46, 62}, words, text_style(18, "#ffffff", "bold"));
}

struct Tile {
  std::string figure, unit, words;
  bool bad = false;
};

std::vector<Tile> tiles_of(const Findings& findings) {
  const Figures& f = findings.all;
  const auto has = [&findings](FaultKind kind) {
    return std::any_of(findings.faults.begin(), findings.faults.end(),
                       [kind](const Fault& x) { return x.kind == kind; });
  };
  const auto asked = [&](double figure) {
    return findings.without_part ? std::string("not asked") : fixed(figure, 4);
  };
  const char* unit = findings.without_part ? "" : " mm";
  return {{clock_time(f.time_s), "", "machining time"},
          {fixed(f.feed_mm, 0), " mm", "feed"},
          {fixed(f.rapid_mm, 0), " mm", "rapid"},
          {std::to_string(f.retracts), "", "retracts"},
          {asked(f.uncut_thickness_mm), unit, "left at most, proven", has(FaultKind::kUncut)},
          {asked(f.gouge_mm), unit, "deepest gouge", has(FaultKind::kGouge)},
          {std::to_string(f.rapid_in_material), "", "rapids in material", f.rapid_in_material > 0},
          {fixed(f.engagement.max_deg, 0), "\u00b0", "largest engagement"}};
}

void draw_tiles(SvgWriter& svg, const std::vector<Tile>& tiles) {
  const double count = static_cast<double>(tiles.size());
  const double width = (kPageWidth - 2 * kPageMargin - (count - 1) * 12) / count;
  double x = kPageMargin;
  for (const Tile& tile : tiles) {
    svg.leaf("rect", {{"x", svg_number(x)},
                      {"y", "96"},
                      {"width", svg_number(width)},
                      {"height", "62"},
                      {"rx", "6"},
                      {"fill", tile.bad ? "#fdebec" : "#f3f5f7"}});
    svg.text({x + 14, 125}, tile.figure + tile.unit,
             text_style(22, tile.bad ? report::palette::kBad : report::palette::kInk, "bold"));
    svg.text({x + 14, 147}, tile.words, text_style(13, report::palette::kFaint));
    x += width + 12;
  }
}

struct LegendRow {
  enum class Kind { kLine, kDashed, kArea, kHatched, kDot } kind;
  std::string color, words;
};

void draw_legend_row(SvgWriter& svg, Vec2 at, const LegendRow& row) {
  if (row.kind == LegendRow::Kind::kArea || row.kind == LegendRow::Kind::kHatched) {
    const bool is_hatched = row.kind == LegendRow::Kind::kHatched;
    const std::string fill = is_hatched ? hatch(svg, row.color, kHatchStep, kHatchWidth) : row.color;
    svg.leaf("rect", {{"x", svg_number(at.x)},
                      {"y", svg_number(at.y - 11)},
                      {"width", "34"},
                      {"height", "14"},
                      {"fill", fill},
                      {"stroke", report::palette::kRule}});
  } else if (row.kind == LegendRow::Kind::kDot) {
    svg.leaf("circle",
             {{"cx", svg_number(at.x + 17)}, {"cy", svg_number(at.y - 4)}, {"r", "5"}, {"fill", row.color}});
  } else {
    SvgWriter::Attributes line{{"d", fmt::format("M{} {}h34", svg_number(at.x), svg_number(at.y - 4))},
                               {"stroke", row.color},
                               {"stroke-width", "2.2"}};
    if (row.kind == LegendRow::Kind::kDashed) line.emplace_back("stroke-dasharray", "5 4");
    svg.leaf("path", line);
  }
  svg.text({at.x + 46, at.y}, row.words, text_style(14, report::palette::kInk));
}

bool has_move(const Toolpath& toolpath, MoveKind kind, bool vertical) {
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (move.kind == kind && move.is_vertical() == vertical) return true;
    }
  }
  return false;
}

/// Lines first, as far as there are any, then areas.
std::vector<LegendRow> legend_rows(const Job& job) {
  using Kind = LegendRow::Kind;
  std::vector<LegendRow> rows;
  const Part& part = job.part;
  for (std::size_t i = 0; i < part.tools.size() && i < 5; ++i) {
    rows.push_back({Kind::kLine, report::palette::tool_color(static_cast<int>(i)),
                    "cut, " + description_of(part.tools[i])});
  }
  if (rows.empty()) rows.push_back({Kind::kLine, report::palette::kCut, "cut"});
  const auto has = [&job](MoveKind kind, bool vertical) { return has_move(job.toolpath, kind, vertical); };
  if (has(MoveKind::kLink, false)) rows.push_back({Kind::kLine, report::palette::kLink, "link, tool down"});
  if (has(MoveKind::kRamp, false))
    rows.push_back({Kind::kLine, report::palette::kEntry, "entry: ramp, helix"});
  if (has(MoveKind::kPlunge, true)) rows.push_back({Kind::kDot, report::palette::kEntry, "plunge"});
  if (has(MoveKind::kRapid, false)) rows.push_back({Kind::kDashed, report::palette::kRapid, "rapid"});
  if (!part.is_shape_stated) {
    rows.push_back({Kind::kArea, report::palette::depth_color(0.6), "cut, darker where deeper"});
    rows.push_back({Kind::kArea, report::palette::depth_color(0), "stock"});
    return rows;
  }
  rows.push_back({Kind::kArea, report::palette::kFloor, "swept by the cutter"});
  rows.push_back({Kind::kArea, report::palette::kUncut, "left, within reach"});
  rows.push_back({Kind::kArea, report::palette::kUnreachable, "left, out of the cutter's reach"});
  rows.push_back({Kind::kArea, report::palette::kGouge, "gouged"});
  const auto leans = [](const Feature& f) { return f.wall_slope.radians() > 0; };
  if (std::any_of(part.features.begin(), part.features.end(), leans)) {
    rows.push_back({Kind::kArea, report::palette::kWall, "drafted wall"});
  }
  rows.push_back({Kind::kArea, report::palette::kMaterial, "material that stays"});
  if (!part.left_out.empty())
    rows.push_back({Kind::kHatched, report::palette::kLeftOut, "the part has a face here that is left out"});
  return rows;
}

/// Figures of a feature over all its operations.
struct Summary {
  double time_s = 0;
  double uncut_mm = 0;
  bool cut = false;
  bool clean = true;
};

Summary summary_of(const std::vector<const FeatureFindings*>& findings) {
  Summary s;
  for (const FeatureFindings* one : findings) {
    s.cut = true;
    s.time_s += one->figures.time_s;
    s.uncut_mm = std::max(s.uncut_mm, one->figures.uncut_thickness_mm);
    s.clean = s.clean && one->figures.clean;
  }
  return s;
}

void draw_feature_row(SvgWriter& svg, const Job& job, int feature, Vec2 at, double width) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  const Summary s = summary_of(findings_of(job.part, job.findings, feature));
  const double fraction = depth_fraction(job.part, f.floor_z), right = at.x + width;
  svg.leaf("rect", {{"x", svg_number(at.x)},
                    {"y", svg_number(at.y - 15)},
                    {"width", "34"},
                    {"height", "20"},
                    {"rx", "3"},
                    {"fill", report::palette::depth_color(fraction)},
                    {"stroke", report::palette::kRule}});
  svg.text({at.x + 17, at.y}, std::to_string(feature + 1),
           text_style(13, fraction > 0.5 ? "#ffffff" : report::palette::kInk, "bold", "middle"));
  svg.text({at.x + 46, at.y}, shortened(f.name, 20), text_style(14, report::palette::kInk));
  svg.text({right - 200, at.y}, trimmed(f.floor_z, 3),
           text_style(14, report::palette::kInk, "normal", "end"));
  svg.text({right - 120, at.y}, s.cut ? clock_time(s.time_s) : "-",
           text_style(14, report::palette::kInk, "normal", "end"));
  svg.text({right - 30, at.y}, s.cut ? fixed(s.uncut_mm, 4) : "-",
           text_style(14, report::palette::kInk, "normal", "end"));
  svg.leaf("circle", {{"cx", svg_number(right - 8)},
                      {"cy", svg_number(at.y - 5)},
                      {"r", "6"},
                      {"fill", !s.cut    ? report::palette::kRule
                               : s.clean ? report::palette::kGood
                                         : report::palette::kBad}});
}

/// The text in lines of at most `letters`, broken between words; what goes beyond `most` lines is cut off with dots.
std::vector<std::string> lines_of(const std::string& text, std::size_t letters, std::size_t most) {
  std::vector<std::string> lines;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::string rest = text.substr(from);
    if (rest.size() <= letters || lines.size() + 1 == most) {
      lines.push_back(shortened(rest, letters));
      break;
    }
    std::size_t end = text.rfind(' ', from + letters);
    if (end == std::string::npos || end <= from) end = text.find(' ', from + letters);
    lines.push_back(shortened(text.substr(from, end - from), letters));
    from = end == std::string::npos ? text.size() : end + 1;
  }
  return lines;
}

}  // namespace

SvgWriter::Attributes text_style(double size, const char* color, const char* weight, const char* anchor) {
  return {{"font-size", svg_number(size)}, {"fill", color}, {"font-weight", weight}, {"text-anchor", anchor}};
}

void draw_header(SvgWriter& svg, const Job& job, const std::string& title) {
  svg.text({kPageMargin, 58}, shortened(title, 60), text_style(31, report::palette::kInk, "bold"));
  svg.text({kPageMargin, 82}, subtitle_of(job.part), text_style(14, report::palette::kFaint));
  draw_verdict(svg, job.findings);
  draw_tiles(svg, tiles_of(job.findings));
}

double draw_feature_list(SvgWriter& svg, const Job& job, Vec2 at, double width) {
  const double right = at.x + width;
  svg.text(at, "Features", text_style(16, report::palette::kInk, "bold"));
  svg.text({right - 200, at.y}, "floor z", text_style(13, report::palette::kFaint, "normal", "end"));
  svg.text({right - 120, at.y}, "time", text_style(13, report::palette::kFaint, "normal", "end"));
  svg.text({right - 30, at.y}, "left, mm", text_style(13, report::palette::kFaint, "normal", "end"));
  double y = at.y + kLineHeight;
  const std::size_t count = job.part.features.size();
  for (std::size_t i = 0; i < std::min(count, kFeaturesListed); ++i, y += kLineHeight) {
    draw_feature_row(svg, job, static_cast<int>(i), {at.x, y}, width);
  }
  if (count > kFeaturesListed) {
    svg.text({at.x, y}, fmt::format("and {} more", count - kFeaturesListed),
             text_style(13, report::palette::kFaint));
    y += kLineHeight;
  }
  return y + 20;
}

double draw_legend(SvgWriter& svg, const Job& job, Vec2 at) {
  svg.text(at, "Legend", text_style(16, report::palette::kInk, "bold"));
  double y = at.y + kLineHeight;
  for (const LegendRow& row : legend_rows(job)) {
    draw_legend_row(svg, {at.x, y}, row);
    y += kLineHeight - 2;
  }
  return y + 20;
}

double draw_margin_list(SvgWriter& svg, const Margin& margin, Vec2 at, double width) {
  const std::size_t letters = static_cast<std::size_t>(width / 7.2);
  const FeatureMargin* const least = margin.least();
  svg.text(at,
           least ? "Holds for " + trimmed(least->mm, 4) + " mm of machine error"
                 : "Machine error: no margin found",
           text_style(16, report::palette::kInk, "bold"));
  double y = at.y + kLineHeight;
  for (std::size_t i = 0; i < std::min(kFeaturesListed, margin.features.size()); ++i, y += 18) {
    const FeatureMargin& one = margin.features[i];
    const std::string limit = one.limit == MarginLimit::kUncut
                                  ? trimmed(margin.bounds.uncut, 4) + " mm left beyond it"
                                  : trimmed(margin.bounds.gouge, 4) + " mm too deep beyond it";
    svg.text({at.x, y},
             shortened(fmt::format("{}: {} mm, {}", one.feature, trimmed(one.mm, 4), limit), letters),
             text_style(13, report::palette::kInk));
  }
  return y + 16;
}

double draw_condition_list(SvgWriter& svg, const Findings& findings, Vec2 at, double width) {
  const std::vector<Condition> open = open_conditions(findings);
  if (open.empty()) return at.y;
  const std::size_t letters = static_cast<std::size_t>(width / 7.2);
  svg.text(at, "Conditions", text_style(16, report::palette::kWarn, "bold"));
  double y = at.y + kLineHeight;
  for (std::size_t i = 0; i < std::min(kConditionsListed, open.size()); ++i) {
    for (const std::string& line : lines_of(open[i].name + ": " + open[i].text, letters, kConditionLines)) {
      svg.text({at.x, y}, line, text_style(13, report::palette::kInk));
      y += 18;
    }
    y += 4;
  }
  if (open.size() > kConditionsListed) {
    svg.text({at.x, y}, fmt::format("and {} more", open.size() - kConditionsListed),
             text_style(13, report::palette::kFaint));
    y += 20;
  }
  return y + 16;
}

double draw_fault_list(SvgWriter& svg, const Findings& findings, Vec2 at, double width) {
  const std::vector<Fault> faults = told_faults(findings);
  if (faults.empty()) return at.y;
  const std::size_t letters = static_cast<std::size_t>(width / 7.2);
  svg.text(at, "Faults", text_style(16, report::palette::kBad, "bold"));
  double y = at.y + kLineHeight;
  for (std::size_t i = 0; i < std::min(kFaultsListed, faults.size()); ++i, y += 20) {
    const Fault& fault = faults[i];
    const std::string where = fault.feature.empty() ? "" : ", " + fault.feature;
    const std::string line = fault.at.line > 0 ? fmt::format(", line {}", fault.at.line) : "";
    svg.text({at.x, y}, shortened(headline_of(fault) + where + line, letters),
             text_style(13, report::palette::kInk));
  }
  if (faults.size() > kFaultsListed) {
    svg.text({at.x, y}, fmt::format("and {} more", faults.size() - kFaultsListed),
             text_style(13, report::palette::kFaint));
    y += 20;
  }
  return y;
}

namespace {

constexpr double kGap = 26;
constexpr double kMainHeightMost = 1000;
constexpr double kMainHeightLeast = 560;
constexpr double kMainWidthLeast = 560;
constexpr double kListWidth = 500;    // width of the list of features
constexpr double kLegendWidth = 330;  // width only of the legend
constexpr double kCaptionHeight = 66;
constexpr int kPanelColumns = 3;
constexpr std::size_t kMostPanels = 36;

bool is_clean(const std::vector<const FeatureFindings*>& findings) {
  return std::all_of(findings.begin(), findings.end(),
                     [](const FeatureFindings* f) { return f->figures.clean; });
}

std::string depths_of(const Feature& f, const std::vector<const FeatureFindings*>& findings) {
  std::size_t layers = 0;
  for (const FeatureFindings* one : findings) layers += one->layers.size();
  const std::string count =
      layers == 0 ? "" : fmt::format(", {} {}", layers, layers == 1 ? "layer" : "layers");
  return fmt::format("z {} to {}{}", trimmed(f.top_z, 3), trimmed(f.floor_z, 3), count);
}

std::string caption_of(const std::vector<const FeatureFindings*>& findings) {
  if (findings.empty()) return "nothing was cut here";
  double feed = 0, time = 0, uncut = 0, gouge = 0;
  for (const FeatureFindings* one : findings) {
    feed += one->figures.feed_mm;
    time += one->figures.time_s;
    uncut = std::max(uncut, one->figures.uncut_thickness_mm);
    gouge = std::max(gouge, one->figures.gouge_mm);
  }
  return fmt::format("feed {} mm, {}, left \u2264 {} mm, gouge {} mm", fixed(feed, 0), clock_time(time),
                     fixed(uncut, 4), fixed(gouge, 4));
}

void draw_panel(SvgWriter& svg, const Job& job, int feature, const PlanView& view) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  const auto findings = findings_of(job.part, job.findings, feature);
  const double y = view.corner.y - kCaptionHeight;
  const char* checked = findings.empty()     ? report::palette::kFaint
                        : is_clean(findings) ? report::palette::kGood
                                             : report::palette::kBad;
  svg.leaf(
      "circle",
      {{"cx", svg_number(view.corner.x + 7)}, {"cy", svg_number(y + 16)}, {"r", "7"}, {"fill", checked}});
  svg.text({view.corner.x + 22, y + 22}, fmt::format("{}  {}", feature + 1, shortened(f.name, 40)),
           text_style(18, report::palette::kInk, "bold"));
  svg.text({view.corner.x + view.width, y + 22}, depths_of(f, findings),
           text_style(13, report::palette::kFaint, "normal", "end"));
  svg.text({view.corner.x, y + 48}, caption_of(findings), text_style(14, report::palette::kFaint));
  draw_feature(svg, view, job, feature);
}

/// The main view, as wide as its world wants to be and the words at its side allow.
PlanView main_view(const Job& job, bool single) {
  PlanView view;
  view.world = single ? world_of(job, 0) : world_of(job);
  view.corner = {kPageMargin, kHeaderHeight + (single ? kCaptionHeight : 0)};
  const double most = kPageWidth - 2 * kPageMargin - kGap - (single ? kLegendWidth : kListWidth);
  const double aspect = view.world.width() / std::max(view.world.height(), 1e-9);
  view.width = single ? most : std::clamp(kMainHeightMost * aspect, kMainWidthLeast, most);
  view.height = std::clamp(view.width / aspect, kMainHeightLeast, kMainHeightMost);
  return view;
}

/// Everything above the panels; returns the height at which they may begin.
double draw_main(SvgWriter& svg, const Job& job) {
  const bool single = job.part.features.size() == 1;
  const PlanView view = main_view(job, single);
  if (single) {
    draw_panel(svg, job, 0, view);
  } else {
    draw_overview(svg, view, job);
  }
  const double left = view.corner.x + view.width + kGap, width = kPageWidth - kPageMargin - left;
  double y = view.corner.y + 16;
  if (!single && job.part.is_shape_stated) y = draw_feature_list(svg, job, {left, y}, width);
  y = draw_legend(svg, job, {left, y});
  if (job.margin) y = draw_margin_list(svg, *job.margin, {left, y}, width);
  y = draw_condition_list(svg, job.findings, {left, y}, width);
  y = draw_fault_list(svg, job.findings, {left, y}, width);
  return std::max(view.corner.y + view.height, y) + kGap;
}

/// All features, or, of very many, first those that are not clean, in order of the part.
std::vector<int> features_with_panel(const Job& job) {
  std::vector<int> features(job.part.features.size());
  std::iota(features.begin(), features.end(), 0);
  if (features.size() < 2) return {};
  if (features.size() <= kMostPanels) return features;
  std::stable_partition(features.begin(), features.end(),
                        [&job](int f) { return !is_clean(findings_of(job.part, job.findings, f)); });
  features.resize(kMostPanels);
  std::sort(features.begin(), features.end());
  return features;
}

double draw_panels(SvgWriter& svg, const Job& job, double top) {
  const double width = (kPageWidth - 2 * kPageMargin - (kPanelColumns - 1) * kGap) / kPanelColumns;
  const double height = width * 0.86, row_height = height + kCaptionHeight + kGap;
  const std::vector<int> features = features_with_panel(job);
  const int count = static_cast<int>(features.size()), rows = (count + kPanelColumns - 1) / kPanelColumns;
  for (int i = 0; i < count; ++i) {
    PlanView view;
    view.world = world_of(job, features[static_cast<std::size_t>(i)]);
    const int column = i % kPanelColumns, row = i / kPanelColumns;
    view.corner = {kPageMargin + column * (width + kGap), top + kCaptionHeight + row * row_height};
    view.width = width;
    view.height = height;
    draw_panel(svg, job, features[static_cast<std::size_t>(i)], view);
  }
  return top + rows * row_height;
}

}  // namespace

std::string svg(const Part& part, const Toolpath& toolpath, const Findings& findings,
                const SvgOptions& options) {
  const Job job{part, toolpath, findings, options.all_layers, options.earlier, options.margin};
  const std::string title = !options.title.empty() ? options.title : part.name.empty() ? "part" : part.name;
  SvgWriter body;
  draw_header(body, job, title);
  const double height = draw_panels(body, job, draw_main(body, job)) + kPageMargin / 2;

  SvgWriter page;
  const std::string w = svg_number(kPageWidth), h = svg_number(height);
  page.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                    {"width", w},
                    {"height", h},
                    {"viewBox", "0 0 " + w + " " + h},
                    {"font-family", "sans-serif"}});
  page.words("title", title);
  page.leaf("rect", {{"width", w}, {"height", h}, {"fill", "#ffffff"}});
  page.raw(body.str());
  page.close();
  return page.str();
}

}  // namespace clearcut::report
