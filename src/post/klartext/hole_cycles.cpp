// Cycles 200 (drilling), 201 (reaming), 206 (tapping in a floating holder) and 207 (rigid tapping). Pecks are written
// as moves: how far above the last depth a cycle feeds again is the same number there as its distance from the
// surface.
#include "post/klartext/hole_cycles.h"

#include <cmath>
#include <initializer_list>

#include "post/klartext/klartext_writer.h"

namespace clearcut::post {
namespace {

constexpr int kPitchDecimals = 4;
constexpr double kPitchShare = 1e-3;  // of a pitch; permitted error of its printed digits

/// One line of a definition.
struct Parameter {
  int number;
  std::string value;
  const char* meaning;
};

std::string definition(const std::string& cycle, std::initializer_list<Parameter> parameters) {
  std::string text = "CYCL DEF " + cycle;
  for (const Parameter& one : parameters)
    text += " ~\n  Q" + std::to_string(one.number) + "=" + one.value + " ;" + one.meaning;
  return text;
}

PrintGrid pitch_grid(bool inch) {
  return {inch, kPitchDecimals};
}

/// Lengths stated by all cycles.
struct Heights {
  std::string above_surface, depth, surface, above;
};

Heights heights_of(const DrillBlock& hole, long long surface, const PrintGrid& grid) {
  const auto text = [&](long long ticks) { return signed_number(ticks, grid.decimals()); };
  return {text(hole.clear - surface), text(hole.bottom.z - surface), text(surface),
          text(hole.above - surface)};
}

std::string drilling(const Heights& at, const std::string& feed) {
  return definition("200 DRILLING", {{200, at.above_surface, "SET-UP CLEARANCE"},
                                     {201, at.depth, "DEPTH"},
                                     {206, feed, "FEED RATE FOR PLNGNG"},
                                     {202, "+" + at.depth.substr(1), "PLUNGING DEPTH"},
                                     {210, "+0", "DWELL TIME AT TOP"},
                                     {203, at.surface, "SURFACE COORDINATE"},
                                     {204, at.above, "2ND SET-UP CLEARANCE"},
                                     {211, "+0", "DWELL TIME AT DEPTH"}});
}

/// A retract feed of 0 means the feed on the way in.
std::string reaming(const Heights& at, const std::string& feed) {
  return definition("201 REAMING", {{200, at.above_surface, "SET-UP CLEARANCE"},
                                    {201, at.depth, "DEPTH"},
                                    {206, feed, "FEED RATE FOR PLNGNG"},
                                    {211, "+0", "DWELL TIME AT DEPTH"},
                                    {208, "+0", "RETRACTION FEED RATE"},
                                    {203, at.surface, "SURFACE COORDINATE"},
                                    {204, at.above, "2ND SET-UP CLEARANCE"}});
}

std::string floating_tapping(const Heights& at, const std::string& feed) {
  return definition("206 TAPPING NEW", {{200, at.above_surface, "SET-UP CLEARANCE"},
                                        {201, at.depth, "DEPTH OF THREAD"},
                                        {206, feed, "FEED RATE FOR PLNGNG"},
                                        {211, "+0", "DWELL TIME AT DEPTH"},
                                        {203, at.surface, "SURFACE COORDINATE"},
                                        {204, at.above, "2ND SET-UP CLEARANCE"}});
}

/// The pitch of a left-hand thread is negative.
std::string rigid_tapping(const Heights& at, const Tool& tap, bool inch) {
  const long long pitch = pitch_grid(inch).ticks(tap.pitch);
  return definition("207 RIGID TAPPING NEW",
                    {{200, at.above_surface, "SET-UP CLEARANCE"},
                     {201, at.depth, "DEPTH OF THREAD"},
                     {239, signed_number(tap.left_hand ? -pitch : pitch, kPitchDecimals), "THREAD PITCH"},
                     {203, at.surface, "SURFACE COORDINATE"},
                     {204, at.above, "2ND SET-UP CLEARANCE"}});
}

}  // namespace

std::string hole_cycle(const DrillBlock& hole, double surface, const Tool* tap, const PrintGrid& grid,
                       bool inch) {
  const Heights at = heights_of(hole, grid.ticks(surface), grid);
  if (tap && !tap->floating) return taps_rigidly(*tap, inch) ? rigid_tapping(at, *tap, inch) : "";
  const std::string feed = signed_number(klartext_feed(hole.feed, inch), kKlartextFeedDecimals);
  if (tap) return floating_tapping(at, feed);
  if (hole.form == DrillForm::kAtOnce) return drilling(at, feed);
  return hole.form == DrillForm::kFeedsOut ? reaming(at, feed) : "";
}

bool taps_rigidly(const Tool& tap, bool inch) {
  const PrintGrid grid = pitch_grid(inch);
  return std::abs(grid.mm(grid.ticks(tap.pitch)) - tap.pitch) <= kPitchShare * tap.pitch;
}

}  // namespace clearcut::post
