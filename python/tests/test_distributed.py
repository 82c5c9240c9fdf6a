# SPDX-License-Identifier: MIT
"""Many queries: files of results, restarts, and Dask clusters whose workers die."""

import fcntl
import os
import re
import signal
import subprocess
import sys
import threading
import time

import numpy
import pytest

import tutavia

distributed = pytest.importorskip("distributed")
from tutavia.distributed import HEADER, plan_many, read_results  # noqa: E402

COUNT = 3000


@pytest.fixture(scope="module")
def queries():
    random = numpy.random.default_rng(21)
    return tutavia.Queries(random.uniform(0, 16, (COUNT, 2)), random.uniform(0, 16, (COUNT, 2)))


@pytest.fixture(scope="module")
def cluster():
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0",
                                  silence_logs=50) as cluster:
        yield cluster


@pytest.fixture
def client(cluster):
    with distributed.Client(cluster) as client:
        yield client


@pytest.fixture(scope="module")
def expected(lattice, queries):
    """The file that one process writes."""
    batch = tutavia.plan_batch(lattice, queries.starts, queries.goals, keep_plans=False)
    return HEADER + "\n" + batch._lines(0)


@pytest.fixture
def queries_csv(queries, tmp_path):
    path = tmp_path / "queries.csv"
    rows = numpy.hstack([queries.starts, queries.goals]).tolist()
    path.write_text("start_x,start_y,goal_x,goal_y\n" +
                    "".join(",".join(map(repr, row)) + "\n" for row in rows))
    return path


def test_the_file_is_that_of_one_process(client, lattice, queries, expected, tmp_path):
    path = tmp_path / "results.csv"
    assert plan_many(client, lattice, queries, path, chunk=100) is None
    assert path.read_text() == expected
    stamp = path.stat().st_mtime_ns
    plan_many(client, lattice, queries, path, chunk=77)  # nothing is left to do
    assert path.read_text() == expected
    columns = read_results(path)
    assert (columns["query"] == numpy.arange(COUNT)).all()
    assert stamp == path.stat().st_mtime_ns


def test_without_a_file_the_columns_are_returned(client, lattice, queries, expected, tmp_path):
    path = tmp_path / "expected.csv"
    path.write_text(expected)
    columns = plan_many(client, lattice, numpy.hstack([queries.starts, queries.goals]), chunk=500)
    for name, values in read_results(path).items():
        assert numpy.array_equal(columns[name], values, equal_nan=values.dtype.kind == "f")


@pytest.mark.parametrize("cut", [0, 7, 500, 100000])
def test_a_restart_completes_a_file_that_was_cut_anywhere(client, lattice, queries, expected,
                                                          tmp_path, cut):
    path = tmp_path / "results.csv"
    plan_many(client, lattice, queries, path, chunk=1000)
    path.write_text(expected[:cut])
    plan_many(client, lattice, queries, path, chunk=333)
    assert path.read_text() == expected


def test_results_of_another_job_are_refused(client, lattice, queries, tmp_path, cells):
    path = tmp_path / "results.csv"
    plan_many(client, lattice, queries, path)
    for job in ((cells, queries, {}), (lattice, queries[:10], {}),
                (lattice, queries, {"search": "jps"}),
                (lattice, queries, {"heuristic": "euclidean"}),
                (lattice, queries, {"max_expansions": 5})):
        with pytest.raises(tutavia.InvalidInput, match="another job"):
            plan_many(client, job[0], job[1], path, **job[2])
    os.remove(f"{path}.job")
    with pytest.raises(tutavia.InvalidInput, match="there is no"):
        plan_many(client, lattice, queries, path)


@pytest.mark.parametrize("text, line", [("a,b\n1,2\n", 1), (HEADER + "\n1,2,3\n", 2),
                                        (HEADER + "\n0,2,3\n", 2), (HEADER + "\n\n", 2)])
def test_what_is_no_file_of_results_is_refused_and_kept(client, lattice, queries, tmp_path, text,
                                                        line):
    path = tmp_path / "results.csv"
    plan_many(client, lattice, queries, path)  # for the job
    path.write_text(text)
    with pytest.raises(tutavia.InvalidInput, match=f"line {line}: this is no file of results"):
        plan_many(client, lattice, queries, path)
    assert path.read_text() == text
    with pytest.raises(tutavia.InvalidInput, match=f"line {line}"):
        read_results(path)


@pytest.mark.parametrize("cut", [10, 700, 5000, 5003])
def test_results_of_a_file_that_was_cut_are_its_whole_lines(expected, tmp_path, cut):
    path = tmp_path / "results.csv"
    path.write_text(expected[:len(HEADER) + 1 + cut])
    whole = expected[len(HEADER) + 1:][:cut].count("\n")
    columns = read_results(path)
    assert columns["query"].tolist() == list(range(whole))
    assert set(columns) == set(HEADER.split(","))
    assert all(len(values) == whole for values in columns.values())


