#include "report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "base/text.h"
#include "model/results/findings.h"
#include "model/section_names.h"
#include "report/picture/job_view.h"
#include "report/words/text_table.h"

namespace clearcut::report {

namespace {

constexpr std::size_t kFaultsShown = 10;
constexpr std::size_t kWidth = 120;
constexpr std::size_t kShortestName = 6;

std::vector<std::string> figures_of(const Figures& f) {
  return {fixed(f.feed_mm, 1),  fixed(f.rapid_mm, 1),           std::to_string(f.retracts),
          clock_time(f.time_s), fixed(f.uncut_thickness_mm, 3), fixed(f.uncut_mm2, 2),
          fixed(f.gouge_mm, 3), fixed(f.engagement.max_deg, 0), f.clean ? "yes" : "NO"};
}

std::vector<std::string> row(const std::string& name, const std::string& tool, const std::string& layers,
                             const Figures& figures) {
  std::vector<std::string> cells{ascii(name), tool, layers};
  for (std::string& cell : figures_of(figures)) cells.push_back(std::move(cell));
  return cells;
}

std::string cutter_of(const FeatureFindings& feature) {
  const bool known = std::isfinite(feature.tool_diameter);
  const std::string diameter = known ? shortened(trimmed(feature.tool_diameter, 3), 8) : "?";
  return fmt::format("T{} D{}", feature.tool_number, diameter);
}

std::string place_of(const Place& place) {
  std::string text =
      fmt::format("x {} y {} z {}", fixed(place.point.x, 3), fixed(place.point.y, 3), fixed(place.z, 3));
  if (place.line > 0) text += fmt::format(", line {}", place.line);
  return text;
}

/// The sentence of a fault contains its place; a fault without a sentence gets its place here.
std::string line_of(const Fault& fault) {
  if (!fault.text.empty()) return fmt::format("  {}: {}\n", name_of(fault.kind), ascii(fault.text));
  std::string text = "  " + headline_of(fault) + " at " + place_of(fault.at);
  if (!fault.feature.empty()) text += " in " + ascii(fault.feature);
  return text + "\n";
}

std::string faults_of(const Findings& findings) {
  const std::vector<Fault> faults = told_faults(findings);
  const std::size_t count = faults.size();
  if (count == 0) {
    if (findings.without_part)
      return "no fault; what is left and what is gouged was not asked: no part was stated\n";
    return findings.all.clean
               ? fmt::format("nothing thicker than {} mm left where the cutter can reach, nothing gouged\n",
                             fixed(findings.all.uncut_thickness_mm, 3))
               : "";
  }
  std::string text = fmt::format("{} {}:\n", count, count == 1 ? "fault" : "faults");
  for (std::size_t i = 0; i < std::min(count, kFaultsShown); ++i) text += line_of(faults[i]);
  if (count > kFaultsShown) text += fmt::format("  and {} more\n", count - kFaultsShown);
  return text;
}

std::string conditions_of(const Findings& findings) {
  std::string text;
  for (const Condition& one : findings.conditions) {
    text += fmt::format("  condition {}: {}", ascii(one.name), ascii(one.text));
    if (one.line > 0) text += fmt::format(" (line {})", one.line);
    text += one.met_by.empty() ? "; say --accept " + ascii(one.name) + " once you have seen to it\n"
                               : "; " + one.met_by + "\n";
  }
  return text;
}

std::string verdict_line(const Findings& findings) {
  return fmt::format("verdict: {}\n", verdict_words(findings));
}

/// Shortens the names in the first column as far as required by the width of the other columns.
void fit_names(TextTable& text) {
  const std::string printed = plain(text);
  std::size_t longest_name = 0;
  for (const auto& cells : text.rows) {
    if (!cells.empty()) longest_name = std::max(longest_name, cells[0].size());
  }
  const std::size_t rule = printed.find("\n-");
  const std::size_t width = printed.find('\n', rule + 1) - rule - 1;
  if (width <= kWidth) return;
  const std::size_t excess = std::min(width - kWidth, longest_name - std::min(longest_name, kShortestName));
  for (auto& cells : text.rows) {
    if (!cells.empty()) cells[0] = shortened(cells[0], longest_name - excess);
  }
}

/// Share of climb milling, and forces if the material is known.
std::string load_lines(const Figures& all) {
  std::string text;
  const Engagement& engagement = all.engagement;
  const double sided = engagement.climb_mm + engagement.conventional_mm;
  if (sided > 0)
    text += fmt::format("climb {} % of the cutting length\n", fixed(100 * engagement.climb_mm / sided, 0));
  if (all.entries.count > 0)
    text += fmt::format("{}: {} mm in material, up to {}\u00b0 and {} mm deep\n",
                        all.entries.count == 1 ? "1 entry" : fmt::format("{} entries", all.entries.count),
                        fixed(all.entries.length_mm, 1), fixed(all.entries.max_deg, 0),
                        fixed(all.entries.max_axial_mm, 2));
  if (all.load) {
    text += fmt::format("force up to {} N, power {} W, energy {} kJ, {} % of a cutter's life\n",
                        fixed(all.load->max_force_n, 0), fixed(all.load->max_power_w, 0),
                        fixed(all.load->energy_j / 1000, 2), fixed(100 * all.load->wear, 2));
  }
  if (all.thin_wall) {
    text += fmt::format("thin wall: {} mm thick, {} mm high, bends {} mm at x {} y {}\n",
                        fixed(all.thin_wall->thickness_mm, 2), fixed(all.thin_wall->height_mm, 2),
                        fixed(all.thin_wall->deflection_mm, 3), fixed(all.thin_wall->at.point.x, 2),
                        fixed(all.thin_wall->at.point.y, 2));
  }
  return text;
}

/// How near the feed length of the levels that clear areas is to the least possible.
std::string bound_line(const Findings& findings) {
  const BoundedFeed feed = bounded_feed(findings);
  if (feed.bound_mm <= 0) return "";
  return fmt::format("clearing: {} mm of feed, at most {} % above the least possible\n",
                     fixed(feed.feed_mm, 1), fixed(feed.percent_above(), 1));
}

/// Scallops left by layers on drafted walls.
std::string scallop_lines(const Findings& findings) {
  std::string text;
  for (const FeatureFindings& feature : findings.features) {
    if (!feature.scallop) continue;
    text += fmt::format("scallop: {} mm at most on the drafted walls of {}",
                        fixed(feature.scallop->height_mm, 3), ascii(feature.name));
    if (feature.scallop->asked_mm)
      text += fmt::format(", {} mm may stand", fixed(*feature.scallop->asked_mm, 3));
    text += "\n";
  }
  return text;
}

/// Figures of each tool that need no part.
TextTable table_of_tools(const Part& part, const Findings& findings) {
  TextTable text;
  text.title = shortened(ascii(part.name), kWidth);
  text.columns = {{"tool", Align::kLeft}, {"layers"}, {"feed mm"},        {"rapid mm"},
                  {"retracts"},           {"time"},   {"deepest cut mm"}, {"eng deg"}};
  std::size_t layers = 0;
  const auto row = [&](const std::string& name, std::size_t count, const Figures& f) {
    text.add({name, std::to_string(count), fixed(f.feed_mm, 1), fixed(f.rapid_mm, 1),
              std::to_string(f.retracts), clock_time(f.time_s), fixed(f.max_axial_mm, 3),
              fixed(f.engagement.max_deg, 0)});
  };
  for (const FeatureFindings& tool : findings.features) {
    layers += tool.layers.size();
    row(cutter_of(tool), tool.layers.size(), tool.figures);
  }
  text.add_rule();
  row("total", layers, findings.all);
  return text;
}

/// The stock block used in the check.
std::string stock_line(const Part& part) {
  if (!part.stock) return "";
  const auto range = [](double low, double high) {
    return fmt::format("{} to {}", trimmed(low, 3), trimmed(high, 3));
  };
  const Stock& stock = *part.stock;
  return fmt::format("stock: x {}, y {}, z {}\n", range(stock.plan.min.x, stock.plan.max.x),
                     range(stock.plan.min.y, stock.plan.max.y), range(stock.z_bottom, stock.z_top));
}

}  // namespace

BoundedFeed bounded_feed(const Findings& findings) {
  BoundedFeed sum;
  for (const FeatureFindings& feature : findings.features) {
    for (const LayerFindings& layer : feature.layers) {
      if (!(layer.figures.lower_bound_mm > 0)) continue;
      sum.feed_mm += layer.figures.feed_mm;
      sum.bound_mm += layer.figures.lower_bound_mm;
    }
  }
  return sum;
}

std::string table(const Part& part, const Findings& findings, std::size_t width) {
  if (findings.without_part)
    return fitted(table_of_tools(part, findings), width) + stock_line(part) + load_lines(findings.all) +
           verdict_line(findings) + faults_of(findings) + conditions_of(findings);
  TextTable text;
  text.title = part.name.empty() ? "" : shortened(ascii(part.name), kWidth);
  text.columns = {{"feature", Align::kLeft},
                  {"tool", Align::kLeft},
                  {"layers"},
                  {"feed mm"},
                  {"rapid mm"},
                  {"retracts"},
                  {"time"},
                  {"uncut mm"},
                  {"uncut mm2"},
                  {"gouge mm"},
                  {"eng deg"},
                  {"clean", Align::kLeft}};
  std::size_t layers = 0;
  const SectionNames names(part);
  for (const FeatureFindings& feature : findings.features) {
    layers += feature.layers.size();
    text.add(row(feature.workingstep < 0 ? feature.name : names.of(feature.workingstep), cutter_of(feature),
                 std::to_string(feature.layers.size()), feature.figures));
  }
  text.add_rule();
  text.add(row("total", "", std::to_string(layers), findings.all));
  fit_names(text);
  return fitted(text, width) + load_lines(findings.all) + bound_line(findings) + scallop_lines(findings) +
         verdict_line(findings) + faults_of(findings) + conditions_of(findings);
}

namespace {

std::string strategy_cell(const CandidateResult& one) {
  std::string cell = one.strategy;
  if (!one.stepover.empty()) cell += " " + one.stepover;
  return one.order.empty() ? cell : cell + " by " + one.order;
}

std::string time_cell(const CandidateResult& one) {
  if (one.time_s > 0) return fmt::format("{:.1f}", one.time_s);
  return one.least_s > 0 ? fmt::format("> {:.1f}", one.least_s) : "-";
}

}  // namespace

TextTable selection_table(const std::vector<StrategySelection>& selections) {
  const bool has_costs = std::any_of(selections.begin(), selections.end(), [](const StrategySelection& one) {
    return std::any_of(one.candidates.begin(), one.candidates.end(),
                       [](const CandidateResult& candidate) { return candidate.cost.has_value(); });
  });
  TextTable table;
  table.columns = {{"feature", Align::kLeft},
                   {"strategy", Align::kLeft},
                   {"time s"},
                   {"feed mm"},
                   {"outcome", Align::kLeft}};
  if (has_costs) table.columns.insert(table.columns.end() - 1, {"objective"});
  for (const auto& selection : selections) {
    std::string feature = selection.feature;
    for (const auto& one : selection.candidates) {
      std::vector<std::string> cells{feature, strategy_cell(one), time_cell(one),
                                     one.feed_mm > 0 ? fmt::format("{:.1f}", one.feed_mm) : "-"};
      if (has_costs) cells.push_back(one.cost ? fmt::format("{:.4g}", *one.cost) : "-");
      cells.emplace_back(name_of(one.outcome));
      table.add(std::move(cells));
      feature.clear();
    }
  }
  return table;
}

namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t kGap = 2;         // between columns
constexpr std::size_t kLeastText = 12;  // a column of words is never wrapped to less

/// A row with words instead of missing figures: its last cell may extend over the columns to its right.
bool runs_over(const TextTable& table, const Cells& row) {
  return row.size() == 2 && table.columns.size() > 2;
}

struct Layout {
  std::vector<std::size_t> widths;               ///< width of each column
  std::vector<std::vector<std::size_t>> blocks;  ///< columns placed side by side
};

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& word : wrapped(text, 1)) longest = std::max(longest, word.size());
  return longest;
}

