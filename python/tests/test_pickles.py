# SPDX-License-Identifier: MIT
"""Everything pickles, and pickles of other versions are refused."""

import copy
import pickle

import numpy
import pytest

import tutavia
from conftest import bits
from tutavia import searches, smoothers


def again(value):
    return pickle.loads(pickle.dumps(value))


def test_a_workspace_keeps_its_obstacles_to_the_bit():
    workspace = tutavia.Workspace(
        (0, 0, 1 / 3, 7), [tutavia.Disc((0.1, 0.2), 0.3), tutavia.Polygon(
            numpy.random.default_rng(2).random((5, 2)), [numpy.random.default_rng(3).random((3, 2))])],
        0.1)
    copied = again(workspace)
    assert copied.bounds == workspace.bounds and copied.safety_radius == workspace.safety_radius
    assert copied.obstacles[0] == workspace.obstacles[0]
    assert (copied.obstacles[1].outer == workspace.obstacles[1].outer).all()
    assert (copied.obstacles[1].holes[0] == workspace.obstacles[1].holes[0]).all()


@pytest.mark.parametrize("edges", ["uniform", "paper_strict"])
def test_a_lattice_is_rebuilt_as_it_was(maze, edges):
    space = tutavia.LatticeSpace(maze.workspace, resolution=0.2, edges=edges)
    copied = again(space)
    assert copied._digest() == space._digest()
    assert (copied.grid == space.grid).all()
    assert bits(tutavia.plan(copied, (2, 1), (14, 6)).curve) == bits(
        tutavia.plan(space, (2, 1), (14, 6)).curve)


def test_cells_are_rebuilt_as_they_were():
    random = numpy.random.default_rng(4)
    space = tutavia.CellSpace.from_numpy(random.random((37, 53)) < 0.8, 0.1, (1 / 3, -2 / 7), 0.03,
                                         movement="no_squeeze")
    copied = again(space)
    assert copied._digest() == space._digest()
    assert copied.origin == space.origin and copied.resolution == space.resolution
    assert (copied.free == space.free).all()
    assert len(pickle.dumps(space)) < 600  # a bit per cell


def test_plans_keep_everything_but_the_space(lattice):
    for smoother in ("none", "clothoid", "delta", "bezier", "b_spline"):
        plan = tutavia.plan(lattice, (2, 1), (14, 6), smoother=smoother)
        copied = again(plan)
        assert copied.curve == plan.curve and bits(copied.curve) == bits(plan.curve)
        assert bits(copied.route) == bits(plan.route)
        for part, names in (("certificate", ("status", "lower", "upper", "point", "piece",
                                             "parameter", "obstacle", "evaluations")),
                            ("metrics", ("length", "turning_angle", "max_curvature",
                                         "max_curvature_jump", "min_clearance")),
                            ("stats", ("expanded", "search_us", "seed"))):
            for name in names:
                assert getattr(getattr(copied, part), name) == getattr(getattr(plan, part), name)
        assert copied.space is None


def test_plans_of_vehicles_keep_their_gears(lattice):
    plan = tutavia.plan(lattice, (2, 1), (5, 4), "hybrid_astar", "vehicle_shortcut",
                        vehicle=tutavia.Vehicle.car(0.6, 0.3, 0.4, 0.5))
    copied = again(plan)
    assert copied.gears == plan.gears and copied.vehicle == plan.vehicle
    assert bits(copied.curve) == bits(plan.curve)


def test_batches_keep_plans_and_failures(lattice):
    points = numpy.random.default_rng(9).uniform(0, 16, (2, 50, 2))
    for keep_plans in (True, False):
        batch = tutavia.plan_batch(lattice, *points, keep_plans=keep_plans)
        copied = again(batch)
        assert copied.status == batch.status
        assert numpy.array_equal(copied.length, batch.length, equal_nan=True)
        for i in range(len(batch) if keep_plans else 0):
            if batch.planned[i]:
                assert bits(copied[i].curve) == bits(batch[i].curve)
            else:
                assert copied[i].__dict__ == batch[i].__dict__


