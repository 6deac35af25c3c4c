#include "studies/reproduce/page/reproduction_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::studies {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Clearcut: the four texts, printed and reproduced</title>
<style>
:root { color-scheme: light dark; --ink: #222; --page: #fff; --rule: #ccc; --link: #0b57a8; --agrees: #cdeccd; --computed: #d5e6f7; --printed: #e6e6e6; --explained: #fbe8b0; --differs: #f6c3c0; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6ebf0; --page: #14191f; --rule: #4a5866; --link: #74b3ff; --agrees: #1d4a2c; --computed: #1c3d5c; --printed: #3a4149; --explained: #564309; --differs: #6b2a2a; }
}
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 76em; padding: 0 1em; color: var(--ink); background: var(--page); overflow-wrap: break-word; }
a { color: var(--link); } td a { display: inline-block; min-width: 24px; min-height: 24px; }
table { border-collapse: collapse; margin: .6em 0; font-size: 13px; }
th, td { border: 1px solid var(--rule); padding: .15em .5em; text-align: right; }
th:first-child, td:first-child { text-align: left; }
.agrees { background: var(--agrees); } .computed { background: var(--computed); } .printed { background: var(--printed); } .explained { background: var(--explained); } .differs { background: var(--differs); }
figure { margin: 1em 0; } figure svg { max-width: 100%; height: auto; background: #fff; border-radius: 6px; } figcaption { font-size: 13px; }
.key { padding: 0 .5em; } .scroll { overflow-x: auto; } .scroll:focus-visible { outline: 2px solid var(--link); }
</style></head><body>
<h1>The four texts: printed, and reproduced by this program</h1>
<p>Our figures are coloured where the text prints one to compare with:
<span class="key agrees">the system ran, and its figure is the printed one</span>
<span class="key computed">a formula gives the printed figure</span>
<span class="key printed">other printed figures add up to it</span>
<span class="key explained">differs by no more than the reason below its table can make it</span>
<span class="key differs">differs by more; below its table stands what is known of why</span>.
Pointing at a cell shows the printed figure.</p>
)";

std::string cell_html(const std::string& text, const Compared* compared) {
  if (compared == nullptr) return "<td>" + xml_escaped(text) + "</td>";
  return fmt::format("<td class=\"{}\" title=\"printed {}\">{}</td>", name_of(compared->agreement),
                     xml_escaped(compared->printed), xml_escaped(text));
}

std::string rows_html(const Reproduction& reproduction) {
  std::map<std::pair<std::size_t, std::size_t>, const Compared*> compared;
  for (const Compared& one : reproduction.compared) compared[{one.row, one.column}] = &one;
  std::string html;
  for (std::size_t row = 0; row < reproduction.table.rows.size(); ++row) {
    const auto& cells = reproduction.table.rows[row];
    if (cells.empty()) continue;
    html += "<tr>";
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const auto found = compared.find({row, column});
      html += cell_html(cells[column], found == compared.end() ? nullptr : found->second);
    }
    html += "</tr>\n";
  }
  return html;
}

std::string table_html(const NamedReproduction& named) {
  const auto& table = named.reproduction.table;
  const auto& compared = named.reproduction.compared;
  std::string html =
      fmt::format("<h2 id=\"{0}\">{1}</h2>\n<p>{2}: <code>clearcut reproduce {0}</code>. {3}</p>\n",
                  xml_escaped(named.name), xml_escaped(table.title), xml_escaped(named.place),
                  named.reproduction.summary());
  for (const Figure& figure : named.reproduction.figures)
    html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", figure.svg,
                        xml_escaped(figure.caption));
  html += "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + xml_escaped(table.title) +
          "\"><table><tr>";
  for (const auto& column : table.columns) html += "<th>" + xml_escaped(column.heading) + "</th>";
  html += "</tr>\n" + rows_html(named.reproduction) + "</table></div>\n<ul>";
  std::set<std::string> reasons;
  for (const Compared& one : compared)
    if (!one.reason.empty()) reasons.insert(one.reason);
  for (const auto& reason : reasons) html += "<li>differs where marked: " + xml_escaped(reason) + "</li>";
  for (const auto& note : table.notes) html += "<li>" + xml_escaped(note) + "</li>";
  return html + "</ul>\n";
}

