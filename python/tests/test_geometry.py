"""Outlines, regions, offsets, clearance; tours and studies."""
import math
import unittest

import numpy
from support import L_SHAPE, pocket

import clearcut

SQUARE = [[0, 0], [20, 0], [20, 20], [0, 20]]


class Outlines(unittest.TestCase):
    def test_from_lists_arrays_and_regions(self):
        for given in (SQUARE, numpy.array(SQUARE), numpy.array(SQUARE, dtype=numpy.float32), (SQUARE, [])):
            self.assertAlmostEqual(clearcut.region(given if not isinstance(given, tuple) else given[0]).area, 400)
        region = clearcut.region(SQUARE, [[[5, 5], [10, 5], [10, 10], [5, 10]]])
        self.assertAlmostEqual(region.area, 375)
        self.assertAlmostEqual(clearcut.regions(region)[0].area, 375)

    def test_bulges_are_arcs(self):
        circle = clearcut.region([[-5, 0, 1], [5, 0, 1]])
        self.assertAlmostEqual(circle.area, math.pi * 25, 9)
        numpy.testing.assert_allclose(circle.outer[:, 2], 1)

    def test_from_shapely(self):
        try:
            from shapely.geometry import MultiPolygon, Point, Polygon, shape
        except ImportError:
            self.skipTest("shapely is absent")
        ring = Polygon(SQUARE, [[[5, 5], [10, 5], [10, 10], [5, 10]]])
        self.assertAlmostEqual(clearcut.region(ring.exterior.coords[:-1]).area, 400)
        part = clearcut.part(MultiPolygon([ring, Polygon([[30, 0], [40, 0], [40, 10]])]), depth=3)
        self.assertEqual([round(sum(r.area for r in f.target)) for f in part.features], [375, 50])
        back = shape(part.features[0].target[0])
        self.assertAlmostEqual(back.area, 375)
        with self.assertRaisesRegex(clearcut.InputError, "a Point bounds no area"):
            clearcut.part(Point(0, 0), depth=1)

    def test_what_crosses_itself_is_refused_with_its_place(self):
        with self.assertRaises(clearcut.InputError):
            clearcut.part([[0, 0], [20, 20], [20, 0], [0, 20]], depth=1)
        with self.assertRaisesRegex(clearcut.InputError, "not finite"):
            clearcut.part([[0, 0], [math.nan, 0], [1, 1]], depth=1)
        with self.assertRaisesRegex(clearcut.InputError, "there are none"):
            clearcut.part([], depth=1)

    def test_a_part_knows_its_features(self):
        part = pocket(stock=((-5, 65), (-5, 45), (-10, 0)))
        (feature,) = part.features
        self.assertEqual((feature.kind, feature.top_z, feature.floor_z), ("closed_pocket", 0, -4))
        self.assertEqual(part.clearance_z, None)
        again = clearcut.read_part_text(part.to_json(), "again.json")
        self.assertAlmostEqual(again.features[0].target[0].area, feature.target[0].area)


class Regions(unittest.TestCase):
    def setUp(self):
        self.square = clearcut.region(SQUARE)

    def test_booleans(self):
        other = clearcut.region([[10, 10], [30, 10], [30, 30], [10, 30]])

        def area(regions):
            return sum(region.area for region in regions)

        self.assertAlmostEqual(area(clearcut.unite([self.square], [other])), 700)
        self.assertAlmostEqual(area(clearcut.subtract([self.square], [other])), 300)
        self.assertAlmostEqual(area(clearcut.intersect([self.square], [other])), 100)

    def test_offsets(self):
        (inner,) = clearcut.inset(self.square, 3)
        self.assertAlmostEqual(inner.area, 14 * 14, 6)
        (outer,) = clearcut.dilate([self.square], 3)
        self.assertAlmostEqual(outer.area, 400 + 4 * 60 + math.pi * 9, 1)

    def test_clearance(self):
        clearance = clearcut.Clearance(self.square)
        self.assertAlmostEqual(clearance.max, 10, 6)
        self.assertEqual([len(level) for level in clearance.insets([1, 5, 11])], [1, 1, 0])
        points, edges = clearance.axis()
        self.assertEqual((points.shape[1], edges.shape[1]), (3, 2))
        self.assertLess(edges.max(), len(points))
        self.assertAlmostEqual(points[:, 2].max(), 10, 6)
        self.assertGreaterEqual(len(clearance.axis_curve(0)), 2)
        with self.assertRaises(IndexError):
            clearance.axis_curve(10_000)

    def test_asks(self):
        self.assertTrue(self.square.contains(1, 1))
        self.assertFalse(self.square.contains(21, 1))
        self.assertAlmostEqual(self.square.boundary_distance(10, 4), 4)
        self.assertEqual(self.square.box, (0, 0, 20, 20))


class ToursAndStudies(unittest.TestCase):
    def test_a_lattice_is_ordered(self):
        tour = clearcut.tour("6x6", time=5)
        self.assertEqual(sorted(tour.order), list(range(36)))
        self.assertAlmostEqual(tour.length, 35)
        self.assertEqual(tour.gap, 0)

    def test_points_of_ones_own(self):
        angle = numpy.linspace(0, 2 * math.pi, 12, endpoint=False)
        points = numpy.column_stack([numpy.cos(angle), numpy.sin(angle)])[[3, 0, 7, 1, 9, 2, 11, 4, 10, 5, 8, 6]]
        tour = clearcut.tour(points, time=2)
        self.assertAlmostEqual(tour.length, 24 * math.sin(math.pi / 12))
        with self.assertRaisesRegex(clearcut.InputError, "rows x, y"):
            clearcut.tour(numpy.zeros((3, 3)))

    def test_a_study_goes_on_from_its_rows(self):
        told = []
        study = clearcut.study("mutation", runs=2, generations=20, side=5, progress=lambda *at: told.append(at))
        self.assertEqual(told[-1][0], told[-1][1])
        columns = study.columns()
        self.assertEqual(len(columns["level"]), len(columns["best"]))
        again = clearcut.study("mutation", runs=2, generations=20, side=5, csv=study.csv())
        self.assertEqual(again.csv(), study.csv())
        self.assertIn("exchange", str(study.table()))
        self.assertIn("mutation", clearcut.study_names())

    def test_a_study_on_islands(self):
        options = dict(runs=1, generations=20, side=5, islands=3, migrate_every=5, migrants=2)
        study = clearcut.study("spread", **options)
        self.assertIn(",3,5,2,1,20,", study.csv())
        self.assertEqual(clearcut.study("spread", threads=1, **options).csv(), study.csv())
        with self.assertRaisesRegex(clearcut.InputError, "migrants"):
            clearcut.study("spread", islands=2, migrants=25)


if __name__ == "__main__":
    unittest.main()