def test_all_else_that_users_hold(lattice):
    plan = tutavia.plan(lattice, (2, 1), (14, 6))
    profile = plan.speed_profile(max_speed=2)
    assert again(profile).sample(0.3).speed.tolist() == profile.sample(0.3).speed.tolist()
    assert bits(again(plan.curve)) == bits(plan.curve)
    assert again(plan.certificate).lower == plan.certificate.lower
    assert again(plan.metrics).length == plan.metrics.length
    assert again(plan.stats).expanded == plan.stats.expanded
    assert again(searches.rrt(goal_bias=0.2)) == searches.rrt(goal_bias=0.2)
    planner = tutavia.Planner(searches.weighted_astar(weight=2), smoothers.bezier(trim=0.4))
    assert repr(again(planner)) == repr(planner)
    assert bits(again(planner).plan(lattice, (2, 1), (14, 6)).curve) == bits(
        planner.plan(lattice, (2, 1), (14, 6)).curve)
    queries = tutavia.Queries(numpy.ones((3, 2)), numpy.zeros((3, 2)), [0, numpy.nan, 1],
                              seeds=[3, 4, 5])
    assert again(queries).seeds.tolist() == [3, 4, 5]
    samples = plan.curve.sample(1)
    assert (again(samples).position == samples.position).all()
    assert (again(tutavia.builtin_map("array")).start) == (2, 1)
    copy.copy(lattice), copy.deepcopy(plan)


@pytest.mark.parametrize("make, kind", [
    (lambda: tutavia.builtin_map("maze").workspace, "Workspace"),
    (lambda: tutavia.LatticeSpace(tutavia.builtin_map("maze").workspace), "LatticeSpace"),
    (lambda: tutavia.CellSpace.from_numpy(numpy.ones((3, 3), bool)), "CellSpace"),
])
def test_pickles_of_another_version_are_refused(make, kind):
    value = make()
    state = value.__getstate__()
    assert state[0] == kind and state[2] == tutavia.__version__
    fresh = type(value).__new__(type(value))
    for other in ((kind, 99, *state[2:]), (kind, state[1], "9.9.9", *state[3:])):
        with pytest.raises(tutavia.InvalidInput, match="install the same version in both"):
            fresh.__setstate__(other)
    with pytest.raises(tutavia.InvalidInput, match="this is no pickle"):
        fresh.__setstate__(("Other", *state[1:]))
    with pytest.raises(tutavia.InvalidInput):
        fresh.__setstate__(state[:-1])


def test_damaged_curves_are_refused(lattice):
    curve = tutavia.plan(lattice, (2, 1), (14, 6)).curve
    head, kinds, numbers = curve.__getstate__()[:3], *curve.__getstate__()[3:]
    fresh = tutavia.Curve.__new__(tutavia.Curve)
    for damaged in ((kinds, numbers[:-8]), (b"\x09" * len(kinds), numbers),
                    (kinds, numbers[:32] + numbers[40:] + numbers[:8])):
        with pytest.raises(tutavia.InvalidInput, match="damaged"):
            fresh.__setstate__((*head, *damaged))


def test_damaged_batches_are_refused(lattice):
    points = numpy.random.default_rng(9).uniform(0, 16, (2, 20, 2))
    batch = tutavia.plan_batch(lattice, *points)
    state = batch.__getstate__()
    head, queries, codes, fell_back, figures, expanded, plans = state[:3], *state[3:]
    fresh = tutavia.Batch.__new__(tutavia.Batch)
    for damaged in ((queries[:3], codes, fell_back, figures, expanded, plans),
                    (queries, codes[:-1], fell_back, figures, expanded, plans),
                    (queries, b"\x20" * 20, fell_back, figures, expanded, plans),
                    (queries, codes, fell_back[1:], figures, expanded, plans),
                    (queries, codes, fell_back, figures[:, :3], expanded, plans),
                    (queries, codes, fell_back, figures, expanded[:7], plans),
                    (queries, codes, fell_back, figures, expanded, plans[:-1]),
                    (queries, codes, fell_back, figures, expanded, plans[::-1])):
        with pytest.raises(tutavia.InvalidInput, match="damaged"):
            fresh.__setstate__((*head, *damaged))
    fresh.__setstate__(state)
    assert fresh.status == batch.status


def test_a_planner_may_be_derived_from(lattice):
    class Counting(tutavia.Planner):
        count = 0

        def plan(self, *arguments, **options):
            self.count += 1
            return super().plan(*arguments, **options)

    planner = Counting("jps")
    assert planner.plan(lattice, (2, 1), (14, 6)).length > 0 and planner.count == 1
