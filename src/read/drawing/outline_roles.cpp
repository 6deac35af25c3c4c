#include "read/drawing/outline_roles.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "read/common/text.h"
#include "read/drawing/layer_rules.h"
#include "read/repair/meetings.h"

namespace clearcut::read {
namespace {

/// One closed outline among all of a drawing.
struct Outline {
  Loop loop;
  std::size_t group = 0;
  std::size_t drawn_in = 0;  ///< the group at first
  std::vector<int> about;    ///< outlines around it, from the largest
  /// The outline itself, if it crosses itself or another: it then has no nesting.
  std::optional<CrossingOutline> crossing = {};
};

/// What rules sort: outlines into groups. References are kept.
struct Sorting {
  std::vector<Outline>& outlines;
  std::vector<ShapedGroup>& groups;
  const ReadOptions& options;
  Diagnostics& diagnostics;
};

std::vector<Outline> outlines_of(const std::vector<ShapedGroup>& groups) {
  std::vector<Outline> outlines;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const Region& region : groups[i].regions) {
      outlines.push_back({region.outer(), i, i, {}});
      for (const Loop& island : region.islands()) outlines.push_back({island, i, i, {}});
    }
  }
  std::vector<Loop> loops;
  for (const Outline& outline : outlines) loops.push_back(outline.loop);
  const auto about = loops_about(loops);
  for (std::size_t i = 0; i < outlines.size(); ++i) outlines[i].about = about[i];
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const CrossingOutline& one : groups[i].crossing)
      outlines.push_back({one.curve.edges, i, i, {}, one});
  }
  return outlines;
}

bool holds_others(const std::vector<Outline>& outlines, std::size_t index) {
  return std::any_of(outlines.begin(), outlines.end(), [&](const Outline& other) {
    return std::find(other.about.begin(), other.about.end(), static_cast<int>(index)) != other.about.end();
  });
}

/// mm. Empty circles beside each other, no wider than drills for usual chucks, are holes.
constexpr double kWidestHole = 13;

/// Whether nothing but a circle of a hole's size is drawn.
bool is_small_circle(const Outline& outline, const Tolerances& tol) {
  const auto diameter = circle_diameter(Region::from_valid_loops(outline.loop, {}), tol);
  return diameter && *diameter <= kWidestHole;
}

/// The outermost outlines. An outline without others inside keeps the role of its layer: a hole of the fixture beside
/// a part. Where a part is on the same layer, that role is meant for what is in the parts, and only holes keep it.
std::set<std::size_t> outer_ones(const std::vector<Outline>& outlines, const std::vector<ShapedGroup>& groups,
                                 const Tolerances& tol) {
  std::set<std::size_t> outer, parts, with_parts;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!outlines[i].about.empty() || outlines[i].crossing) continue;
    outer.insert(i);
    if (!holds_others(outlines, i)) continue;
    parts.insert(i);
    with_parts.insert(outlines[i].group);
  }
  for (const std::size_t i : outer) {
    const bool is_said = groups[outlines[i].group].group.says_role;
    const bool is_beside_parts =
        with_parts.count(outlines[i].group) > 0 && !is_small_circle(outlines[i], tol);
    if (!is_said || is_beside_parts) parts.insert(i);
  }
  return parts.empty() ? outer : parts;
}

/// Numbers of outlines from 1, parted by commas; nothing when the text is anything else.
std::optional<std::vector<int>> numbers_of(const std::string& text) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* end = at + text.size();
  while (true) {
    int number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || number < 1) return std::nullopt;
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != ',') return std::nullopt;
    at = next + 1;
  }
}

bool names_outer(const LayerRule& rule) {
  return capitals(rule.pattern) == "OUTER";
}

std::optional<std::set<std::size_t>> chosen_by(const LayerRule& rule, const std::vector<Outline>& outlines,
                                               const std::vector<ShapedGroup>& groups,
                                               const Tolerances& tol) {
  if (names_outer(rule)) return outer_ones(outlines, groups, tol);
  const auto numbers = numbers_of(rule.pattern);
  if (!numbers) return std::nullopt;
  std::set<std::size_t> chosen;
  for (const int number : *numbers) {
    if (number > static_cast<int>(outlines.size())) {
      throw InputError("--op", "there is no outline " + std::to_string(number) + ", the drawing has " +
                                   std::to_string(outlines.size()) + "; `clearcut info` lists them");
    }
    chosen.insert(static_cast<std::size_t>(number - 1));
  }
  return chosen;
}

