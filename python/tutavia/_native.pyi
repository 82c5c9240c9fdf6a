# SPDX-License-Identifier: MIT
# Written by `python3 -m tutavia.stubs`.

from typing import Any

import numpy

from .samples import CurveSamples, SpeedSamples

__version__: str


class Batch:
    """The results of many queries, in their order.

    batch[i] is the Plan of query i, or its exception, which is not raised. The columns are arrays of
    one figure per query, NaN where there is no plan. Pickles hold everything but the space."""
    def __getitem__(self, index: int) -> Any:
        ...
    def __len__(self) -> int:
        ...
    @property
    def clearance_lower(self) -> numpy.ndarray:
        """The proved lower bound [m]."""
    @property
    def clearance_upper(self) -> numpy.ndarray:
        """The proved upper bound [m]."""
    @property
    def length(self) -> numpy.ndarray:
        """[m]"""
    @property
    def max_curvature(self) -> numpy.ndarray:
        """[1/m]"""
    @property
    def planned(self) -> numpy.ndarray:
        """Whether each query has a plan: an array of bools."""
    @property
    def status(self) -> list[str]:
        """"planned" or the code of the failure, a list."""
    @property
    def turning_angle(self) -> numpy.ndarray:
        """[rad]"""

class CellSpace:
    """The free space between the blocked cells of a grid map.

    Made by `from_numpy`, `from_ros_map` or `from_moving_ai`. Blocked cells are closed squares, from
    which every point of a path keeps the safety radius. Immutable: threads may share it."""
    @property
    def bounds(self) -> tuple:
        """(min_x, min_y, max_x, max_y) [m]."""
    def clearance(self, points: Any) -> Any:
        """The signed distance from a point to the nearest obstacle [m], negative inside; for an array of shape (n, 2) an array."""
    @property
    def free(self) -> numpy.ndarray:
        """The map as given: a bool array of shape (height, width), made anew at each call."""
    @staticmethod
    def from_moving_ai(path: Any, safety_radius: float = 0.0, movement: str = 'no_cut', terrain: str = 'refused') -> CellSpace:
        """The space of a map file of the MovingAI benchmarks.

        Cells have the side 1; y grows downwards, from row 0 at the top of the file. `terrain` says how to
        read swamp and water: "refused", "blocked" or "free". Raises InvalidInput with the line."""
    @staticmethod
    def from_numpy(free: Any, resolution: float = 1.0, origin: Any = (0.0, 0.0), safety_radius: float = 0.0, movement: str = 'no_cut') -> CellSpace:
        """The space of an array of cells.

        free: a bool array of shape (height, width), True where a cell is free. Cell (x, y) is free[y, x];
            its centre is origin + resolution * (x + 0.5, y + 0.5).
        resolution: the side of a cell [m].
        origin: the lower left corner of cell (0, 0), (x, y) [m].
        safety_radius: the distance to keep from blocked cells [m].
        movement: "no_cut", "no_squeeze", "allow" or "four_connected".

        Raises InvalidInput for other dtypes and shapes, InvalidOption for options out of range."""
    @staticmethod
    def from_ros_map(path: Any, safety_radius: float = 0.0, movement: str = 'no_cut', unknown: str = 'blocked', frame: str = 'map') -> CellSpace:
        """The space of a map of ROS' map_server: a YAML file that names an image.

        unknown: "blocked" or "free": how to read unknown cells.
        frame: "map": in the map's own frame; "grid": with the origin at the lower left corner of the image
            and x along its rows, for maps that are turned.

        Doubts about the files are warnings. Raises InvalidInput with the file and the line, InvalidOption
        for a map that is turned and frame="map"."""
    @property
    def grid(self) -> numpy.ndarray:
        """Where a path may step: a bool array of shape (height, width), made anew at each call."""
    def is_free(self, points: Any) -> Any:
        """Whether a point (x, y) is free; for an array of shape (n, 2) an array of bools. Exact."""
    @property
    def origin(self) -> tuple:
        """The lower left corner of cell (0, 0), (x, y) [m]."""
    def plot(space, ax=None, *, color='0.35', zone='0.85') -> Any:
        """Draws the obstacles of a space, and around those of a LatticeSpace their safety zones.

        ax: matplotlib axes; None: those of pyplot. Returns the axes."""
    @property
    def resolution(self) -> float:
        """The distance between neighbours of the grid [m]."""
    @property
    def safety_radius(self) -> float:
        """[m]"""
    def segment_free(self, a: Any, b: Any) -> bool:
        """Whether the segment between two points is free. Exact."""
    @property
    def shape(self) -> tuple:
        """(height, width) of the grid."""
    def shortest_length(self, start: Any, goal: Any) -> float:
        """The length of the shortest path there is [m]. Raises the failures of a plan."""

