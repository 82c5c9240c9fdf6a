# SPDX-License-Identifier: MIT
"""What Python adds to the times of C++; run by hand, on a machine with nothing else to do.

    PYTHONPATH=build/python/python python3 python/benchmarks/speed.py \
        build/python/python/tutavia-python-reference calls batch interrupts

calls: the time of a short plan in both, alternating, in microseconds.
batch: queries on a map of 1024 x 1024 cells on all cores, alternating (COUNT=100000).
interrupts: milliseconds from SIGINT to KeyboardInterrupt, for plans that would take longer.
"""

import os
import pathlib
import signal
import statistics
import subprocess
import sys
import threading
import time

import numpy

import tutavia

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests"))
from test_same_bits import Draws  # noqa: E402


def reference(program, what, count):
    return subprocess.run([program, what, str(count)], check=True, capture_output=True,
                          text=True).stdout.split()


def calls(program, rounds=9, count=20000):
    scene = tutavia.builtin_map("maze")
    space = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
    planner = tutavia.Planner("astar", "clothoid")
    start, goal = (2, 1), (1.5, 1.2)

    def of(plan):
        for _ in range(1000):
            plan(space, start, goal)
        begin = time.perf_counter()
        for _ in range(count):
            plan(space, start, goal)
        return 1e6 * (time.perf_counter() - begin) / count

    times = {"C++": [], "Planner.plan": [], "plan": []}
    for _ in range(rounds):
        times["C++"].append(float(reference(program, "calls", count)[0]))
        times["Planner.plan"].append(of(planner.plan))
        times["plan"].append(of(tutavia.plan))
    cpp = statistics.median(times["C++"])
    for name, values in times.items():
        median = statistics.median(values)
        print(f"{name:14}{median:8.2f} us a call, least {min(values):.2f}; "
              f"{median - cpp:+.2f} us over C++")


def rooms(draws):
    free = numpy.ones((1024, 1024), dtype=bool)
    for _ in range(400):
        x, y = draws.next() % 1024, draws.next() % 1024
        width, height = 4 + draws.next() % 40, 4 + draws.next() % 40
        free[y:y + height, x:x + width] = False
    return tutavia.CellSpace.from_numpy(free)


def batch(program, rounds=3, count=int(os.environ.get("COUNT", 100000))):
    draws = Draws()
    space = rooms(draws)
    points = numpy.array([draws.points(1024) for _ in range(count)])
    ratios = []
    for _ in range(rounds):
        *seconds, planned = reference(program, "batch", count)
        seconds, cpu = map(float, seconds)
        times = []
        for keep_plans in (True, False):
            begin = time.perf_counter(), time.process_time()
            result = tutavia.plan_batch(space, points[:, 0], points[:, 1], "jps", "clothoid",
                                        keep_plans=keep_plans)
            times.append((time.perf_counter() - begin[0], time.process_time() - begin[1]))
            assert result.planned.sum() == int(planned)
            del result
        ratios.append((seconds / times[0][0], cpu / times[0][1]))
        print(f"C++ {count / seconds:.0f} queries/s, Python {count / times[0][0]:.0f} "
              f"({ratios[-1][0]:.2f}; by processor time {ratios[-1][1]:.2f}), without plans "
              f"{count / times[1][0]:.0f}; {planned} planned", flush=True)
    wall, cpu = (statistics.median(ratio) for ratio in zip(*ratios))
    print(f"Python's speed in C++'s: {wall:.3f}, by processor time {cpu:.3f}")


def interrupts(_, rounds=20):
    scene = tutavia.builtin_map("maze")
    lattice = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
    # A long snake, on which every search has to expand everything.
    free = numpy.ones((1024, 1024), dtype=bool)
    for wall in range(2, 1024, 4):
        free[:, wall] = False
        free[0 if wall % 8 == 2 else 1023, wall] = True
    snake = tutavia.CellSpace.from_numpy(free)
    tutavia.plan(snake, (0.5, 0.5), (1.5, 0.5), "jps")
    ends = (0.5, 0.5), (1021.5, 10.5)
    cases = [("rrt_star on the maze", lattice, (2, 1), (14, 6), "rrt_star", "none",
              {"max_iterations": 10**9}, 0.1)]
    cases += [(f"{search} on a snake", snake, *ends, search, "none", {}, 0.05)
              for search in ("dijkstra", "astar", "theta_star", "any_angle", "bidirectional_astar")]
    cases += [(f"jps and {smoother} on a snake", snake, *ends, "jps", smoother, {}, delay)
              for smoother, delay in (("clothoid", 0.3), ("taut_string", 0.3), ("bezier", 0.3))]
    for name, space, start, goal, search, smoother, options, delay in cases:
        begin = time.perf_counter()
        if options == {}:
            tutavia.plan(space, start, goal, search, smoother, time_limit=20)
            delay = 0.6 * (time.perf_counter() - begin)
        waits = []
        for i in range(rounds):
            sent = []

            def send():
                time.sleep(delay * (0.5 + i / rounds))
                sent.append(time.perf_counter())
                os.kill(os.getpid(), signal.SIGINT)

            thread = threading.Thread(target=send)
            try:
                thread.start()
                tutavia.plan(space, start, goal, search, smoother, **options)
                thread.join()
            except KeyboardInterrupt:
                waits.append(1e3 * (time.perf_counter() - sent[0]))
            except tutavia.Failure as failure:
                print(name, failure)
                try:
                    thread.join()
                except KeyboardInterrupt:
                    pass
                break
        if waits:
            print(f"{name:36}{statistics.median(waits):8.2f} ms, at most {max(waits):.2f} "
                  f"({len(waits)} of {rounds})")


if __name__ == "__main__":
    for part in sys.argv[2:] or ("calls", "batch", "interrupts"):
        {"calls": calls, "batch": batch, "interrupts": interrupts}[part](sys.argv[1])
