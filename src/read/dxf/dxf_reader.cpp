#include "read/dxf/dxf_reader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <span>

#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/drawing/drawn_features.h"
#include "read/drawing/stroke.h"
#include "read/dxf/dxf_curves.h"
#include "read/dxf/dxf_text.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

constexpr int kDeepestBlocks = 16;
/// Units of the drawing. Heights differing by less are equal.
constexpr double kFlat = 1e-6;
/// mm; lines this near to the boundary of a fill are drawn along it.
constexpr double kOnLine = 0.05;
/// Edges of a boundary that are looked for among the lines.
constexpr std::size_t kSamplesOfBoundary = 8;
/// Entities after all blocks are put in place: beyond this the drawing is a trap.
constexpr int kMostEntities = 2'000'000;

/// Kinds of entities that only annotate the drawing: dimensions, notes, views, pictures, construction lines. All
/// other unread entities may be part of the work.
constexpr std::array<std::string_view, 28> kAnnotations{"DIMENSION",
                                                        "ARC_DIMENSION",
                                                        "LARGE_RADIAL_DIMENSION",
                                                        "LEADER",
                                                        "MULTILEADER",
                                                        "MLEADER",
                                                        "TOLERANCE",
                                                        "ATTDEF",
                                                        "RTEXT",
                                                        "ARCALIGNEDTEXT",
                                                        "ACAD_TABLE",
                                                        "VIEWPORT",
                                                        "IMAGE",
                                                        "WIPEOUT",
                                                        "OLEFRAME",
                                                        "OLE2FRAME",
                                                        "PDFUNDERLAY",
                                                        "DGNUNDERLAY",
                                                        "DWFUNDERLAY",
                                                        "POINT",
                                                        "XLINE",
                                                        "RAY",
                                                        "LIGHT",
                                                        "SUN",
                                                        "CAMERA",
                                                        "SECTION",
                                                        "POINTCLOUD",
                                                        "GEOPOSITIONMARKER"};

bool is_annotation(std::string_view dxf_type) {
  return std::find(kAnnotations.begin(), kAnnotations.end(), dxf_type) != kAnnotations.end();
}

/// Curves by layer while a document is walked through.
class Collector {
 public:
  Collector(const DxfDocument& document, const ReadOptions& options, double unit, Diagnostics& diagnostics)
      : document_(document),
        options_(options),
        unit_(unit),
        diagnostics_(diagnostics),
        lettering_(document) {}

  void collect() {
    walk(document_.entities, Affine::scaling(unit_, unit_), "0", 0);
    for (const auto& [layer, band] : bands_) say_what_bands_are(groups_[by_layer_.at(layer)], band);
    take_fills();
  }

  /// Layers without read entities have empty groups, so that options may name them.
  std::vector<DrawnGroup> take() {
    for (const auto& [key, name] : unread_)
      if (by_layer_.count(key) == 0) groups_.push_back(new_group(name));
    return std::move(groups_);
  }

  /// A requested but missing layer is always a mistake.
  void refuse_unknown_layers() const {
    for (const std::string& pattern : options_.layers) {
      const auto hit = [&](const auto& layer) { return matches(pattern, layer.second); };
      if (std::any_of(seen_.begin(), seen_.end(), hit)) continue;
      std::string names;
      for (const auto& [key, name] : seen_) names += (names.empty() ? "" : ", ") + printable(name);
      throw InputError(document_.file, "no layer is called '" + printable(pattern) +
                                           "'; the drawing has the layers " +
                                           (names.empty() ? "of no outlines" : names));
    }
  }

  /// Warns of ignored spaces and pen widths.
  void warn_of_space() const {
    if (risen_ > 0) {
      diagnostics_.doubt(document_.file, kNotAsDrawn,
                         std::to_string(risen_) +
                             " curve(s) rise or fall: their heights are not read, they are taken as "
                             "flat outlines cut to the depth given");
    }
    const auto [low, high] = heights_;
    if (risen_ == 0 && high - low > kFlat) {
      diagnostics_.warn(document_.file, "outlines lie at heights from " + trimmed(low * unit_, 4) + " to " +
                                            trimmed(high * unit_, 4) +
                                            " mm: heights are not read, all are cut to the depth given");
    }
    tell_widths();
  }

