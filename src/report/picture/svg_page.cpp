#include "report/picture/svg_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"
#include "model/results/told_faults.h"
#include "report/picture/job_view.h"
#include "report/picture/palette.h"
#include "report/words/text.h"

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
  enum class Kind { kLine, kDashed, kArea, kDot } kind;
  std::string color, words;
};

void draw_legend_row(SvgWriter& svg, Vec2 at, const LegendRow& row) {
  if (row.kind == LegendRow::Kind::kArea) {
    svg.leaf("rect", {{"x", svg_number(at.x)},
                      {"y", svg_number(at.y - 11)},
                      {"width", "34"},
                      {"height", "14"},
                      {"fill", row.color},
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

}  // namespace clearcut::report
