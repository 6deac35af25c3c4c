// Boost's Voronoi builder with its own circle events (docs/offset.md, Speed).
//
// The builder asks for circles to within 64 roundings of a double. Its own formulas use an origin far from the three
// sites, nearly always lose this accuracy on most outlines, and then turn to big integers, which are many times
// slower. Here doubles come first, numbers of twice the precision next, both with a bound on their error; the
// builder's integers serve for cases undecided by both.
#pragma once

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cstdint>

#include "geometry/voronoi/tangent_circle.h"

namespace clearcut::inline geometry::voronoi {

using BuilderTraits = boost::polygon::detail::voronoi_ctype_traits<boost::polygon::detail::int32>;
using BuilderPredicates = boost::polygon::detail::voronoi_predicates<BuilderTraits>;

/// The four kinds of events by the builder's names: p for point, s for segment.
template <class Site, class Event>
class CircleFormation {
 public:
  void ppp(const Site& a, const Site& b, const Site& c, Event& event) {
    const Origin o = b.point0();
    const SitePoint p = point(a, o), q = point(c, o);
    if (!settle(o, event, [&]<class T>() { return tangent_circle<T>(p, q); })) exact_.ppp(a, b, c, event);
  }

  void pps(const Site& a, const Site& b, const Site& c, int segment_index, Event& event) {
    const Origin o = a.point0();
    const SitePoint p = point(b, o);
    const SiteLine s = line(c, o);
    const bool larger = segment_index != 2;
    if (!settle(o, event, [&]<class T>() { return tangent_circle<T>(p, s, larger); }))
      exact_.pps(a, b, c, segment_index, event);
  }

  void pss(const Site& a, const Site& b, const Site& c, int point_index, Event& event) {
    const Origin o = a.point0();
    const SiteLine s = line(b, o), t = line(c, o);
    const bool larger = (point_index == 2) == (cross(s, t) < 0);
    if (!settle(o, event, [&]<class T>() { return tangent_circle<T>(s, t, larger); }))
      exact_.pss(a, b, c, point_index, event);
  }

  void sss(const Site& a, const Site& b, const Site& c, Event& event) {
    const bool starts_at_end = b.point1() == a.point0() || b.point1() == a.point1();
    const Origin o = starts_at_end ? b.point1() : b.point0();
    const SiteLine s = line(a, o), t = line(b, o), u = line(c, o);
    if (!settle(o, event, [&]<class T>() { return tangent_circle<T>(s, t, u); })) exact_.sss(a, b, c, event);
  }

 private:
  using Origin = typename Site::point_type;
  /// Half of the builder's limit: its largest x is the sum of two limits used here.
  static constexpr double kMostRoundings = 32;
  /// Rounding of DoubleDouble in roundings of double, with a safety factor.
  static constexpr double kFineRounding = 0x1p-48;

  static SitePoint point(const Site& site, Origin o) {
    return {std::int64_t{site.x0()} - o.x(), std::int64_t{site.y0()} - o.y()};
  }
  static SiteLine line(const Site& site, Origin o) {
    const SitePoint p = point(site, o);
    const std::int64_t a = std::int64_t{site.x1()} - site.x0(), b = std::int64_t{site.y1()} - site.y0();
    return {a, b, p.y * a - p.x * b};
  }

  template <class Make>
  static bool settle(Origin o, Event& event, Make make) {
    return accept(o, make.template operator()<double>(), 1, event) ||
           accept(o, make.template operator()<DoubleDouble>(), kFineRounding, event);
  }

  template <class T>
  static bool accept(Origin o, const TangentCircle<T>& circle, double rounding, Event& event) {
    const T x = circle.x + T(1.0 * o.x()), y = circle.y + T(1.0 * o.y()), last = x + circle.radius;
    const double least = std::min({magnitude(x), magnitude(y), magnitude(last)});
    if (!(circle.error * rounding < kMostRoundings * least)) return false;
    event = Event(leading(x), leading(y), leading(last));
    return true;
  }

  typename BuilderPredicates::template mp_circle_formation_functor<Site, Event> exact_;
};

struct Predicates : BuilderPredicates {
  template <class Site, class Event>
  using circle_formation_predicate = BuilderPredicates::circle_formation_predicate<
      Site, Event, BuilderPredicates::circle_existence_predicate<Site>, CircleFormation<Site, Event>>;
};

/// Errors are relative to the coordinates of a circle. The sites are therefore moved away from both axes by as much
/// as they extend: this avoids needless precision near the axes.
using VoronoiBuilder =
    boost::polygon::voronoi_builder<boost::polygon::detail::int32, BuilderTraits, Predicates>;

}  // namespace clearcut::inline geometry::voronoi
