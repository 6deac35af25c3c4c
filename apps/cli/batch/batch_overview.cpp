#include <clearcut/text.h>
#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "batch/batch_parts.h"

namespace clearcut::cli {
namespace {

constexpr int kOverviewDigits = 3;

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// A name as a relative address: everything but letters, digits and a few signs by its number.
std::string address(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '.' || c == '-' || c == '_';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

constexpr const char* kStyle =
    "body{font:14px system-ui,sans-serif;margin:2em;color:#222}table{border-collapse:collapse}"
    "td,th{padding:.4em .8em;border-bottom:1px solid #ddd;text-align:left;vertical-align:middle}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}img{width:120px;height:90px;object-fit:contain}"
    ".CLEAN{color:#06752e}.CONDITIONAL{color:#8a5a00}.bad{color:#b00020;font-weight:600}";

std::string page_row(const BatchRow& row) {
  const std::string at = address(row.name);
  const bool bad = row.verdict != "CLEAN" && row.verdict != "CONDITIONAL";
  const std::string picture =
      has_program(row)
          ? fmt::format("<a href=\"{0}.svg\"><img src=\"{0}.svg\" loading=\"lazy\" alt=\"\"></a>", at)
          : "";
  const std::string links =
      has_program(row)
          ? fmt::format("<a href=\"{0}.ngc\">program</a> <a href=\"{0}.json\">certificate</a>", at)
          : fmt::format("<a href=\"{0}.log\">what it said</a>", at);
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td class=\"{}\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
      "<td>{}</td><td>{}</td></tr>\n",
      picture, html_text(row.name), bad ? "bad" : row.verdict, row.verdict, trimmed(row.time_s, 1),
      trimmed(row.feed_mm, 0), html_text(row.message), links);
}

/// "1:0.25;2:0.5", with all digits.
std::string wear_text(const std::map<int, double>& wear) {
  std::string text;
  for (const auto& [tool, share] : wear) text += fmt::format("{}{}:{}", text.empty() ? "" : ";", tool, share);
  return text;
}

std::map<int, double> wear_of_text(const std::string& text) {
  std::map<int, double> wear;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const int tool = static_cast<int>(std::strtol(at, &end, 10));
    wear[tool] = std::strtod(end + 1, &end);
    at = *end == ';' ? end + 1 : end;
  }
  return wear;
}

/// The programs that use up a cutter, with their places in the batch.
std::string ending_programs(const std::vector<BatchRow>& rows, int tool) {
  std::string names;
  double used = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto found = rows[i].wear.find(tool);
    if (found == rows[i].wear.end()) continue;
    used += found->second;
    if (used < 1) continue;
    used = 0;
    names += fmt::format("{}{} (no. {})", names.empty() ? "" : ", ", rows[i].name, i + 1);
  }
  return names;
}

}  // namespace

bool has_program(const BatchRow& row) {
  return row.verdict == "CLEAN" || row.verdict == "CONDITIONAL" || row.verdict == "FAULTY";
}

std::string batch_csv(const std::vector<BatchRow>& rows) {
  std::string csv = "name,part,verdict,time_s,feed_mm,rapid_mm,uncut_mm,gouge_mm,faults,message,tool_wear\n";
  for (const auto& row : rows)
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(row.name), csv_cell(row.part), row.verdict,
                    trimmed(row.time_s, kOverviewDigits), trimmed(row.feed_mm, kOverviewDigits),
                    trimmed(row.rapid_mm, kOverviewDigits), trimmed(row.uncut_mm, 6),
                    trimmed(row.gouge_mm, 6), row.faults, csv_cell(row.message), wear_text(row.wear));
  return csv;
}

std::string batch_json(const std::vector<BatchRow>& rows) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    json.push_back({{"name", row.name},
                    {"part", row.part},
                    {"verdict", row.verdict},
                    {"time_s", row.time_s},
                    {"feed_mm", row.feed_mm},
                    {"rapid_mm", row.rapid_mm},
                    {"uncut_mm", row.uncut_mm},
                    {"gouge_mm", row.gouge_mm},
                    {"faults", row.faults},
                    {"message", row.message}});
    for (const auto& [tool, share] : row.wear) json.back()["tool_wear"][std::to_string(tool)] = share;
  }
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string batch_page(const std::vector<BatchRow>& rows, const std::string& title) {
  std::string summary = batch_line(rows);
  for (const std::string& line : tool_life_lines(rows)) summary += "; " + line;
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta "
      "charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>"
      "<body>\n<h1>{0}</h1>\n<p>{2}</p>\n<table>\n<tr><th></th><th>part</th><th>verdict</th><th>time, s</th>"
      "<th>feed, mm</th><th></th><th></th></tr>\n",
      html_text(title), kStyle, html_text(summary));
  for (const auto& row : rows) page += page_row(row);
  return page + "</table>\n</body></html>\n";
}

std::vector<std::string> row_fields(const BatchRow& row) {
  std::vector<std::string> fields{row.name, row.part, row.verdict, row.message, std::to_string(row.faults)};
  // {} writes as many digits as bring the same number back.
  for (const double figure : {row.time_s, row.feed_mm, row.rapid_mm, row.uncut_mm, row.gouge_mm})
    fields.push_back(fmt::format("{}", figure));
  fields.push_back(wear_text(row.wear));
  return fields;
}

BatchRow row_of_fields(const std::vector<std::string>& fields) {
  const auto figure = [&fields](std::size_t index) { return std::strtod(fields.at(index).c_str(), nullptr); };
  BatchRow row;
  row.name = fields.at(0);
  row.part = fields.at(1);
  row.verdict = fields.at(2);
  row.message = fields.at(3);
  row.faults = std::stoul(fields.at(4));
  row.time_s = figure(5);
  row.feed_mm = figure(6);
  row.rapid_mm = figure(7);
  row.uncut_mm = figure(8);
  row.gouge_mm = figure(9);
  row.wear = wear_of_text(fields.at(10));
  return row;
}

std::string batch_line(const std::vector<BatchRow>& rows) {
  std::map<std::string, std::size_t> counts;
  for (const auto& row : rows) ++counts[row.verdict];
  std::string line = fmt::format("{} of {} CLEAN", counts["CLEAN"], rows.size());
  for (const auto& [verdict, count] : counts) {
    if (verdict != "CLEAN" && count > 0) line += fmt::format(", {} {}", count, verdict);
  }
  return line;
}

std::vector<std::string> tool_life_lines(const std::vector<BatchRow>& rows) {
  std::map<int, double> total;
  for (const auto& row : rows)
    for (const auto& [tool, share] : row.wear) total[tool] += share;
  std::vector<std::string> lines;
  for (const auto& [tool, share] : total) {
    const std::string programs = ending_programs(rows, tool);
    lines.push_back(fmt::format("T{}: {} % of a cutter's life, {}", tool, trimmed(100 * share, 2),
                                programs.empty() ? "no program uses it up" : "used up in " + programs));
  }
  return lines;
}

}  // namespace clearcut::cli