@pytest.mark.parametrize("cell, wrong", [("length", "x"), ("fell_back", "maybe"),
                                         ("expanded", "1" * 30), ("status", b"\xff")])
def test_cells_that_are_no_results_are_named(expected, tmp_path, cell, wrong):
    path = tmp_path / "results.csv"
    rows = [line.split(",") for line in expected.splitlines()[:6]]
    at = next(i for i in range(1, 6) if rows[i][5] == "planned")
    rows[at][rows[0].index(cell)] = wrong if isinstance(wrong, str) else "WRONG"
    text = "\n".join(map(",".join, rows)) + "\n"
    path.write_bytes(text.encode() if isinstance(wrong, str)
                     else text.encode().replace(b"WRONG", wrong))
    message = f"line {at + 1}: {cell}" if isinstance(wrong, str) else "no file of results"
    with pytest.raises(tutavia.InvalidInput, match=message):
        read_results(path)


def test_lines_that_are_not_in_order_are_no_results(expected, tmp_path):
    path = tmp_path / "results.csv"
    lines = expected.splitlines(keepends=True)
    path.write_text("".join(lines[:5] + lines[6:9]))
    with pytest.raises(tutavia.InvalidInput, match="line 6: this is no result of the query"):
        read_results(path)


def test_a_file_has_one_writer(client, lattice, queries, tmp_path):
    path = tmp_path / "results.csv"
    with open(path, "ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        with pytest.raises(tutavia.InvalidInput, match="another process is writing it"):
            plan_many(client, lattice, queries, path)
        assert path.stat().st_size == 0
    plan_many(client, lattice, queries, path)
    assert len(read_results(path)["query"]) == COUNT


def test_bad_input_is_refused_before_anything_is_written(client, lattice, queries, tmp_path):
    path = tmp_path / "results.csv"
    for arguments, options, message in (
            ((lattice, numpy.zeros((3, 3)), path), {}, r"\(n, 4\)"),
            ((lattice, queries, path), {"search": "astr"}, "did you mean astar"),
            ((lattice, queries, path), {"heuristics": "octile"}, "did you mean heuristic"),
            ((lattice, queries, path), {"search": "any_angle"}, "any_angle"),
            ((lattice, queries, path), {"chunk": 0}, "chunk"),
            ((lattice, queries, path), {"chunk": 1.5}, "chunk"),
            ((lattice, queries, path), {"threads": 0}, "threads"),
            ((lattice, queries, path), {"threads": "two"}, "threads"),
            ((lattice, queries, path), {"retries": -1}, "retries"),
            ((lattice, queries, path), {"max_expansions": 2.0}, "max_expansions"),
            ((lattice, queries, path), {"time_limit": 1}, "time_limit: no option"),
            ((lattice, queries, "results.txt"), {}, "NAME.csv or NAME.parquet"),
            (("space", queries, path), {}, "expected a LatticeSpace")):
        with pytest.raises(ValueError, match=message):
            plan_many(client, *arguments, **options)
        assert not path.exists()


def test_parquet_says_what_it_needs_or_resumes_by_parts(client, lattice, queries, tmp_path):
    path = tmp_path / "results.parquet"
    try:
        import pandas
        pandas.io.parquet.get_engine("auto")
    except ImportError:
        with pytest.raises(tutavia.InvalidOption, match="pyarrow or fastparquet"):
            plan_many(client, lattice, queries, path)
        return
    plan_many(client, lattice, queries, path, chunk=1000)
    os.remove(path / "part-000000001000.parquet")
    plan_many(client, lattice, queries, path, chunk=1000)
    assert pandas.read_parquet(path)["query"].tolist() == list(range(COUNT))


def test_a_worker_that_dies_loses_no_query(lattice, queries, expected, tmp_path):
    path = tmp_path / "results.csv"
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0",
                                  silence_logs=50) as cluster:
        with distributed.Client(cluster) as client:
            pids = list(client.run(os.getpid).values())

            def kill_when_begun():
                while not (path.exists() and path.stat().st_size > 10000):
                    time.sleep(0.005)
                os.kill(pids[0], signal.SIGKILL)

            # A daemon, so that a plan that fails does not wait for it.
            killer = threading.Thread(target=kill_when_begun, daemon=True)
            killer.start()
            plan_many(client, lattice, queries, path, chunk=20)
            killer.join(timeout=60)
            assert not killer.is_alive()
    assert path.read_text() == expected


PROGRAM = """
import sys, distributed, tutavia
from tutavia.distributed import plan_many
if __name__ == "__main__":
    scene = tutavia.builtin_map("maze")
    space = tutavia.LatticeSpace(scene.workspace, resolution=0.2)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0",
                                  silence_logs=50) as cluster:
        with distributed.Client(cluster) as client:
            plan_many(client, space, sys.argv[1], sys.argv[2], chunk=20)
"""


