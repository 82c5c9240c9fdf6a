# SPDX-License-Identifier: MIT
"""Plans: one query, or many on all cores."""

import collections
import threading
from typing import Any, Dict, Iterable, NamedTuple, Optional, Sequence, Tuple, Union

from . import _native
from .algorithms import Algorithm, _described, to_text, unknown_option
from .failures import InvalidOption

AlgorithmChoice = Union[str, Algorithm]
SmootherChoice = Union[str, Algorithm, Sequence[Union[str, Algorithm]]]


class Planner:
    """A search and a smoother that keep their memory warm from one query to the next.

    search: a name, or one with options: `searches.rrt_star(goal_bias=0.1)`.
    smoother: the same; "shortcut+bezier" or a list stands for several, one after the other.
    vehicle: a Vehicle, for searches that plan headings (hybrid_astar).
    options: options of the search and the smoother; one that both have has to be given to one of
        them by its function.

    Threads may share a planner. Raises InvalidOption for unknown names and options, with the
    nearest one.
    """

    def __init__(self, search: AlgorithmChoice = "astar",
                 smoother: SmootherChoice = "clothoid", *,
                 vehicle: Optional["_native.Vehicle"] = None, **options: Any):
        search, smoothers = _with_options(_algorithm("search", search), _stages(smoother), options)
        if vehicle is not None:
            if not isinstance(vehicle, _native.Vehicle):
                raise InvalidOption(
                    f"vehicle: expected a tutavia.Vehicle, got {type(vehicle).__name__}")
            if any(key.startswith("vehicle.") for key, _ in search.options):
                raise InvalidOption("vehicle: the search's options describe one, too")
        self.search = search
        self.smoothers = smoothers
        self.vehicle = vehicle
        self._native = _native._Planner(search._stage(), [s._stage() for s in smoothers], vehicle)
        if type(self).plan is Planner.plan:
            # The compiled function itself in place of the method: a call takes a microsecond less.
            self.plan = self._native.plan

    def plan(self, space, start, goal, *, start_heading: Optional[float] = None,
             goal_heading: Optional[float] = None, seed: int = 0,
             time_limit: Optional[float] = None,
             max_expansions: Optional[int] = None) -> "_native.Plan":
        """The Plan from start to goal.

        space: a LatticeSpace or a CellSpace.
        start, goal: (x, y) [m].
        start_heading, goal_heading: for searches that plan headings [rad]; None: any.
        seed: for searches that draw random numbers.
        time_limit: [s]; a search that improves its path returns the best one by then.
        max_expansions: of the search.

        Other threads run meanwhile; Ctrl-C in the main thread cancels. Raises the subclass of
        Failure for the reason why there is no plan.
        """
        return self._native.plan(space, start, goal, start_heading=start_heading,
                                 goal_heading=goal_heading, seed=seed, time_limit=time_limit,
                                 max_expansions=max_expansions)

    def plan_batch(self, space, starts, goals, *, start_headings=None, goal_headings=None,
                   seeds=None, time_limit: Optional[float] = None,
                   max_expansions: Optional[int] = None, threads: int = 0,
                   keep_plans: bool = True) -> "_native.Batch":
        """Plans many queries on all cores; returns a Batch in their order.

        starts, goals: arrays of shape (n, 2) [m].
        start_headings, goal_headings: arrays of shape (n,) [rad], NaN: any.
        seeds: an array of n whole numbers.
        time_limit: of each query [s].
        max_expansions: of each query.
        threads: 0: one per core. Results do not depend on it, unless time limits pass.
        keep_plans: False keeps the columns of figures alone, which takes a hundredth of the memory.

        A query that fails is no exception here: its entry of the batch is. Raises InvalidInput for
        other shapes and dtypes, InvalidOption for algorithms that do not work on the space.
        """
        return self._native.plan_batch(
            space, starts, goals, start_headings=start_headings, goal_headings=goal_headings,
            seeds=seeds, time_limit=time_limit, max_expansions=max_expansions, threads=threads,
            keep_plans=keep_plans)

    def __repr__(self):
        return f"Planner({self._native.text})"

    def __reduce__(self):
        return (_planner_of, (self.search, self.smoothers, self.vehicle))


def _planner_of(search, smoothers, vehicle):
    return Planner(search, smoothers, vehicle=vehicle)


def plan(space, start, goal, search: AlgorithmChoice = "astar",
         smoother: SmootherChoice = "clothoid", *, vehicle=None,
         start_heading: Optional[float] = None, goal_heading: Optional[float] = None,
         seed: int = 0, time_limit: Optional[float] = None,
         max_expansions: Optional[int] = None, **options: Any) -> "_native.Plan":
    """Plans from start to goal; see Planner and Planner.plan.

    The planners of the last calls are kept, so that their memory is warm in the next one.
    """
    planner = _planner(search, smoother, vehicle, options)
    return planner.plan(space, start, goal, start_heading=start_heading,
                        goal_heading=goal_heading, seed=seed, time_limit=time_limit,
                        max_expansions=max_expansions)


