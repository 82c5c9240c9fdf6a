# SPDX-License-Identifier: MIT
"""Plans of Python, of C++, of batches and of threads are equal to the last bit."""

import os
import struct
import subprocess

import numpy
import pytest

import tutavia
from conftest import bits


class Draws:
    """The numbers that benchmarks/reference.cpp draws (SplitMix64)."""

    def __init__(self):
        self.state = 27

    def next(self):
        mask = 2**64 - 1
        self.state = (self.state + 0x9E3779B97F4A7C15) & mask
        z = self.state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        return z ^ (z >> 31)

    def points(self, size):
        return tuple(tuple(size * (self.next() >> 11) * 2.0**-53 for _ in "xy") for _ in "ab")


def hexadecimal(numbers):
    return "".join(f" {word:016x}" for word in struct.unpack(f"<{len(numbers)}Q",
                                                             numpy.asarray(numbers, float).tobytes()))


def test_a_thousand_plans_of_python_and_of_cpp(lattice):
    output = subprocess.run([os.environ["TUTAVIA_REFERENCE"], "plans", "1000"], check=True,
                            capture_output=True, text=True).stdout.splitlines()
    assert len(output) == 1000
    draws = Draws()
    planned = 0
    for line in output:
        start, goal = draws.points(16)
        try:
            plan = tutavia.plan(lattice, start, goal)
        except tutavia.Failure as failure:
            assert line == failure.code
            continue
        planned += 1
        bounds = hexadecimal([plan.certificate.lower, plan.certificate.upper])
        assert line == "planned" + bounds + "".join(
            hexadecimal(numbers) for _, numbers in plan.curve.pieces)
    assert planned > 500


@pytest.fixture(scope="module")
def queries(lattice):
    random = numpy.random.default_rng(11)
    return random.uniform(0, 16, (300, 2)), random.uniform(0, 16, (300, 2))


@pytest.mark.parametrize("algorithms", [("astar", "clothoid"), ("rrt_connect", "taut_string")])
def test_a_batch_equals_single_plans_whatever_the_threads(lattice, queries, algorithms):
    starts, goals = queries
    seeds = numpy.arange(300)
    batches = [tutavia.plan_batch(lattice, starts, goals, *algorithms, seeds=seeds,
                                  threads=threads) for threads in (1, 2, 5)]
    for i in range(300):
        try:
            alone = tutavia.plan(lattice, starts[i], goals[i], *algorithms, seed=i)
        except tutavia.Failure as failure:
            for batch in batches:
                assert type(batch[i]) is type(failure)
                assert batch[i].__dict__ == failure.__dict__
                assert batch.status[i] == failure.code
            continue
        for batch in batches:
            assert bits(batch[i].curve) == bits(alone.curve)
            assert batch.length[i] == alone.length
            assert batch.clearance_lower[i] == alone.certificate.lower
            assert batch[i].stats.expanded == alone.stats.expanded


def test_the_columns_of_a_batch_have_a_figure_per_query(lattice, queries):
    batch = tutavia.plan_batch(lattice, *queries)
    lean = tutavia.plan_batch(lattice, *queries, keep_plans=False)
    assert len(batch) == len(lean) == 300
    assert batch.planned.dtype == bool and 0 < batch.planned.sum() < 300
    assert (numpy.isnan(batch.length) == ~batch.planned).all()
    for name in ("length", "clearance_lower", "clearance_upper", "turning_angle", "max_curvature"):
        assert numpy.array_equal(getattr(batch, name), getattr(lean, name), equal_nan=True)
    assert batch.status == lean.status
    with pytest.raises(tutavia.InvalidOption, match="keep_plans"):
        lean[0]
    with pytest.raises(IndexError):
        batch[300]
    assert len([result for result in batch]) == 300
    assert len(tutavia.plan_batch(lattice, [], [])) == 0