[[noreturn]] void refuse_unmatched(const LayerRule& rule, const std::vector<NamedLayer>& layers) {
  std::string known;
  for (const NamedLayer& layer : layers) known += (known.empty() ? "" : ", ") + printable(layer.name);
  throw InputError("--op", "no layer or outline is called '" + printable(rule.pattern) +
                               "'; write the name of a layer (" + known +
                               "), the number of an outline as `clearcut info` lists them, or outer");
}

/// Whether a layer has this name. Refuses a rule giving a role to a layer of which nothing was read.
bool names_layer(const LayerRule& rule, const std::vector<NamedLayer>& layers) {
  bool named = false, drawn = false, others = false;
  for (const NamedLayer& layer : layers) {
    const bool is_it = matches(rule.pattern, layer.name);
    named = named || is_it;
    drawn = drawn || (is_it && layer.has_outlines);
    others = others || layer.has_outlines;
  }
  if (named && !drawn && others && rule.asked && rule.role && *rule.role != LayerRole::kIgnore) {
    throw InputError("--op", "layer '" + printable(rule.pattern) +
                                 "' has no outlines that are read; `clearcut info` says what is on it");
  }
  return named;
}

/// Outlines with an edge to be broken keep their role: only outlines without another role leave their group.
bool stays(const LayerRule& rule, const DrawnGroup& group) {
  return *rule.role == LayerRole::kChamfer && group.says_role;
}

/// The areas enclosed by the outlines. Outlines of one layer do not cross; those of several are mended together.
Regions regions_of(const std::vector<const Outline*>& outlines, const std::string& where,
                   const ReadOptions& options, Diagnostics& diagnostics) {
  std::vector<Loop> loops;
  std::vector<RawCurve> curves;
  std::set<std::size_t> layers;
  for (const Outline* outline : outlines) {
    if (outline->crossing) continue;  // decided when all rules were applied
    loops.push_back(outline->loop);
    curves.push_back({outline->loop, true, "outline", {}});
    layers.insert(outline->drawn_in);
  }
  if (layers.size() < 2) return nested(loops);  // also of none
  RepairOptions how;
  how.tol = options.tol;
  how.where = where;
  how.find_arcs = false;
  return repair(std::move(curves), how, diagnostics);
}

/// Outlines of one rule leave their groups for a new one.
void move_out(const LayerRule& rule, const std::set<std::size_t>& chosen, const Sorting& sorting) {
  auto& [outlines, groups, options, diagnostics] = sorting;
  ShapedGroup moved;
  const DrawnGroup& first = groups[outlines[*chosen.begin()].group].group;
  moved.group.name = name_of(*rule.role);
  moved.group.where = first.where;
  moved.group.role = *rule.role;
  moved.group.says_role = true;
  moved.group.depth = rule.depth || *rule.role == LayerRole::kChamfer ? rule.depth : first.depth;
  moved.group.top = rule.top ? rule.top : first.top;
  moved.group.hole = rule.hole;
  moved.group.width = rule.width ? rule.width : first.width;
  std::vector<const Outline*> moving;
  for (const std::size_t i : chosen) {
    moving.push_back(&outlines[i]);
    if (!stays(rule, groups[outlines[i].group].group)) outlines[i].group = groups.size();
  }
  moved.regions = regions_of(moving, moved.group.where, options, diagnostics);
  groups.push_back(std::move(moved));
}

/// The outermost outlines separated by the depth and top of their layers: they do not nest in each other. Other
/// outlines stay together.
std::vector<std::set<std::size_t>> of_one_depth(const LayerRule& rule, const std::set<std::size_t>& chosen,
                                                const std::vector<Outline>& outlines,
                                                const std::vector<ShapedGroup>& groups) {
  if (!names_outer(rule)) return {chosen};
  std::map<std::array<std::optional<double>, 3>, std::set<std::size_t>> apart;
  for (const std::size_t i : chosen) {
    const DrawnGroup& group = groups[outlines[i].group].group;
    apart[{group.depth, group.top, group.width}].insert(i);
  }
  std::vector<std::set<std::size_t>> alike;
  for (auto& [said, some] : apart) alike.push_back(std::move(some));
  std::sort(alike.begin(), alike.end());
  return alike;
}