def test_killed_as_a_whole_and_restarted_it_completes(queries_csv, expected, tmp_path):
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    path = tmp_path / "results.csv"
    command = [sys.executable, str(program), str(queries_csv), str(path)]
    run = subprocess.Popen(command, start_new_session=True)
    while run.poll() is None and not (path.exists() and path.stat().st_size > 20000):
        time.sleep(0.005)
    if run.poll() is None:
        os.killpg(run.pid, signal.SIGKILL)
    run.wait()
    assert expected.startswith(path.read_text())
    subprocess.run(command, check=True, timeout=300)
    assert path.read_text() == expected


@pytest.mark.skipif("TUTAVIA_BATCH" not in os.environ, reason="tutavia-batch is not built")
class TestCommandLine:
    """tutavia-batch writes the same files."""

    def run(self, *arguments, **options):
        return subprocess.run([os.environ["TUTAVIA_BATCH"], *map(str, arguments)],
                              capture_output=True, text=True, **options)

    def test_the_file_is_that_of_python(self, queries_csv, expected, tmp_path, client, lattice):
        path = tmp_path / "results.csv"
        done = self.run(queries_csv, "--map", "maze", "--results", path, check=True)
        assert f"{COUNT} queries planned or refused" in done.stdout and not done.stderr
        assert path.read_text() == expected
        # Python goes on where it stopped, and the other way round.
        path.write_text(expected[:50000])
        plan_many(client, lattice, queries_csv, path)
        assert path.read_text() == expected
        path.write_text(expected[:70000])
        done = self.run(queries_csv, "--map", "maze", "--results", path, "--threads", 1, check=True)
        assert "results were there" in done.stdout
        assert path.read_text() == expected

    def test_bad_usage_is_named(self, queries_csv, tmp_path):
        path = tmp_path / "results.csv"
        for arguments, message in (
                ((), "QUERIES|queries"),
                ((queries_csv, "--map", "maze"), "--results"),
                ((tmp_path / "none.csv", "--results", path), "cannot be read"),
                ((queries_csv, "--results", path, "--search", "astr"), "did you mean astar"),
                ((queries_csv, "--results", path, "--serch", "astar"), "did you mean --search"),
                ((queries_csv, "--results", path, "--map", "attic"), "attic"),
                ((queries_csv, "--results", tmp_path / "no" / "r.csv", "--map", "maze"),
                 "cannot")):
            done = self.run(*arguments)
            assert done.returncode == 2
            assert len(done.stderr.splitlines()) == 1
            assert re.search(message, done.stderr), done.stderr

    def test_a_file_has_one_writer(self, queries_csv, tmp_path):
        path = tmp_path / "results.csv"
        with open(path, "ab") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            done = self.run(queries_csv, "--map", "maze", "--results", path)
        assert done.returncode == 2 and "another process is writing it" in done.stderr
        assert path.stat().st_size == 0

    def test_options_that_fit_no_query_are_named(self, tmp_path):
        queries = tmp_path / "queries.csv"
        queries.write_text("start_x,start_y,goal_x,goal_y,start_heading\n2,1,14,6,0\n")
        path = tmp_path / "results.csv"
        done = self.run(queries, "--map", "maze", "--results", path)
        assert done.returncode == 2 and "start_heading" in done.stderr
        assert path.read_text() == HEADER + "\n"

    def test_a_turned_map_and_its_unknown_cells_are_part_of_the_job(self, tmp_path):
        def write(yaw, x, unknown):
            rows = [[254] * 20 for _ in range(20)]
            for column in range(20):
                rows[10][column] = 205 if column in unknown else 0 if column < 15 else 254
            pixels = "\n".join(" ".join(map(str, row)) for row in rows)
            (tmp_path / "m.pgm").write_text(f"P2\n20 20\n255\n{pixels}\n")
            (tmp_path / "m.yaml").write_text(
                f"image: m.pgm\nresolution: 0.5\norigin: [{x}, 2, {yaw}]\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n")

        def job(*options):
            path = tmp_path / "r.csv"
            for file in (path, tmp_path / "r.csv.job"):
                file.unlink(missing_ok=True)
            self.run(queries, "--grid", tmp_path / "m.yaml", "--results", path, *options,
                     check=True)
            return (tmp_path / "r.csv.job").read_text()

        queries = tmp_path / "queries.csv"
        queries.write_text("start_x,start_y,goal_x,goal_y\n2,4,2,10\n")
        jobs = []
        for yaw, x, unknown in ((0.1, 1, {3}), (0.2, 1, {3}), (0.1, 1.5, {3}), (0.1, 1, {3, 4})):
            write(yaw, x, unknown)
            jobs.append(job("--unknown", "cost:5"))
        jobs.append(job("--unknown", "cost:6"))
        assert len(set(jobs)) == len(jobs)
        write(0.1, 1, {3})
        assert job("--unknown", "cost:5") == jobs[0]

    def test_other_jobs_are_refused(self, queries_csv, tmp_path):
        path = tmp_path / "results.csv"
        self.run(queries_csv, "--map", "maze", "--results", path, check=True)
        done = self.run(queries_csv, "--map", "maze", "--results", path, "--radius", "0.2")
        assert done.returncode == 2 and "another job" in done.stderr
