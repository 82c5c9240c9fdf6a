# SPDX-License-Identifier: MIT
"""Plans and spaces on matplotlib axes."""

import numpy

from . import _native


def plot_space(space, ax=None, *, color="0.35", zone="0.85"):
    """Draws the obstacles of a space, and around those of a LatticeSpace their safety zones.

    ax: matplotlib axes; None: those of pyplot. Returns the axes.
    """
    ax = _axes(ax)
    if isinstance(space, _native.CellSpace):
        left, bottom, right, top = space.bounds
        blocked = numpy.ma.masked_where(space.free, numpy.ones(space.free.shape))
        ax.imshow(blocked, origin="lower", extent=(left, right, bottom, top), cmap="gray", vmin=0,
                  vmax=1 / _grey(color), interpolation="nearest", zorder=1)
    else:
        _plot_workspace(space.workspace, ax, color, zone)
    left, bottom, right, top = space.bounds
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    ax.set_aspect("equal")
    return ax


def plot_plan(plan, ax=None, *, space=True, route=True, ds=None, **line):
    """Draws the curve of a plan, its route, its ends and the point nearest to an obstacle.

    ax: matplotlib axes; None: those of pyplot.
    space: True draws the space of the plan, if it is known; False none; or a space to draw.
    route: whether to draw the result of the search, thin.
    ds: the distance between the points drawn [m]; None: a thousandth of the length.
    line: properties of the curve's line, such as color="tab:blue".

    Returns the axes.
    """
    ax = _axes(ax)
    drawn = plan.space if space is True else space
    if drawn is not None and drawn is not False:
        plot_space(drawn, ax)
    else:
        ax.set_aspect("equal")
    if route:
        ax.plot(*plan.route.waypoints.T, color="tab:orange", linewidth=0.8, zorder=3)
    line = {"color": "tab:blue", "linewidth": 1.8, "zorder": 4, **line}
    points = plan.curve.sample(ds or max(plan.length / 1000, 1e-9)).position
    ax.plot(points[:, 0], points[:, 1], **line)
    ends = numpy.array([points[0], points[-1]])
    ax.plot(ends[0, 0], ends[0, 1], "o", color="tab:green", zorder=5)
    ax.plot(ends[1, 0], ends[1, 1], "o", color="tab:red", zorder=5)
    if plan.certificate.obstacle is not None:
        ax.plot(*plan.certificate.point, "x", color="black", zorder=5)
    return ax


def _axes(ax):
    if ax is not None:
        return ax
    from matplotlib import pyplot
    return pyplot.gca()


def _grey(color):
    try:
        return max(float(color), 1e-3)
    except ValueError:
        return 1e-3


def _plot_workspace(workspace, ax, color, zone):
    from matplotlib.patches import Circle, PathPatch
    from matplotlib.path import Path

    radius = workspace.safety_radius
    for obstacle in workspace.obstacles:
        if hasattr(obstacle, "radius"):
            if radius > 0:
                ax.add_patch(Circle(obstacle.center, obstacle.radius + radius, color=zone,
                                    zorder=0))
            ax.add_patch(Circle(obstacle.center, obstacle.radius, color=color, zorder=1))
            continue
        rings = [numpy.asarray(ring) for ring in (obstacle.outer, *obstacle.holes)]
        path = Path.make_compound_path(*(Path(numpy.concatenate([ring, ring[:1]]), closed=True)
                                         for ring in rings))
        if radius > 0:
            _plot_zone(rings, radius, ax, zone)
        ax.add_patch(PathPatch(path, facecolor=color, edgecolor=color, linewidth=0.5, zorder=1))


def _plot_zone(rings, radius, ax, zone):
    """The zone of a polygon: a disc around each corner and a rectangle along each side."""
    from matplotlib.patches import Circle
    from matplotlib.patches import Polygon as Patch

    for ring in rings:
        for a, b in zip(ring, numpy.roll(ring, -1, axis=0)):
            ax.add_patch(Circle(a, radius, color=zone, linewidth=0, zorder=0))
            length = numpy.hypot(*(b - a))
            if length > 0:
                normal = radius / length * numpy.array([a[1] - b[1], b[0] - a[0]])
                ax.add_patch(Patch([a + normal, b + normal, b - normal, a - normal], color=zone,
                                   linewidth=0, zorder=0))
