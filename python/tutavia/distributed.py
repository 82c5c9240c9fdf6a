# SPDX-License-Identifier: MIT
"""Many queries on many machines, by Dask: `plan_many`.

    from dask.distributed import Client
    from tutavia.distributed import plan_many

    with Client("scheduler:8786") as client:
        plan_many(client, space, tutavia.Queries.from_csv("queries.csv"), "results.csv")

Workers need tutavia of the same version, and nothing else of this program.
"""

import csv
import fcntl
import io
import operator
import os
import pickle
import sys
import time
import warnings
from typing import Any, Dict, Optional

import numpy

from . import _native
from .failures import InvalidInput, InvalidOption
from .planning import AlgorithmChoice, Planner, SmootherChoice, _planner

HEADER = _native._result_header


def plan_many(client, space, queries, results: Optional[str] = None, *,
              search: AlgorithmChoice = "astar", smoother: SmootherChoice = "clothoid",
              vehicle=None, max_expansions: Optional[int] = None, chunk: int = 1000,
              threads: int = 1, retries: int = 20, progress: Optional[bool] = None,
              **options: Any) -> Optional[Dict[str, numpy.ndarray]]:
    """Plans many queries on the workers of a Dask cluster.

    client: a `dask.distributed.Client`.
    space: a LatticeSpace or a CellSpace; each worker gets it once.
    queries: Queries, an array of shape (n, 4) (start x, y, goal x, y) [m], or the path of a CSV
        file of queries.
    results: a file: NAME.csv, or NAME.parquet, a folder of one file per chunk, which needs pandas
        and pyarrow or fastparquet. None: the results are returned, as by `read_results`.
    search, smoother, vehicle, options: as for `plan`.
    max_expansions: of each query.
    chunk: queries per task.
    threads: of each task; a worker runs as many tasks as it has threads.
    retries: how often a chunk is given to another worker when its worker dies.
    progress: whether to draw a bar on stderr; None: if that is a terminal.

    A CSV file grows in the order of the queries. The same call completes it after an interruption,
    even on another cluster, and it has the same bits as the file that one process writes, such as
    tutavia-batch. FILE.job says of which space, queries and algorithms it is. Results of another
    job are refused by InvalidInput.
    """
    queries = _queries(queries)
    chunk = _whole(chunk, "chunk", 1)
    threads = _whole(threads, "threads", 1, 4096)
    retries = _whole(retries, "retries", 0)
    if max_expansions is not None:
        max_expansions = _whole(max_expansions, "max_expansions", 0, 2**64 - 1)
    planner = Planner(search, smoother, vehicle=vehicle, **options)
    planner._native.check_on(space)
    job = planner._native.describe_job(space, queries)
    if max_expansions is not None:
        job += f", max_expansions {max_expansions}"
    sink = _sink(results, job, chunk)
    firsts = sink.missing(len(queries), chunk)
    task = (planner.search, planner.smoothers, planner.vehicle, max_expansions, threads)
    run = _Run(client, space, queries, task, chunk, retries)
    try:
        with _Bar(progress, len(queries), firsts, chunk) as bar:
            run.write_to(sink, firsts, bar)
    finally:
        sink.close()
    return sink.columns()


def read_results(file) -> Dict[str, numpy.ndarray]:
    """The columns of a CSV file of results, by name.

    file: a path or an open text file. Figures are NaN where there is no plan; `status` is an array
    of strings, `fell_back` of bools. A last line that was cut off while it was written does not
    count. Raises InvalidInput with the line for what is no file of results.
    """
    if not hasattr(file, "read"):
        with open(file, newline="", encoding="utf-8") as opened:
            return read_results(opened)
    try:
        text = file.read()
        rows = list(csv.reader(io.StringIO(text[:text.rfind("\n") + 1])))
    except (UnicodeDecodeError, csv.Error) as error:
        raise InvalidInput(f"this is no file of results: {error}") from None
    if not rows or rows[0] != HEADER.split(","):
        raise InvalidInput("line 1: this is no file of results")
    first = rows[1][0] if len(rows) > 1 and rows[1] else "0"
    for index, row in enumerate(rows[1:]):
        if len(row) != len(rows[0]):
            raise InvalidInput(f"line {index + 2}: expected {len(rows[0])} columns, got {len(row)}")
        if not first.isdecimal() or row[0] != str(int(first) + index):
            raise InvalidInput(f"line {index + 2}: this is no result of the query after the last")
    columns = zip(*rows[1:]) if len(rows) > 1 else [()] * len(rows[0])
    return {name: _column(name, values) for name, values in zip(rows[0], columns)}