def plan_batch(space, starts, goals, search: AlgorithmChoice = "astar",
               smoother: SmootherChoice = "clothoid", *, vehicle=None, start_headings=None,
               goal_headings=None, seeds=None, time_limit: Optional[float] = None,
               max_expansions: Optional[int] = None, threads: int = 0, keep_plans: bool = True,
               **options: Any) -> "_native.Batch":
    """Plans many queries on all cores; see Planner and Planner.plan_batch."""
    planner = _planner(search, smoother, vehicle, options)
    return planner.plan_batch(
        space, starts, goals, start_headings=start_headings, goal_headings=goal_headings,
        seeds=seeds, time_limit=time_limit, max_expansions=max_expansions, threads=threads,
        keep_plans=keep_plans)


class Scene(NamedTuple):
    """A workspace with a start and goals."""

    workspace: "_native.Workspace"
    start: Tuple[float, float]  #: (x, y) [m]
    goals: Iterable[Tuple[float, float]]  #: (x, y) [m]
    resolution: float  #: a suitable distance between neighbours of a lattice [m]


def builtin_map(name: str) -> Scene:
    """A map of the library: "array", "complex", "maze", "rrt_scene_1" or "rrt_scene_2"."""
    return Scene(*_native._builtin_map(name))


_KEPT = 8
_kept: "collections.OrderedDict[Any, Planner]" = collections.OrderedDict()  # the last used: last
_lock = threading.Lock()


def _planner(search, smoother, vehicle, options) -> Planner:
    """A kept planner of these algorithms."""
    # With types: True and 1.0 are equal to 1, but not the same option.
    given = None
    if options:
        given = tuple((word, type(value), value) for word, value in options.items())
    key = (search, smoother, vehicle, given)
    try:
        planner = _kept[key]
        _kept.move_to_end(key)
        return planner
    except KeyError:  # or another thread has just dropped it
        pass
    except TypeError:  # a list, or a value that cannot be looked up
        return Planner(search, smoother, vehicle=vehicle, **options)
    planner = Planner(search, smoother, vehicle=vehicle, **options)
    with _lock:
        _kept[key] = planner
        if len(_kept) > _KEPT:
            _kept.popitem(last=False)
    return planner


def _algorithm(kind: str, choice: AlgorithmChoice) -> Algorithm:
    if isinstance(choice, Algorithm):
        if choice.kind != kind:
            raise InvalidOption(f"{kind}: {choice.name} is a {choice.kind}")
        return choice
    if callable(choice) and getattr(choice, "__module__", "").startswith("tutavia."):
        return _algorithm(kind, choice())
    if not isinstance(choice, str):
        raise InvalidOption(f"{kind}: expected a name or an algorithm, got {choice!r}")
    return Algorithm(kind, choice, {})


def _stages(choice: SmootherChoice) -> Tuple[Algorithm, ...]:
    if isinstance(choice, str):
        choice = choice.split("+")
    elif not isinstance(choice, (list, tuple)):
        choice = [choice]
    return tuple(_algorithm("smoother", stage) for stage in choice) or (
        Algorithm("smoother", "none", {}),)


def _with_options(search: Algorithm, smoothers: Tuple[Algorithm, ...],
                  options: Dict[str, Any]):
    """The algorithms with the keyword arguments that are theirs."""
    algorithms = [search, *smoothers]
    known = [[o.name for o in _described(a.kind, a.name).options] for a in algorithms]
    given: Any = [dict(a.options) for a in algorithms]
    for word, value in options.items():
        if word in _QUERY_OPTIONS:
            raise InvalidOption(f"{word}: no option of an algorithm: it belongs to one query or "
                                "batch, as an argument of Planner.plan or Planner.plan_batch")
        owners = [i for i, names in enumerate(known) if word in names]
        if not owners:
            names = list(dict.fromkeys(name for own in known for name in own))
            raise InvalidOption(unknown_option(
                " and ".join(f"{a.kind} {a.name}" for a in algorithms), word,
                names + list(_QUERY_OPTIONS)))
        if len(owners) > 1:
            owner = algorithms[owners[0]]
            raise InvalidOption(
                f"{word}: {' and '.join(algorithms[i].name for i in owners)} have it: give it to "
                f"one of them, such as {owner.kind}={owner.kind}"
                f"{'es' if owner.kind == 'search' else 's'}.{owner.name}({word}={value!r})")
        i = owners[0]
        key = next(o.key for o in _described(algorithms[i].kind, algorithms[i].name).options
                   if o.name == word)
        if key in given[i]:
            raise InvalidOption(f"{word}: {algorithms[i].name} has it already")
        given[i][key] = to_text(word, value)
    made = [Algorithm(a.kind, a.name, dict(own)) for a, own in zip(algorithms, given)]
    return made[0], tuple(made[1:])


_QUERY_OPTIONS = ("vehicle", "start_heading", "goal_heading", "start_headings", "goal_headings",
                  "seed", "seeds", "time_limit", "max_expansions", "threads", "keep_plans")
