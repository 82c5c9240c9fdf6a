# SPDX-License-Identifier: MIT
# Written by `python3 -m tutavia.stubs`.

from typing import Literal, Optional

from .algorithms import Algorithm


def auto() -> Algorithm:
    """On workspaces A*, and tangent_graph where the lattice has no path; on cells jump points.

    On LatticeSpace and CellSpace."""


def dijkstra() -> Algorithm:
    """A* without a heuristic.

    On LatticeSpace and CellSpace."""


def astar(
    *,
    heuristic: Literal["octile", "euclidean", "chebyshev", "manhattan"] = 'octile',
    successors: Literal["canonical", "all"] = 'canonical',
) -> Algorithm:
    """A cheapest path on a grid, guided by a heuristic.

    On LatticeSpace and CellSpace.

    heuristic: estimate of the distance to the goal; manhattan overestimates diagonals.
    successors: steps from a cell: those of one of many equal paths, or all."""


def weighted_astar(
    *,
    weight: float = 1.5,
) -> Algorithm:
    """A* whose path may be longer by a bounded factor.

    On LatticeSpace and CellSpace.

    weight: factor of the heuristic, and bound on the path's length in shortest paths, from 1 to 1000."""


def canonical_astar() -> Algorithm:
    """A* that generates one of many equal paths.

    On LatticeSpace and CellSpace."""


def bidirectional_astar() -> Algorithm:
    """A* from the start and from the goal at once.

    On LatticeSpace and CellSpace."""


def penalty_astar(
    *,
    turn_penalty: float = 0.4,
) -> Algorithm:
    """A* with a cost for turning.

    On LatticeSpace and CellSpace.

    turn_penalty: lambda, the cost of a turn, up to 1000 [m per rad]."""


def jps() -> Algorithm:
    """Jump point search without preprocessing.

    On LatticeSpace and CellSpace."""


def jps_plus() -> Algorithm:
    """Jump point search with a table of all jumps.

    On LatticeSpace and CellSpace."""


def theta_star(
    *,
    nodes: Literal["cell_centre", "cell_corner"] = 'cell_centre',
) -> Algorithm:
    """A* whose paths bend by any angle.

    On LatticeSpace and CellSpace.

    nodes: where paths bend; corners are for grid maps at safety radius 0."""


def lazy_theta_star(
    *,
    nodes: Literal["cell_centre", "cell_corner"] = 'cell_centre',
) -> Algorithm:
    """Theta* with fewer line-of-sight tests.

    On LatticeSpace and CellSpace.

    nodes: where paths bend; corners are for grid maps at safety radius 0."""


def jps_theta_star(
    *,
    far_weight: float = 2.0,
    near_weight: float = 0.8,
    switch_distance: float = 12.0,
    lines_of_sight: Literal["never", "after_search", "in_search"] = 'after_search',
) -> Algorithm:
    """Weighted jump point search with line-of-sight tests.

    On LatticeSpace and CellSpace.

    far_weight: factor of the heuristic farther than switch_distance from the goal.
    near_weight: factor of the heuristic nearer by.
    switch_distance: distance from the goal at which the weight changes [cells].
    lines_of_sight: when bends are removed by lines of sight."""


def ssa_astar(
    *,
    weights_chebyshev: float = 1.55,
    weights_euclidean: float = 0.85,
    weights_density: float = 0.7,
    reopen: bool = True,
) -> Algorithm:
    """A* with a heuristic tuned by a salp swarm.

    On LatticeSpace and CellSpace.

    weights_chebyshev: w1, factor of the Chebyshev distance.
    weights_euclidean: w2, factor of the Euclidean distance.
    weights_density: w3, factor of the share of blocked cells among the neighbours [cells].
    reopen: whether a cell is expanded again when a cheaper path to it is found."""


def ant_colony(
    *,
    ants: int = 30,
    iterations: int = 50,
    pheromone_exponent: float = 1.0,
    distance_exponent: float = 5.0,
    evaporation: float = 0.3,
    dead_ends: Literal["step_back", "discard"] = 'step_back',
    deposit: float = 100.0,
) -> Algorithm:
    """Repeated random walks guided by pheromone.

    On LatticeSpace and CellSpace.

    ants: ants per round, at least 1.
    iterations: rounds, at least 1.
    pheromone_exponent: alpha, from 0 to 100.
    distance_exponent: beta, the exponent of 1 / distance to the goal, from 0 to 100.
    evaporation: rho, the share of pheromone lost per round, less than 1.
    dead_ends: what an ant does without a step left.
    deposit: Q: an ant deposits Q / length in cells."""


def rea_star() -> Algorithm:
    """A* over free rectangles.

    On LatticeSpace and CellSpace."""


def sb_rea_star() -> Algorithm:
    """Rectangle expansion from both ends, with nodes that slide along their portals.

    On LatticeSpace and CellSpace."""


