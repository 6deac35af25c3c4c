// Drawings of flat parts with the habits of eight CADs: units, header variables, entities, layers, small faults.
#pragma once

#include "support/cad/cad_part.h"

namespace clearcut::test_support {

/// Paths with Bezier curves instead of arcs in layers that are groups, moved by transforms; mm by the viewBox.
CadDrawing inkscape_drawing(const CadPart& part, Random& random);
/// 72 px per inch and no unit, style classes, names of layers with escaped characters.
CadDrawing illustrator_drawing(const CadPart& part, Random& random);
/// Loose lines, arcs and splines in any order and direction, in the document's unit; sheets with the layers
/// OUTER_PROFILES and INTERIOR_PROFILES.
CadDrawing fusion_drawing(const CadPart& part, Random& random);
/// Loose lines and arcs, fillets as rational splines, on layer 0; notes, and ends that miss each other by a little.
CadDrawing solidworks_drawing(const CadPart& part, Random& random);
/// Polylines with bulges, holes as inserts of a block, named layers, dimensions and texts; lines drawn twice.
CadDrawing librecad_drawing(const CadPart& part, Random& random);
/// Old polylines with vertices, no unit, objects' names as layers.
CadDrawing freecad_drawing(const CadPart& part, Random& random);
/// Edge.Cuts of a board: loose segments in inches (DXF), or one path each in mm (SVG); segments drawn twice.
CadDrawing kicad_drawing(const CadPart& part, Random& random);
/// Polygons of six digits: lines (DXF), or one filled path with y upside down (SVG).
CadDrawing openscad_drawing(const CadPart& part, Random& random);

}  // namespace clearcut::test_support
