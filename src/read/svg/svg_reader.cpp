#include "read/svg/svg_reader.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/text.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/stroke.h"
#include "read/lettering/lettering.h"
#include "read/svg/svg_clip.h"
#include "read/svg/svg_document.h"
#include "read/svg/svg_elements.h"
#include "read/svg/svg_inherited.h"
#include "read/svg/svg_numbers.h"
#include "read/svg/svg_page.h"
#include "read/svg/svg_shapes.h"
#include "read/svg/svg_style.h"
#include "read/svg/svg_text.h"

namespace clearcut::read {
namespace {

/// Elements drawn, with every use counted again: beyond this the drawing is a trap.
constexpr int kMostElements = 1'000'000;

class SvgCollector {
 public:
  SvgCollector(std::string_view text, const std::string& file, const ReadOptions& options,
               Diagnostics& diagnostics)
      : text_(text), file_(file), options_(options), diagnostics_(diagnostics) {}

  void collect(const pugi::xml_node& root) {
    pugi::xml_node too_deep;
    document_ = svg_document_of(root, too_deep);
    if (too_deep) throw InputError(place(too_deep), "elements nested deeper than 200; simplify the drawing");
    if (draws_more_than(kMostElements, root, document_)) refuse_size();
    if (text_.substr(0, text_.find("<svg")).find("<?xml-stylesheet") != std::string_view::npos)
      document_.sheet_understood = false;
    SvgInherited start;
    apply_svg_style(root, document_.sheet, start.style);
    take_svg_geometry(root, start.style);
    start.style = {};
    pixels_ = pixel_size_of(text_, svg_text_of(root, "inkscape:version"));
    const auto said = [&](const char* name) { return std::string(svg_text_of(root, name)); };
    const SvgPage page = page_of(
        {said("width"), said("height"), said("viewBox"), said("preserveAspectRatio")},
        options_.unit ? std::optional(require_unit(*options_.unit, "unit")) : std::nullopt, pixels_.per_inch);
    physical_ = page.physical;
    has_size_ = page.has_size;
    start.map = Affine::scaling(options_.scale, options_.scale) * page.to_mm;
    start.view = {page.view_width, page.view_height};
    take(root, start, 0, true);
  }

  std::vector<DrawnGroup> take_groups() {
    for (DrawnGroup& group : groups_) say_what_strokes_are(group);
    return std::move(groups_);
  }

  /// Throws if no requested layer has shapes.
  void refuse_unknown_layers() const {
    const bool found = std::any_of(groups_.begin(), groups_.end(),
                                   [](const DrawnGroup& group) { return !group.curves.empty(); });
    if (options_.layers.empty() || found || notes_.not_chosen.empty()) return;
    std::string names;
    for (const auto& [name, count] : notes_.not_chosen)
      names += (names.empty() ? "" : ", ") + printable(name);
    throw InputError(file_, "no layer is called '" + printable(options_.layers.front()) +
                                "'; the drawing has the layers " + names);
  }

  void report() const {
    if (!physical_) warn_of_pixels();
    if (!document_.sheet_understood) {
      diagnostics_.doubt(
          file_, kNotAsDrawn,
          "a style sheet has rules that are not read; fills and sizes set by them are not seen");
    }
    lettering_.report(diagnostics_, file_);
    notes_.report(diagnostics_, file_);
  }

 private:
  void warn_of_pixels() const {
    Box all;
    for (const DrawnGroup& group : groups_) {
      for (const RawCurve& curve : group.curves) all.add(box(curve.edges));
    }
    const std::string size = all.empty() ? ""
                                         : "; the drawing is " + trimmed(all.width(), 2) + " x " +
                                               trimmed(all.height(), 2) + " mm then";
    diagnostics_.warn(file_, std::string(has_size_ ? "the file has a size and no viewBox: "
                                                   : "the file states no physical size: ") +
                                 trimmed(pixels_.per_inch, 0) + " px per inch assumed" +
                                 (pixels_.because.empty() ? "" : ", " + pixels_.because) + size);
  }