  /// Widths are a question until --strokes answers it, except on layers where the cutter follows the line.
  void tell_widths() const {
    const std::string wide =
        std::to_string(wide_) + " polyline(s) have a width and are read as their middle lines";
    if (wide_ > 0 && options_.stroke_areas)
      diagnostics_.note(document_.file, wide);
    else if (wide_ > 0)
      diagnostics_.doubt(document_.file, kNotAsDrawn,
                         wide +
                             ": say --strokes areas if they are meant as wide as they are drawn, --strokes "
                             "lines if their middle lines are meant");
    if (tapered_ > 0)
      diagnostics_.doubt(document_.file, kNotAsDrawn,
                         std::to_string(tapered_) +
                             " polyline(s) have a width that changes along the line and are read as their "
                             "middle lines: draw the edges of what they cover");
    if (followed_ > 0)
      diagnostics_.note(document_.file, std::to_string(followed_) +
                                            " polyline(s) have a width, which does not count where the "
                                            "cutter follows the line");
  }

  void report() const {
    warn_of_space();
    for (const auto& [block, count] : clipped_)
      diagnostics_.doubt(
          document_.file, kNotAsDrawn,
          "the block '" + printable(block) + "' is clipped (XCLIP) at " + std::to_string(count) +
              (count == 1 ? " place" : " places") +
              ", which is not applied: it is read whole; trim it where it stands, or switch the "
              "clip off if all of it is meant");
    if (!unplotted_.empty())
      diagnostics_.note(document_.file, "read, though not plotted: the layer(s) " + unplotted_ +
                                            " (--op ignore:LAYER leaves one out)");
    report_left_out(diagnostics_, document_.file, not_read_, "not read, because they are no outlines:");
    if (const std::string shapes = listed(shapes_not_read_); !shapes.empty())
      diagnostics_.doubt(
          document_.file, kLeftOut,
          "not read, because they are no outlines: " + shapes +
              "; draw what of them is to be cut as outlines (--op ignore:LAYER says that none is)");
    lettering_.report(diagnostics_);
    report_left_out(diagnostics_, document_.file, texts_not_read_,
                    "not read, because letters are no outlines (--text outlines draws them):");
    report_left_out(
        diagnostics_, document_.file, fills_not_read_,
        "not read, because lines are drawn elsewhere (--op pocket:LAYER reads the boundaries of fills):");
    if (const std::string drawings = listed(external_); !drawings.empty())
      diagnostics_.doubt(
          document_.file, kLeftOut,
          "not read, because they are drawings in files of their own (bind them, then export again): " +
              drawings);
    report_left_out(diagnostics_, document_.file, hidden_,
                    "not read, because their layers are off or frozen, or they are invisible:");
    report_left_out(diagnostics_, document_.file, not_chosen_,
                    "not read, because their layers were not chosen:");
    report_left_out(diagnostics_, document_.file, ignored_, "not read, because their layers' names say so:");
  }

