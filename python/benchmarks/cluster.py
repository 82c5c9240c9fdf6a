# SPDX-License-Identifier: MIT
"""Plans many queries on a cluster of four workers, one of which dies; run by hand.

    PYTHONPATH=build/python/python python3 python/benchmarks/cluster.py [COUNT [FOLDER]]

Then the whole run is killed in the middle, and run again. Each file is compared with that of one
process.
"""

import filecmp
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy
from distributed import Client, LocalCluster

import tutavia
from tutavia.distributed import HEADER, plan_many


def task(count):
    scene = tutavia.builtin_map("maze")
    points = numpy.random.default_rng(3).uniform(0, 16, (count, 4))
    return (tutavia.LatticeSpace(scene.workspace, resolution=0.2),
            tutavia.Queries(points[:, :2], points[:, 2:]))


def run(path, count, kill_worker=False):
    space, queries = task(count)
    begin = time.monotonic()
    with LocalCluster(n_workers=4, threads_per_worker=1, dashboard_address=":0",
                      silence_logs=50) as cluster:
        with Client(cluster) as client:
            pids = list(client.run(os.getpid).values())

            def kill():
                while not (path.exists() and path.stat().st_size > 45 * count):
                    time.sleep(0.01)
                os.kill(pids[0], signal.SIGKILL)
                print(f"killed worker {pids[0]} at {path.stat().st_size} bytes", flush=True)

            if kill_worker:
                threading.Thread(target=kill, daemon=True).start()
            plan_many(client, space, queries, path, search="jps", chunk=500)
    print(f"{path.name}: {time.monotonic() - begin:.1f} s", flush=True)


def main(count, folder):
    space, queries = task(count)
    one = folder / "one_process.csv"
    begin = time.monotonic()
    batch = tutavia.plan_batch(space, queries.starts, queries.goals, "jps", keep_plans=False)
    one.write_text(HEADER + "\n" + batch._lines(0))
    print(f"one process, {os.cpu_count()} threads: {time.monotonic() - begin:.1f} s, "
          f"{batch.planned.sum()} of {count} planned")
    died = folder / "worker_died.csv"
    run(died, count, kill_worker=True)
    whole = folder / "killed_as_a_whole.csv"
    command = [sys.executable, __file__, "--run", str(count), str(whole)]
    child = subprocess.Popen(command, start_new_session=True)
    while child.poll() is None and not (whole.exists() and whole.stat().st_size > 45 * count):
        time.sleep(0.01)
    os.killpg(child.pid, signal.SIGKILL)
    child.wait()
    print(f"killed everything at {whole.read_bytes().count(10) - 1} results")
    subprocess.run(command, check=True)
    for path in (died, whole):
        lines = path.read_bytes().count(10) - 1
        print(f"{path.name}: {lines} results, equal to one process: "
              f"{filecmp.cmp(one, path, shallow=False)}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--run"]:
        run(pathlib.Path(sys.argv[3]), int(sys.argv[2]))
    else:
        target = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")
        target.mkdir(exist_ok=True)
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 100000, target)