/// Regions of a group from its current outlines.
void renest(const std::vector<Outline>& outlines, std::size_t group, ShapedGroup& shaped,
            const ReadOptions& options, Diagnostics& diagnostics) {
  std::vector<const Outline*> own;
  for (const Outline& outline : outlines) {
    if (outline.group == group) own.push_back(&outline);
  }
  shaped.regions = own.empty() ? Regions{} : regions_of(own, shaped.group.where, options, diagnostics);
}

/// Whether an outline of `inner` in one of `outer` is an island unless stated otherwise: it is on the same layer, or
/// on a layer without a stated role that is no deeper.
bool may_be_island(const DrawnGroup& inner, const DrawnGroup& outer, const ReadOptions& options) {
  const bool same_depth = options.depth || !inner.depth || inner.depth == outer.depth;
  const bool same_top = options.top || inner.top.value_or(0) == outer.top.value_or(0);
  return &inner == &outer || (inner.role == LayerRole::kPocket && !inner.says_role && same_depth && same_top);
}

/// An outermost outline, and the outlines in it that are its islands, pockets in those, and so on, on any layer.
std::set<std::size_t> with_islands(std::size_t outer, const std::vector<Outline>& outlines,
                                   const std::vector<ShapedGroup>& groups, const ReadOptions& options) {
  std::vector<std::size_t> within;
  for (std::size_t i = 0; i < outlines.size(); ++i)
    if (!outlines[i].about.empty() && outlines[i].about.front() == static_cast<int>(outer))
      within.push_back(i);
  std::stable_sort(within.begin(), within.end(), [&](std::size_t a, std::size_t b) {
    return outlines[a].about.size() < outlines[b].about.size();
  });
  const DrawnGroup& own = groups[outlines[outer].group].group;
  std::set<std::size_t> all{outer};
  for (const std::size_t i : within) {
    const auto& about = outlines[i].about;
    const bool nests = std::all_of(about.begin(), about.end(),
                                   [&](int j) { return all.count(static_cast<std::size_t>(j)) > 0; });
    if (nests && may_be_island(groups[outlines[i].group].group, own, options)) all.insert(i);
  }
  return all;
}

/// The outermost outlines are pockets and outlines in them are islands, also on other layers.
void make_outer_pockets(const LayerRule& rule, const std::set<std::size_t>& outer, const Sorting& sorting) {
  auto& [outlines, groups, options, diagnostics] = sorting;
  std::set<std::size_t> touched;
  for (const std::size_t one : outer) {
    const std::set<std::size_t> pocket = with_islands(one, outlines, groups, options);
    const std::size_t own = outlines[one].group;
    std::set<std::size_t> from;
    for (const std::size_t i : pocket) from.insert(outlines[i].group);
    if (rule.depth || rule.top) {
      move_out(rule, pocket, sorting);
    } else if (from.size() > 1) {
      for (const std::size_t i : pocket) outlines[i].group = own;
    } else {
      continue;  // the default by nesting
    }
    touched.insert(from.begin(), from.end());
    for (const std::size_t group : from) {
      if (group == own) continue;
      diagnostics.note(groups[group].group.where, "outlines in the outermost one of layer " +
                                                      printable(groups[own].group.name) +
                                                      " nest in it: islands, and pockets in those");
    }
  }
  for (const std::size_t group : touched) renest(outlines, group, groups[group], options, diagnostics);
}

/// Rules of chamfers last: they depend on the roles of outlines.
std::vector<LayerRule> in_turn(std::vector<LayerRule> rules) {
  std::stable_partition(rules.begin(), rules.end(),
                        [](const LayerRule& rule) { return rule.role != LayerRole::kChamfer; });
  return rules;
}

/// Chamfers along all outlines of layers that also have another role.
void add_broken_edges(std::vector<ShapedGroup>& groups) {
  const std::size_t count = groups.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<LayerRule> rule = groups[i].group.broken_edges;
    if (!rule) continue;
    ShapedGroup edges = groups[i];
    edges.group.name = name_of(LayerRole::kChamfer);
    edges.group.role = LayerRole::kChamfer;
    edges.group.depth = rule->depth;
    if (rule->top) edges.group.top = rule->top;
    groups.push_back(std::move(edges));
  }
}

