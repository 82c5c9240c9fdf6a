# SPDX-License-Identifier: MIT
"""Input that is refused, and what the messages name."""

import math

import numpy
import pytest

import tutavia
from tutavia import searches


@pytest.mark.parametrize("start", [(1,), (1, 2, 3), "ab", b"ab", 7, None, (1, "x"), {"x": 1},
                                   numpy.zeros((2, 2)), [(1, 2)], {1, 2}, {1: 2, 3: 4}])
def test_points_of_other_shapes(lattice, start):
    with pytest.raises(tutavia.InvalidInput, match=r"start: expected two numbers \(x, y\)"):
        tutavia.plan(lattice, start, (14, 6))


@pytest.mark.parametrize("goal", [(math.nan, 1), (1, math.inf), numpy.array([math.nan, 2])])
def test_points_that_are_not_finite(lattice, goal):
    with pytest.raises(tutavia.Failure):
        tutavia.plan(lattice, (2, 1), goal)


@pytest.mark.parametrize("point", [[2, 1], numpy.array([2, 1]), numpy.array([2.0, 1.0]),
                                   numpy.float32([2, 1]), iter((2, 1))])
def test_pairs_of_any_kind_are_points(lattice, point):
    assert tutavia.plan(lattice, point, (14, 6)).curve.waypoints[0].tolist() == [2, 1]


@pytest.mark.parametrize("free, message", [
    (numpy.zeros((3, 4)), "dtype bool.*float64"),
    (numpy.zeros((3, 4), dtype=numpy.int8), "dtype bool.*int8.*costs < 100"),
    (numpy.ones(4, dtype=bool), r"shape \(height, width\).*\(4,\)"),
    (numpy.ones((2, 3, 4), dtype=bool), r"shape \(height, width\)"),
    ([[True, False]], "numpy array"),
    (None, "numpy array"),
])
def test_cells_of_other_dtypes_and_shapes(free, message):
    with pytest.raises(tutavia.InvalidInput, match=message):
        tutavia.CellSpace.from_numpy(free)


@pytest.mark.parametrize("options, message", [
    ({"resolution": 0}, "resolution"),
    ({"resolution": math.nan}, "resolution"),
    ({"safety_radius": -1}, "safety_radius"),
    ({"safety_radius": math.nan}, "safety_radius"),
    ({"origin": (math.nan, 0)}, "origin"),
    ({"origin": 3}, "origin"),
    ({"movement": "no_cuts"}, "movement.*no_cut"),
])
def test_options_of_cells(options, message):
    with pytest.raises(ValueError, match=message):
        tutavia.CellSpace.from_numpy(numpy.ones((3, 3), dtype=bool), **options)


def test_views_and_orders_of_memory_do_not_matter():
    free = numpy.random.default_rng(1).random((9, 14)) < 0.6
    for view in (free, free[::-1], free[:, ::2], numpy.asfortranarray(free), free.T):
        assert (tutavia.CellSpace.from_numpy(view).free == view).all()


