# SPDX-License-Identifier: MIT
"""Spaces, plans, curves and failures."""

import math
import pickle
import threading

import numpy
import pytest

import tutavia
from conftest import bits
from tutavia import searches, smoothers


def test_a_plan_of_the_maze_is_proved_and_as_long_as_in_the_readme(lattice):
    plan = tutavia.plan(lattice, (2, 1), (14, 6))
    assert plan.certificate.status == "proved"
    assert plan.certificate.lower >= 0.3 - 1e-9
    assert f"{plan.length:.3f}" == "17.603"
    assert f"{lattice.shortest_length((2, 1), (14, 6)):.3f}" == "17.562"
    assert plan.space is lattice


def test_the_curve_is_sampled_as_arrays_with_both_ends_exact(lattice):
    curve = tutavia.plan(lattice, (2, 1), (14, 6)).curve
    samples = curve.sample(0.1)
    n = len(samples.s)
    assert n == math.ceil(curve.length / 0.1) + 1
    assert samples.position.shape == (n, 2)
    assert samples.heading.shape == samples.curvature.shape == (n,)
    assert all(column.dtype == numpy.float64 for column in samples)
    assert samples.position[0].tolist() == [2, 1]
    assert samples.position[-1].tolist() == [14, 6]
    assert samples.s[0] == 0 and samples.s[-1] == curve.length
    steps = numpy.hypot(*numpy.diff(samples.position, axis=0).T)
    assert (steps <= numpy.diff(samples.s) + 1e-9).all()
    turns = numpy.unwrap(samples.heading)
    assert numpy.allclose(numpy.diff(turns), 0.05 * (samples.curvature[1:] + samples.curvature[:-1])
                          * numpy.diff(samples.s) / 0.1, atol=0.05)


def test_single_states_and_nearest_points_agree_with_samples(lattice):
    curve = tutavia.plan(lattice, (2, 1), (14, 6)).curve
    samples = curve.sample(0.5)
    again = curve.at(samples.s)
    assert (again.position == samples.position).all()
    one = curve.at(samples.s[7])
    assert one.position == tuple(samples.position[7])
    s, position, distance = curve.nearest(samples.position[7])
    assert distance < 1e-9 and abs(s - samples.s[7]) < 1e-6
    assert curve.waypoints.shape == (len(curve) + 1, 2)
    assert curve.reversed().reversed().length == pytest.approx(curve.length)


def test_cells_lie_where_the_manual_says(cells):
    assert cells.shape == (20, 60)
    assert cells.origin == (-3, 2) and cells.bounds == (-3, 2, 27, 12)
    free = cells.free
    for x, y in ((0, 0), (3, 15), (3, 4), (59, 19)):
        centre = (-3 + 0.5 * (x + 0.5), 2 + 0.5 * (y + 0.5))
        assert (cells.clearance(centre) > 0) == bool(free[y, x])


def test_points_are_asked_one_at_a_time_or_as_an_array(lattice):
    points = numpy.random.default_rng(5).uniform(0, 16, (200, 2))
    free = lattice.is_free(points)
    clearance = lattice.clearance(points)
    assert free.dtype == bool and clearance.shape == (200,)
    assert free.tolist() == [lattice.is_free(tuple(p)) for p in points]
    assert clearance.tolist() == [lattice.clearance(p) for p in points]
    assert (free == (clearance >= 0.3)).all()


@pytest.mark.parametrize("name", sorted(tutavia.describe_searches()))
def test_every_search_plans_or_says_why_not(name, lattice, cells):
    described = tutavia.describe_searches()[name]
    smoother = "vehicle_shortcut" if name == "hybrid_astar" else "none"
    for space, works, ends in ((lattice, described.on_lattice, ((2, 1), (14, 6))),
                               (cells, described.on_cells, ((-2.75, 2.75), (-0.25, 9.25)))):
        if not works:
            with pytest.raises(tutavia.InvalidOption):
                tutavia.plan(space, *ends, search=name, smoother=smoother)
            continue
        try:
            plan = tutavia.plan(space, *ends, search=name, smoother=smoother, seed=3,
                                max_expansions=100000)
        except (tutavia.BudgetExhausted, tutavia.UnreachableAtResolution, tutavia.NotProved):
            assert name in ("rrt", "rrt_star", "ant_colony", "hybrid_astar", "safe_rrt_star")
            continue
        assert plan.certificate.status == "proved"


@pytest.mark.parametrize("name", sorted(tutavia.describe_smoothers()))
def test_every_smoother_smooths_or_says_why_not(name, lattice, cells):
    described = tutavia.describe_smoothers()[name]
    if name in ("vehicle_shortcut", "continuous_curvature"):
        car = tutavia.Vehicle.car(0.6, 0.3, 0.4, 0.5)
        plan = tutavia.plan(lattice, (2, 1), (5, 4), "hybrid_astar", name, vehicle=car)
        assert plan.gears and plan.vehicle == car
        return
    for space, works, ends in ((lattice, described.on_lattice, ((2, 1), (14, 6))),
                               (cells, described.on_cells, ((-2.75, 2.75), (1.25, 2.75)))):
        if works:
            assert tutavia.plan(space, *ends, smoother=name).certificate.status == "proved"
        else:
            with pytest.raises(tutavia.InvalidOption):
                tutavia.plan(space, *ends, smoother=name)


def test_failures_carry_code_point_obstacle_and_the_nearest_safe_point(lattice):
    with pytest.raises(tutavia.GoalBlocked) as caught:
        tutavia.plan(lattice, (2, 1), (9, 3))  # in the wall from (8.8, 0) to (9.2, 6.9)
    failure = caught.value
    assert failure.code == "goal_blocked"
    assert failure.point == (9, 3)
    assert failure.obstacle == 4
    assert failure.clearance < 0
    assert lattice.is_free(failure.nearest_safe_point)
    assert "goal (9, 3)" in str(failure)
    assert isinstance(failure, tutavia.Failure)
    again = pickle.loads(pickle.dumps(failure))
    assert type(again) is type(failure) and again.__dict__ == failure.__dict__


