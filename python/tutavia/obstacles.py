# SPDX-License-Identifier: MIT
"""Obstacles from arrays, shapely geometries and anything with `__geo_interface__`."""

import math
from collections.abc import Mapping
from typing import Any, List, NamedTuple, Tuple

import numpy

from .failures import InvalidInput


class Disc(NamedTuple):
    """A solid disc; radius 0 is a single point."""

    center: Tuple[float, float]  #: (x, y) [m]
    radius: float  #: [m]


class Polygon(NamedTuple):
    """A solid area with holes. Rings need not be closed; both orientations are valid."""

    outer: Any  #: an array of shape (n, 2) [m]
    holes: Any = ()  #: arrays of shape (n, 2) [m]


_KINDS = ("Polygon, MultiPolygon, LineString, LinearRing, MultiLineString, Point, MultiPoint, "
          "GeometryCollection, Feature and FeatureCollection")


def flatten(obstacles) -> List[Any]:
    """A list of Disc and Polygon from one obstacle or an iterable of them; see Workspace.

    Raises InvalidInput, with the index, for what is no obstacle.
    """
    if _is_table(obstacles):
        obstacles = obstacles.geometry
    if _is_one(obstacles):
        obstacles = [obstacles]
    try:
        items = iter(obstacles)
    except TypeError:
        raise InvalidInput(
            f"obstacles: expected obstacles, got {_name(obstacles)}") from None
    flat = []
    for index, item in enumerate(items):
        _add(item, f"obstacles[{index}]", flat)
    return flat


def _name(value):
    return type(value).__name__


def _is_one(value):
    is_geometry = hasattr(value, "__geo_interface__") and not _is_table(value)
    is_corners = isinstance(value, numpy.ndarray) and value.ndim == 2
    return isinstance(value, (Disc, Polygon, dict)) or is_geometry or is_corners


def _is_table(value):
    # A GeoDataFrame or a GeoSeries: the obstacles are its geometries, in the order of the rows.
    return hasattr(value, "geometry") and hasattr(value, "iloc")


def _add(item, where, flat):
    if isinstance(item, Disc):
        flat.append(Disc(item.center, _radius(item.radius, where)))
    elif isinstance(item, Polygon):
        flat.append(item)
    elif isinstance(item, dict):
        _add_geometry(item, where, flat, None)
    elif hasattr(item, "__geo_interface__"):
        _add_geometry(item.__geo_interface__, where, flat, None)
    elif isinstance(item, (numpy.ndarray, list, tuple)):
        flat.append(Polygon(_ring(item, where, (2,))))
    else:
        raise InvalidInput(
            f"{where}: {_name(item)} is no obstacle: give an array of shape (n, 2), a "
            "tutavia.Polygon or Disc, or something with __geo_interface__")


def _radius(value, where):
    try:
        radius = float(value)
    except (TypeError, ValueError):
        raise InvalidInput(f"{where}: radius: expected a number, got {value!r}") from None
    if not (radius >= 0 and math.isfinite(radius)):
        raise InvalidInput(f"{where}: radius: must be finite and not negative, got {radius!r}")
    return radius


def _ring(coordinates, where, widths=(2, 3, 4)):
    """The points of a ring; heights and measures of GeoJSON are dropped."""
    try:
        ring = numpy.asarray(coordinates, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"{where}: expected pairs of numbers") from None
    if ring.ndim != 2 or ring.shape[1] not in widths:
        raise InvalidInput(
            f"{where}: expected an array of shape (n, 2), got shape {ring.shape}")
    return numpy.ascontiguousarray(ring[:, :2])


def _parts(geometry, member, where):
    parts = geometry.get(member)
    if not isinstance(parts, (list, tuple)):
        raise InvalidInput(f"{where}: a {geometry['type']} has a list of {member}, found {parts!r}")
    return parts


def _add_geometry(geometry, where, flat, radius):
    if not isinstance(geometry, Mapping):
        raise InvalidInput(f"{where}: expected a GeoJSON object, got {_name(geometry)}")
    kind = geometry.get("type")
    if kind == "FeatureCollection":
        for index, feature in enumerate(_parts(geometry, "features", where)):
            _add_geometry(feature, f"{where}.features[{index}]", flat, None)
    elif kind == "Feature":
        if geometry.get("geometry") is not None:
            properties = geometry.get("properties")
            own = properties.get("radius") if isinstance(properties, Mapping) else None
            _add_geometry(geometry["geometry"], where, flat,
                          None if own is None else _radius(own, where))
    elif kind == "GeometryCollection":
        for index, part in enumerate(_parts(geometry, "geometries", where)):
            _add_geometry(part, f"{where}.geometries[{index}]", flat, radius)
    elif isinstance(kind, str) and kind in _SHAPES and "coordinates" in geometry:
        try:
            _SHAPES[kind](geometry["coordinates"], where, flat, radius)
        except TypeError:
            raise InvalidInput(f"{where}: these are no coordinates of a {kind}") from None
    else:
        raise InvalidInput(f"{where}: a geometry of type {kind!r} is no obstacle: known are "
                           f"{_KINDS}")


def _add_polygon(rings, where, flat, radius):
    if len(rings) > 0:
        rings = [_ring(ring, where) for ring in rings]
        flat.append(Polygon(rings[0], rings[1:]))


def _add_line(points, where, flat, radius):
    # A wall without thickness: a ring that goes there and back.
    if len(points) > 0:
        ring = _ring(points, where)
        flat.append(Polygon(numpy.concatenate([ring, ring[-2::-1]]) if len(ring) > 1 else ring))


def _add_point(point, where, flat, radius):
    if len(point) > 0:
        x, y = _ring([point], where)[0]
        flat.append(Disc((x, y), radius or 0.0))


def _each(add):
    def add_all(parts, where, flat, radius):
        for part in parts:
            add(part, where, flat, radius)
    return add_all


_SHAPES = {
    "Polygon": _add_polygon, "MultiPolygon": _each(_add_polygon), "LineString": _add_line,
    "LinearRing": _add_line, "MultiLineString": _each(_add_line), "Point": _add_point,
    "MultiPoint": _each(_add_point),
}