def _column(name, values):
    """The array of a column of texts."""
    if name == "status":
        return numpy.array(values, dtype=str)
    kind, read = float, lambda value: float(value) if value else numpy.nan
    if name == "fell_back":
        kind, read = bool, lambda value: {"true": True, "false": False, "": False}[value]
    elif name in ("query", "expanded"):
        kind, read = numpy.int64, int
    column = numpy.empty(len(values), dtype=kind)
    for index, value in enumerate(values):
        try:
            column[index] = read(value)
        except (ValueError, KeyError, OverflowError):
            raise InvalidInput(f"line {index + 2}: {name}: found {value!r}") from None
    return column


def _whole(value, name, least, most=2**63 - 1):
    try:
        number = None if isinstance(value, bool) else operator.index(value)
    except TypeError:
        number = None
    if number is None or not least <= number <= most:
        raise InvalidOption(
            f"{name}: expected a whole number from {least} to {most}, got {value!r}")
    return number


def _queries(queries):
    if isinstance(queries, (str, os.PathLike)):
        return _native.Queries.from_csv(queries)
    if isinstance(queries, _native.Queries):
        return queries
    table = numpy.asarray(queries)
    if table.ndim != 2 or table.shape[1] != 4:
        raise InvalidInput("queries: expected Queries, an array of shape (n, 4) or the path of a "
                           f"CSV file, got an array of shape {table.shape}")
    return _native.Queries(table[:, :2], table[:, 2:])


# What workers run.

def _load(pickled):
    return pickle.loads(pickled)


def _plan_chunk(space, queries, first, task):
    search, smoothers, vehicle, max_expansions, threads = task
    planner = _planner(search, smoothers, vehicle, {})
    batch = planner.plan_batch(
        space, queries.starts, queries.goals, start_headings=queries.start_headings,
        goal_headings=queries.goal_headings, seeds=queries.seeds, max_expansions=max_expansions,
        threads=threads, keep_plans=False)
    return batch._lines(first)


class _Run:
    """Chunks on their way through a cluster."""

    def __init__(self, client, space, queries, task, chunk, retries):
        self.client = client
        self.queries = queries
        self.task = task
        self.chunk = chunk
        self.retries = retries
        self.pickled = pickle.dumps(space)
        self.space = None
        self.first = {}  # of each future
        self.tries = {}  # of each chunk

    def write_to(self, sink, firsts, bar):
        from distributed import as_completed

        if not firsts:
            return
        self._send_space()
        # Enough that no worker waits, few enough that a restart repeats little.
        window = 4 * max(sum(self.client.nthreads().values()), 1)
        finished = as_completed()
        waiting = list(reversed(firsts))
        held = {}  # results that earlier ones hold up
        order = iter(firsts)
        next_first = next(order)
        try:
            while next_first is not None:
                while waiting and len(self.first) + len(held) < 2 * window \
                        and len(self.first) < window:
                    finished.add(self._submit(waiting.pop()))
                future = next(finished)
                first = self.first.pop(future)
                lines = self._result(future, first, finished)
                if lines is None:
                    continue
                held[first] = lines
                while next_first in held:
                    sink.write(next_first, held.pop(next_first))
                    bar.advance(min(self.chunk, len(self.queries) - next_first))
                    next_first = next(order, None)
        finally:
            self.client.cancel(list(self.first))

    def _send_space(self):
        # A task, not scattered data: the scheduler makes it anew when its worker dies.
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that the graph is large
            self.space = self.client.submit(_load, self.pickled, pure=False)

    def _submit(self, first):
        part = self.queries[first:first + self.chunk]
        future = self.client.submit(_plan_chunk, self.space, part, first, self.task, pure=False)
        self.first[future] = first
        return future

    def _result(self, future, first, finished):
        """The lines of a chunk; None if its worker died and it is on its way again."""
        from concurrent.futures import CancelledError

        from distributed.scheduler import KilledWorker

        try:
            return future.result()
        except (KilledWorker, CancelledError):
            self.tries[first] = self.tries.get(first, 0) + 1
            if self.tries[first] > self.retries:
                raise
            if self.space.status in ("error", "lost", "cancelled"):
                self._send_space()
            finished.add(self._submit(first))
            return None


def _sink(results, job, chunk):
    if results is None:
        return _MemorySink()
    path = os.fspath(results)
    if path.endswith(".parquet"):
        return _ParquetSink(path, f"{job}, {chunk} per part")
    if path.endswith(".csv"):
        return _CsvSink(path, job)
    raise InvalidOption(f"results: expected NAME.csv or NAME.parquet, got {path!r}")