/// Treats crossing outlines after all rules are applied: the rest of their groups is mended once more, or refused. An
/// overview lists them.
void settle_crossing(std::vector<ShapedGroup>& groups, const std::vector<Outline>& outlines,
                     const ReadOptions& options, Diagnostics& diagnostics) {
  std::set<std::size_t> open;
  for (const Outline& outline : outlines) {
    if (!outline.crossing || groups[outline.group].group.role == LayerRole::kIgnore) continue;
    if (options.overview && options.overview->missing.empty())
      options.overview->missing = outline.crossing->refusal.what();
    open.insert(outline.group);
  }
  if (options.overview) return;
  for (const std::size_t group : open) {
    RepairOptions how;
    how.tol = options.tol;
    how.where = groups[group].group.where;
    std::vector<RawCurve> curves;
    for (const Outline& outline : outlines) {
      if (outline.group != group) continue;
      curves.push_back(outline.crossing ? outline.crossing->curve
                                        : RawCurve{outline.loop, true, "outline", {}});
    }
    try {
      groups[group].regions = repair(std::move(curves), how, diagnostics);
    } catch (const InputError&) {
      const auto first = std::find_if(outlines.begin(), outlines.end(), [&](const Outline& outline) {
        return outline.group == group && outline.crossing;
      });
      throw InputError("", first->crossing->refusal.what());  // this names the curves as drawn
    }
  }
}

/// Applies options and rules naming outlines; returns whether one says what all outermost outlines are.
bool apply_outline_rules(std::vector<ShapedGroup>& groups, std::vector<Outline>& outlines,
                         const std::vector<NamedLayer>& layers, const ReadOptions& options,
                         Diagnostics& diagnostics) {
  bool says_outer = false;
  for (const LayerRule& rule : in_turn(options.layer_rules)) {
    if (names_layer(rule, layers) || !rule.role) continue;
    const auto chosen = chosen_by(rule, outlines, groups, options.tol);
    if (!chosen) {
      const bool has_drawn = !layers.empty() || !outlines.empty();
      if (has_drawn && rule.asked && rule.pattern.substr(0, 1) != "#") refuse_unmatched(rule, layers);
      continue;
    }
    says_outer = says_outer || names_outer(rule);
    if (chosen->empty()) continue;
    if (names_outer(rule) && *rule.role == LayerRole::kPocket) {
      make_outer_pockets(rule, *chosen, {outlines, groups, options, diagnostics});
      continue;
    }
    std::set<std::size_t> touched;
    for (const std::size_t i : *chosen) touched.insert(outlines[i].group);
    for (const std::set<std::size_t>& alike : of_one_depth(rule, *chosen, outlines, groups))
      move_out(rule, alike, {outlines, groups, options, diagnostics});
    for (const std::size_t group : touched) renest(outlines, group, groups[group], options, diagnostics);
  }
  return says_outer;
}

/// Whether two outlines are one outline drawn twice, for example on two layers.
bool is_drawn_twice(const Outline& a, const Outline& b, const Tolerances& tol) {
  const Box one = box(a.loop), other = box(b.loop);
  return distance(one.min, other.min) <= tol.join_gap && distance(one.max, other.max) <= tol.join_gap;
}

/// Whether an option or rule names the outline itself: it is one of several outlines drawn alike.
bool is_named(const Outline& outline) {
  return outline.group != outline.drawn_in;
}

/// Whether an outline in this one is said to be an island: this one is then a pocket.
bool holds_island(std::size_t index, const std::vector<Outline>& outlines,
                  const std::vector<ShapedGroup>& groups) {
  return std::any_of(outlines.begin(), outlines.end(), [&](const Outline& other) {
    return groups[other.group].group.role == LayerRole::kIsland &&
           std::find(other.about.begin(), other.about.end(), static_cast<int>(index)) != other.about.end();
  });
}

