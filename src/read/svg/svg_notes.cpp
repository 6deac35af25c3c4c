#include "read/svg/svg_reader.h"

namespace clearcut::read {
namespace {

struct Said {
  int count;
  const char* what;
};

}  // namespace

void SvgNotes::report(Diagnostics& diagnostics, const std::string& file) const {
  const auto text = [](int count, const std::string& what) { return std::to_string(count) + " " + what; };
  report_left_out(diagnostics, file, texts_not_read,
                  "not read, because letters are no outlines (--text outlines draws them):");
  for (const auto& [property, count] : letters_not_so)
    diagnostics.doubt(
        file, kNotAsDrawn,
        text(count, "text(s) have a " + property + ", which is not applied; turn them into paths"));
  report_left_out(diagnostics, file, not_read, "not read, because they are no outlines:");
  if (const std::string shapes = listed(shapes_not_read); !shapes.empty())
    diagnostics.doubt(
        file, kLeftOut,
        "not read, because they are no outlines: " + shapes + "; draw what of them is to be cut as paths");
  report_left_out(diagnostics, file, hidden, "not read, because they are not displayed:");
  report_left_out(diagnostics, file, not_chosen, "not read, because their layers were not chosen:");
  report_left_out(diagnostics, file, ignored, "not read, because their layers' names say so:");
  for (const auto& [property, count] : not_applied)
    diagnostics.doubt(
        file, kNotAsDrawn,
        text(count, "elements have a " + property +
                        ", which is not applied: what it hides is read too; cut the shapes in the drawing"));
  if (odd_points > 0)
    diagnostics.doubt(
        file, kNotAsDrawn,
        text(odd_points, "lists of points end in half a point, which is left out; correct them"));
  const Said doubts[] = {
      {clipped_lines,
       "lines reach beyond a clip path or a viewport, which hides that; they are read whole: cut them in the "
       "drawing"},
      {even_odd_strokes, "strokes of shapes filled by the even-odd rule do not count; turn them into paths"},
      {dashed, "dashed strokes are read without their gaps; turn them into paths"},
      {fixed_strokes,
       "strokes are not scaled with their shapes (vector-effect), but read as if they were; turn them into "
       "paths"}};
  for (const Said& one : doubts)
    if (one.count > 0) diagnostics.doubt(file, kNotAsDrawn, text(one.count, one.what));
  if (marked > 0)
    diagnostics.doubt(file, kLeftOut,
                      text(marked, "shapes have markers, which are not read; turn them into paths"));
  if (filtered > 0)
    diagnostics.note(file, text(filtered, "elements have a filter, which moves nothing that is read"));
  if (clipped > 0)
    diagnostics.note(
        file, text(clipped, "shapes reach beyond a clip path or a viewport: what that hides is left out"));
  if (stroke_only > 0) {
    diagnostics.note(file,
                     text(stroke_only,
                          "shapes with a stroke and no fill were read as outlines; their stroke's width "
                          "does not count (--strokes areas makes it count)"));
  }
}

}  // namespace clearcut::read