class Certificate:
    """The proved bounds of a curve's clearance.

    lower <= c <= upper holds for the least distance c between any point of the continuous curve and any
    obstacle, rounding included."""
    @property
    def evaluations(self) -> int:
        """Distances computed."""
    @property
    def lower(self) -> float:
        """[m]"""
    @property
    def obstacle(self) -> Any:
        """The index of the obstacle nearest to it, of a CellSpace that of the blocked cell; None without obstacles."""
    @property
    def parameter(self) -> float:
        """Of the point on that piece, 0 to 1."""
    @property
    def piece(self) -> int:
        """The index of the piece with that point."""
    @property
    def point(self) -> tuple:
        """The point of the curve that attains `upper`, (x, y) [m]."""
    @property
    def status(self) -> str:
        """"proved", "violated" or "undecided"; that of a plan is always "proved"."""
    @property
    def upper(self) -> float:
        """[m]"""

class Curve:
    """A chain of segments, Bezier pieces, arcs and clothoids.

    It is addressed by arc length from its start [m]; values outside are clamped. `len` is the number of
    its pieces."""
    def __len__(self) -> int:
        ...
    def at(self, s: Any) -> Any:
        """The state at an arc length [m], or CurveSamples of arrays for an array of them."""
    @property
    def length(self) -> float:
        """[m]"""
    def nearest(self, point: Any) -> tuple:
        """The nearest point of the curve: (s, (x, y), distance) [m]."""
    @property
    def pieces(self) -> list:
        """The pieces, as (kind, numbers), numbers to the last bit:

        segment: ax, ay, bx, by.
        quadratic_bezier, cubic_bezier: the control points.
        arc: ax, ay, bx, by, centre x, centre y, radius, start_angle, sweep.
        clothoid: ax, ay, bx, by, start_heading, start_curvature, sharpness, length."""
    def reversed(self) -> Curve:
        """The curve from its end to its start."""
    def sample(self, ds: float) -> Any:
        """States at equal steps of arc length, at most `ds` [m] apart.

        Both ends are included. Returns CurveSamples: the arrays s (n,) [m], position (n, 2) [m], heading
        (n,), the direction of travel in (-pi, pi] [rad], and curvature (n,) [1/m], left turns positive.
        Raises InvalidOption for a step that is not positive."""
    @property
    def waypoints(self) -> numpy.ndarray:
        """The start and the end of every piece: an array of shape (n + 1, 2) [m]."""

class LatticeSpace:
    """The free space of a workspace with a lattice on which every step is safe.

    workspace: a Workspace.
    resolution: the distance between neighbours of the lattice [m]; None: 1/200 of the larger side of
        the bounds.
    movement: "no_cut", "no_squeeze", "allow" or "four_connected"; every rule is safe.
    edges: "uniform", or "paper_strict", which reproduces a paper's tables.
    max_nodes: more nodes than these are refused.

    Immutable: threads may share it. Raises InvalidInput, InvalidOption and LimitExceeded."""
    def __init__(self, workspace: Workspace, resolution: float | None = None, movement: str = 'no_cut', edges: str = 'uniform', max_nodes: int = 268435456) -> None:
        ...
    @property
    def bounds(self) -> tuple:
        """(min_x, min_y, max_x, max_y) [m]."""
    def clearance(self, points: Any) -> Any:
        """The signed distance from a point to the nearest obstacle [m], negative inside; for an array of shape (n, 2) an array."""
    @property
    def grid(self) -> numpy.ndarray:
        """Where a path may step: a bool array of shape (height, width), made anew at each call."""
    def is_free(self, points: Any) -> Any:
        """Whether a point (x, y) is free; for an array of shape (n, 2) an array of bools. Exact."""
    def plot(space, ax=None, *, color='0.35', zone='0.85') -> Any:
        """Draws the obstacles of a space, and around those of a LatticeSpace their safety zones.

        ax: matplotlib axes; None: those of pyplot. Returns the axes."""
    @property
    def resolution(self) -> float:
        """The distance between neighbours of the grid [m]."""
    @property
    def safety_radius(self) -> float:
        """[m]"""
    def segment_free(self, a: Any, b: Any) -> bool:
        """Whether the segment between two points is free. Exact."""
    @property
    def shape(self) -> tuple:
        """(height, width) of the grid."""
    def shortest_length(self, start: Any, goal: Any) -> float:
        """The length of the shortest path there is [m]. Raises the failures of a plan."""
    @property
    def workspace(self) -> Workspace:
        """The obstacles, as a Workspace."""

