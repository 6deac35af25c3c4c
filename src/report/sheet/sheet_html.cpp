#include "base/text.h"
#include "report/picture/svg_writer.h"
#include "report/sheet/sheet_writers.h"

namespace clearcut::report {
namespace {

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

void write_title(SvgWriter& page, const SetupSheet& sheet) {
  page.words("h1", sheet.part);
  page.open("p", {});
  page.words("span", sheet.verdict, {{"class", "verdict " + sheet.verdict}});
  page.words("span", " " + sheet.headline);
  page.close();
}

void write_facts(SvgWriter& page, const std::vector<SheetFact>& facts) {
  page.open("dl", {{"class", "facts"}});
  for (const SheetFact& fact : facts) {
    page.words("dt", fact.name);
    page.words("dd", fact.value);
  }
  page.close();
}

SvgWriter::Attributes style_of(const SheetColumn& column) {
  return column.is_number ? SvgWriter::Attributes{{"class", "n"}} : SvgWriter::Attributes{};
}

void write_table(SvgWriter& page, const SheetTable& table) {
  page.words("h2", table.title);
  page.open("div", {{"class", "scroll"}});
  page.open("table", {});
  page.open("thead", {});
  page.open("tr", {});
  for (const SheetColumn& column : table.columns) page.words("th", column.name, style_of(column));
  page.close();
  page.close();
  page.open("tbody", {});
  for (const auto& row : table.rows) {
    page.open("tr", {});
    for (std::size_t i = 0; i < row.size(); ++i) page.words("td", row[i], style_of(table.columns[i]));
    page.close();
  }
  for (int i = 0; i < 3; ++i) page.close();
}

void write_notes(SvgWriter& page, const std::vector<std::string>& notes) {
  if (notes.empty()) return;
  page.words("h2", "Notes");
  page.open("ul", {});
  for (const std::string& line : notes) page.words("li", line);
  page.close();
}

void write_lines_by_hand(SvgWriter& page, const std::vector<std::string>& names) {
  page.open("div", {{"class", "by-hand"}});
  for (const std::string& name : names) page.words("span", name);
  page.close();
}

/// Element by element; every text is escaped by the writer.
std::string body_of(const SetupSheet& sheet) {
  SvgWriter page;
  write_title(page, sheet);
  write_facts(page, sheet.facts);
  page.raw(sheet.picture);
  write_table(page, sheet.tools);
  write_table(page, sheet.operations);
  write_notes(page, sheet.notes);
  write_lines_by_hand(page, sheet.by_hand);
  return page.str();
}

}  // namespace

std::string setup_sheet_html(const SetupSheet& sheet) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>Set-up: " +
         xml_escaped(sheet.part) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n" +
         body_of(sheet) + "</body>\n</html>\n";
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