 private:
  void walk(const std::vector<DxfEntity>& entities, const Affine& map, const std::string& layer_of_zero,
            int depth) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
      const DxfEntity& entity = entities[i];
      std::size_t last = i;
      if (entity.type == "POLYLINE" || entity.type == "INSERT") {
        while (last + 1 < entities.size() &&
               (entities[last + 1].type == "VERTEX" || entities[last + 1].type == "ATTRIB")) {
          ++last;
        }
      }
      take_entity(entity, std::span(entities).subspan(i + 1, last - i), map, layer_of_zero, depth);
      i = last;
    }
  }

  void take_entity(const DxfEntity& entity, std::span<const DxfEntity> followers, const Affine& map,
                   const std::string& layer_of_zero, int depth) {
    if (entity.type == "SEQEND" || entity.type.empty()) return;
    if (++count_ > kMostEntities) {
      throw InputError(document_.file,
                       "more than 2 million entities with all blocks in place; simplify the drawing");
    }
    const bool is_paper = document_.integer(entity, 67, 0) == 1;
    const std::string own(entity.text(8, "0"));
    const std::string layer = own == "0" ? layer_of_zero : own;
    if (is_paper) {
      leave_out(std::string(entity.type) + " of the paper layout", layer);
    } else if (is_hidden(entity, layer)) {
      unread_.try_emplace(capitals(layer), layer);
      ++hidden_[layer];
    } else if (entity.type == "INSERT") {
      for (const DxfEntity& attribute : followers) take_attribute(attribute, map, layer);
      insert(entity, map, layer, depth);
    } else if (is_fill(entity.type)) {
      keep_fill(entity, map, layer);
    } else if (is_text(entity.type)) {
      take_text(entity, map, layer);
    } else if (!is_curve(entity.type)) {
      if (is_annotation(entity.type)) {
        leave_out(std::string(entity.type), layer);
      } else {
        leave_out_shape(std::string(entity.type), layer);
      }
    } else {
      take_curve(entity, followers, map, layer);
    }
  }

  void leave_out(const std::string& what, const std::string& layer) {
    unread_.try_emplace(capitals(layer), layer);
    ++not_read_[layer == "0" ? what : what + " on layer " + layer];
  }

  /// Counts a shape left out that may be part of the work.
  void leave_out_shape(const std::string& what, const std::string& layer) {
    const bool counts = is_chosen(layer) && new_group(layer).role != LayerRole::kIgnore;
    if (!counts) return leave_out(what, layer);
    unread_.try_emplace(capitals(layer), layer);
    ++shapes_not_read_[layer == "0" ? what : what + " on layer " + layer];
  }

  /// Text of a block's instance in addition to its drawing: a part's number.
  void take_attribute(const DxfEntity& attribute, const Affine& map, const std::string& layer_of_zero) {
    constexpr int kInvisible = 1;
    const std::string own(attribute.text(8, "0"));
    const std::string& layer = own == "0" ? layer_of_zero : own;
    if (attribute.type != "ATTRIB") {
      leave_out(std::string(attribute.type), layer);
    } else if (is_hidden(attribute, layer) || (document_.integer(attribute, 70, 0) & kInvisible)) {
      ++hidden_[layer];
    } else {
      take_text(attribute, map, layer);
    }
  }

  void take_text(const DxfEntity& entity, const Affine& map, const std::string& layer) {
    const std::string type(entity.type);
    if (!options_.text_outlines.value_or(false)) {
      unread_.try_emplace(capitals(layer), layer);
      ++texts_not_read_[layer == "0" ? type : type + " on layer " + layer];
    } else if (is_wanted(layer)) {
      auto letters = lettering_.letters_of(entity, map, Compound{compounds_++, true});
      if (!letters) return leave_out(type + " that is not flat", layer);
      if (letters->empty()) return leave_out(type + " without letters", layer);
      auto& curves = group_of(layer).curves;
      std::move(letters->begin(), letters->end(), std::back_inserter(curves));
    }
  }

  bool is_chosen(const std::string& layer) const {
    return options_.layers.empty() || std::any_of(options_.layers.begin(), options_.layers.end(),
                                                  [&](const std::string& p) { return matches(p, layer); });
  }
  bool is_hidden(const DxfEntity& entity, const std::string& layer) const {
    if (document_.integer(entity, 60, 0) == 1) return true;
    const auto found = document_.layers.find(capitals(layer));
    if (found == document_.layers.end()) return false;
    const bool named = !options_.layers.empty() && is_chosen(layer);
    const bool off = document_.integer(found->second, 62, 7) < 0;
    const bool frozen = document_.integer(found->second, 70, 0) & 1;
    return (off || frozen) && !named;
  }

  void take_curve(const DxfEntity& entity, std::span<const DxfEntity> followers, const Affine& map,
                  const std::string& layer) {
    if (!is_wanted(layer)) return;
    DrawnGroup& group = group_of(layer);
    auto curve = curve_of(document_, entity, followers, map);
    if (!curve) {
      leave_out_shape(std::string(entity.type) + " that is not flat or has no points", layer);
    } else if (curve->edges.empty()) {
      leave_out(std::string(entity.type) + " without length", layer);
    } else {
      note_heights(entity, followers);
      if (const DxfWidth width = width_of(document_, entity, followers); width.widest > 0) {
        if (count_width(width, group)) return take_band(entity, followers, map, *width.constant, group);
      }
      group.curves.push_back(std::move(*curve));
    }
  }

  /// Whether the polyline is to be read as wide as it is drawn.
  bool count_width(const DxfWidth& width, DrawnGroup& group) {
    if (group.role == LayerRole::kEngrave || group.role == LayerRole::kTSlot) {
      ++followed_;
    } else if (options_.stroke_areas.value_or(false)) {
      if (width.constant) return true;
      ++tapered_;
    } else {
      ++wide_;
      group.has_pens = true;
    }
    return false;
  }

  /// The area that a polyline of one width covers: ends cut square at its ends, mitred corners. Those of a layer are one area.
  void take_band(const DxfEntity& entity, std::span<const DxfEntity> followers, const Affine& map,
                 double width, DrawnGroup& group) {
    const auto lines = [&](const Affine& at) {
      const auto curve = curve_of(document_, entity, followers, at);
      return std::vector<Subpath>{{curve->edges, curve->closed}};
    };
    const auto [band, is_new] = bands_.try_emplace(capitals(group.name), Compound{compounds_, true});
    if (is_new) ++compounds_;
    const std::string source = std::string(entity.type) + " at line " + std::to_string(entity.line);
    for (Path& piece : stroke_pieces(map, Pen{.width = width}, lines))
      group.curves.push_back({std::move(piece), true, source + " (as wide as drawn)", band->second});
  }

  /// A layer that holds nothing else is milled without a question.
  static void say_what_bands_are(DrawnGroup& group, const Compound& band) {
    const auto is_band = [&](const RawCurve& curve) { return curve.compound == band; };
    group.says_role = group.says_role || std::all_of(group.curves.begin(), group.curves.end(), is_band);
  }

  /// Whether entities of a layer are to be read; counts the entity if not.
  bool is_wanted(const std::string& layer) {
    seen_.try_emplace(capitals(layer), layer);
    if (!is_chosen(layer)) {
      ++not_chosen_[layer];
      return false;
    }
    const auto [role, is_new] = roles_.try_emplace(capitals(layer), LayerRole::kPocket);
    // Ignored layers have empty groups, so that options may name them.
    if (is_new) role->second = group_of(layer).role;
    if (role->second == LayerRole::kIgnore) ++ignored_[layer];
    return role->second != LayerRole::kIgnore;
  }

  /// A filled area; only after reading everything it is known whether its boundary is an outline.
  struct Fill {
    const DxfEntity* entity;
    Affine map;
    std::string layer;
  };

  void keep_fill(const DxfEntity& entity, const Affine& map, const std::string& layer) {
    if (is_wanted(layer)) fills_[capitals(layer)].push_back({&entity, map, layer});
  }

  /// The boundaries of fills are outlines if their layer has no lines, and the layer's role is stated or the drawing
  /// has no lines at all. Otherwise they show areas bounded by lines, or are decoration; on a layer with a stated role,
  /// a fill that no lines bound may be part of the work.
  void take_fills() {
    const auto has_curves = [](const DrawnGroup& group) { return !group.curves.empty(); };
    const bool lines = std::any_of(groups_.begin(), groups_.end(), has_curves);
    for (auto& [key, fills] : fills_) {
      const bool beside_lines = by_layer_.count(key) > 0 && has_curves(groups_[by_layer_.at(key)]);
      const bool says_role = new_group(fills.front().layer).says_role;
      const bool taken = !beside_lines && (!lines || says_role);
      for (const Fill& fill : fills) {
        const std::string type(fill.entity->type);
        if (taken) {
          take_fill(fill);
        } else if (beside_lines && says_role && !is_bounded_by_lines(fill)) {
          leave_out_shape(type + " that no lines bound", fill.layer);
        } else if (beside_lines) {
          leave_out(type, fill.layer);
        } else {
          ++fills_not_read_[type + " on layer " + fill.layer];
        }
      }
    }
  }

  /// Whether lines are drawn along the boundaries of a fill: at the middles of some of their edges.
  bool is_bounded_by_lines(const Fill& fill) const {
    const auto boundaries = boundaries_of(document_, *fill.entity, fill.map);
    if (!boundaries) return true;
    return std::all_of(boundaries->begin(), boundaries->end(), [&](const RawCurve& curve) {
      const std::size_t step = 1 + curve.edges.size() / kSamplesOfBoundary;
      for (std::size_t i = 0; i < curve.edges.size(); i += step)
        if (!is_drawn(curve.edges[i].at(0.5))) return false;
      return true;
    });
  }

  bool is_drawn(Vec2 p) const {
    const auto leads_through = [&](const Edge& edge) {
      return edge.box().grown(kOnLine).contains(p) && distance(nearest_point(edge, p), p) <= kOnLine;
    };
    return std::any_of(groups_.begin(), groups_.end(), [&](const DrawnGroup& group) {
      return std::any_of(group.curves.begin(), group.curves.end(), [&](const RawCurve& curve) {
        return std::any_of(curve.edges.begin(), curve.edges.end(), leads_through);
      });
    });
  }

  void take_fill(const Fill& fill) {
    auto boundaries = boundaries_of(document_, *fill.entity, fill.map);
    if (!boundaries) return leave_out(std::string(fill.entity->type) + " without boundary", fill.layer);
    auto& curves = group_of(fill.layer).curves;
    for (RawCurve& curve : *boundaries) {
      curve.compound = Compound{compounds_, false};
      curves.push_back(std::move(curve));
    }
    ++compounds_;
  }

  /// Notes the heights of a curve as written, in any block.
  void note_heights(const DxfEntity& entity, std::span<const DxfEntity> followers) {
    std::vector<double> heights;
    const bool light = entity.type == "LWPOLYLINE", line = entity.type == "LINE";
    const bool of_drawing = line || entity.type == "SPLINE" || entity.type == "ELLIPSE";
    const double up = !of_drawing && document_.number(entity, 230, 1) < 0 ? -1 : 1;
    const auto add = [&](const DxfEntity& one) {
      for (const DxfGroup& group : one.groups)
        if (light ? group.code == 38 : group.code == 30 || (group.code == 31 && line))
          heights.push_back(up * document_.number(group));
    };
    if (followers.empty()) add(entity);
    for (const DxfEntity& vertex : followers) add(vertex);
    if (heights.empty()) heights.push_back(0);
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (*high - *low > kFlat) ++risen_;
    if (!any_height_) heights_ = {*low, *high};
    any_height_ = true;
    heights_ = {std::min(heights_[0], *low), std::max(heights_[1], *high)};
  }

  DrawnGroup& group_of(const std::string& layer) {
    const auto [found, is_new] = by_layer_.try_emplace(capitals(layer), groups_.size());
    if (is_new) {
      groups_.push_back(new_group(layer));
      if (groups_.back().role != LayerRole::kIgnore) note_unplotted(layer);
    }
    return groups_[found->second];
  }
  /// Curves on unplotted layers are often construction.
  void note_unplotted(const std::string& layer) {
    const auto found = document_.layers.find(capitals(layer));
    if (found == document_.layers.end() || document_.integer(found->second, 290, 1) != 0) return;
    unplotted_ += (unplotted_.empty() ? "" : ", ") + printable(layer);
  }
  DrawnGroup new_group(const std::string& layer) const {
    DrawnGroup group;
    group.name = layer;
    group.where = document_.file + ": layer " + printable(layer);
    const LayerMeaning meaning = meaning_of_layer(layer);
    group.role = meaning.role;
    group.says_role = meaning.says_role;
    if (meaning.depth) group.depth = *meaning.depth * (meaning.depth_in_mm ? 1 : unit_);
    if (meaning.top) group.top = *meaning.top * unit_;
    if (meaning.start) group.start = *meaning.start * unit_;
    if (meaning.width) group.width = *meaning.width * unit_;
    group.hole = scaled(meaning.hole, unit_);
    apply_rules(options_.layer_rules, layer, group);
    return group;
  }

  /// Puts a block in place, in rows and columns if stated by the INSERT.
  void insert(const DxfEntity& entity, const Affine& map, const std::string& layer, int depth) {
    const std::string name = capitals(entity.text(2));
    const auto block = document_.blocks.find(name);
    if (block == document_.blocks.end()) {
      document_.fail(entity.line,
                     "INSERT of the block '" + printable(name) +
                         "', which the file does not define; bind the reference it stands for, or delete it");
    }
    if (block->second.external && block->second.entities.empty()) {
      ++external_[block->second.path.empty() ? name : std::string(block->second.path)];
      return;
    }
    if (depth >= kDeepestBlocks) {
      document_.fail(entity.line,
                     "blocks within blocks deeper than 16; '" + printable(name) + "' may contain itself");
    }
    if (document_.clipped.contains(entity.text(5))) ++clipped_[name];
    const auto own = entity_map(document_, entity);
    if (!own) {
      leave_out_shape("INSERT that is not parallel to the plane", layer);
      return;
    }
    const int columns = std::max(1, document_.integer(entity, 70, 1)),
              rows = std::max(1, document_.integer(entity, 71, 1));
    const double dx = document_.number(entity, 44, 0), dy = document_.number(entity, 45, 0);
    const Affine turn = Affine::rotation(Radians::of_degrees(document_.number(entity, 50, 0)).radians());
    const Affine place =
        *own * Affine::translation({document_.required(entity, 10), document_.required(entity, 20)});
    const Affine scale = Affine::scaling(document_.number(entity, 41, 1), document_.number(entity, 42, 1)) *
                         Affine::translation(-block->second.base);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        if (++count_ > kMostEntities)
          document_.fail(entity.line, "too many copies of a block; simplify the drawing");
        const Affine shift = Affine::translation({column * dx, row * dy});
        walk(block->second.entities, map * place * turn * shift * scale, layer, depth + 1);
      }
    }
  }

  const DxfDocument& document_;
  const ReadOptions& options_;
  const double unit_;
  Diagnostics& diagnostics_;
  std::vector<DrawnGroup> groups_;
  std::map<std::string, std::size_t> by_layer_;
  std::map<std::string, LayerRole> roles_;
  std::map<std::string, std::vector<Fill>> fills_;  ///< fills by layers' names in capitals
  int compounds_ = 0;                               ///< fills and texts
  DxfLettering lettering_;
  LeftOut fills_not_read_, texts_not_read_;
  LeftOut clipped_;  ///< places of blocks, by their names
  LeftOut not_read_, external_, hidden_, not_chosen_, ignored_;
  LeftOut shapes_not_read_;                    ///< unread shapes that may be part of the work
  std::map<std::string, std::string> seen_;    ///< layers with curves, as written, by their names in capitals
  std::map<std::string, std::string> unread_;  ///< likewise layers with unread entities
  int risen_ = 0;                              ///< curves with varying height
  std::array<double, 2> heights_{};            ///< lowest and highest, in units of the drawing
  bool any_height_ = false;
  std::string unplotted_;                  ///< names of layers
  int wide_ = 0;                           ///< polylines of a width that is not asked to count
  int tapered_ = 0;                        ///< the same of a width that cannot count, because it changes
  int followed_ = 0;                       ///< the same that the cutter follows
  std::map<std::string, Compound> bands_;  ///< areas of wide polylines by layer
  int count_ = 0;
};