  std::string place(const pugi::xml_node& node) const {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    const auto line =
        1 + std::count(text_.begin(),
                       text_.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text_.size())), '\n');
    return file_ + ":" + std::to_string(line);
  }

  [[noreturn]] void refuse_size() const {
    throw InputError(file_, "more than 1 million elements with all uses; simplify it");
  }

  void take(const pugi::xml_node& node, const SvgInherited& outer, int depth, bool is_root) {
    if (++count_ > kMostElements) refuse_size();
    if (depth > kDeepestSvg)
      throw InputError(place(node), "uses within uses deeper than 200; the drawing refers to itself");
    const std::string_view name = local_name(node);
    if (is_svg_definition(name)) return;
    SvgInherited own = outer;
    inherit(node, own);
    if (!is_root) check_lengths(node);
    if (!own.style.shown || !own.style.seen) {
      ++notes_.hidden[std::string(name)];
    } else if (name == "svg" && is_root) {
      take_children(node, own, depth);
    } else if (name == "svg") {
      take_viewport(node, own, svg_attribute(node, "width", own.view.width, own.view.width),
                    svg_attribute(node, "height", own.view.height, own.view.height), depth);
    } else if (name == "g" || name == "a") {
      take_children(node, own, depth);
    } else if (name == "switch") {
      take_switch(node, own, depth);
    } else if (name == "use") {
      take_use(node, own, depth);
    } else if (is_svg_shape(name)) {
      take_shape(node, own);
    } else if (name == "text") {
      take_text(node, own);
    } else {
      auto& kind = draws_nothing_to_cut(node) ? notes_.not_read : notes_.shapes_not_read;
      ++kind[std::string(name) + (own.layer.empty() ? "" : " on layer " + own.layer)];
    }
  }