class Metrics:
    """Length, smoothness and clearance of a path."""
    @property
    def length(self) -> float:
        """[m]"""
    @property
    def max_curvature(self) -> float:
        """Of the pieces [1/m]."""
    @property
    def max_curvature_jump(self) -> float:
        """Between consecutive pieces [1/m]; 0 up to rounding if it is continuous."""
    @property
    def max_joint_deflection(self) -> float:
        """The largest turn between two consecutive pieces [rad]; 0 for a smooth path."""
    @property
    def min_clearance(self) -> float:
        """The proved lower bound [m]."""
    @property
    def turning_angle(self) -> float:
        """The sum of the magnitudes of all changes of heading [rad]."""
    @property
    def turning_points(self) -> int:
        """Turns of more than half a degree."""

class Plan:
    """A path that is proved safe.

    Pickles hold everything but the space."""
    @property
    def certificate(self) -> Certificate:
        """The proof, of a vehicle for its whole footprint."""
    @property
    def curve(self) -> Curve:
        """From start to goal, both exact."""
    @property
    def fell_back(self) -> bool:
        """Whether the curve, or a part of it, is the route's, because no smoothed one is proved."""
    @property
    def found_by(self) -> str:
        """The search that found the route, if several took part; else empty."""
    @property
    def gears(self) -> list:
        """"forward" or "reverse" for each piece of a vehicle's path; else empty."""
    @property
    def length(self) -> float:
        """[m]"""
    @property
    def metrics(self) -> Metrics:
        ...
    def plot(plan, ax=None, *, space=True, route=True, ds=None, **line) -> Any:
        """Draws the curve of a plan, its route, its ends and the point nearest to an obstacle.

        ax: matplotlib axes; None: those of pyplot.
        space: True draws the space of the plan, if it is known; False none; or a space to draw.
        route: whether to draw the result of the search, thin.
        ds: the distance between the points drawn [m]; None: a thousandth of the length.
        line: properties of the curve's line, such as color="tab:blue".

        Returns the axes."""
    @property
    def route(self) -> Curve:
        """The result of the search, before smoothing."""
    @property
    def space(self) -> Any:
        """The space of the plan; None after unpickling."""
    def speed_profile(self, **limits) -> Any:
        """The SpeedProfile of the plan's curve; the limits are those of SpeedProfile."""
    @property
    def stats(self) -> Statistics:
        ...
    @property
    def vehicle(self) -> Vehicle | None:
        """The Vehicle that was planned for, or None."""

class Queries:
    """Starts and goals of many queries.

    starts, goals: arrays of shape (n, 2) [m].
    start_headings, goal_headings: arrays of shape (n,) [rad], NaN: any; or None.
    seeds: an array of n whole numbers, or None.

    `Queries.from_csv` reads them from a file. Raises InvalidInput for other shapes and dtypes."""
    def __getitem__(self, part: slice) -> Queries:
        ...
    def __init__(self, starts: Any, goals: Any, start_headings: Any = None, goal_headings: Any = None, seeds: Any = None) -> None:
        ...
    def __len__(self) -> int:
        ...
    @staticmethod
    def from_csv(path) -> Any:
        """Reads queries from a CSV file with a header, one query a line.

        Columns: start_x, start_y, goal_x, goal_y [m], and, if they are there, start_heading and
        goal_heading [rad; empty: any] and seed. Others are skipped. Raises InvalidInput with the line."""
    @property
    def goal_headings(self) -> numpy.ndarray:
        """(n,) [rad], NaN: any."""
    @property
    def goals(self) -> numpy.ndarray:
        """(n, 2) [m]."""
    @property
    def seeds(self) -> numpy.ndarray:
        """(n,)"""
    @property
    def start_headings(self) -> numpy.ndarray:
        """(n,) [rad], NaN: any."""
    @property
    def starts(self) -> numpy.ndarray:
        """(n, 2) [m]."""

