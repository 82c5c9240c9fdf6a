# SPDX-License-Identifier: MIT
"""Safe, smooth, short paths for a robot in the plane, each with a proof.

    import tutavia

    scene = tutavia.builtin_map("maze")
    space = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
    plan = tutavia.plan(space, scene.start, scene.goals[2])
    print(plan.length, plan.certificate.lower)
    curve = plan.curve.sample(0.1)  # curve.position has shape (n, 2)
    plan.plot()

Lengths are metres, angles radians. A point is a pair (x, y).
"""

from . import failures, plotting, searches, smoothers
from ._native import (Batch, CellSpace, Certificate, Curve, LatticeSpace, Metrics, Plan, Queries,
                      SpeedProfile, Statistics, Vehicle, Workspace, __version__)
from .algorithms import Algorithm, describe_searches, describe_smoothers
from .failures import (BudgetExhausted, Cancelled, Failure, GoalBlocked, GoalOutOfBounds,
                       InvalidInput, InvalidOption, LimitExceeded, NotProved, StartBlocked,
                       StartOutOfBounds, Unreachable, UnreachableAtResolution)
from .obstacles import Disc, Polygon
from .planning import Planner, Scene, builtin_map, plan, plan_batch
from .samples import CurveSamples, SpeedSamples

__all__ = [
    "Algorithm", "Batch", "BudgetExhausted", "Cancelled", "CellSpace", "Certificate", "Curve",
    "CurveSamples", "Disc", "Failure", "GoalBlocked", "GoalOutOfBounds", "InvalidInput",
    "InvalidOption", "LatticeSpace", "LimitExceeded", "Metrics", "NotProved", "Plan", "Planner",
    "Polygon", "Queries", "Scene", "SpeedProfile", "SpeedSamples", "StartBlocked",
    "StartOutOfBounds", "Statistics", "Unreachable", "UnreachableAtResolution", "Vehicle",
    "Workspace", "builtin_map", "describe_searches", "describe_smoothers", "failures", "plan",
    "plan_batch", "plotting", "searches", "smoothers",
]


def _speed_profile(self, **limits):
    """The SpeedProfile of the plan's curve; the limits are those of SpeedProfile."""
    return SpeedProfile(self.curve, **limits)


def _queries_from_csv(path):
    """Reads queries from a CSV file with a header, one query a line.

    Columns: start_x, start_y, goal_x, goal_y [m], and, if they are there, start_heading and
    goal_heading [rad; empty: any] and seed. Others are skipped. Raises InvalidInput with the line.
    """
    with open(path, encoding="utf-8") as file:
        return Queries._parse(file.read())


Plan.plot = plotting.plot_plan
Plan.speed_profile = _speed_profile
CellSpace.plot = plotting.plot_space
LatticeSpace.plot = plotting.plot_space
Queries.from_csv = staticmethod(_queries_from_csv)
# The classes are known by where users find them.
for _class in (Batch, CellSpace, Certificate, Curve, LatticeSpace, Metrics, Plan, Queries,
               SpeedProfile, Statistics, Vehicle, Workspace):
    _class.__module__ = "tutavia"
del _class