@pytest.mark.parametrize("obstacles, message", [
    ([5], r"obstacles\[0\]: int is no obstacle"),
    (["POLYGON ((0 0, 1 0, 1 1))"], r"obstacles\[0\]: str is no obstacle"),
    (7, "expected obstacles, got int"),
    ([numpy.zeros((3, 1))], r"obstacles\[0\].*\(n, 2\).*\(3, 1\)"),
    ([[(0, 0), (1, 0), (1, 1)], numpy.zeros(4)], r"obstacles\[1\].*\(n, 2\)"),
    ([[(0, 0), (1, "x"), (1, 1)]], r"obstacles\[0\]: expected pairs of numbers"),
    ([[(0, 0), (1, math.nan), (1, 1)]], r"obstacles\[0\].polygon\[1\] must be finite"),
    ([tutavia.Disc((0, 0), -1)], r"obstacles\[0\]: radius"),
    ([tutavia.Disc((0, 0), math.nan)], r"obstacles\[0\]: radius"),
    ([tutavia.Disc((0, math.inf), 1)], r"obstacles\[0\].center"),
    ([{"type": "Sphere", "coordinates": []}], r"obstacles\[0\].*'Sphere' is no obstacle.*Polygon"),
    ([{}], r"type None is no obstacle"),
    ([{"type": []}], r"type \[\] is no obstacle"),
    ([{"type": "FeatureCollection"}],
     r"obstacles\[0\]: a FeatureCollection has a list of features"),
    ([{"type": "FeatureCollection", "features": ["tree"]}], r"features\[0\]: expected a GeoJSON"),
    ([{"type": "GeometryCollection", "geometries": 3}], "has a list of geometries, found 3"),
    ([{"type": "Polygon", "coordinates": 5}], "these are no coordinates of a Polygon"),
    ([{"type": "Point", "coordinates": [1]}], r"obstacles\[0\].*\(n, 2\)"),
    ([numpy.zeros((4, 3))], r"obstacles\[0\].*\(n, 2\).*\(4, 3\)"),
    ([{"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": {
        "type": "CircularString", "coordinates": [[0, 0]]}}]}], r"features\[0\].*CircularString"),
])
def test_what_is_no_obstacle(obstacles, message):
    with pytest.raises(tutavia.InvalidInput, match=message):
        tutavia.Workspace((0, 0, 9, 9), obstacles)


@pytest.mark.parametrize("bounds, radius, message", [
    ((0, 0, 9), 0, r"bounds.*\(4,\)"),
    ((9, 9, 0, 0), 0, "bounds are empty"),
    ((0, 0, math.nan, 9), 0, "bounds must be finite"),
    ("abcd", 0, "bounds"),
    ((0, 0, 9, 9), -1, "safety_radius"),
    ((0, 0, 9, 9), math.nan, "safety_radius"),
])
def test_bounds_and_radius_of_a_workspace(bounds, radius, message):
    with pytest.raises(tutavia.InvalidInput, match=message):
        tutavia.Workspace(bounds, [], radius)


@pytest.mark.parametrize("options, message", [
    ({"goal_bais": 0.1, "search": "rrt_star"}, "did you mean goal_bias?"),
    ({"max_iteration": 9, "search": "rrt_star"}, "did you mean max_iterations?"),
    ({"min_turning_radus": 1}, "did you mean min_turning_radius?"),
    ({"time_limits": 1}, "did you mean time_limit?"),
    ({"search": "astr"}, "did you mean astar?"),
    ({"smoother": "clothiod"}, "did you mean clothoid?"),
    ({"search": 3}, "search: expected a name"),
    ({"search": "rrt_star", "goal_bias": "often"}, "goal_bias: expected a number"),
    ({"search": "rrt_star", "goal_bias": [1]}, "goal_bias"),
    ({"search": "rrt_star", "goal_bias": math.nan}, "goal_bias: expected a number"),
    ({"search": "rrt_star", "goal_bias": 7}, "goal_bias"),
    ({"search": "rrt_star", "max_iterations": 1.5}, "max_iterations: expected a whole number"),
    ({"heuristic": "euclid"}, "heuristic: expected octile, euclidean"),
    ({"search": "hybrid_astar", "smoother": "vehicle_shortcut", "cusp_cost": 1},
     "hybrid_astar and vehicle_shortcut have it.*searches.hybrid_astar"),
    ({"search": "string_pull"}, "search: unknown name"),
    ({"time_limit": -1}, "time_limit"),
    ({"time_limit": "soon"}, "time_limit"),
    ({"max_expansions": -1}, "max_expansions"),
    ({"max_expansions": 1.5}, "max_expansions"),
    ({"max_expansions": True}, "max_expansions"),
    ({"max_expansions": 2**64}, "max_expansions: expected a whole number from 0 to"),
    ({"seed": -1}, "seed: expected a whole number"),
    ({"seed": "one"}, "seed: expected a whole number"),
    ({"start_heading": 1.0}, "start_heading.*hybrid_astar"),
    ({"vehicle": 3}, "vehicle: expected a tutavia.Vehicle"),
    ({"search": tutavia.smoothers.clothoid()}, "clothoid is a smoother"),
])
def test_options_of_plans(lattice, options, message):
    with pytest.raises(ValueError, match=message):
        tutavia.plan(lattice, (2, 1), (14, 6), **options)