class SpeedProfile:
    """The fastest speed along a curve within limits.

    curve: a Curve.
    max_speed [m/s]; max_acceleration and max_deceleration, along the curve [m/s^2], and
    max_lateral_acceleration, across it [m/s^2]: positive and finite.
    max_jerk: the change of the acceleration [m/s^3]; infinity allows jumps.
    max_curvature_rate: the change of the curvature [1/(m s)], on curves of segments, arcs and clothoids;
        infinity allows jumps.
    start_speed; end_speed, an upper bound at the end [m/s].

    The limits hold everywhere on the curve, not only at samples. Raises InvalidOption for limits out of
    range and a start speed from which the robot cannot brake, InvalidInput for a curve with a cusp."""
    def __init__(self, curve: Curve, *, max_speed: float = 1.0, max_acceleration: float = 0.5, max_deceleration: float = 0.5, max_lateral_acceleration: float = 0.5, max_jerk: float = float("inf"), max_curvature_rate: float = float("inf"), start_speed: float = 0.0, end_speed: float = 0.0) -> None:
        ...
    def at(self, times: Any) -> Any:
        """SpeedSamples at an array of times [s], clamped to the duration."""
    @property
    def curve(self) -> Curve:
        ...
    @property
    def duration(self) -> float:
        """Of the whole motion [s]."""
    def sample(self, dt: float) -> Any:
        """States at equal steps of time, at most `dt` [s] apart.

        Returns SpeedSamples: the arrays time (n,) [s], s (n,) [m], position (n, 2) [m], heading (n,) [rad],
        curvature (n,) [1/m], speed (n,) [m/s] and acceleration (n,) [m/s^2]."""

class Statistics:
    """The effort of one query; times are wall-clock."""
    @property
    def certify_us(self) -> float:
        """[us]"""
    @property
    def expanded(self) -> int:
        ...
    @property
    def generated(self) -> int:
        ...
    @property
    def search_us(self) -> float:
        """[us]"""
    @property
    def seed(self) -> int:
        ...
    @property
    def smooth_us(self) -> float:
        """[us]"""

class Vehicle:
    """What a vehicle may drive, and the room that it takes.

    The reference point is the one whose path is planned: the middle of the rear axle of a car. The
    footprint is a union of discs, each of which keeps the safety radius of the space.

    min_turning_radius: of the reference point [m]; 0: the vehicle turns on the spot, which only a
        footprint of one disc around the reference point may do.
    reverse: whether it may drive backwards.
    footprint: an array of shape (n, 3): ahead, to the left and radius of each disc [m]; None: a point.

    Raises InvalidOption for values out of range."""
    def __init__(self, min_turning_radius: float = 0.0, reverse: bool = False, footprint: Any = None) -> None:
        ...
    @staticmethod
    def car(length: float, width: float, wheelbase: float, min_turning_radius: float, reverse: bool = True, margin: float = 0.0) -> Vehicle:
        """A rectangle, covered by few discs that stay within `margin` of it [m].

        The rear axle lies as far from the back as the front axle from the front. Margin 0 stands for an
        eighteenth of the shorter side."""
    @property
    def footprint(self) -> numpy.ndarray:
        """An array of shape (n, 3): ahead, to the left, radius [m]."""
    @property
    def min_turning_radius(self) -> float:
        """[m]"""
    @property
    def reverse(self) -> bool:
        ...

class Workspace:
    """Bounds, obstacles and the distance to keep from them.

    Free space is closed: the points of the bounds at a distance of `safety_radius` or more from every
    obstacle. The bounds limit the robot's centre and are not inflated. Obstacles may overlap, touch,
    nest or extend beyond the bounds.

    bounds: (min_x, min_y, max_x, max_y) [m].
    obstacles: an iterable, or one, of: arrays of shape (n, 2) (the corners of a polygon), Polygon,
        Disc, shapely geometries, anything with `__geo_interface__`, GeoJSON objects as dicts. Lines are
        walls without thickness; points are discs of radius 0, or of the property `radius` of their
        feature.
    safety_radius: the robot's radius plus any extra margin [m].

    Raises InvalidInput, with the obstacle and its index, for what is no obstacle, for coordinates that
    are not finite and for empty bounds."""
    def __init__(self, bounds: Any, obstacles: Any = (), safety_radius: float = 0.0) -> None:
        ...
    @property
    def bounds(self) -> tuple:
        """(min_x, min_y, max_x, max_y) [m]."""
    @property
    def obstacles(self) -> list:
        """A list of Polygon and Disc, in the order given."""
    @property
    def safety_radius(self) -> float:
        """[m]"""