/// mm per unit of the drawing, 0 if stated neither by the user nor by the file.
double stated_unit(const DxfDocument& document, const ReadOptions& options) {
  if (options.unit) return require_unit(*options.unit, "unit");
  const auto variable = document.header.find("$INSUNITS");
  return variable == document.header.end() ? 0 : mm_of_insunits(document.integer(variable->second, 70, 0));
}

/// Warns of the assumed unit, with the resulting size, so that a wrong assumption is visible.
void warn_of_assumed_unit(const std::string& file, const std::vector<DrawnGroup>& groups,
                          Diagnostics& diagnostics) {
  Box all;
  for (const DrawnGroup& group : groups) {
    for (const RawCurve& curve : group.curves) all.add(box(curve.edges));
  }
  std::string size;
  if (!all.empty()) {
    const auto by = [](double w, double h) { return trimmed(w, 2) + " x " + trimmed(h, 2); };
    size = "; the drawing is " + by(all.width(), all.height()) + " mm then (inch would give " +
           by(all.width() * 25.4, all.height() * 25.4) + " mm)";
  }
  diagnostics.warn(file, "the file names no unit ($INSUNITS): millimetres assumed" + size);
}

}  // namespace

Part read_dxf(std::string_view text, const std::string& file_name, const ReadOptions& options) {
  const DxfDocument document = parse_dxf(text, file_name);
  Part part;
  part.name = std::filesystem::path(file_name).stem().string();
  part.source_file = file_name;
  const double stated = stated_unit(document, options);
  Collector collector(document, options, (stated > 0 ? stated : 1) * options.scale, part.diagnostics);
  collector.collect();
  collector.refuse_unknown_layers();
  std::vector<DrawnGroup> groups = collector.take();
  if (!(stated > 0)) warn_of_assumed_unit(file_name, groups, part.diagnostics);
  collector.report();
  question_size(groups, file_name, options);
  add_drawn_features(part, std::move(groups), options);
  return part;
}

}  // namespace clearcut::read