def improved_rea_star(
    *,
    exit_cost: Literal["cumulative", "last_leg"] = 'cumulative',
    target: Literal["goal", "newest_exit"] = 'goal',
    continue_after_contact: bool = False,
    funnel: bool = True,
) -> Algorithm:
    """Rectangle expansion from both ends, with exits evaluated at their midpoints.

    On LatticeSpace and CellSpace.

    exit_cost: how the cost of an exit is summed.
    target: towards what the rest of the way from an exit is estimated.
    continue_after_contact: whether to go on after the two searches have met, for a shorter path.
    funnel: whether to return the shortest path through the exits instead of the paper's nodes."""


def rrt(
    *,
    step: Optional[float] = None,
    goal_bias: float = 0.05,
    max_iterations: int = 3000,
) -> Algorithm:
    """The first path found by a random tree.

    On LatticeSpace and CellSpace.

    step: longest step; none: 1/25 of the longer side of the bounds [m].
    goal_bias: share of iterations that grow towards the goal, from 0 to 1.
    max_iterations: iterations at most."""


def rrt_star(
    *,
    step: Optional[float] = None,
    goal_bias: float = 0.05,
    max_iterations: int = 3000,
    neighbours: Literal["k_nearest", "radius"] = 'k_nearest',
    rewire_factor: float = 1.1,
) -> Algorithm:
    """A random tree that keeps the cheapest parents, so its path shortens as it grows.

    On LatticeSpace and CellSpace.

    step: longest step; none: 1/25 of the longer side of the bounds [m].
    goal_bias: share of iterations that grow towards the goal, from 0 to 1.
    max_iterations: iterations at most.
    neighbours: which nodes count as near a new one.
    rewire_factor: factor of the bounds on near nodes; more than 1 for asymptotic optimality."""


def rrt_connect(
    *,
    step: Optional[float] = None,
    max_iterations: int = 3000,
) -> Algorithm:
    """Two random trees that grow towards each other.

    On LatticeSpace and CellSpace.

    step: longest step; none: 1/25 of the longer side of the bounds [m].
    max_iterations: iterations at most."""


def informed_rrt_star(
    *,
    step: Optional[float] = None,
    goal_bias: float = 0.05,
    max_iterations: int = 3000,
    neighbours: Literal["k_nearest", "radius"] = 'k_nearest',
    rewire_factor: float = 1.1,
) -> Algorithm:
    """RRT* that samples only points that can shorten its path.

    On LatticeSpace and CellSpace.

    step: longest step; none: 1/25 of the longer side of the bounds [m].
    goal_bias: share of iterations that grow towards the goal, from 0 to 1.
    max_iterations: iterations at most.
    neighbours: which nodes count as near a new one.
    rewire_factor: factor of the bounds on near nodes; more than 1 for asymptotic optimality."""


def safe_rrt_star(
    *,
    step: Optional[float] = None,
    goal_bias: float = 0.05,
    max_iterations: int = 3000,
    neighbours: Literal["k_nearest", "radius"] = 'k_nearest',
    rewire_factor: float = 1.1,
    risk_width: Optional[float] = None,
    risk_weight: float = 1.0,
    keep_out: bool = True,
    prune: bool = True,
) -> Algorithm:
    """RRT* that prefers to stay away from obstacles.

    On LatticeSpace and CellSpace.

    step: longest step; none: 1/25 of the longer side of the bounds [m].
    goal_bias: share of iterations that grow towards the goal, from 0 to 1.
    max_iterations: iterations of each tree at most.
    neighbours: which nodes count as near a new one.
    rewire_factor: factor of the bounds on near nodes; more than 1 for asymptotic optimality.
    risk_width: width of the risk zones; none: the longest step [m].
    risk_weight: metres of length that a metre at full risk costs.
    keep_out: whether to try a tree outside the risk zones first.
    prune: whether to remove redundant nodes."""


def any_angle() -> Algorithm:
    """The shortest path of a point among blocked cells, at any angle.

    On CellSpace."""


def tangent_graph(
    *,
    bound: float = float("inf"),
) -> Algorithm:
    """The shortest path of a disc or a point among polygons and discs, or among cells.

    On LatticeSpace and CellSpace.

    bound: longer paths are not searched [m]."""


def hybrid_astar(
    *,
    vehicle_min_turning_radius: float = 1.0,
    vehicle_reverse: bool = True,
    reverse_weight: float = 1.5,
    cusp_cost: float = 1.0,
    heuristic_weight: float = 2.0,
    headings: int = 24,
    searches: int = 3,
) -> Algorithm:
    """A path for a vehicle with headings, a turning radius and a footprint.

    On LatticeSpace and CellSpace.

    vehicle_min_turning_radius: of the reference point; 0: turns on the spot [m].
    vehicle_reverse: whether the vehicle may drive backwards.
    reverse_weight: cost of a metre in reverse, at least 1.
    cusp_cost: cost of a change of gear [m].
    heuristic_weight: factor of the heuristic, at least 1.
    headings: directions in the first search.
    searches: searches at most, each with twice as many headings."""
