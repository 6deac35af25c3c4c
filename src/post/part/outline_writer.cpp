#include <fmt/format.h>

#include "post/part/part_writers.h"

namespace clearcut::post {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

/// The shortest text reading back as the same number.
std::string number(double value) {
  return fmt::format("{}", value == 0 ? 0.0 : value);
}

std::string vertices_text(const std::vector<BulgeVertex>& vertices, const std::string& indent) {
  std::string out = "[";
  const char* separator = "\n";
  for (const BulgeVertex& vertex : vertices) {
    out += fmt::format("{}{}  [{}, {}, {}]", separator, indent, number(vertex.point.x),
                       number(vertex.point.y), number(vertex.bulge));
    separator = ",\n";
  }
  return out + "\n" + indent + "]";
}

std::string loop_text(const Loop& loop, const std::string& indent) {
  return vertices_text(to_bulges(loop), indent);
}

/// The path followed by the cutter, instead of an area; open lines end with their last point.
std::string profile_text(const ProfileCut& cut, const std::string& indent) {
  std::vector<BulgeVertex> vertices = to_bulges(cut.line);
  if (!cut.closed && !cut.line.empty()) vertices.push_back({cut.line.back().to, 0});
  std::string out = indent + "\"closed\": " + (cut.closed ? "true" : "false") + ",\n";
  if (cut.beyond != 0) out += indent + "\"beyond\": " + number(cut.beyond) + ",\n";
  return out + indent + "\"line\": " + vertices_text(vertices, indent);
}

std::string region_text(const Region& region, const std::string& indent) {
  std::string out =
      fmt::format("{}\"outer\": {},\n{}\"islands\": [", indent, loop_text(region.outer(), indent), indent);
  const char* separator = "";
  for (const Loop& island : region.islands()) {
    out += separator + loop_text(island, indent);
    separator = ", ";
  }
  return out + "]";
}

/// The area permitted to the cutter, if larger than the target: open sides.
std::string allowed_text(const Feature& feature, const std::string& indent) {
  std::string out = ",\n" + indent + "\"allowed\": [";
  const char* separator = "";
  for (const Region& region : feature.allowed) {
    out += separator + std::string("{\n") + region_text(region, indent + "  ") + "\n" + indent + "}";
    separator = ", ";
  }
  return out + "]";
}

bool same_loops(const Regions& a, const Regions& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].outer() != b[i].outer() || a[i].islands() != b[i].islands()) return false;
  }
  return true;
}

/// Name, kind, heights: common to all kinds of features.
std::string head_text(const Feature& feature, const std::string& indent) {
  std::string out =
      fmt::format("    {{\n{}\"name\": {},\n{}\"kind\": \"{}\",\n{}\"top\": {},\n{}\"depth\": {},\n", indent,
                  quoted(feature.name), indent, name_of(feature.kind), indent, number(feature.top_z), indent,
                  number(feature.top_z - feature.floor_z));
  if (feature.wall_slope.radians() != 0) {
    out += fmt::format("{}\"slope_rad\": {},\n", indent, number(feature.wall_slope.radians()));
  }
  if (feature.floor_fillet > 0)
    out += fmt::format("{}\"floor_fillet\": {},\n", indent, number(feature.floor_fillet));
  if (feature.through) out += indent + "\"through\": true,\n";
  return out;
}

std::string profile_feature_text(const Feature& feature) {
  const std::string indent = "      ";
  return head_text(feature, indent) + profile_text(*feature.profile, indent) + "\n    }";
}

std::string pocket_text(const Feature& feature, const Region& region) {
  const std::string indent = "      ";
  std::string out = head_text(feature, indent);
  out += region_text(region, indent);
  if (!same_loops(feature.target, feature.allowed)) out += allowed_text(feature, indent);
  return out + "\n    }";
}

}  // namespace

std::string write_outline_json(const Part& part) {
  std::string out = fmt::format("{{\n  \"name\": {},\n  \"units\": \"mm\",\n", quoted(part.name));
  if (part.stock) {
    const Stock& stock = *part.stock;
    out += fmt::format("  \"stock\": {{\"x\": [{}, {}], \"y\": [{}, {}], \"z\": [{}, {}]}},\n",
                       number(stock.plan.min.x), number(stock.plan.max.x), number(stock.plan.min.y),
                       number(stock.plan.max.y), number(stock.z_bottom), number(stock.z_top));
  }
  out += "  \"pockets\": [";
  const char* separator = "\n";
  for (const Feature& feature : part.features) {
    if (feature.profile) {
      out += separator + profile_feature_text(feature);
      separator = ",\n";
      continue;
    }
    for (const Region& region : feature.target) {
      out += separator + pocket_text(feature, region);
      separator = ",\n";
    }
  }
  return out + "\n  ]\n}\n";
}

}  // namespace clearcut::post
