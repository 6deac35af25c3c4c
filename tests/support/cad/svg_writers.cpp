#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "support/cad/dxf_texts.h"
#include "support/cad/writers.h"

namespace clearcut::test_support {
namespace {

/// A page around a part, y downwards: places on it in user units.
struct Page {
  Box box;          ///< mm
  double unit = 1;  ///< mm

  Vec2 at(Vec2 p) const { return Vec2{p.x - box.min.x, box.max.y - p.y} / unit; }
};

Page page_of(const CadPart& part, double unit) {
  return {part.box().grown(15), unit};
}

std::string text_of(Vec2 p) {
  return fmt::format("{:.6f},{:.6f}", p.x, p.y);
}

/// An arc of up to a quarter of a turn as a Bezier curve; longer ones as several.
std::string bezier_text(const Edge& arc, const Page& page) {
  const int parts = static_cast<int>(std::ceil(std::abs(arc.sweep()) / (kPi / 2) - 1e-9));
  std::string text;
  for (int i = 0; i < parts; ++i) {
    const Edge piece = arc.part(static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts);
    const double reach = 4.0 / 3 * std::tan(std::abs(piece.sweep()) / 4) * piece.radius();
    text += fmt::format(" C {} {} {}", text_of(page.at(piece.from + piece.tangent_at(0) * reach)),
                        text_of(page.at(piece.to - piece.tangent_at(1) * reach)), text_of(page.at(piece.to)));
  }
  return text;
}

/// y points down on the page, so arcs turn the other way.
std::string arc_text(const Edge& arc, const Page& page) {
  const double radius = arc.radius() / page.unit;
  return fmt::format(" A {:.6f} {:.6f} 0 {} {} {}", radius, radius, std::abs(arc.sweep()) > kPi ? 1 : 0,
                     arc.turn == Turn::kClockwise ? 1 : 0, text_of(page.at(arc.to)));
}

enum class Curves { kBezier, kArcs };

std::string path_data(const Loop& loop, const Page& page, Curves curves) {
  std::string text = "M " + text_of(page.at(loop.front().from));
  for (const Edge& edge : loop) {
    text += !edge.is_arc()              ? " L " + text_of(page.at(edge.to))
            : curves == Curves::kBezier ? bezier_text(edge, page)
                                        : arc_text(edge, page);
  }
  return text + " Z";
}

/// The page's size in `suffix` units of `page.unit` mm, and the viewBox in the same.
std::string svg_head(const Page& page, const std::string& suffix, const std::string& more) {
  const double width = page.box.width() / page.unit, height = page.box.height() / page.unit;
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" {3}width=\"{0:.6f}{2}\" height=\"{1:.6f}{2}\" "
      "viewBox=\"0 0 {0:.6f} {1:.6f}\">\n",
      width, height, suffix, more);
}

std::string circle_text(const CadShape& shape, const Page& page, const std::string& attributes) {
  const Vec2 center = page.at(shape.center);
  return fmt::format("<circle {} cx=\"{:.6f}\" cy=\"{:.6f}\" r=\"{:.6f}\"/>\n", attributes, center.x,
                     center.y, *shape.diameter / 2 / page.unit);
}

std::string shape_text(const CadShape& shape, const Page& page, Curves curves,
                       const std::string& attributes) {
  if (shape.diameter && curves == Curves::kBezier) return circle_text(shape, page, attributes);
  return fmt::format("<path {} d=\"{}\"/>\n", attributes, path_data(shape.outline, page, curves));
}

const char* group_name(CadShapeKind kind, const char* plate, const char* pocket, const char* hole) {
  return kind == CadShapeKind::kPlate ? plate : kind == CadShapeKind::kPocket ? pocket : hole;
}

constexpr CadShapeKind kKinds[] = {CadShapeKind::kHole, CadShapeKind::kPlate, CadShapeKind::kPocket};

}  // namespace

CadDrawing inkscape_drawing(const CadPart& part, Random& random) {
  const bool named = random.below(3) > 0, old = random.below(3) == 0;
  Page page = page_of(part, old ? 25.4 / 90 : 1);
  // Layers are moved, and what is in them moved back.
  const Vec2 aside{random.between(-50, 50), random.between(-90, 90)};
  const std::string xmlns =
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\" version=\"1.1\" " +
      std::string(old ? "inkscape:version=\"0.91 r13725\" " : "inkscape:version=\"1.2.2 (b0a8486541)\" ");
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n" +
                     svg_head(page, old ? "" : "mm", xmlns) +
                     "<sodipodi:namedview id=\"base\" inkscape:document-units=\"mm\" showgrid=\"false\"/>\n"
                     "<defs id=\"defs2\"/>\n";
  for (const CadShapeKind kind : kKinds) {
    const char* label = named ? group_name(kind, "Profile D6", "Pocket D3", "Drill D6") : "Layer 1";
    text += fmt::format(
        "<g inkscape:groupmode=\"layer\" inkscape:label=\"{}\" id=\"layer{}\" transform=\"translate({})\">\n",
        label, static_cast<int>(kind), text_of(aside));
    for (const CadShape& shape : part.shapes) {
      if (shape.kind != kind) continue;
      text += shape_text(shape, page, Curves::kBezier,
                         fmt::format("style=\"fill:none;stroke:#000000;stroke-width:0.2\" "
                                     "transform=\"translate({})\"",
                                     text_of(-aside)));
    }
    text += "</g>\n";
  }
  return {"inkscape.svg", text + "</svg>\n", named};
}

