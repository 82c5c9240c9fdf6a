# SPDX-License-Identifier: MIT
"""Ctrl-C, signals and the GIL. No test asserts a time: benchmarks/calls.py measures."""

import asyncio
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy
import pytest

import tutavia

# Runs until it is cancelled.
ENDLESS = {"search": "rrt_star", "smoother": "none", "max_iterations": 10**9}


def interrupt_soon(seconds=0.2):
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


def test_ctrl_c_cancels_a_plan(lattice):
    interrupt_soon()
    with pytest.raises(KeyboardInterrupt):
        tutavia.plan(lattice, (2, 1), (14, 6), **ENDLESS)
    # The next plan is not disturbed.
    assert tutavia.plan(lattice, (2, 1), (14, 6)).certificate.status == "proved"


def test_ctrl_c_cancels_a_batch(lattice):
    points = numpy.tile([[2.0, 1.0]], (100000, 1))
    interrupt_soon()
    with pytest.raises(KeyboardInterrupt):
        tutavia.plan_batch(lattice, points, points + [12, 5], **ENDLESS)


def test_a_handler_that_raises_something_else_is_heard(lattice):
    class Stop(Exception):
        pass

    def stop(*_):
        raise Stop

    before = signal.signal(signal.SIGINT, stop)
    try:
        interrupt_soon()
        with pytest.raises(Stop):
            tutavia.plan(lattice, (2, 1), (14, 6), **ENDLESS)
    finally:
        signal.signal(signal.SIGINT, before)


def test_a_handler_that_raises_nothing_does_not_cancel(lattice):
    heard = []
    before = signal.signal(signal.SIGINT, lambda *_: heard.append(1))
    try:
        timer = interrupt_soon(0.05)
        limited = {**ENDLESS, "max_iterations": 30000}
        plan = tutavia.plan(lattice, (2, 1), (14, 6), **limited)
        timer.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert heard and plan.length == tutavia.plan(lattice, (2, 1), (14, 6), **limited).length


def test_other_signals_wait_until_the_plan_ends(lattice):
    heard = []
    before = signal.signal(signal.SIGUSR1, lambda *_: heard.append(1))
    try:
        threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGUSR1)).start()
        tutavia.plan(lattice, (2, 1), (14, 6), **{**ENDLESS, "max_iterations": 30000})
        time.sleep(0.05)
    finally:
        signal.signal(signal.SIGUSR1, before)
    assert heard


def test_asyncio_still_hears_signals(lattice):
    async def main():
        heard = asyncio.Event()
        asyncio.get_running_loop().add_signal_handler(signal.SIGUSR1, heard.set)
        threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGUSR1)).start()
        tutavia.plan(lattice, (2, 1), (14, 6), **{**ENDLESS, "max_iterations": 30000})
        await asyncio.wait_for(heard.wait(), 10)
        heard.clear()
        os.kill(os.getpid(), signal.SIGUSR1)
        await asyncio.wait_for(heard.wait(), 10)

    asyncio.run(main())


def test_other_threads_run_during_a_plan(lattice):
    counted = []

    def count():
        while not done.is_set():
            counted.append(1)
            time.sleep(0.001)

    done = threading.Event()
    thread = threading.Thread(target=count)
    thread.start()
    before = len(counted)
    with pytest.raises(tutavia.Failure):
        tutavia.plan(lattice, (2, 1), (9, 3), **ENDLESS)
    tutavia.plan(lattice, (2, 1), (14, 6), time_limit=0.3, **ENDLESS)
    during = len(counted) - before
    done.set()
    thread.join()
    assert during > 10


def test_plans_in_other_threads_go_on_at_ctrl_c(lattice):
    lengths = []

    def work():
        lengths.append(tutavia.plan(lattice, (2, 1), (14, 6),
                                    **{**ENDLESS, "max_iterations": 30000}).length)

    thread = threading.Thread(target=work)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(1)
    thread.join()
    assert len(lengths) == 1


def test_a_forked_process_hears_ctrl_c():
    program = textwrap.dedent("""
        import os, signal, sys, threading
        import tutavia
        scene = tutavia.builtin_map("maze")
        space = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
        tutavia.plan(space, (2, 1), (14, 6))
        child = os.fork()
        if child == 0:
            threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
            try:
                tutavia.plan(space, (2, 1), (14, 6), "rrt_star", "none", max_iterations=10**9)
            except KeyboardInterrupt:
                os._exit(7)
            os._exit(1)
        sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    """)
    assert subprocess.run([sys.executable, "-c", program], timeout=60).returncode == 7


def test_a_signal_before_a_plan_is_handled_first(lattice):
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    os.kill(os.getpid(), signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
        tutavia.plan(lattice, (2, 1), (14, 6), **ENDLESS)
