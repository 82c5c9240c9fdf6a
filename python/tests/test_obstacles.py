# SPDX-License-Identifier: MIT
"""Obstacles from shapely and from anything with __geo_interface__."""

import numpy
import pytest

import tutavia

shapely = pytest.importorskip("shapely.geometry")

SQUARE = [(1, 1), (3, 1), (3, 3), (1, 3)]


def space_of(*obstacles, radius=0.0):
    return tutavia.LatticeSpace(tutavia.Workspace((0, 0, 10, 10), obstacles, radius),
                                resolution=0.5)


def same(a, b):
    points = numpy.random.default_rng(8).uniform(0, 10, (500, 2))
    return (a.clearance(points) == b.clearance(points)).all()


def test_polygons_of_every_kind_are_the_same():
    plain = space_of(SQUARE)
    for obstacle in (numpy.array(SQUARE), tuple(SQUARE), tutavia.Polygon(SQUARE),
                     shapely.Polygon(SQUARE), shapely.Polygon([(*p, 5) for p in SQUARE]),
                     shapely.MultiPolygon([shapely.Polygon(SQUARE)]),
                     {"type": "Polygon", "coordinates": [SQUARE]},
                     {"type": "Feature", "properties": None,
                      "geometry": {"type": "Polygon", "coordinates": [SQUARE]}},
                     shapely.GeometryCollection([shapely.Polygon(SQUARE)])):
        assert same(space_of(obstacle), plain)
    assert same(space_of(numpy.array(SQUARE)), tutavia.LatticeSpace(
        tutavia.Workspace((0, 0, 10, 10), numpy.array(SQUARE)), resolution=0.5))


def test_holes_are_free_inside():
    ring = shapely.Polygon([(0, 0), (9, 0), (9, 9), (0, 9)], [SQUARE])
    space = space_of(ring)
    assert space.is_free((2, 2)) and not space.is_free((5, 5))
    assert same(space, space_of(tutavia.Polygon([(0, 0), (9, 0), (9, 9), (0, 9)], [SQUARE])))


def test_lines_are_walls_and_points_are_discs():
    space = space_of(shapely.LineString([(2, 0), (2, 5), (6, 5)]), radius=0.1)
    assert space.clearance((3, 2)) == 1 and not space.is_free((2, 3))
    points = space_of(shapely.MultiPoint([(1, 1), (5, 5)]), radius=0.1)
    assert points.clearance((5, 7)) == 2
    feature = {"type": "Feature", "properties": {"radius": 0.5},
               "geometry": {"type": "Point", "coordinates": [5, 5]}}
    assert same(space_of(feature), space_of(tutavia.Disc((5, 5), 0.5)))
    assert space_of(shapely.Point(5, 5).buffer(1)).clearance((5, 5)) < 0


def test_nothing_is_no_obstacle():
    assert len(tutavia.Workspace((0, 0, 1, 1)).obstacles) == 0
    for nothing in (shapely.Polygon(), shapely.GeometryCollection(), shapely.MultiPolygon(),
                    {"type": "Feature", "properties": {}, "geometry": None}):
        assert len(tutavia.Workspace((0, 0, 1, 1), [nothing]).obstacles) == 0


def test_anything_with_a_geo_interface_is_an_obstacle():
    class Machine:
        __geo_interface__ = {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {}, "geometry": {
                "type": "MultiLineString", "coordinates": [[(0, 0), (1, 1)], [(2, 2), (3, 3)]]}},
            {"type": "Feature", "properties": {}, "geometry": {
                "type": "Polygon", "coordinates": [SQUARE]}}]}

    assert len(tutavia.Workspace((0, 0, 9, 9), Machine()).obstacles) == 3
    assert len(tutavia.Workspace((0, 0, 9, 9), (Machine() for _ in range(2))).obstacles) == 6


def space_of_table(table):
    return tutavia.LatticeSpace(tutavia.Workspace((0, 0, 10, 10), table), resolution=0.5)


def test_tables_of_geopandas_are_their_geometries():
    geometries = [shapely.Polygon(SQUARE), shapely.Point(5, 5)]
    geopandas = pytest.importorskip("geopandas")
    frame = geopandas.GeoDataFrame({"name": ["a", "b"]}, geometry=geometries, index=[7, 3])
    for table in (frame, frame.geometry):
        assert same(space_of_table(table), space_of(*geometries))
    assert same(space_of_table(frame.iloc[0]), space_of(geometries[0]))
    frame.loc[3, "geometry"] = None
    with pytest.raises(tutavia.InvalidInput, match=r"obstacles\[1\]: NoneType is no obstacle"):
        space_of_table(frame)


def test_the_index_of_an_obstacle_is_that_of_its_part():
    space = space_of(shapely.MultiPolygon([shapely.Polygon(SQUARE),
                                           shapely.Polygon([(5, 5), (6, 5), (6, 6)])]))
    with pytest.raises(tutavia.StartBlocked) as caught:
        tutavia.plan(space, (5.9, 5.5), (9, 9))
    assert caught.value.obstacle == 1