  /// Unreadable lengths would count as absent.
  void check_lengths(const pugi::xml_node& node) const {
    for (const char* name :
         {"x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "x1", "y1", "x2", "y2"}) {
      const std::string_view text = svg_text_of(node, name);
      if (text.empty() || text == "auto" || svg_length(text, 1)) continue;
      const std::string_view element = local_name(node);
      if (is_svg_shape(element) || element == "use" || element == "svg" || element == "symbol")
        throw InputError(place(node), std::string(name) + " '" + printable(text) +
                                          "' is no length that can be read; write it in mm or without unit");
    }
  }

  void take_children(const pugi::xml_node& node, const SvgInherited& own, int depth) {
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element) take(child, own, depth + 1, false);
    }
  }

  /// Draws the first child that requires no extension and no language, like a browser without any of them.
  void take_switch(const pugi::xml_node& node, const SvgInherited& own, int depth) {
    bool taken = false;
    for (const pugi::xml_node& child : node) {
      if (child.type() != pugi::node_element) continue;
      const bool plain = !child.attribute("requiredExtensions") && !child.attribute("systemLanguage");
      if (plain && !taken) {
        take(child, own, depth + 1, false);
      } else {
        ++notes_.hidden[std::string(local_name(child)) + " of a switch"];
      }
      taken = taken || plain;
    }
  }

  /// A nested <svg>, or a <symbol> in use: its own viewBox within a place of the page.
  void take_viewport(const pugi::xml_node& node, SvgInherited own, double width, double height, int depth) {
    const std::string view_box(svg_text_of(node, "viewBox"));
    const Affine place = own.map * Affine::translation({svg_attribute(node, "x", own.view.width, 0),
                                                        svg_attribute(node, "y", own.view.height, 0)});
    own.map =
        place * view_box_map(view_box, std::string(svg_text_of(node, "preserveAspectRatio")), width, height);
    own.view = view_size(view_box, {width, height});
    if (!own.style.overflows) narrow_to_viewport(own, place, width, height, options_.tol);
    take_children(node, own, depth);
  }

  void take_use(const pugi::xml_node& node, SvgInherited own, int depth) {
    const pugi::xml_node used = document_.used_by(node);
    if (!used) {
      throw InputError(place(node),
                       "use of '" + printable(svg_target_of(node)) +
                           "', which the file does not define; copy it into the file, or delete the use");
    }
    own.map = own.map * Affine::translation({svg_attribute(node, "x", own.view.width, 0),
                                             svg_attribute(node, "y", own.view.height, 0)});
    const bool is_svg = local_name(used) == "svg";
    if (local_name(used) != "symbol" && !is_svg) return take(used, own, depth + 1, false);
    if (depth > kDeepestSvg)
      throw InputError(place(node), "uses within uses deeper than 200; the drawing refers to itself");
    inherit(used, own);
    check_lengths(used);
    if (!own.style.shown || !own.style.seen) return leave_out(used);
    // The size in the <use> takes precedence over that of an <svg>.
    const auto size = [&](const char* side, double whole) {
      return svg_attribute(node, side, whole, is_svg ? svg_attribute(used, side, whole, whole) : whole);
    };
    take_viewport(used, own, size("width", own.view.width), size("height", own.view.height), depth + 1);
  }

  void inherit(const pugi::xml_node& node, SvgInherited& own) {
    const std::string problem = inherit_svg(node, document_.sheet, options_, own);
    if (!problem.empty()) throw InputError(place(node), problem);
    if (own.style.masked) ++notes_.not_applied["mask"];
    if (own.style.filtered) ++notes_.filtered;
    if (!clips_.narrow(own)) ++notes_.not_applied["clip-path"];
  }

  void leave_out(const pugi::xml_node& node) { ++notes_.hidden[std::string(local_name(node))]; }

  SvgPathData shape_of(const pugi::xml_node& node, const SvgInherited& own, const Affine& map) const {
    SvgPathData data = svg_shape(node, own.view, map);
    if (!data.error.empty()) throw InputError(place(node), data.error + "; correct it");
    return data;
  }

  void take_shape(const pugi::xml_node& node, const SvgInherited& own) {
    const bool filled = own.style.fills() && local_name(node) != "line";
    const bool stroked = own.style.strokes();
    if (!own.style.visible || (!filled && !stroked)) return leave_out(node);
    DrawnGroup* group = wanted_group(own, filled);
    if (!group) return;
    if (own.style.marked) ++notes_.marked;
    const bool as_area = stroked && options_.stroke_areas.value_or(false);
    std::optional<Compound> compound;
    if (filled)
      compound = Compound{compounds_++, own.style.fill_rule != "evenodd", normal_color(own.style.fill)};
    if (filled || !as_area) add_curves(node, own, compound, *group);
    if (as_area) add_stroke(node, own, compound, *group);
  }

  /// The group for such elements; null, with a count, if they are not to be read.
  DrawnGroup* wanted_group(const SvgInherited& own, bool filled) {
    DrawnGroup& group = group_of(own, filled ? own.style.fill : own.style.stroke);
    const bool chosen = options_.layers.empty() || own.chosen;
    if (!chosen) ++notes_.not_chosen[own.layer.empty() ? "(no layer)" : own.layer];
    if (chosen && group.role == LayerRole::kIgnore) ++notes_.ignored[own.layer];
    return chosen && group.role != LayerRole::kIgnore ? &group : nullptr;
  }

  /// All letters of one element fill an area together.
  void take_text(const pugi::xml_node& node, const SvgInherited& own) {
    if (!options_.text_outlines.value_or(false)) {
      ++notes_.texts_not_read["text" + (own.layer.empty() ? "" : " on layer " + own.layer)];
      if (!own.layer.empty()) group_of(own, own.style.fill);  // so that options may name it
      return;
    }
    SvgText text = read_svg_text(node, own.style, document_.sheet, own.view, own.map, lettering_);
    if (!text.problem.empty()) throw InputError(place(node), text.problem);
    for (const auto& [name, count] : text.left_out) notes_.shapes_not_read[name] += count;
    for (const auto& [name, count] : text.not_applied) notes_.letters_not_so[name] += count;
    const Compound compound{compounds_++, true, normal_color(own.style.fill)};
    bool drawn = false;
    for (SvgTextRun& run : text.runs) {
      const bool filled = run.style.fills();
      std::vector<RawCurve> curves =
          run.loops.take(svg_source(node), filled ? std::optional(compound) : std::nullopt);
      drawn = drawn || !curves.empty();
      if (curves.empty()) continue;
      SvgInherited part = own;
      part.style = run.style;
      if (!run.style.visible || (!filled && !run.style.strokes())) {
        ++notes_.hidden["text"];
      } else if (DrawnGroup* group = wanted_group(part, filled)) {
        if (!filled) ++notes_.stroke_only;
        add_seen(std::move(curves), own, filled ? std::optional(compound) : std::nullopt, "text", *group);
      }
    }
    if (!drawn && text.left_out.empty()) ++notes_.not_read["text without letters"];
  }

  /// Strokes of a group are one area; the stroke of a filled shape is one area with its fill.
  void add_stroke(const pugi::xml_node& node, const SvgInherited& own, const std::optional<Compound>& fill,
                  DrawnGroup& group) {
    if (!svg_length(own.style.stroke_width, 1))
      throw InputError(place(node), "stroke-width '" + printable(own.style.stroke_width) +
                                        "' is no length that can be read; write it in mm or without unit");
    const Pen pen = own.style.pen(own.view.diagonal());
    if (!(pen.width > 0)) {
      ++notes_.hidden[std::string(local_name(node)) + " with a stroke without width"];
    } else if (fill && !fill->nonzero) {
      ++notes_.even_odd_strokes;
    } else {
      if (own.style.dashed) ++notes_.dashed;
      if (own.style.fixed_stroke) ++notes_.fixed_strokes;
      const Compound compound = fill ? *fill : compound_of_strokes(group, own.style);
      const bool clockwise = fill && winding_of(group, compound) < 0;
      const auto lines = [&](const Affine& map) { return shape_of(node, own, map).subpaths; };
      std::vector<RawCurve> pieces;
      for (const Path& piece : stroke_pieces(own.map, pen, lines))
        pieces.push_back(
            {clockwise ? reversed(piece) : piece, true, svg_source(node) + " (stroke)", compound});
      add_seen(std::move(pieces), own, compound, std::string(local_name(node)) + " (stroke)", group);
    }
  }

  /// If the areas of strokes were requested, and there are no other shapes, they are milled. Strokes of one colour
  /// are one area with overlapping fills of this colour.
  void say_what_strokes_are(DrawnGroup& group) const {
    const auto strokes = strokes_.find(group.where);
    if (strokes == strokes_.end()) return;
    const auto& [compound, colors] = strokes->second;
    bool alone = true;
    for (RawCurve& curve : group.curves) {
      const bool is_stroke = curve.compound == compound;
      alone = alone && is_stroke;
      if (is_stroke && colors.size() == 1) curve.compound->paint = *colors.begin();
    }
    group.says_role = group.says_role || alone;
  }

  Compound compound_of_strokes(const DrawnGroup& group, const SvgStyle& style) {
    const auto [found, is_new] = strokes_.try_emplace(group.where);
    auto& [compound, colors] = found->second;
    if (is_new) compound.number = compounds_++;
    colors.insert(normal_color(style.stroke));
    return compound;
  }

  /// mm2, positive if the curves of a compound run counter-clockwise around their fill.
  static double winding_of(const DrawnGroup& group, const Compound& compound) {
    double sum = 0;
    for (const RawCurve& curve : group.curves)
      if (curve.compound == compound) sum += signed_area(curve.edges);
    return sum;
  }

  void add_curves(const pugi::xml_node& node, const SvgInherited& own, const std::optional<Compound>& fill,
                  DrawnGroup& group) {
    SvgPathData data = shape_of(node, own, own.map);
    if (!fill) {
      ++notes_.stroke_only;
      group.has_pens = true;
    }
    if (data.half_point) ++notes_.odd_points;
    if (data.subpaths.empty()) ++notes_.not_read[std::string(local_name(node)) + " without size"];
    std::vector<RawCurve> curves;
    for (Subpath& subpath : data.subpaths)
      curves.push_back({std::move(subpath.edges), fill || subpath.closed, svg_source(node), fill});
    add_seen(std::move(curves), own, fill, std::string(local_name(node)), group);
  }

  /// Adds the parts of areas visible through clip paths and viewports; partly visible lines are read whole. `what`:
  /// name for the list of hidden elements.
  void add_seen(std::vector<RawCurve> curves, const SvgInherited& own, const std::optional<Compound>& fill,
                const std::string& what, DrawnGroup& group) {
    if (fill) {
      const Seen seen = clip_fill(curves, fill->nonzero, own.shown, options_.tol);
      if (seen == Seen::kPart) ++notes_.clipped;
      if (seen == Seen::kNothing) ++notes_.hidden[what];
    }
    for (RawCurve& curve : curves) {
      const Seen seen = fill ? Seen::kWhole : how_much_is_seen(curve.edges, own.shown, options_.tol);
      if (seen == Seen::kPart) ++notes_.clipped_lines;
      if (seen == Seen::kNothing) {
        ++notes_.hidden[what];
      } else {
        group.curves.push_back(std::move(curve));
      }
    }
  }

  DrawnGroup& group_of(const SvgInherited& own, const std::string& color) {
    DrawnGroup group;
    group.name = own.layer.empty() ? "pocket" : own.layer;
    group.where = own.layer.empty() ? file_ : file_ + ": layer " + printable(own.layer);
    group.role = own.role.value_or(LayerRole::kPocket);
    group.says_role = own.role.has_value();
    group.depth = own.depth;
    group.top = own.top;
    group.hole = own.hole;
    group.width = own.width;
    apply_rules(options_.layer_rules, own.layer, group);
    apply_rules(options_.layer_rules, normal_color(color), group);
    const auto key = std::make_tuple(group.name, group.role, group.depth, group.top);
    const auto [found, is_new] = by_key_.try_emplace(key, groups_.size());
    if (is_new) groups_.push_back(std::move(group));
    return groups_[found->second];
  }

  std::string_view text_;
  const std::string& file_;
  const ReadOptions& options_;
  Diagnostics& diagnostics_;
  SvgDocument document_;
  SvgClips clips_{document_, options_};
  PixelSize pixels_;
  bool physical_ = true;
  bool has_size_ = false;
  std::vector<DrawnGroup> groups_;
  std::map<std::tuple<std::string, LayerRole, std::optional<double>, std::optional<double>>, std::size_t>
      by_key_;
  SvgNotes notes_;
  Lettering lettering_;
  int compounds_ = 0;
  /// Strokes of a group are one area: its compound, and the colours.
  std::map<std::string, std::pair<Compound, std::set<std::string>>> strokes_;
  int count_ = 0;
};

}  // namespace