def test_whole_numbers_of_numpy_are_whole_numbers(lattice):
    for kind in (numpy.int8, numpy.uint64):
        plan = tutavia.plan(lattice, (2, 1), (14, 6), seed=kind(3))
        assert plan.stats.seed == 3
    with pytest.raises(tutavia.BudgetExhausted):
        tutavia.plan(lattice, (2, 1), (14, 6), max_expansions=numpy.int64(2))


@pytest.mark.parametrize("option", ["time_limit", "max_expansions", "seed", "threads"])
def test_planners_have_no_options_of_queries(option):
    with pytest.raises(tutavia.InvalidOption, match=f"^invalid_option: {option}: no option of an "
                                                    "algorithm.*Planner.plan"):
        tutavia.Planner("astar", **{option: 1})


def test_options_of_another_type_are_other_options(lattice):
    for _ in range(2):
        tutavia.plan(lattice, (2, 1), (14, 6), "rrt", max_iterations=100000)
        tutavia.plan(lattice, (2, 1), (14, 6), "weighted_astar", weight=1)
        with pytest.raises(tutavia.InvalidOption, match="weight: expected a number"):
            tutavia.plan(lattice, (2, 1), (14, 6), "weighted_astar", weight=True)


def test_options_of_algorithms_are_checked_where_they_are_given():
    with pytest.raises(tutavia.InvalidOption, match="did you mean goal_bias?"):
        searches.rrt_star(goal_bais=0.1)
    with pytest.raises(tutavia.InvalidOption, match="there are none"):
        searches.jps(weight=1)


def test_what_is_no_space(maze):
    for space in (maze.workspace, None, 3):
        with pytest.raises(tutavia.InvalidInput, match="expected a LatticeSpace or a CellSpace"):
            tutavia.plan(space, (2, 1), (14, 6))


@pytest.mark.parametrize("starts, goals, message", [
    (numpy.zeros((3, 3)), numpy.zeros((3, 2)), r"starts.*\(n, 2\).*\(3, 3\)"),
    (numpy.zeros((3, 2)), numpy.zeros(2), r"goals.*\(n, 2\).*\(2,\)"),
    (numpy.zeros((3, 2)), numpy.zeros((4, 2)), "3 and 4"),
    (numpy.zeros((3, 2), dtype=complex), numpy.zeros((3, 2)), "real numbers.*complex128"),
    (numpy.array([["a", "b"]]), numpy.zeros((1, 2)), "real numbers"),
    ([[1, 2], [3]], numpy.zeros((2, 2)), "starts"),
])
def test_tables_of_queries(lattice, starts, goals, message):
    with pytest.raises(tutavia.InvalidInput, match=message):
        tutavia.plan_batch(lattice, starts, goals)


def test_seeds_and_headings_of_queries():
    two = numpy.zeros((2, 2))
    with pytest.raises(tutavia.InvalidInput, match="seeds"):
        tutavia.Queries(two, two, seeds=[0.5, 1.5])
    with pytest.raises(tutavia.InvalidInput, match="seeds.*not negative"):
        tutavia.Queries(two, two, seeds=[3, -1])
    with pytest.raises(tutavia.InvalidInput, match="start_headings"):
        tutavia.Queries(two, two, start_headings=[0.5])


@pytest.mark.parametrize("threads", [-1, 1.5, "two", 10**6])
def test_threads_of_a_batch(lattice, threads):
    with pytest.raises(tutavia.InvalidOption,
                       match="threads: expected a whole number from 0 to 4096"):
        tutavia.plan_batch(lattice, [[2, 1]], [[14, 6]], threads=threads)