CadDrawing illustrator_drawing(const CadPart& part, Random& random) {
  const bool named = random.below(3) > 0;
  const Page page = page_of(part, 25.4 / 72);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
      "<!-- Generator: Adobe Illustrator 26.0.1, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->\n" +
      svg_head(page, random.below(2) == 0 ? "px" : "",
               "version=\"1.1\" id=\"Layer_1\" x=\"0px\" y=\"0px\" ") +
      "<style type=\"text/css\">\n\t.st0{fill:none;stroke:#ED1C24;stroke-width:0.25;stroke-miterlimit:10;}\n"
      "</style>\n";
  for (const CadShapeKind kind : kKinds) {
    const char* id = named ? group_name(kind, "PROFILE_x5F_D6", "POCKET_x5F_D3", "DRILL_x5F_D6") : "Artwork";
    text += fmt::format("<g id=\"{}\">\n", id);
    for (const CadShape& shape : part.shapes) {
      if (shape.kind == kind) text += shape_text(shape, page, Curves::kBezier, "class=\"st0\"");
    }
    text += "</g>\n";
  }
  return {"illustrator.svg", text + "</svg>\n", named};
}

CadDrawing kicad_drawing(const CadPart& part, Random& random) {
  if (random.below(2) == 0) return {"kicad-Edge_Cuts.dxf", kicad_dxf(part, random)};
  const Page page = page_of(part, 1);
  std::string text = svg_head(page, "mm", "version=\"1.1\" ") +
                     "<title>SVG Image created as kicad-Edge_Cuts.svg</title>\n"
                     "<g style=\"fill:none; stroke:#000000; stroke-width:0.1; stroke-opacity:1; "
                     "stroke-linecap:round; stroke-linejoin:round;\">\n";
  for (const CadShape& shape : part.shapes) {
    if (shape.diameter) {
      text += circle_text(shape, page, "");
      continue;
    }
    for (const Edge& edge : shape.outline) {
      const Edge drawn = random.below(2) == 0 ? edge : edge.reversed();
      text += "<path d=\"M " + text_of(page.at(drawn.from)) + "\n" +
              (drawn.is_arc() ? arc_text(drawn, page) : " L " + text_of(page.at(drawn.to))) + "\"/>\n";
    }
  }
  return {"kicad-Edge_Cuts.svg", text + "</g>\n</svg>\n"};
}

CadDrawing openscad_drawing(const CadPart& part, Random& random) {
  const int fragments = random.below(2) == 0 ? 48 : 100;  // $fn
  std::vector<std::vector<Vec2>> polygons;
  for (const CadShape& shape : part.shapes) {
    auto& points = polygons.emplace_back();
    for (const Edge& edge : shape.outline) {
      const int count =
          std::max(1, static_cast<int>(std::round(std::abs(edge.sweep()) / (2 * kPi) * fragments)));
      for (int i = 0; i < count; ++i) points.push_back(edge.at(static_cast<double>(i) / count));
    }
    // Holes run the other way round, so that the fill leaves them out.
    if (shape.kind != CadShapeKind::kPlate) std::reverse(points.begin(), points.end());
  }
  CadDrawing drawing{"openscad.dxf", "", false, false, false};
  if (random.below(2) == 0) {
    drawing.text = openscad_dxf(polygons);
    return drawing;
  }
  const Box box = part.box();
  std::string data;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      data += fmt::format("{} {:.6g},{:.6g} ", i == 0 ? "M" : "L", polygon[i].x, -polygon[i].y);
    data += "z\n";
  }
  drawing.file = "openscad.svg";
  drawing.text = fmt::format(
      "<?xml version=\"1.0\" standalone=\"no\"?>\n<svg width=\"{:.6g}mm\" height=\"{:.6g}mm\" "
      "viewBox=\"{:.6g} {:.6g} {:.6g} {:.6g}\" xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\">\n"
      "<title>OpenSCAD Model</title>\n<path d=\"{}\" stroke=\"black\" fill=\"lightgray\" "
      "stroke-width=\"0.5\"/></svg>\n",
      box.width(), box.height(), box.min.x, -box.max.y, box.width(), box.height(), data);
  return drawing;
}

}  // namespace clearcut::test_support