/// The outermost outlines with unknown role, edges of parts or pockets, if one of them contains others, or if several
/// are no holes and have no depth of their own, those that options name counted. A single outline is a pocket.
std::vector<std::size_t> unclear_outlines(const std::vector<ShapedGroup>& groups,
                                          const std::vector<Outline>& outlines, const ReadOptions& options) {
  // An island stands in a pocket: where an option names one, outlines without others are pockets, too.
  const auto& rules = options.layer_rules;
  const bool any_island = std::any_of(rules.begin(), rules.end(), [](const LayerRule& rule) {
    return rule.asked && rule.role == LayerRole::kIsland;
  });
  std::vector<std::size_t> outermost;
  bool holding = false, several = false;
  const Outline* first_plain = nullptr;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const DrawnGroup& group = groups[outlines[i].group].group;
    if (!outlines[i].about.empty() || outlines[i].crossing || group.role == LayerRole::kChamfer) continue;
    const bool is_said = group.says_role || holds_island(i, outlines, groups);
    if (is_said && !is_named(outlines[i])) continue;
    if (!is_said) {
      outermost.push_back(i);
      holding = holding || holds_others(outlines, i);
    }
    if (any_island || (group.depth && !is_said) || is_small_circle(outlines[i], options.tol)) continue;
    several = several || (first_plain && !is_drawn_twice(*first_plain, outlines[i], options.tol));
    if (!first_plain) first_plain = &outlines[i];
  }
  return holding || several ? outermost : std::vector<std::size_t>{};
}

/// The question for outlines without others inside.
std::string question_of_plain(const Outline& first, std::size_t count, const ShapedGroup& group) {
  const Box size = box(first.loop);
  const std::string drawn = trimmed(size.width(), 2) + " x " + trimmed(size.height(), 2) + " mm (layer " +
                            printable(group.group.name) + ")";
  if (count == 1)
    return "the outline of " + drawn +
           " stands beside others, and nothing says what it is: --op profile:outer if it is the edge of a "
           "part, which is cut out along it; --op pocket:outer if it is a pocket";
  return "the drawing has " + std::to_string(count) + " outlines beside each other, the first of " + drawn +
         ", and nothing says what they are: --op profile:outer if they are the edges of parts, which are "
         "cut out along them; --op pocket:outer if they are pockets";
}

std::string question_of(const std::vector<Outline>& outlines, const std::vector<std::size_t>& unclear,
                        const std::vector<ShapedGroup>& groups) {
  const auto holds = [&](std::size_t i) { return holds_others(outlines, i); };
  const auto holding = static_cast<std::size_t>(std::count_if(unclear.begin(), unclear.end(), holds));
  if (holding == 0) {
    const Outline& first = outlines[unclear.front()];
    return question_of_plain(first, unclear.size(), groups[first.group]);
  }
  const std::size_t first = *std::find_if(unclear.begin(), unclear.end(), holds);
  const Outline& outline = outlines[first];
  const Box size = box(outline.loop);
  const auto others = std::count_if(outlines.begin(), outlines.end(), [&](const Outline& other) {
    return std::find(other.about.begin(), other.about.end(), static_cast<int>(first)) != other.about.end();
  });
  const bool alone = unclear.size() == 1;
  const std::string beside =
      alone ? ""
      : holding == unclear.size()
          ? ", as each of " + std::to_string(unclear.size()) + " outermost outlines does"
          : ", as " + std::to_string(holding) + " of " + std::to_string(unclear.size()) +
                " outermost outlines " + (holding == 1 ? "does" : "do");
  return "the outline of " + trimmed(size.width(), 2) + " x " + trimmed(size.height(), 2) + " mm (layer " +
         printable(groups[outline.group].group.name) + ") holds " + std::to_string(others) +
         (others == 1 ? " other" : " others") + beside + ", and nothing says what " +
         (alone ? "it is" : "they are") + ": --op profile:outer if " +
         (alone ? "it is the edge of the part, which is cut out along it; "
                : "they are the edges of parts, which are cut out along them; ") +
         "--op pocket:outer if " +
         (alone ? "it is a pocket and the outlines in it are islands"
                : "they are pockets and the outlines in them are islands");
}

