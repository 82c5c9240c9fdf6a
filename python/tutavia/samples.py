# SPDX-License-Identifier: MIT
"""States along curves, as arrays."""

from typing import Any, NamedTuple


class CurveSamples(NamedTuple):
    """States of a curve: n rows, in the order of travel."""

    s: Any  #: arc length from the start, (n,) [m]
    position: Any  #: (n, 2) [m]
    heading: Any  #: direction of travel in (-pi, pi], (n,) [rad]
    curvature: Any  #: left turns positive, (n,) [1/m]


class SpeedSamples(NamedTuple):
    """States of a robot that drives along a curve: n rows, in the order of time."""

    time: Any  #: (n,) [s]
    s: Any  #: arc length from the start, (n,) [m]
    position: Any  #: (n, 2) [m]
    heading: Any  #: of the motion, (n,) [rad]
    curvature: Any  #: left turns positive, (n,) [1/m]
    speed: Any  #: (n,) [m/s]
    acceleration: Any  #: along the curve, (n,) [m/s^2]
