# SPDX-License-Identifier: MIT
"""What the tests share."""

import numpy
import pytest

import tutavia


@pytest.fixture(scope="session")
def maze():
    return tutavia.builtin_map("maze")


@pytest.fixture(scope="session")
def lattice(maze):
    return tutavia.LatticeSpace(maze.workspace, resolution=0.2)


@pytest.fixture(scope="session")
def cells():
    """Twenty rooms in a row, each with a door; 60 x 20 cells of half a metre."""
    free = numpy.ones((20, 60), dtype=bool)
    for wall in range(3, 60, 3):
        free[:, wall] = False
        free[4 if wall % 2 else 15, wall] = True
    return tutavia.CellSpace.from_numpy(free, resolution=0.5, origin=(-3, 2))


def bits(curve):
    """The pieces of a curve, to the last bit."""
    return [(kind, numbers.tobytes()) for kind, numbers in curve.pieces]