Part read_svg(std::string_view written, const std::string& file_name, const ReadOptions& options) {
  if (written.substr(0, 2) == "\x1f\x8b") {
    throw InputError(file_name, "this is a compressed SVG; save it as plain SVG");
  }
  const auto expanded = with_svg_entities(written, file_name);
  const std::string_view text = expanded ? std::string_view(*expanded) : written;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata);
  if (!parsed) {
    const auto end =
        text.begin() + std::clamp<std::ptrdiff_t>(parsed.offset, 0, static_cast<std::ptrdiff_t>(text.size()));
    throw InputError(file_name + ":" + std::to_string(1 + std::count(text.begin(), end, '\n')),
                     std::string("not SVG (") + parsed.description() + "); mend the text there");
  }
  const pugi::xml_node root = document.document_element();
  if (local_name(root) != "svg")
    throw InputError(file_name, "the outermost element is not <svg>; this is not an SVG drawing");
  Part part;
  part.name = std::filesystem::path(file_name).stem().string();
  part.source_file = file_name;
  SvgCollector collector(text, file_name, options, part.diagnostics);
  collector.collect(root);
  collector.refuse_unknown_layers();
  collector.report();
  std::vector<DrawnGroup> groups = collector.take_groups();
  question_size(groups, file_name, options);
  add_drawn_features(part, std::move(groups), options);
  return part;
}

}  // namespace clearcut::read