/// Widths of the cells and the heading, or of the heading's longest word if the heading is wrapped.
std::vector<std::size_t> widths_of(const TextTable& table, bool wraps_headings) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::string heading = ascii(table.columns[column].heading);
    std::size_t width = wraps_headings ? longest_word(heading) : heading.size();
    for (const Cells& row : table.rows) {
      if (column >= row.size() || (column == 1 && runs_over(table, row))) continue;
      width = std::max(width, ascii(row[column]).size());
    }
    widths.push_back(width);
  }
  return widths;
}

std::size_t total_of(const std::vector<std::size_t>& widths) {
  return std::accumulate(widths.begin(), widths.end(), kGap * (widths.size() - 1));
}

/// As many columns per block as fit beside the first column, which every block repeats.
Layout layout_of(const TextTable& table, std::size_t width) {
  Layout layout{widths_of(table, false), {{0}}};
  if (total_of(layout.widths) > width) layout.widths = widths_of(table, true);
  std::size_t used = layout.widths[0];
  for (std::size_t column = 1; column < layout.widths.size(); ++column) {
    const std::size_t more = kGap + layout.widths[column];
    if (used + more > width && layout.blocks.back().size() > 1) {
      layout.blocks.push_back({0});
      used = layout.widths[0];
    }
    layout.blocks.back().push_back(column);
    used += more;
  }
  // A last column of words is wrapped if it is too wide by itself.
  if (used > width && table.columns.back().align == Align::kLeft) {
    std::size_t& last = layout.widths.back();
    last = std::max(kLeastText, last - std::min(last, used - width));
  }
  return layout;
}

