# SPDX-License-Identifier: MIT
"""Every smoother of the library, with its options as keyword arguments.

    plan(space, start, goal, smoother=smoothers.clothoid(min_turning_radius=0.4))
    plan(space, start, goal, smoother=[smoothers.shortcut(), smoothers.bezier(trim=0.5)])
"""

from . import algorithms as _algorithms

_algorithms.make_functions("smoother", globals())
