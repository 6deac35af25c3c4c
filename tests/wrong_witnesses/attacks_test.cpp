// Wrong programs with honest, stale and adapted witnesses, judged by samples (claim_judge.h). CLEARCUT_ATTACKS: their number, else a few.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "pipeline/run.h"
#include "pipeline/witness/find_witness.h"
#include "post/part/part_writers.h"
#include "support/independent/claim_judge.h"
#include "support/plans.h"
#include "support/random/first_seed.h"
#include "support/random/random_parts.h"

// The reader of witnesses and programs, to adapt what it read; under a name of its own, as the library holds the checker, too.
#define CLEARCUT_CHECK_WITHOUT_MAIN
#define clearcut_check attacked_check
#include "checker/clearcut_check.cpp"
#undef clearcut_check
#undef CLEARCUT_CHECK_WITHOUT_MAIN

namespace clearcut::test_support {
namespace {

namespace ccw = attacked_check;
using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}
std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A changed program; for each old line its new number, -1 where it is gone.
struct Attack {
  std::string kind;
  Lines lines;
  std::vector<int> now;
};

/// Lines that move the tool.
std::vector<std::size_t> motion_lines(const Lines& lines) {
  static const std::regex motion("^(G[0123] ?)?[XYZ]-?[0-9].*");
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (std::regex_match(lines[i], motion)) found.push_back(i);
  return found;
}

std::string number_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

/// Changes the number of one word; false where the line has none.
bool change_word(std::string& line, const std::string& letters, double by) {
  static const std::regex word("([XYZ])(-?[0-9.]+)");
  std::vector<std::smatch> found;
  for (std::sregex_iterator it(line.begin(), line.end(), word), end; it != end; ++it)
    if (letters.find((*it)[1].str()) != std::string::npos) found.push_back(*it);
  if (found.empty()) return false;
  const std::smatch& one = found.back();
  line.replace(static_cast<std::size_t>(one.position(2)), one[2].str().size(),
               number_text(std::stod(one[2].str()) + by));
  return true;
}

/// Nothing where the kind finds nothing to change.
std::optional<Attack> attacked(const Lines& program, Random& random) {
  const std::vector<std::size_t> motions = motion_lines(program);
  Attack out{"", program, std::vector<int>(program.size())};
  for (std::size_t i = 0; i < program.size(); ++i) out.now[i] = static_cast<int>(i);
  const std::size_t at = motions[random.below(motions.size())];
  constexpr double kSteps[] = {0.003, 0.008, 0.012, 0.02, 0.05, 0.3, 3};
  const double by = kSteps[random.below(7)] * (random.below(2) == 0 ? 1 : -1);
  const auto swap_code = [&](const char* from, const char* to) {
    std::vector<std::size_t> with;
    for (const std::size_t i : motions)
      if (program[i].rfind(from, 0) == 0) with.push_back(i);
    if (with.empty()) return false;
    std::string& line = out.lines[with[random.below(with.size())]];
    line = to + line.substr(std::string(from).size());
    return true;
  };
  switch (random.below(8)) {
    case 0:
      out.kind = "place";
      return change_word(out.lines[at], "XY", by) ? std::optional(out) : std::nullopt;
    case 1:
      out.kind = "height";
      return change_word(out.lines[at], "Z", by) ? std::optional(out) : std::nullopt;
    case 2:
      out.kind = "dropped";
      out.lines.erase(out.lines.begin() + static_cast<std::ptrdiff_t>(at));
      out.now[at] = -1;
      for (std::size_t i = at + 1; i < out.now.size(); ++i) --out.now[i];
      return out;
    case 3: {
      out.kind = "exchanged";
      const std::size_t other = motions[random.below(motions.size())];
      std::swap(out.lines[at], out.lines[other]);
      std::swap(out.now[at], out.now[other]);
      return out;
    }
    case 4:
      out.kind = "feed as rapid";
      return swap_code("G1", "G0") ? std::optional(out) : std::nullopt;
    case 5:
      out.kind = "arc reversed";
      return swap_code("G2", "G3") ? std::optional(out) : std::nullopt;
    case 6: {  // all that follows, a little aside: the passes of one part of the work
      out.kind = "all after moved";
      for (std::size_t i = at; i < out.lines.size(); ++i) change_word(out.lines[i], "X", by);
      return out;
    }
    default: {
      out.kind = "later first";
      const std::size_t other = motions[random.below(motions.size())];
      const auto begin = out.lines.begin();
      if (other <= at) return std::nullopt;
      std::rotate(begin + static_cast<std::ptrdiff_t>(at), begin + static_cast<std::ptrdiff_t>(other),
                  begin + static_cast<std::ptrdiff_t>(other) + 1);
      out.now[other] = static_cast<int>(at);
      for (std::size_t i = at; i < other; ++i) ++out.now[i];
      return out;
    }
  }
}

/// Bytes of a witness as docs/witness.md has them.
class Bytes {
 public:
  explicit Bytes(const ccw::Witness& w) {
    out_ = "CCW3" + w.program_hash + w.part_hash;
    put(w.tools.size());
    for (const ccw::Tool& tool : w.tools)
      for (const ccw::Int n : {tool.number, tool.radius, tool.point}) put(static_cast<std::uint64_t>(n));
    put(w.vertices.size());
    ccw::Point at{-ccw::kLargest, -ccw::kLargest};
    for (const ccw::Point p : w.vertices) {
      put(static_cast<std::uint64_t>(p.x - at.x));
      if (p.x > at.x) {
        put_signed(p.y - at.y);
      } else {
        put(static_cast<std::uint64_t>(p.y - at.y - 1));
      }
      at = p;
    }
    put(w.claims.size());
    for (const ccw::Claim& claim : w.claims) {
      put(claim.feature);
      for (const ccw::Int n : {claim.radius, claim.wall_stock, claim.floor_stock})
        put(static_cast<std::uint64_t>(n));
      put_tiles(claim.cover);
      put_tiles(claim.centre);
    }
    put(w.rapids.size());
    for (const ccw::RapidTiles& rapid : w.rapids) put(rapid.move), put_tiles(rapid.tiles);
    put(w.rims.size());
    for (const ccw::RimMove& rim : w.rims) {
      put(rim.move);
      put(rim.pieces.size());
      for (const ccw::RimPiece& piece : rim.pieces) {
        put(static_cast<std::uint64_t>(piece.steps));
        put(piece.sectors.size());
        for (const ccw::FreeSector& sector : piece.sectors) {
          put(static_cast<std::uint64_t>(sector.from));
          put(static_cast<std::uint64_t>(sector.size));
          put(rim.move - sector.by);
        }
      }
    }
  }
  const std::string& text() const { return out_; }

