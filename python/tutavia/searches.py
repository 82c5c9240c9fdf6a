# SPDX-License-Identifier: MIT
"""Every search of the library, with its options as keyword arguments.

    plan(space, start, goal, search=searches.rrt_star(max_iterations=5000, goal_bias=0.1))
"""

from . import algorithms as _algorithms

_algorithms.make_functions("search", globals())