std::string joined(const TextTable& table, const Layout& layout, const std::vector<std::size_t>& block,
                   const std::vector<Cells>& cells) {
  std::size_t height = 0;
  for (const Cells& lines : cells) height = std::max(height, lines.size());
  std::string text;
  for (std::size_t at = 0; at < height; ++at) {
    std::string line;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::string cell = at < cells[i].size() ? cells[i][at] : "";
      const std::string blanks(layout.widths[block[i]] - std::min(layout.widths[block[i]], cell.size()), ' ');
      if (i > 0) line += std::string(kGap, ' ');
      line += table.columns[block[i]].align == Align::kLeft ? cell + blanks : blanks + cell;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

/// Lines of each cell; headings end on the same line.
std::string heading_of(const TextTable& table, const Layout& layout, const std::vector<std::size_t>& block) {
  std::vector<Cells> cells;
  std::size_t height = 0;
  for (const std::size_t column : block) {
    cells.push_back(wrapped(ascii(table.columns[column].heading), layout.widths[column]));
    height = std::max(height, cells.back().size());
  }
  for (Cells& lines : cells) lines.insert(lines.begin(), height - lines.size(), "");
  return joined(table, layout, block, cells);
}

std::string row_of(const TextTable& table, const Layout& layout, const std::vector<std::size_t>& block,
                   const Cells& row) {
  std::vector<Cells> cells;
  for (const std::size_t column : block) {
    const std::string cell = column < row.size() ? ascii(row[column]) : "";
    const bool wraps = column + 1 == table.columns.size() && column > 0;
    cells.push_back(wraps ? wrapped(cell, layout.widths[column]) : Cells{cell});
  }
  return joined(table, layout, block, cells);
}

std::string words_of(const Layout& layout, const Cells& row, std::size_t width) {
  const std::size_t indent = layout.widths[0] + kGap;
  std::string text = ascii(row[0]) + std::string(indent - std::min(indent, ascii(row[0]).size()), ' ');
  const auto lines = wrapped(ascii(row[1]), std::max(kLeastText, width - std::min(width, indent)));
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += (i > 0 ? std::string(indent, ' ') : "") + lines[i] + "\n";
  return text;
}

std::string block_text(const TextTable& table, const Layout& layout, std::size_t index, std::size_t width) {
  const auto& block = layout.blocks[index];
  std::size_t total = kGap * (block.size() - 1);
  for (const std::size_t column : block) total += layout.widths[column];
  const std::string rule = std::string(std::min(total, width), '-') + "\n";
  std::string text = heading_of(table, layout, block) + rule;
  for (const Cells& row : table.rows) {
    if (row.empty()) {
      text += rule;
    } else if (!runs_over(table, row)) {
      text += row_of(table, layout, block, row);
    } else if (index == 0) {
      text += words_of(layout, row, width);
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::string fitted(const TextTable& table, std::size_t width) {
  if (table.columns.empty()) return plain(table);
  std::string text;
  const auto add_wrapped = [&](const std::string& words) {
    for (const std::string& line : wrapped(ascii(words), width)) text += line + "\n";
  };
  if (!table.title.empty()) add_wrapped(table.title);
  const Layout layout = layout_of(table, width);
  for (std::size_t i = 0; i < layout.blocks.size(); ++i)
    text += (i > 0 ? "\n" : "") + block_text(table, layout, i, width);
  for (const std::string& note : table.notes) add_wrapped(note);
  return text;
}

}  // namespace clearcut::report
