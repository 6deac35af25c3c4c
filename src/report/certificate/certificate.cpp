#include "report/certificate/certificate.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/units.h"
#include "report/certificate/certificate_json.h"
#include "report/result.h"

namespace clearcut::report {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return certificate_number(value);
}

Json place(const std::optional<Place>& at) {
  if (!at) return nullptr;
  Json json;
  json["x"] = number(at->point.x);
  json["y"] = number(at->point.y);
  json["z"] = number(at->z);
  json["line"] = at->line;
  return json;
}

Json engagement(const Engagement& e) {
  Json json;
  json["max_deg"] = number(e.max_deg);
  json["max_at"] = place(e.max_at);
  json["mean_deg"] = number(e.mean_deg);
  json["over_limit_mm"] = number(e.over_limit_mm);
  json["histogram"] = Json::array();
  for (const double length : e.histogram_mm) json["histogram"].push_back(number(length));
  json["climb_mm"] = number(e.climb_mm);
  json["conventional_mm"] = number(e.conventional_mm);
  const double sided = e.climb_mm + e.conventional_mm;
  json["climb_percent"] = sided > 0 ? number(100 * e.climb_mm / sided) : Json(nullptr);
  return json;
}

Json entries(const Entries& e) {
  Json json;
  json["count"] = e.count;
  json["length_mm"] = number(e.length_mm);
  json["max_deg"] = number(e.max_deg);
  json["max_at"] = place(e.max_at);
  json["max_axial_mm"] = number(e.max_axial_mm);
  return json;
}

Json forces(const CuttingLoad& load) {
  Json json;
  json["max_force_n"] = number(load.max_force_n);
  json["max_force_at"] = place(load.max_force_at);
  json["mean_force_n"] = number(load.mean_force_n);
  json["max_power_w"] = number(load.max_power_w);
  json["energy_j"] = number(load.energy_j);
  json["removed_mm3"] = number(load.removed_mm3);
  json["tool_wear"] = number(load.wear);
  return json;
}

Json reference_load(const ReferenceLoad& load) {
  Json json;
  json["share"] = number(load.share);
  json["at"] = place(load.at);
  return json;
}

Json thin_wall(const ThinWall& wall) {
  Json json;
  json["thickness_mm"] = number(wall.thickness_mm);
  json["height_mm"] = number(wall.height_mm);
  json["deflection_mm"] = number(wall.deflection_mm);
  json["at"] = place(wall.at);
  return json;
}

bool all_finite(const Figures& f) {
  const double figures[] = {f.feed_mm,
                            f.rapid_mm,
                            f.plunge_mm,
                            f.turn_angle_deg,
                            f.time_s,
                            f.time_naive_s,
                            f.uncut_mm2,
                            f.uncut_thickness_mm,
                            f.gouge_mm,
                            f.unreachable_mm2,
                            f.max_axial_mm,
                            f.engagement.max_deg,
                            f.air_cut_mm,
                            f.lower_bound_mm,
                            f.engagement.over_limit_mm};
  return std::all_of(std::begin(figures), std::end(figures), [](double v) { return std::isfinite(v); });
}

void add_figures(Json& json, const Figures& f) {
  json["clean"] = f.clean && all_finite(f);
  json["feed_mm"] = number(f.feed_mm);
  json["rapid_mm"] = number(f.rapid_mm);
  json["plunge_mm"] = number(f.plunge_mm);
  json["turns"] = f.turns;
  json["turn_angle_deg"] = number(f.turn_angle_deg);
  json["retracts"] = f.retracts;
  json["time_s"] = number(f.time_s);
  json["waits_s"] = number(f.waits_s);
  json["time_naive_s"] = number(f.time_naive_s);
  json["uncut_mm2"] = number(f.uncut_mm2);
  json["uncut_thickness_mm"] = number(f.uncut_thickness_mm);
  json["path_tolerance_mm"] = number(f.path_tolerance_mm);
  json["uncut_at"] = place(f.uncut_at);
  json["gouge_mm"] = number(f.gouge_mm);
  json["gouge_at"] = place(f.gouge_at);
  json["unreachable_mm2"] = number(f.unreachable_mm2);
  json["rapid_in_material"] = f.rapid_in_material;
  json["max_axial_mm"] = number(f.max_axial_mm);
  json["engagement"] = engagement(f.engagement);
  json["entries"] = entries(f.entries);
  json["air_cut_mm"] = number(f.air_cut_mm);
  json["lower_bound_mm"] = number(f.lower_bound_mm);
  if (f.load) json["load"] = forces(*f.load);
  if (f.reference_load) json["reference_load"] = reference_load(*f.reference_load);
  if (f.thin_wall) json["thin_wall"] = thin_wall(*f.thin_wall);
}