class _MemorySink:
    def __init__(self):
        self.text = [HEADER + "\n"]

    def missing(self, count, chunk):
        return list(range(0, count, chunk))

    def write(self, first, lines):
        self.text.append(lines)

    def close(self):
        pass

    def columns(self):
        return read_results(io.StringIO("".join(self.text)))


def _check_job(path, job_path, job, has_begun):
    """Writes the job beside new results; refuses those of another one."""
    if not has_begun:
        with open(job_path, "w", encoding="utf-8") as file:
            file.write(job + "\n")
        return
    try:
        with open(job_path, encoding="utf-8") as file:
            written = file.read().rstrip("\n")
    except FileNotFoundError:
        raise InvalidInput(f"{path}: there is no {job_path} that says of which job these results "
                           "are: give another file") from None
    if written != job:
        raise InvalidInput(f"{path}: these results are of another job ({written}) than this one "
                           f"({job}): give another file")


def _lock(file, path):
    """Keeps other writers away, also tutavia-batch, until the file is closed."""
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InvalidInput(f"{path}: another process is writing it") from None


class _CsvSink:
    """A file whose lines are in the order of the queries; a restart appends to it."""

    def __init__(self, path, job):
        self.done = 0
        self.file = open(path, "ab")
        try:
            _lock(self.file, path)
            self._begin(path, job)
        except BaseException:
            self.file.close()
            raise

    def _begin(self, path, job):
        written = os.fstat(self.file.fileno()).st_size  # now that nobody else writes it
        has_begun = written > 0
        _check_job(path, path + ".job", job, has_begun)
        size = 0
        if has_begun:
            with open(path, "rb") as file:
                try:
                    self.done, size = _native._count_results(file.read())
                except InvalidInput as error:
                    raise InvalidInput(f"{path}: {error.detail}") from None
            if written > size:
                self.file.truncate(size)  # to the last whole line
        if size == 0:
            self._append(HEADER + "\n")

    def missing(self, count, chunk):
        return list(range(self.done, count, chunk))

    def write(self, first, lines):
        self._append(lines)

    def _append(self, text):
        self.file.write(text.encode())
        self.file.flush()

    def close(self):
        self.file.close()

    def columns(self):
        return None


class _ParquetSink:
    """A folder with a file per chunk; a restart writes those that are not there."""

    def __init__(self, path, job):
        try:
            import pandas
            pandas.io.parquet.get_engine("auto")
        except ImportError as error:
            raise InvalidOption(f"results: {path}: Parquet needs pandas and pyarrow or "
                                f"fastparquet; NAME.csv needs nothing ({error})") from None
        self.path = path
        os.makedirs(path, exist_ok=True)
        self.lock = open(os.path.join(path, "_lock"), "ab")
        try:
            _lock(self.lock, path)
            has_begun = any(name != "_lock" for name in os.listdir(path))
            _check_job(path, os.path.join(path, "_job"), job, has_begun)
        except BaseException:
            self.lock.close()
            raise

    def _part(self, first):
        return os.path.join(self.path, f"part-{first:012d}.parquet")

    def missing(self, count, chunk):
        return [first for first in range(0, count, chunk)
                if not os.path.exists(self._part(first))]

    def write(self, first, lines):
        import pandas

        table = pandas.DataFrame(read_results(io.StringIO(HEADER + "\n" + lines)))
        part = self._part(first)
        hidden = os.path.join(self.path, "_" + os.path.basename(part))
        table.to_parquet(hidden, index=False)
        os.replace(hidden, part)  # whole, or not there

    def close(self):
        self.lock.close()

    def columns(self):
        return None


class _Bar:
    """How far a run has come, on a terminal."""

    def __init__(self, wanted, count, firsts, chunk):
        self.shown = sys.stderr.isatty() if wanted is None else wanted
        self.count = count
        left = sum(min(chunk, count - first) for first in firsts)
        self.done = self.before = count - left
        self.start = time.monotonic()

    def __enter__(self):
        self.advance(0)
        return self

    def advance(self, queries):
        self.done += queries
        if not self.shown:
            return
        rate = (self.done - self.before) / max(time.monotonic() - self.start, 1e-9)
        filled = 40 * self.done // self.count if self.count else 40
        left = (self.count - self.done) / rate if rate > 0 else 0
        sys.stderr.write(f"\r[{'#' * filled}{'.' * (40 - filled)}] {self.done}/{self.count}, "
                         f"{rate:.0f}/s, {left:.0f} s left  ")
        sys.stderr.flush()

    def __exit__(self, *_):
        if self.shown:
            sys.stderr.write("\n")
