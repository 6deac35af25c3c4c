#include "report/viewer/html.h"

#include <fmt/format.h>

#include "base/text/xml_text.h"
#include "report/picture/palette.h"
#include "report/viewer/html_data.h"
#include "report/viewer/html_page.h"

namespace clearcut::report {

namespace {

std::string colors() {
  return fmt::format(
      ":root {{ --ink: {}; --faint: {}; --rule: {}; --good: {}; --bad: {}; --cut: {}; --link: {}; --entry: "
      "{}; "
      "--rapid: {}; }}",
      report::palette::kInk, report::palette::kFaint, report::palette::kRule, report::palette::kGood,
      report::palette::kBad, report::palette::kCut, report::palette::kLink, report::palette::kEntry,
      report::palette::kRapid);
}

}  // namespace

std::string html(const Part& part, const Toolpath& toolpath, const Findings& findings,
                 const HtmlOptions& options) {
  const std::string title = xml_escaped(part.name.empty() ? "part" : part.name);
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n";
  page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n";
  page += "<title>" + title + "</title>\n<style>\n" + colors() + kHtmlStyle + "</style>\n</head>\n<body>\n";
  page += kHtmlBody;
  page += "<script type=\"application/json\" id=\"job\">" + html_data(part, toolpath, findings, options) +
          "</script>\n";
  page += std::string("<script>\n//<![CDATA[") + kHtmlScript + "//]]>\n</script>\n</body>\n</html>\n";
  return page;
}

}  // namespace clearcut::report
