# SPDX-License-Identifier: MIT
"""Ctrl-C, signals and the GIL. No test asserts a time: benchmarks/speed.py measures."""

import asyncio
import contextlib
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


@contextlib.contextmanager
def handling_sigint(handler):
    before = signal.signal(signal.SIGINT, handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


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

    with handling_sigint(stop), pytest.raises(Stop):
        interrupt_soon()
        tutavia.plan(lattice, (2, 1), (14, 6), **ENDLESS)


def test_a_handler_that_raises_nothing_runs_during_the_plan_and_ends_nothing(lattice):
    heard = []

    class Stop(Exception):
        pass

    def handle(*_):
        heard.append(1)
        if len(heard) == 3:
            raise Stop
        interrupt_soon(0.05)

    # Only a handler that is called three times during this one plan ends it.
    with handling_sigint(handle), pytest.raises(Stop):
        interrupt_soon(0.05)
        tutavia.plan(lattice, (2, 1), (14, 6), **ENDLESS)
    assert len(heard) == 3


def test_a_handler_may_plan(lattice):
    lengths = []

    def handle(*_):
        lengths.append(tutavia.plan(lattice, (2, 1), (14, 6)).length)

    limited = {**ENDLESS, "max_iterations": 30000}
    with handling_sigint(handle):
        timer = interrupt_soon(0.05)
        plan = tutavia.plan(lattice, (2, 1), (14, 6), **limited)
        timer.join()
        time.sleep(0.01)
    assert lengths == [tutavia.plan(lattice, (2, 1), (14, 6)).length]
    assert plan.length == tutavia.plan(lattice, (2, 1), (14, 6), **limited).length


def test_no_ctrl_c_is_lost_whenever_it_comes(lattice):
    # A lost one would let the plan without an end run until its time limit, and fail the test.
    seed = time.time_ns() % 10**6
    print("seed", seed)
    random = numpy.random.default_rng(seed)
    for _ in range(100):
        with pytest.raises(KeyboardInterrupt):
            interrupt_soon(random.uniform(0, 0.003))
            for _ in range(random.integers(0, 200)):
                tutavia.plan(lattice, (2, 1), (2.5, 1))
            tutavia.plan(lattice, (2, 1), (14, 6), time_limit=30, **ENDLESS)


@pytest.mark.parametrize("by", ["python", "library"])
def test_without_a_handler_of_python_the_process_ends(by):
    program = textwrap.dedent("""
        import ctypes, os, signal, sys, threading
        import tutavia
        space = tutavia.LatticeSpace(tutavia.builtin_map("maze").workspace, resolution=0.2)
        if sys.argv[1] == "python":
            signal.signal(signal.SIGINT, signal.SIG_DFL)
        else:
            ctypes.CDLL(None).signal(signal.SIGINT, None)
        tutavia.plan(space, (2, 1), (14, 6))
        threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
        tutavia.plan(space, (2, 1), (14, 6), "rrt_star", "none", max_iterations=10**9)
    """)
    run = subprocess.run([sys.executable, "-c", program, by], timeout=60)
    assert run.returncode == -signal.SIGINT


def test_other_signals_are_not_lost(lattice):
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


def test_under_asyncio_ctrl_c_is_a_matter_of_the_loop(lattice):
    async def main():
        heard = asyncio.Event()
        asyncio.get_running_loop().add_signal_handler(signal.SIGINT, heard.set)
        timer = interrupt_soon(0.05)
        plan = tutavia.plan(lattice, (2, 1), (14, 6), **{**ENDLESS, "max_iterations": 30000})
        timer.join()
        await asyncio.wait_for(heard.wait(), 10)
        return plan

    assert asyncio.run(main()).certificate.status == "proved"


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


def test_ctrl_c_in_a_forked_process_writes_into_no_file(tmp_path):
    program = textwrap.dedent("""
        import os, signal, sys
        import tutavia
        space = tutavia.LatticeSpace(tutavia.builtin_map("maze").workspace, resolution=0.2)
        tutavia.plan(space, (2, 1), (14, 6))
        if os.fork() != 0:
            os.wait()
            sys.exit()
        os.closerange(3, 64)
        files = [open(f"{sys.argv[1]}/{i}", "wb") for i in range(40)]
        try:
            os.kill(os.getpid(), signal.SIGINT)
        except KeyboardInterrupt:
            pass
        os._exit(0)
    """)
    subprocess.run([sys.executable, "-c", program, str(tmp_path)], timeout=60, check=True)
    assert [file.stat().st_size for file in tmp_path.iterdir()] == [0] * 40


def test_a_process_forked_during_a_plan_hears_ctrl_c():
    program = textwrap.dedent("""
        import os, signal, sys, threading, time
        import tutavia
        space = tutavia.LatticeSpace(tutavia.builtin_map("maze").workspace, resolution=0.2)
        codes = []

        def work():
            time.sleep(0.1)
            child = os.fork()
            if child != 0:
                codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
                return
            try:
                threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
                tutavia.plan(space, (2, 1), (14, 6), "rrt_star", "none", max_iterations=10**9)
            except KeyboardInterrupt:
                os._exit(7)
            os._exit(1)

        thread = threading.Thread(target=work)
        thread.start()
        tutavia.plan(space, (2, 1), (14, 6), "rrt_star", "none", max_iterations=10**9, time_limit=1)
        thread.join()
        sys.exit(codes[0])
    """)
    assert subprocess.run([sys.executable, "-c", program], timeout=60).returncode == 7