void fill_overview(const std::vector<ShapedGroup>& groups, const std::vector<Outline>& outlines,
                   const ReadOptions& options, DrawingOverview& overview) {
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Outline& outline = outlines[i];
    const DrawnGroup& group = groups[outline.group].group;
    OutlineSummary one;
    one.number = static_cast<int>(i) + 1;
    one.layer = group.name;
    one.role = name_of(group.role);
    // By default an outline inside another of its layer is an island, alternating with the depth of nesting.
    const auto in_own = std::count_if(outline.about.begin(), outline.about.end(), [&](int j) {
      const Outline& around = outlines[static_cast<std::size_t>(j)];
      return around.group == outline.group ||
             (group.role == LayerRole::kProfile && groups[around.group].group.role == LayerRole::kProfile);
    });
    if (is_pocket(group.role) && in_own % 2 == 1) one.role = "island";
    if (group.role == LayerRole::kProfile && in_own % 2 == 1) one.role = "inside";
    if (group.role == LayerRole::kInside && in_own % 2 == 1) one.role = "profile";
    const bool crosses = outline.crossing && group.role != LayerRole::kIgnore;
    if (crosses) one.role = "crossing";
    one.says_role = group.says_role || crosses;
    one.depth = options.depth ? options.depth : group.depth;
    one.box = box(outline.loop);
    one.loop = outline.loop;
    one.area = std::abs(signed_area(outline.loop));
    // A self-crossing outline bounds no region, and is no circle.
    if (!outline.crossing)
      one.diameter = circle_diameter(Region::from_valid_loops(outline.loop, {}), options.tol);
    one.within = outline.about.empty() ? 0 : outline.about.back() + 1;
    overview.outlines.push_back(std::move(one));
  }
  for (const ShapedGroup& group : groups) {
    overview.lines += static_cast<int>(group.lines.size());
    if (!group.lines.empty() && !options.depth && !group.group.depth) overview.lines_have_depths = false;
  }
}

}  // namespace

void assign_outline_roles(std::vector<ShapedGroup>& groups, const std::vector<NamedLayer>& layers,
                          const ReadOptions& options, const std::string& file, Diagnostics& diagnostics) {
  add_broken_edges(groups);
  const bool wanted = options.ask_if_unclear || options.overview || !options.layer_rules.empty();
  if (!wanted) {
    for (const ShapedGroup& group : groups)
      if (!group.crossing.empty()) throw InputError("", group.crossing.front().refusal.what());
    return;
  }
  std::vector<Outline> outlines = outlines_of(groups);
  const bool says_outer = apply_outline_rules(groups, outlines, layers, options, diagnostics);
  const auto unclear = says_outer ? std::vector<std::size_t>{} : unclear_outlines(groups, outlines, options);
  settle_crossing(groups, outlines, options, diagnostics);
  if (options.overview) fill_overview(groups, outlines, options, *options.overview);
  if (unclear.empty()) return;
  const std::string question = question_of(outlines, unclear, groups);
  if (options.overview) {
    options.overview->question = question;
    options.overview->answers = {{"--op", "profile:outer"}, {"--op", "pocket:outer"}};
  }
  if (options.ask_if_unclear && !options.overview) throw InputError(file, question);
}

std::vector<Path> chained_lines(const std::vector<RawCurve>& curves, double gap) {
  std::vector<Path> lines;
  for (const RawCurve& curve : curves) {
    Path path;
    for (const Edge& edge : curve.edges) {
      if (edge.from != edge.to) path.push_back(edge);
    }
    if (path.empty()) continue;
    if (curve.closed && path.back().to != path.front().from) {
      if (distance(path.back().to, path.front().from) > gap) {
        path.push_back(Edge::line(path.back().to, path.front().from));
      }
    }
    if (!lines.empty()) {
      // Drawn one after the other, as most programs write them.
      Path& last = lines.back();
      const bool open = distance(last.front().from, last.back().to) > gap;
      if (open && distance(last.back().to, path.back().to) <= gap) path = reversed(path);
      if (open && distance(last.back().to, path.front().from) <= gap) {
        if (last.back().to != path.front().from && !path.front().is_arc()) path.front().from = last.back().to;
        if (last.back().to == path.front().from) {
          last.insert(last.end(), path.begin(), path.end());
          continue;
        }
      }
    }
    lines.push_back(std::move(path));
  }
  return lines;
}

}  // namespace clearcut::read
