# SPDX-License-Identifier: MIT
# Written by `python3 -m tutavia.stubs`.

from typing import Literal, Optional

from .algorithms import Algorithm


def none() -> Algorithm:
    """The route, unchanged.

    On LatticeSpace and CellSpace."""


def shortcut() -> Algorithm:
    """Straight lines between waypoints in sight.

    On LatticeSpace and CellSpace."""


def redundant_node_removal(
    *,
    scan: Literal["forward", "from_far_end"] = 'forward',
) -> Algorithm:
    """Removes redundant nodes of a route.

    On LatticeSpace and CellSpace.

    scan: from which end the next kept node is sought."""


def delta(
    *,
    corner_threshold: float = 0.3,
    arc_initial_offset: float = 0.12,
    arc_max_offset: float = 0.6,
    arc_growth_step: float = 0.12,
    min_exterior_angle: float = 0.3490658503988659,
    join: Literal["paper", "tangent"] = 'tangent',
) -> Algorithm:
    """Wide arcs where the path turns near corners, long straight lines in between.

    On LatticeSpace and CellSpace.

    corner_threshold: largest distance between the path and the safety zone of a critical corner [m].
    arc_initial_offset: first distance tried between the control point of an arc and the safety zone of its corner [m].
    arc_max_offset: largest such distance [m].
    arc_growth_step: step between such distances, positive [m].
    min_exterior_angle: corners that turn by less are facets of a round obstacle [rad].
    join: how lines and arcs meet: in one direction, or as in the paper."""


def bezier(
    *,
    trim: float = 1.5,
    fullness: float = 0.6666666666666666,
) -> Algorithm:
    """Corners rounded by cubic Bezier pieces.

    On LatticeSpace and CellSpace.

    trim: largest length taken of each leg [spacing].
    fullness: position of the inner control points between leg and corner, in (0, 1]."""


def b_spline(
    *,
    reach: float = 3.0,
    prune: bool = True,
) -> Algorithm:
    """A cubic B-spline along the pruned route.

    On LatticeSpace and CellSpace.

    reach: distance of the auxiliary control points from a corner, positive [spacing].
    prune: whether redundant nodes are removed first."""


def smoothing_spline(
    *,
    smoothing: float = 0.1,
    output_points: int = 100,
) -> Algorithm:
    """A least-squares cubic spline near the route.

    On LatticeSpace and CellSpace.

    smoothing: bound s on the sum of squared distances from the nodes [spacing^2].
    output_points: points of the spline on the whole route, from 2 to a million."""


def two_stage_b_spline(
    *,
    a: float = 0.5,
    b: float = 0.5,
    c: float = 1.0,
    d0: float = 2.0,
    passes: int = 1,
) -> Algorithm:
    """A cubic B-spline on nodes moved away from obstacles by f(d) = 1 / (a + b e^(c d)).

    On LatticeSpace and CellSpace.

    a: a in f(d).
    b: b in f(d).
    c: c in f(d) [per cell].
    d0: range of influence of blocked cells, up to 100 [cells].
    passes: how often nodes are moved."""


def taut_string() -> Algorithm:
    """The shortest path that leaves the obstacles on the same sides as the route.

    On LatticeSpace and CellSpace."""


def clothoid(
    *,
    clearance_budget: float = 0.1,
    min_turning_radius: Optional[float] = None,
    spirals: Literal["clothoids", "cubic_beziers"] = 'clothoids',
) -> Algorithm:
    """A path of continuous curvature.

    On LatticeSpace and CellSpace.

    clearance_budget: largest distance by which the path is moved away from the safety zones; at safety radius 0 in spacings [safety radii].
    min_turning_radius: lower bound on the turning radius, or a failure [m].
    spirals: the pieces along which the curvature changes."""


def homotopy_refine(
    *,
    max_expansions: int = 18446744073709551615,
) -> Algorithm:
    """The shortest path of all, if it is shorter than the route.

    On LatticeSpace.

    max_expansions: expansions of the search at most."""


def string_pull() -> Algorithm:
    """The shortest path of a point on cells that leaves them on the same sides as the route.

    On CellSpace."""


def vehicle_shortcut(
    *,
    reverse_weight: float = 1.5,
    cusp_cost: float = 1.0,
    places: int = 40,
) -> Algorithm:
    """Shortens the path of a vehicle by shortest drives.

    On LatticeSpace and CellSpace.

    reverse_weight: cost of a metre in reverse, at least 1.
    cusp_cost: cost of a change of gear [m].
    places: between how many places drives are tried, from 2 to 1000."""


def continuous_curvature(
    *,
    max_sharpness: float = 0.0,
    reverse_weight: float = 1.5,
    cusp_cost: float = 1.0,
    places: int = 40,
) -> Algorithm:
    """Gives the path of a vehicle a curvature that never jumps.

    On LatticeSpace and CellSpace.

    max_sharpness: change of curvature per metre; 0: one over the radius squared [1/m^2].
    reverse_weight: cost of a metre in reverse, at least 1.
    cusp_cost: cost of a change of gear [m].
    places: between how many places drives are tried, from 2 to 1000."""