@pytest.mark.parametrize("text, message", [
    ("", "line 1: no column is named start_x"),
    ("x,y\n1,2\n", "line 1: no column is named start_x"),
    ("start_x,start_y,goal_x,gaol_y\n", "line 1.*goal_y.*is it \"gaol_y\""),
    ("start_x,start_y,goal_x,goal_y\n1,2,3\n", "line 2: expected 4 columns, found 3"),
    ("start_x,start_y,goal_x,goal_y\n1,2,3,4\n1,2,3,nan\n", "line 3: goal_y"),
    ("start_x,start_y,goal_x,goal_y\n1,2,3,\n", "line 2: goal_y"),
    ("start_x,start_y,goal_x,goal_y,seed\n1,2,3,4,-5\n", "line 2: seed"),
])
def test_files_of_queries(tmp_path, text, message):
    path = tmp_path / "queries.csv"
    path.write_text(text)
    with pytest.raises(tutavia.InvalidInput, match=message):
        tutavia.Queries.from_csv(path)


def test_files_of_queries_may_have_more_columns_and_lines(tmp_path):
    path = tmp_path / "queries.csv"
    path.write_bytes(b"\xef\xbb\xbfid,goal_y,goal_x,start_y,start_x,start_heading\r\n"
                     b"a, 4 ,3,2,\"1\",\r\n\r\nb,8,7,6,5,0.5\r\n")
    queries = tutavia.Queries.from_csv(path)
    assert queries.starts.tolist() == [[1, 2], [5, 6]]
    assert queries.goals.tolist() == [[3, 4], [7, 8]]
    assert math.isnan(queries.start_headings[0]) and queries.start_headings[1] == 0.5


@pytest.mark.parametrize("ds", [0, -1, math.nan, math.inf, 1e-12])
def test_steps_of_samples(lattice, ds):
    plan = tutavia.plan(lattice, (2, 1), (14, 6))
    with pytest.raises(tutavia.InvalidOption, match="ds"):
        plan.curve.sample(ds)
    if ds != math.inf:
        with pytest.raises(tutavia.InvalidOption, match="dt"):
            plan.speed_profile().sample(ds)


def test_nan_is_no_place(lattice, cells):
    curve = tutavia.plan(lattice, (2, 1), (14, 6)).curve
    for point in ((math.nan, 1), (1, math.inf)):
        with pytest.raises(tutavia.InvalidInput, match="point: expected two finite numbers"):
            curve.nearest(point)
    for s in (math.nan, "x", None, [1.0, math.nan], numpy.zeros((2, 2)), [[1], [2, 3]]):
        with pytest.raises(tutavia.InvalidInput, match="^invalid_input: s"):
            curve.at(s)
    class Series:  # as pandas has it
        def __float__(self):
            return 0.5

        def __array__(self, dtype=None, copy=None):
            return numpy.array([0.5])

    assert curve.at(Series()).s.tolist() == [0.5] and curve.at(numpy.float32(0.5)).s == 0.5
    assert curve.at(math.inf).s == curve.at(numpy.array(1e9)).s == curve.length
    for times in (3.0, "x", [math.nan]):
        with pytest.raises(tutavia.InvalidInput, match="times"):
            tutavia.SpeedProfile(curve).at(times)
    for space in (lattice, cells):
        assert math.isnan(space.clearance((math.nan, 1))) and not space.is_free((math.nan, 1))
        assert numpy.isnan(space.clearance(numpy.array([[1, math.nan], [1, 1]]))).tolist() == [
            True, False]


@pytest.mark.parametrize("car", [(0, 1, 0, 1), (4, -1, 2, 5), (4, 2, 5, 5), (4, 2, 2, -1),
                                 (math.nan, 1, 1, 1), (4, 2, 2, 0)])
def test_cars_that_cannot_be(car):
    with pytest.raises(tutavia.InvalidOption):
        tutavia.Vehicle.car(*car)


def test_footprints_of_other_shapes():
    with pytest.raises(tutavia.InvalidInput, match=r"footprint.*\(n, 3\)"):
        tutavia.Vehicle(1, footprint=numpy.zeros((2, 2)))
    with pytest.raises(tutavia.InvalidOption, match="disc 0"):
        tutavia.Vehicle(1, footprint=[[0, 0, -1]])


def test_maps_that_are_not_there(tmp_path):
    for load in (tutavia.CellSpace.from_ros_map, tutavia.CellSpace.from_moving_ai):
        with pytest.raises(ValueError):
            load(tmp_path / "none")
    with pytest.raises(tutavia.InvalidOption, match="maze"):
        tutavia.builtin_map("attic")
