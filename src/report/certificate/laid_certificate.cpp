#include "report/certificate/laid_certificate.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/text.h"
#include "report/certificate/certificate_json.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;

Json place_json(const std::optional<Vec2>& at) {
  return at ? Json{certificate_number(at->x), certificate_number(at->y)} : Json();
}

const char* verdict_of(const LaidFindings& findings) {
  return findings.is_clean() ? "CLEAN" : "FAULTY";
}

}  // namespace

std::string laid_certificate(const LaidFindings& findings, const LaidCertificateInfo& info) {
  Json json;
  json["schema"] = "clearcut-laid-1";
  json["version"] = info.version;
  json["arguments"] = info.arguments;
  json["inputs"] = Json::array();
  for (const CertificateFile& file : info.inputs) json["inputs"].push_back(certificate_file(file));
  json["program"] = {{"name", info.program_name}, {"sha256", sha256_hex(info.program)}};
  json["strategy"] = info.strategy;
  json["stepover"] = info.stepover;
  json["verdict"] = verdict_of(findings);
  json["faults"] = findings.faults;
  const bool extrudes = findings.word == LayingWord::kExtruded;
  json["word"] = extrudes ? "E" : "S";
  json["width_mm"] = certificate_number(findings.width);
  json["lines"] = findings.lines;
  json["laid_mm"] = certificate_number(findings.laid_mm);
  json["travel_mm"] = certificate_number(findings.travel_mm);
  json["time_naive_s"] = certificate_number(findings.time_s);
  json[extrudes ? "filament_mm" : "power"] = certificate_number(findings.amount);
  json["region_mm2"] = certificate_number(findings.region_mm2);
  json["unreachable_mm2"] = certificate_number(findings.unreachable_mm2);
  json["cover_proven"] = findings.lines > 0 && findings.uncut_mm2 == 0;
  json["uncut_mm2"] = certificate_number(findings.uncut_mm2);
  json["uncut_thickness_mm"] = certificate_number(findings.uncut_thickness_mm);
  json["uncut_at"] = place_json(findings.uncut_at);
  json["over_mm2"] = certificate_number(findings.over_mm2);
  json["over_share"] = certificate_number(findings.over_share);
  json["over_share_stated"] = certificate_number(findings.most_over);
  json["outside_mm"] = certificate_number(findings.outside_mm);
  json["outside_at"] = place_json(findings.outside_at);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string laid_table(const LaidFindings& findings) {
  std::string text =
      fmt::format("laid: {} mm in {} line{} of {} mm, {} mm of travel, {} s at the stated feeds\n",
                  trimmed(findings.laid_mm, 1), findings.lines, findings.lines == 1 ? "" : "s",
                  trimmed(findings.width, 4), trimmed(findings.travel_mm, 1), trimmed(findings.time_s, 1));
  text += findings.word == LayingWord::kExtruded
              ? fmt::format("filament: {} mm\n", trimmed(findings.amount, 2))
              : fmt::format("power: {}\n", trimmed(findings.amount, 3));
  text += fmt::format("area: {} mm2, of which the line does not reach {} mm2\n",
                      trimmed(findings.region_mm2, 2), trimmed(findings.unreachable_mm2, 3));
  if (findings.lines > 0 && findings.uncut_mm2 == 0)
    text += fmt::format("cover: proven, no gap wider than {} mm\n", trimmed(findings.uncut_thickness_mm, 4));
  text += fmt::format("laid over: {} mm2, {} % of the area, stated {} %\n", trimmed(findings.over_mm2, 2),
                      trimmed(100 * findings.over_share, 2), trimmed(100 * findings.most_over, 2));
  for (const std::string& fault : findings.faults) text += "fault: " + fault + "\n";
  return text + "verdict: " + verdict_of(findings);
}

}  // namespace clearcut::report