def test_each_failure_has_its_class(lattice):
    with pytest.raises(tutavia.StartOutOfBounds) as caught:
        tutavia.plan(lattice, (-1, 1), (14, 6))
    assert caught.value.point == (-1, 1)
    with pytest.raises(tutavia.GoalOutOfBounds):
        tutavia.plan(lattice, (2, 1), (99, 6))
    with pytest.raises(tutavia.StartBlocked):
        tutavia.plan(lattice, (9, 3), (14, 6))
    with pytest.raises(tutavia.BudgetExhausted):
        tutavia.plan(lattice, (2, 1), (14, 6), search="dijkstra", max_expansions=3)
    with pytest.raises(tutavia.BudgetExhausted):
        tutavia.plan(lattice, (2, 1), (14, 6), search="rrt_star", time_limit=0)
    walled = tutavia.Workspace((0, 0, 4, 4), [numpy.array([[1.9, 0], [2.1, 0], [2.1, 4], [1.9, 4]])],
                               0.1)
    with pytest.raises(tutavia.Unreachable):
        tutavia.plan(tutavia.LatticeSpace(walled), (1, 1), (3, 3), search="tangent_graph")
    with pytest.raises(tutavia.LimitExceeded):
        tutavia.LatticeSpace(walled, resolution=1e-6)


def test_a_vehicle_is_planned_in_both_gears(lattice):
    def block(x0, y0, x1, y1):
        return numpy.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])

    lot = tutavia.Workspace((-15, -8, 15, 8),
                            [block(-15, -6, -1.3, -0.8), block(1.3, -6, 15, -0.8)])
    car = tutavia.Vehicle.car(4.5, 1.8, 2.7, 5)
    plan = tutavia.plan(tutavia.LatticeSpace(lot, resolution=0.25), (-8, 1.5), (0, -4.6),
                        search="hybrid_astar", smoother="vehicle_shortcut", vehicle=car,
                        start_heading=0, goal_heading=math.pi / 2)
    assert set(plan.gears) == {"forward", "reverse"}
    assert len(plan.gears) == len(plan.curve)
    assert plan.certificate.lower >= 0
    with pytest.raises(tutavia.InvalidOption, match="hybrid_astar"):
        tutavia.plan(lattice, (2, 1), (14, 6), vehicle=car)


def test_a_speed_profile_keeps_its_limits(lattice):
    plan = tutavia.plan(lattice, (2, 1), (14, 6))
    profile = plan.speed_profile(max_speed=1.5, max_lateral_acceleration=0.8)
    samples = profile.sample(0.05)
    assert samples.time[-1] == profile.duration
    assert samples.s[-1] == plan.length
    assert samples.speed.max() <= 1.5 + 1e-9
    assert (samples.speed**2 * abs(samples.curvature)).max() <= 0.8 + 1e-6
    assert samples.position.shape == (len(samples.time), 2)
    assert profile.at(samples.time).speed.tolist() == samples.speed.tolist()
    with pytest.raises(tutavia.InvalidOption, match="max_speed"):
        plan.speed_profile(max_speed=-1)
    with pytest.raises(TypeError):
        plan.speed_profile(max_sped=1)


def test_threads_may_share_a_planner_and_a_space(lattice, maze):
    planner = tutavia.Planner("theta_star", "taut_string")
    alone = [bits(planner.plan(lattice, maze.start, goal).curve) for goal in maze.goals]
    results = [None] * 16

    def work(k):
        results[k] = bits(planner.plan(lattice, maze.start, maze.goals[k % 4]).curve)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == [alone[k % 4] for k in range(16)]


def test_options_are_keyword_arguments(lattice):
    plain = tutavia.plan(lattice, (2, 1), (14, 6), search="weighted_astar", smoother="none")
    heavy = tutavia.plan(lattice, (2, 1), (14, 6), search="weighted_astar", smoother="none",
                         weight=3.0)
    same = tutavia.plan(lattice, (2, 1), (14, 6), search=searches.weighted_astar(weight=3),
                        smoother=smoothers.none())
    assert heavy.stats.expanded < plain.stats.expanded
    assert bits(heavy.curve) == bits(same.curve)
    nested = tutavia.plan(lattice, (2, 1), (14, 6), search="ssa_astar", smoother="none",
                          weights_density=0.5, reopen=True)
    assert nested.certificate.status == "proved"
    rounded = tutavia.plan(lattice, (2, 1), (14, 6),
                           smoother=["shortcut", smoothers.bezier(trim=0.5)])
    assert bits(rounded.curve) == bits(
        tutavia.plan(lattice, (2, 1), (14, 6), smoother="shortcut+bezier", trim=0.5).curve)


def test_plans_are_drawn(lattice, cells, tmp_path):
    from matplotlib import pyplot

    for space, start, goal in ((lattice, (2, 1), (14, 6)), (cells, (-2.75, 2.75), (1.25, 2.75))):
        figure, ax = pyplot.subplots()
        assert tutavia.plan(space, start, goal).plot(ax, color="tab:red") is ax
        assert len(ax.lines) >= 4
        figure.savefig(tmp_path / "plan.png")
        pyplot.close(figure)
    figure, ax = pyplot.subplots()
    tutavia.plan(lattice, (2, 1), (14, 6)).plot(ax, space=False, route=False)
    assert not ax.patches
    pyplot.close(figure)