Json length_bound(const LengthBound& bound) {
  Json json;
  json["mm"] = number(bound.mm);
  json["cutter_radius_mm"] = number(bound.cutter_radius_mm);
  json["area_mm2"] = number(bound.area_mm2);
  json["paths"] = bound.paths;
  json["closed"] = bound.closed;
  json["points"] = Json::array();
  for (const LengthBoundPoint& one : bound.points)
    json["points"].push_back({{"x", number(one.at.x)}, {"y", number(one.at.y)}, {"mm2", number(one.mm2)}});
  json["rings"] = Json::array();
  for (const LengthBoundRing& one : bound.rings)
    json["rings"].push_back({{"x", number(one.at.x)},
                             {"y", number(one.at.y)},
                             {"radius_mm", number(one.radius_mm)},
                             {"mm2", number(one.mm2)}});
  return json;
}

Json layer(const LayerFindings& findings) {
  Json json;
  json["z"] = number(findings.z);
  add_figures(json, findings.figures);
  return json;
}

Json candidate_result(const CandidateResult& one) {
  Json json;
  json["strategy"] = one.strategy;
  json["stepover"] = one.stepover;
  json["outcome"] = name_of(one.outcome);
  json["time_s"] = number(one.time_s);
  json["feed_mm"] = number(one.feed_mm);
  json["least_s"] = number(one.least_s);
  if (!one.order.empty()) json["order"] = one.order;
  if (one.cost) json["objective"] = number(*one.cost);
  return json;
}

/// The strategy kept for a workingstep, and all candidates.
void add_selections(Json& json, const std::vector<StrategySelection>& selections, int workingstep) {
  for (const StrategySelection& selection : selections) {
    if (selection.workingstep != workingstep) continue;
    json["strategy"] = selection.kept();
    json["candidates"] = Json::array();
    for (const CandidateResult& one : selection.candidates)
      json["candidates"].push_back(candidate_result(one));
  }
}

Json feature(const FeatureFindings& findings, const CertificateInfo& info) {
  Json json;
  json["name"] = findings.name;
  json["workingstep"] = findings.workingstep;
  json["tool_number"] = findings.tool_number;
  json["tool_diameter"] = number(findings.tool_diameter);
  add_selections(json, info.selections, findings.workingstep);
  add_figures(json, findings.figures);
  if (findings.scallop) {
    json["scallop_mm"] = number(findings.scallop->height_mm);
    json["scallop_asked_mm"] = findings.scallop->asked_mm ? number(*findings.scallop->asked_mm) : Json();
  }
  for (const StepLengthBound& one : info.length_bounds)
    if (one.workingstep == findings.workingstep) json["length_bound"] = length_bound(one.bound);
  json["layers"] = Json::array();
  for (const LayerFindings& one : findings.layers) json["layers"].push_back(layer(one));
  return json;
}

Json fault(const Fault& findings) {
  Json json;
  json["kind"] = name_of(findings.kind);
  json["feature"] = findings.feature;
  json["place"] = place(findings.at);
  json["line"] = findings.at.line;
  json["size_mm"] = number(findings.size);
  json["text"] = findings.text;
  if (!findings.cause.empty()) json["follows_from"] = findings.cause;
  return json;
}

Json program(const CertificateInfo& info) {
  Json json;
  json["name"] = info.program_name;
  json["sha256"] = sha256_hex(info.program);
  json["motion_sha256"] = sha256_hex(motion_text(info.program));
  json["dialect"] = info.dialect;
  json["dialect_stated"] = info.dialect_stated;
  return json;
}

/// A value of the plan; `workingstep` is null for those of the whole.
Json resolved(const ResolvedValue& value) {
  Json json;
  json["workingstep"] = value.step < 0 ? Json(nullptr) : Json(value.step);
  json["name"] = value.name;
  json["value"] = value.value;
  json["unit"] = value.unit;
  json["origin"] = name_of(value.source.origin);
  json["source"] = value.source.text;
  return json;
}

/// Contours of published methods; contours of other methods add no information to the layers.
Json contours(const ContourLevels& levels) {
  Json json;
  json["feature"] = levels.feature;
  json["from_wall_mm"] = Json::array();
  for (const double level : levels.from_wall) json["from_wall_mm"].push_back(number(level));
  json["coefficients"] = Json::array();
  for (const ContourCoefficient& one : levels.coefficients) {
    Json coefficient;
    coefficient["from_wall_mm"] = number(one.from_wall);
    coefficient["smallest_angle_deg"] = number(one.smallest_angle * 180 / kPi);
    coefficient["coefficient"] = number(one.share);
    coefficient["residual_mm"] = number(one.residual);
    json["coefficients"].push_back(coefficient);
  }
  return json;
}