std::string overview_html(const std::vector<NamedReproduction>& tables) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"All tables\">"
      "<table><tr><th>table</th><th>name</th><th>agree</th><th>computed</th><th>sums of "
      "print</th><th>explained</th><th>differ</th></tr>\n";
  for (const auto& named : tables) {
    const Reproduction& one = named.reproduction;
    html += fmt::format(
        "<tr><td>{0}</td><td><a "
        "href=\"#{1}\">{1}</a></td><td>{2}</td><td>{3}</td><td>{4}</td><td>{5}</td><td "
        "class=\"{7}\">{6}</td></tr>\n",
        xml_escaped(named.place), xml_escaped(named.name), one.count(Agreement::kAgrees),
        one.count(Agreement::kComputed), one.count(Agreement::kPrinted), one.count(Agreement::kExplained),
        one.count(Agreement::kDiffers), one.compared.empty() ? "runs" : name_of(one.agreement()));
  }
  return html + "</table></div>\n";
}

nlohmann::ordered_json json_of(const NamedReproduction& named) {
  const auto& table = named.reproduction.table;
  const auto& compared = named.reproduction.compared;
  nlohmann::ordered_json json;
  json["name"] = named.name;
  json["place"] = named.place;
  json["title"] = table.title;
  json["agreement"] = name_of(named.reproduction.agreement());
  for (const auto& column : table.columns) {
    json["columns"].push_back(column.heading);
    json["left"].push_back(column.align == Align::kLeft);
  }
  json["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) json["rows"].push_back(row);
  json["notes"] = table.notes;
  json["figures"] = nlohmann::ordered_json::array();
  for (const Figure& figure : named.reproduction.figures)
    json["figures"].push_back({{"caption", figure.caption}, {"svg", figure.svg}});
  json["compared"] = nlohmann::ordered_json::array();
  for (const Compared& one : compared) {
    json["compared"].push_back({{"row", one.row},
                                {"column", one.column},
                                {"printed", one.printed},
                                {"ours", one.ours},
                                {"agreement", name_of(one.agreement)},
                                {"reason", one.reason}});
  }
  return json;
}

Agreement agreement_named(const std::string& name) {
  for (const Agreement one : kAgreements)
    if (name == name_of(one)) return one;
  return Agreement::kDiffers;
}

NamedReproduction reproduction_of(const nlohmann::json& json) {
  NamedReproduction named;
  named.name = json.at("name").get<std::string>();
  named.place = json.at("place").get<std::string>();
  TextTable& table = named.reproduction.table;
  table.title = json.at("title").get<std::string>();
  const auto& left = json.at("left");
  for (const auto& heading : json.at("columns")) {
    const bool is_left = left.at(table.columns.size()).get<bool>();
    table.columns.push_back({heading.get<std::string>(), is_left ? Align::kLeft : Align::kRight});
  }
  table.rows = json.at("rows").get<std::vector<std::vector<std::string>>>();
  table.notes = json.at("notes").get<std::vector<std::string>>();
  for (const auto& figure : json.value("figures", nlohmann::json::array()))
    named.reproduction.figures.push_back(
        {figure.at("caption").get<std::string>(), figure.at("svg").get<std::string>()});
  for (const auto& one : json.at("compared")) {
    named.reproduction.compared.push_back(
        {one.at("printed").get<std::string>(), one.at("ours").get<std::string>(),
         agreement_named(one.at("agreement").get<std::string>()), one.at("reason").get<std::string>(),
         one.at("row").get<std::size_t>(), one.at("column").get<std::size_t>()});
  }
  return named;
}

}  // namespace

std::vector<NamedReproduction> read_reproduction_json(const std::string& text, const std::string& file) {
  std::vector<NamedReproduction> tables;
  try {
    for (const auto& json : nlohmann::json::parse(text)) tables.push_back(reproduction_of(json));
  } catch (const nlohmann::json::exception&) {
    throw InputError(file,
                     "holds no reproduced tables; leave out --resume or name the file that --json wrote");
  }
  return tables;
}

std::string reproduction_json(const std::vector<NamedReproduction>& tables) {
  auto json = nlohmann::ordered_json::array();
  for (const auto& named : tables) json.push_back(json_of(named));
  return json.dump(1) + "\n";
}

std::string reproduction_page(const std::vector<NamedReproduction>& tables) {
  std::string html = kHead + overview_html(tables);
  for (const auto& named : tables) html += table_html(named);
  return html + "</body></html>\n";
}

}  // namespace clearcut::studies
