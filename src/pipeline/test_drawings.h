// Drawings of tests, and what is asked of the programs planned from them.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/elementary.h"
#include "base/error.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"

namespace clearcut::pipeline {

inline std::string outline(const std::string& layer, const std::vector<BulgeVertex>& vertices) {
  std::string text = "0\nLWPOLYLINE\n8\n" + layer + "\n90\n" + std::to_string(vertices.size()) + "\n70\n1\n";
  for (const BulgeVertex& v : vertices) {
    text += "10\n" + std::to_string(v.point.x) + "\n20\n" + std::to_string(v.point.y) + "\n";
    if (v.bulge != 0) text += "42\n" + std::to_string(v.bulge) + "\n";
  }
  return text;
}

inline std::string box(const std::string& layer, double x0, double y0, double x1, double y1) {
  return outline(layer, {{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}});
}

inline std::string circle(const std::string& layer, Vec2 center, double radius) {
  return "0\nCIRCLE\n8\n" + layer + "\n10\n" + std::to_string(center.x) + "\n20\n" +
         std::to_string(center.y) + "\n40\n" + std::to_string(radius) + "\n";
}

inline std::string rounded_box(const std::string& layer, double x0, double y0, double x1, double y1,
                               double r) {
  const double quarter = base::tan(kPi / 8);
  return outline(layer, {{{x0 + r, y0}},
                         {{x1 - r, y0}, quarter},
                         {{x1, y0 + r}},
                         {{x1, y1 - r}, quarter},
                         {{x1 - r, y1}},
                         {{x0 + r, y1}, quarter},
                         {{x0, y1 - r}},
                         {{x0, y0 + r}, quarter}});
}

inline std::string drawing(const std::string& entities) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
         "0\nENDSEC\n0\nEOF\n";
}

inline Part drawn(const std::string& entities) {
  return read::read_part_text(drawing(entities), "sign.dxf", {});
}

inline PlanOptions with(const std::vector<std::string>& tools) {
  PlanOptions options;
  for (const std::string& tool : tools) options.tools.push_back(resolve::parse_tool(tool));
  for (std::size_t i = 0; i < options.tools.size(); ++i) options.tools[i].number = static_cast<int>(i) + 1;
  options.threads = 1;
  return options;
}

inline std::string faults_of(const Findings& findings) {
  std::string text;
  for (const Fault& fault : findings.faults)
    text += std::string(name_of(fault.kind)) + ": " + fault.text + "\n";
  return text;
}

/// All conditions, met or open.
inline std::string texts_of(const Findings& findings) {
  std::string text;
  for (const Condition& one : findings.conditions) text += one.name + ": " + one.text + "\n";
  return text;
}

inline bool has(const Findings& findings, FaultKind kind) {
  return std::any_of(findings.faults.begin(), findings.faults.end(),
                     [&](const Fault& fault) { return fault.kind == kind; });
}

inline std::string refusal(const Part& part, const std::vector<std::string>& tools) {
  try {
    plan_part(part, with(tools));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace clearcut::pipeline