 private:
  void put(std::uint64_t value) {
    for (; value >= 128; value >>= 7) out_ += static_cast<char>(value | 128);
    out_ += static_cast<char>(value);
  }
  void put_signed(ccw::Int value) {
    put(value < 0 ? static_cast<std::uint64_t>(-(value + 1)) * 2 + 1 : static_cast<std::uint64_t>(value) * 2);
  }
  void put_tiles(const ccw::Tiles& tiles) {
    put(tiles.size());
    ccw::Int of = 0, index = 0;
    for (const ccw::Tile& tile : tiles) {
      put(static_cast<std::uint64_t>(tile.label));
      const ccw::Int own = static_cast<ccw::Int>(tile.of);
      if (tile.label == 0) put_signed(own - of), of = own;
      put(tile.corners.size());
      for (const std::size_t corner : tile.corners)
        put_signed(static_cast<ccw::Int>(corner) - index), index = static_cast<ccw::Int>(corner);
    }
  }
  std::string out_;
};

/// Whether a move runs the same way in both programs.
bool is_same_way(const ccw::Move& a, const ccw::Move& b) {
  return a.path.a == b.path.a && a.path.b == b.path.b && a.path.arc == b.path.arc &&
         a.path.center == b.path.center && a.z0 == b.z0 && a.z1 == b.z1;
}

/// Rims of moves that still run the same way, with the numbers by `now`, and their sectors that earlier moves still free.
template <typename Now>
void adapt_rims(ccw::Witness& w, const ccw::Program& before, const ccw::Program& after, const Now& now) {
  std::map<std::size_t, ccw::RimMove> kept;
  for (ccw::RimMove rim : w.rims) {
    const std::size_t move = now(rim.move);
    if (!is_same_way(before.moves[rim.move], after.moves[move])) continue;
    rim.move = move;
    for (ccw::RimPiece& piece : rim.pieces) {
      for (ccw::FreeSector& sector : piece.sectors) sector.by = now(sector.by);
      std::erase_if(piece.sectors, [&](const ccw::FreeSector& sector) { return sector.by > move; });
    }
    kept.emplace(move, rim);
  }
  w.rims.clear();
  for (const auto& [move, rim] : kept) w.rims.push_back(rim);
}

/// The witness of the right program with the numbers that its moves have in the wrong one.
std::string adapted(const std::string& witness, const ccw::Program& before, const ccw::Program& after,
                    const Attack& attack, const std::string& program) {
  std::map<int, std::size_t> by_line;
  for (std::size_t i = 0; i < after.moves.size(); ++i) by_line.emplace(after.moves[i].line, i);
  const auto now = [&](std::size_t move) {
    const int line = move < before.moves.size()
                         ? attack.now[static_cast<std::size_t>(before.moves[move].line - 1)] + 1
                         : 0;
    const auto found = by_line.lower_bound(line);
    return found == by_line.end() ? after.moves.size() - 1 : found->second;
  };
  ccw::Witness w = ccw::WitnessReader(witness).whole();
  w.program_hash = ccw::sha256(program);
  for (ccw::Claim& claim : w.claims)
    for (ccw::Tile& tile : claim.cover)
      if (tile.label == 0) tile.of = now(tile.of);
  for (ccw::RapidTiles& rapid : w.rapids) {
    rapid.move = now(rapid.move);
    for (ccw::Tile& tile : rapid.tiles)
      if (tile.label == 0) tile.of = now(tile.of);
  }
  std::sort(w.rapids.begin(), w.rapids.end(), [](const auto& a, const auto& b) { return a.move < b.move; });
  adapt_rims(w, before, after, now);
  return Bytes(w).text();
}

struct Counts {
  int attacks = 0, honest = 0, stale = 0, adapted = 0, wrong = 0, falsely_accepted = 0, falsely_refused = 0,
      right = 0;
};

/// A planned part with its witness.
struct Case {
  Part part;
  double diameter = 0;
  std::string program, outline, witness;
};

WitnessQuestion question_of(const Case& one) {
  WitnessQuestion question;
  question.tools = {{1, one.diameter, 0}};
  question.first_tool = 1;
  const Feature& feature = one.part.features.front();
  for (std::size_t i = 0; i < feature.target.size(); ++i)
    question.features.push_back({.name = feature.name, .diameter = one.diameter, .floor = feature.floor_z});
  return question;
}

constexpr std::array kStrategies{"contour", "zigzag", "spiral", "adaptive"};

/// Nothing where the part cannot be cut by the cutter.
std::optional<Case> without_witness(std::uint64_t seed) {
  Random random(seed);
  Case one;
  one.diameter = 0.5 * static_cast<double>(4 + random.below(14));
  one.part = random_part(random, one.diameter);
  if (one.part.features.front().target.size() != 1) return std::nullopt;
  PlanOptions options = with_tool(one.diameter);
  options.strategy = kStrategies[seed % kStrategies.size()];
  options.stepdown = random.below(3) == 0 ? 2.0 : 1.0;  // two layers, with rapids between, in most
  try {
    const PlanResult result = pipeline::plan_part(one.part, options);
    if (result.findings.all.feed_mm == 0) return std::nullopt;
    one.program = result.program;
  } catch (const InputError&) {
    return std::nullopt;
  }
  one.outline = post::write_outline_json(one.part);
  return one;
}

struct Outcome {
  std::string why;  ///< why there is no witness; "" where one is found, which the case then has
  int tiles = 0;
};
Outcome prove(Case& one, double uncut, bool engagement) {
  WitnessQuestion question = question_of(one);
  question.uncut = uncut;
  question.engagement = engagement;
  const FoundWitness found = pipeline::find_witness(one.program, "program", one.outline, "part", question);
  one.witness = found.bytes;
  return {found.bytes.empty() ? found.why_not : found.missing.empty() ? "" : found.missing[0], found.tiles};
}

/// Nothing where the part cannot be cut by the cutter, or the plan has no witness.
std::optional<Case> planned(std::uint64_t seed) {
  std::optional<Case> one = without_witness(seed);
  if (!one || !prove(*one, 0.01, true).why.empty()) return std::nullopt;
  return one;
}

/// CLEARCUT_KEEP: the folder for what is to be looked at.
void keep(const std::string& name, const std::string& program, const std::string& outline) {
  const char* folder = std::getenv("CLEARCUT_KEEP");
  if (!folder) return;
  std::ofstream(std::string(folder) + "/" + name + ".nc") << program;
  std::ofstream(std::string(folder) + "/" + name + ".json") << outline;
}

void attack(const Case& one, Random& random, Counts& counts, const std::string& where) {
  const auto wrong = attacked(lines_of(one.program), random);
  if (!wrong) return;
  const std::string program = text_of(wrong->lines);
  const ccw::Part part = ccw::read_part(one.outline, "part");
  const ccw::Program before = ccw::read_program(one.program, "before", part.top);
  ClaimFaults faults;
  std::optional<ccw::Program> after;
  try {
    after = ccw::read_program(program, "after", part.top);
    faults = judged(one.part, program, one.diameter, 1e-6 * static_cast<double>(after->lift));
  } catch (const ccw::Refusal&) {
    return;
  } catch (const std::runtime_error&) {
    return;
  }
  ++counts.attacks;
  const bool faulty = faults.uncut > 0.0105 || faults.gouge > 0.002 || faults.rapid > 0.0205;
  const bool round = std::all_of(after->moves.begin(), after->moves.end(), [](const ccw::Move& move) {
    return !move.path.arc ||
           move.path.high - move.path.low < 700;  // nm; others go anywhere between their radii
  });
  const bool right = round && faults.uncut < 0.006 && faults.gouge < 0.0005 && faults.rapid_off_height < 0;
  counts.wrong += faulty;
  counts.right += right;
  WitnessQuestion question = question_of(one);
  question.engagement = false;
  const FoundWitness honest = pipeline::find_witness(program, "program", one.outline, "part", question);
  const bool honestly = !honest.bytes.empty() && honest.missing.empty();
  std::string stale = one.witness;
  stale.replace(4, 32, ccw::sha256(program));
  const bool stalely = pipeline::check_witness(program, one.outline, stale).accepted;
  const bool adaptedly =
      pipeline::check_witness(program, one.outline, adapted(one.witness, before, *after, *wrong, program))
          .accepted;
  counts.honest += honestly, counts.stale += stalely, counts.adapted += adaptedly;
  const std::string said = where + " " + wrong->kind + ": uncut " + std::to_string(faults.uncut) + " gouge " +
                           std::to_string(faults.gouge) + " rapid " + std::to_string(faults.rapid);
  if (faulty && (honestly || stalely || adaptedly)) {
    ++counts.falsely_accepted;
    ADD_FAILURE() << said;
  }
  if (right && !honestly) {
    ++counts.falsely_refused;
    std::cout << "refused: " << said << ": " << honest.why_not
              << (honest.missing.empty() ? "" : honest.missing[0]) << "\n";
    keep("refused-" + std::to_string(counts.falsely_refused), program, one.outline);
  }
}

/// What is proven of the programs of one strategy.
struct Proven {
  int programs = 0, proven = 0, finer = 0;
  std::vector<std::size_t> bytes, tiles;
  double finding = 0, checking = 0, longest = 0;  // seconds
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
std::size_t median(std::vector<std::size_t> of) {
  std::sort(of.begin(), of.end());
  return of.empty() ? 0 : of[of.size() / 2];
}
void print_table(const std::map<std::string, Proven>& all) {
  std::cout << "strategy, programs, proven at 0.01 mm, at 0.005 mm, tiles: median and most, bytes: median "
               "and most, "
               "finding s: mean, checking s: mean and most\n";
  for (const auto& [name, one] : all)
    std::cout << name << ", " << one.programs << ", " << one.proven << ", " << one.finer << ", "
              << median(one.tiles) << " " << std::ranges::max(one.tiles) << ", " << median(one.bytes) << " "
              << std::ranges::max(one.bytes) << ", " << number_text(one.finding / one.programs) << ", "
              << number_text(one.checking / one.programs) << " " << number_text(one.longest) << "\n";
}

/// Whether the program keeps to the places that claims can be about, docs/claim.md.
bool is_within_range(const Case& one) {
  try {
    ccw::read_program(one.program, "program", ccw::read_part(one.outline, "part").top);
  } catch (const ccw::Refusal& refusal) {
    return refusal.what.find("beyond 1.07 m") == std::string::npos;
  }
  return true;
}

TEST(Coverage, OfRandomPartsByAllStrategies) {
  const int count = random_count(4);
  int programs = 0, far = 0, proven = 0, finer = 0;
  std::map<std::string, Proven> table;
  for (std::uint64_t seed = first_seed(); programs < count; ++seed) {
    std::optional<Case> one = without_witness(seed);
    if (!one) continue;
    if (!is_within_range(*one)) {
      ++far;
      continue;
    }
    ++programs;
    Proven& row = table[kStrategies[seed % kStrategies.size()]];
    ++row.programs;
    const std::string finer_why = prove(*one, 0.005, false).why;
    const auto start = std::chrono::steady_clock::now();
    const Outcome found = prove(*one, 0.01, false);
    row.finding += seconds_since(start);
    row.finer += finer_why.empty(), finer += finer_why.empty();
    if (!found.why.empty()) {
      std::cout << "part " << seed << " at 0.01 mm: " << found.why << "\n";
      keep("part-" + std::to_string(seed), one->program, one->outline);
      continue;
    }
    if (!finer_why.empty()) std::cout << "part " << seed << " at 0.005 mm: " << finer_why << "\n";
    ++row.proven, ++proven;
    row.bytes.push_back(one->witness.size());
    row.tiles.push_back(static_cast<std::size_t>(found.tiles));
    const auto check_start = std::chrono::steady_clock::now();
    EXPECT_TRUE(pipeline::check_witness(one->program, one->outline, one->witness).accepted);
    const double checking = seconds_since(check_start);
    row.checking += checking, row.longest = std::max(row.longest, checking);
  }
  print_table(table);
  std::cout << programs << " programs, " << proven << " proven at 0.01 mm, " << finer << " at 0.005 mm; "
            << far
            << " more have centers of arcs, or coordinates, beyond 1.07 m, which no claim can be about\n";
  EXPECT_EQ(proven, count);
  EXPECT_GE(finer, count - count / 50 - 1);
}

/// Places where the cutter just fits, walls that meet so sharply that their crossings with a cut are rounded to one place, and cuts
/// that would leave slivers.
TEST(Coverage, OfNarrowPlacesAndSharpCorners) {
  for (const std::uint64_t seed : {347, 378, 550, 733, 870, 966}) {
    std::optional<Case> one = without_witness(seed);
    ASSERT_TRUE(one);
    EXPECT_EQ(prove(*one, 0.01, false).why, "") << "part " << seed;
  }
}

TEST(Attacks, NoWrongProgramIsAcceptedWithAnyWitness) {
  const char* set = std::getenv("CLEARCUT_ATTACKS");
  const char* first = std::getenv("CLEARCUT_FIRST");
  const int count = set ? std::atoi(set) : 12;
  Counts counts;
  std::uint64_t seed = first ? std::strtoull(first, nullptr, 10) : 1;
  for (; counts.attacks < count; ++seed) {
    const auto one = planned(seed);
    if (!one) continue;
    Random random(seed + 1'000'000);
    const int until = counts.attacks + 24;
    for (int i = 0; i < 40 && counts.attacks < std::min(until, count); ++i)
      attack(*one, random, counts, "part " + std::to_string(seed) + " attack " + std::to_string(i));
  }
  std::cout << counts.attacks << " attacks, " << counts.wrong << " certainly wrong, " << counts.right
            << " certainly right; accepted with honest " << counts.honest << ", stale " << counts.stale
            << ", adapted " << counts.adapted << "; falsely accepted " << counts.falsely_accepted
            << ", falsely refused " << counts.falsely_refused << "; next part " << seed << "\n";
  EXPECT_GT(counts.wrong, count / 4);
  EXPECT_GT(counts.honest, 0);
  EXPECT_EQ(counts.falsely_accepted, 0);
  EXPECT_LE(counts.falsely_refused, count / 20);
}

/// The engagement that the checker states for each line, degrees; nothing where it does not accept. `alone`: of a witness that claims
/// nothing else, so that a program may leave material and reach into walls by nearly the cutter's radius.
std::map<int, double> stated_engagement(const Case& one, const std::string& witness, bool alone = false) {
  ccw::Question asked;
  asked.each = true;
  if (alone) asked.partial = true, asked.gouge = static_cast<ccw::Int>(0.45e6 * one.diameter);
  std::map<int, double> stated;
  try {
    const std::string text = ccw::check(asked, one.program, "program", one.outline, "part", witness);
    static const std::regex entry("\n  line ([0-9]+) ([0-9.]+)");
    for (std::sregex_iterator it(text.begin(), text.end(), entry), end; it != end; ++it)
      stated[std::stoi((*it)[1].str())] = std::stod((*it)[2].str());
  } catch (const ccw::Refusal&) {
  }
  return stated;
}

double rim_of(const Case& one) {  // mm; docs/claim.md, C4
  return 0.001 + 2e-6 * static_cast<double>(ccw::read_program(one.program, "program", 0).blending);
}

/// A small pocket; `CLEARCUT_RANDOM_PARTS` more are random.
std::optional<Case> case_number(std::uint64_t seed) {
  if (seed > 0) return planned(seed);
  Case one;
  one.diameter = 4;
  const Regions square{
      Region::from_valid_loops(loop_from_points(std::vector<Vec2>{{0, 0}, {17, 0}, {17, 13}, {0, 13}}), {})};
  one.part = part_of(square, square, FeatureKind::kClosedPocket, one.diameter);
  PlanOptions options = with_tool(one.diameter);
  options.strategy = "contour";
  options.stepover = "0.3";
  one.program = pipeline::plan_part(one.part, options).program;
  one.outline = post::write_outline_json(one.part);
  one.witness = pipeline::find_witness(one.program, "program", one.outline, "part", question_of(one)).bytes;
  return one;
}

TEST(Engagement, IsProvenWithinTwoDegreesOfDenseSampling) {
  const int count = 1 + random_count(0);
  int lines = 0, parts = 0;
  double above = 0;
  for (std::uint64_t seed = 0; parts < count; ++seed) {
    const auto one = case_number(seed);
    if (!one) continue;
    ++parts;
    const auto stated = stated_engagement(*one, one->witness);
    auto sampled = sampled_engagement(one->part, one->program, one->diameter, rim_of(*one), 0.1, 0.25);
    for (const auto& [line, degrees] : stated) {
      ++lines;
      EXPECT_GE(degrees, sampled[line] - 0.3) << "part " << seed << " line " << line;
      EXPECT_LE(degrees, sampled[line] + 2 + 0.3) << "part " << seed << " line " << line;
      above = std::max(above, degrees - sampled[line]);
    }
  }
  std::cout << lines << " level feeds of " << parts << " programs, at most " << above
            << " degrees above sampling\n";
  EXPECT_GT(lines, 10 * count);
}

/// A changed rim; what it says may still be true.
void change_rim(ccw::Witness& w, Random& random) {
  ccw::RimMove& rim = w.rims[random.below(w.rims.size())];
  ccw::RimPiece& piece = rim.pieces[random.below(rim.pieces.size())];
  const auto some = [&]() -> ccw::FreeSector* {
    return piece.sectors.empty() ? nullptr : &piece.sectors[random.below(piece.sectors.size())];
  };
  switch (random.below(6)) {
    case 0:
      if (auto* sector = some()) sector->size += static_cast<ccw::Int>(1 + random.below(300));
      return;
    case 1:
      if (auto* sector = some()) sector->from = static_cast<ccw::Int>(random.below(3600));
      return;
    case 2:
      if (auto* sector = some()) sector->by = random.below(rim.move + 1);
      return;
    case 3:  // a piece of the length of two
      if (rim.pieces.size() < 2) return;
      rim.pieces[0].steps += rim.pieces[1].steps;
      rim.pieces.erase(rim.pieces.begin() + 1);
      return;
    case 4:
      if (auto* sector = some()) sector->from = (sector->from + 3590) % 3600, sector->size += 20;
      return;
    default:
      piece.sectors.push_back({static_cast<ccw::Int>(random.below(3600)),
                               static_cast<ccw::Int>(1 + random.below(900)),
                               rim.move - 1 - std::min<std::size_t>(rim.move - 1, random.below(5))});
  }
}

TEST(Engagement, ChangedRimsClaimNoLessThanSampling) {
  const char* set = std::getenv("CLEARCUT_ATTACKS");
  const int count = set ? std::atoi(set) : 60;
  int attacks = 0, accepted = 0, faults = 0;
  for (std::uint64_t seed = 0; attacks < count; ++seed) {
    const auto one = case_number(seed);
    if (!one) continue;
    const ccw::Witness right = ccw::WitnessReader(one->witness).whole();
    if (right.rims.empty()) continue;
    auto sampled = sampled_engagement(one->part, one->program, one->diameter, rim_of(*one), 0.1, 1);
    Random random(seed);
    for (int i = 0; i < 60 && attacks < count; ++i, ++attacks) {
      ccw::Witness changed = right;
      change_rim(changed, random);
      const auto stated = stated_engagement(*one, Bytes(changed).text());
      accepted += !stated.empty();
      for (const auto& [line, degrees] : stated) faults += degrees < sampled[line] - 1.1;
    }
  }
  std::cout << attacks << " changed rims, " << accepted << " accepted, " << faults << " claim too little\n";
  EXPECT_EQ(faults, 0);
  EXPECT_LT(accepted, attacks * 3 / 4);
}

/// Witnesses of a right program, of which the wrong one's engagement might be claimed: those of the wrong program itself, the old one, and
/// the old one with the numbers of moves in the wrong program.
std::array<std::string, 3> witnesses_of_engagement(const Case& right, const Case& wrong, const Attack& attack,
                                                   const ccw::Program& before, const ccw::Program& after) {
  const auto alone = [&](const std::string& bytes) {
    if (bytes.empty()) return bytes;
    ccw::Witness w = ccw::WitnessReader(bytes).whole();
    w.program_hash = ccw::sha256(wrong.program);
    w.claims.clear();
    return Bytes(w).text();
  };
  const FoundWitness honest =
      pipeline::find_witness(wrong.program, "program", wrong.outline, "part", question_of(wrong));
  return {alone(honest.bytes), alone(right.witness),
          alone(adapted(right.witness, before, after, attack, wrong.program))};
}

TEST(Engagement, WrongProgramsClaimNoLessThanSampling) {
  const char* set = std::getenv("CLEARCUT_ATTACKS");
  const char* first = std::getenv("CLEARCUT_FIRST");
  const int count = set ? std::atoi(set) : 12;
  int attacks = 0, lines = 0, faults = 0, higher = 0;
  std::array<int, 3> accepted{};
  std::uint64_t seed = first ? std::strtoull(first, nullptr, 10) : 0;
  for (; attacks < count; ++seed) {
    const auto right = case_number(seed);
    if (!right || right->witness.empty()) continue;
    Random random(seed + 2'000'000);
    for (int i = 0, until = attacks + 24; i < 40 && attacks < std::min(until, count); ++i) {
      const auto change = attacked(lines_of(right->program), random);
      if (!change) continue;
      Case wrong = *right;
      wrong.program = text_of(change->lines);
      std::array<std::map<int, double>, 3> stated;
      try {
        const ccw::Int top = ccw::read_part(right->outline, "part").top;
        const ccw::Program before = ccw::read_program(right->program, "before", top),
                           after = ccw::read_program(wrong.program, "after", top);
        const auto witnesses = witnesses_of_engagement(*right, wrong, *change, before, after);
        for (std::size_t k = 0; k < stated.size(); ++k) {
          stated[k] = stated_engagement(wrong, witnesses[k], true);
          accepted[k] += !stated[k].empty();
        }
      } catch (const ccw::Refusal&) {
        continue;
      }
      ++attacks;
      if (stated[0].empty() && stated[1].empty() && stated[2].empty()) continue;
      const auto before =
          sampled_engagement(right->part, right->program, right->diameter, rim_of(*right), 0.3, 2);
      const auto sampled =
          sampled_engagement(wrong.part, wrong.program, wrong.diameter, rim_of(wrong), 0.3, 2);
      for (const auto& of : stated)
        for (const auto& [line, degrees] : of) {
          ++lines;
          const auto found = sampled.find(line), old = before.find(line);
          if (found == sampled.end()) continue;
          higher += old != before.end() && found->second > old->second + 2.1;
          if (degrees >= found->second - 2.1) continue;
          ++faults;
          ADD_FAILURE() << "part " << seed << " attack " << i << " " << change->kind << " line " << line
                        << ": " << degrees << " degrees stated, " << found->second << " sampled";
        }
    }
  }
  std::cout << attacks << " wrong programs; rims accepted with honest " << accepted[0] << ", stale "
            << accepted[1] << ", adapted " << accepted[2] << " witnesses, " << lines << " lines, " << higher
            << " with more engagement than before; " << faults << " claim too little; next part " << seed
            << "\n";
  EXPECT_EQ(faults, 0);
  EXPECT_GT(lines, count);
}

}  // namespace
}  // namespace clearcut::test_support