void add_proof(Json& json, const CertificateInfo& info) {
  if (!info.proof) return;
  const CertificateProof& proof = *info.proof;
  json["proved"] = proof.proved;
  json["proof"] = {{"not_proved", proof.not_proved}, {"options", proof.options}};
  if (!proof.witness_sha256.empty()) json["proof"]["witness_sha256"] = proof.witness_sha256;
}

void add_wear(Json& json, const Findings& findings) {
  if (!findings.wear) return;
  json["wear"]["range_mm"] = number(findings.wear->range_mm);
  json["wear"]["tools"] = findings.wear->tools;
}

void add_margin(Json& json, const CertificateInfo& info) {
  if (!info.margin) return;
  const Margin& margin = *info.margin;
  Json& out = json["margin"];
  const FeatureMargin* const least = margin.least();
  out["mm"] = least ? number(least->mm) : Json();
  out["uncut_bound_mm"] = number(margin.bounds.uncut);
  out["gouge_bound_mm"] = number(margin.bounds.gouge);
  out["features"] = Json::array();
  for (const FeatureMargin& one : margin.features)
    out["features"].push_back({{"feature", one.feature},
                               {"mm", number(one.mm)},
                               {"limit", name_of(one.limit)},
                               {"at", place(one.at)}});
  out["not_asked"] = margin.not_asked;
}

void add_copies(Json& json, const CertificateInfo& info) {
  if (!info.copies) return;
  const CopiesMade& copies = *info.copies;
  Json& out = json["copies"];
  out["parts"] = copies.parts;
  out["clean_parts"] = copies.clean_parts;
  out["turned"] = copies.turned;
  out["gap_mm"] = number(copies.gap);
  if (copies.wanted) out["wanted"] = *copies.wanted;
  if (copies.at_most) out["at_most"] = *copies.at_most;
  for (const KindMade& kind : copies.kinds) {
    Json one{{"name", kind.name},
             {"parts", kind.parts},
             {"clean_parts", kind.clean_parts},
             {"turned", kind.turned}};
    if (kind.wanted) one["wanted"] = *kind.wanted;
    out["kinds"].push_back(std::move(one));
  }
  for (const PlaceMade& made : copies.places)
    out["places"].push_back({{"name", copies.kinds[made.kind].name},
                             {"at_mm", {number(made.taken.min.x), number(made.taken.min.y)}},
                             {"size_mm", {number(made.taken.width()), number(made.taken.height())}},
                             {"turned", made.turned}});
}

void add_contours(Json& json, const CertificateInfo& info) {
  for (const ContourLevels& one : info.contours)
    if (!one.coefficients.empty()) json["contours"].push_back(contours(one));
  if (!json.contains("contours") || !info.published) return;
  const PublishedTime& time = *info.published;
  json["published_time_s"] = number(time.seconds());
  json["published_length_mm"] = number(time.length_mm);
  json["published_discontinuities"] = time.discontinuities;
  json["published_feed_mm_per_min"] = {number(time.slowest.mm_per_min()), number(time.fastest.mm_per_min())};
}

}  // namespace

Json certificate_file(const CertificateFile& file) {
  Json json;
  json["role"] = file.role;
  json["name"] = file.name;
  json["sha256"] = file.sha256;
  return json;
}

std::string certificate_json(const Part& part, const Findings& findings, const CertificateInfo& info) {
  Json json;
  json["schema"] = "clearcut-certificate-2";
  json["version"] = info.version;
  json["seed"] = info.seed;
  json["part"] = part.name;
  json["source_file"] = part.source_file;
  json["inputs"] = Json::array();
  for (const CertificateFile& one : info.inputs) json["inputs"].push_back(certificate_file(one));
  json["program"] = program(info);
  json["question"] = certificate_question(part, findings, info);
  json["verdict"] = verdict_words(findings);
  if (findings.without_part) json["not_asked"] = {name_of(FaultKind::kUncut), name_of(FaultKind::kGouge)};
  add_figures(json, findings.all);
  json["clean"] = all_finite(findings.all) && verdict_of(findings) == Verdict::kClean;
  json["features"] = Json::array();
  for (const FeatureFindings& one : findings.features) json["features"].push_back(feature(one, info));
  json["faults"] = Json::array();
  for (const Fault& one : findings.faults) json["faults"].push_back(fault(one));
  add_contours(json, info);
  add_proof(json, info);
  add_margin(json, info);
  add_copies(json, info);
  add_wear(json, findings);
  if (!info.values.empty()) json["values"] = Json::array();
  for (const ResolvedValue& one : info.values) json["values"].push_back(resolved(one));
  json["conditions"] = Json::array();
  for (const Condition& one : findings.conditions) json["conditions"].push_back(condition_json(one));
  json["seal"] = seal_of(json);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace clearcut::report
