# SPDX-License-Identifier: MIT
"""Failures as exceptions: one class per code of the library."""


class Failure(Exception):
    """Why there is no plan.

    code: the name of the code, such as "start_blocked".
    detail: one line for people.
    point: the start or goal that the failure is about, (x, y) [m], or None.
    obstacle: the index of the obstacle nearest to it, or None; on cells, of the blocked cell
        y * width + x.
    clearance: the signed clearance of the point [m], or None.
    nearest_safe_point: the nearest point of free space, (x, y) [m], if it was found.
    """

    code = "failure"

    def __init__(self, detail="", point=None, obstacle=None, clearance=None,
                 nearest_safe_point=None):
        super().__init__(detail, point, obstacle, clearance, nearest_safe_point)
        self.detail = detail
        self.point = point
        self.obstacle = obstacle
        self.clearance = clearance
        self.nearest_safe_point = nearest_safe_point

    def __str__(self):
        return f"{self.code}: {self.detail}" if self.detail else self.code


class StartBlocked(Failure):
    """The start lies in an obstacle or its safety zone."""

    code = "start_blocked"


class GoalBlocked(Failure):
    """The goal lies in an obstacle or its safety zone."""

    code = "goal_blocked"


class StartOutOfBounds(Failure):
    """The start lies outside the bounds."""

    code = "start_out_of_bounds"


class GoalOutOfBounds(Failure):
    """The goal lies outside the bounds."""

    code = "goal_out_of_bounds"


class Unreachable(Failure):
    """Proved: there is no path."""

    code = "unreachable"


class UnreachableAtResolution(Failure):
    """There is no path on the lattice; a finer one may have one."""

    code = "unreachable_at_resolution"


class NotProved(Failure):
    """A path was found, but its safety could not be proved."""

    code = "not_proved"


class BudgetExhausted(Failure):
    """The time limit or the limit of expansions was reached."""

    code = "budget_exhausted"


class Cancelled(Failure):
    """The plan was stopped on request."""

    code = "cancelled"


class InvalidOption(Failure, ValueError):
    """An option is unknown or out of range; the detail names it."""

    code = "invalid_option"


class InvalidInput(Failure, ValueError):
    """The input is malformed; the detail names object and index."""

    code = "invalid_input"


class LimitExceeded(Failure):
    """The request is too large; the detail has needed and allowed sizes."""

    code = "limit_exceeded"


_BY_CODE = {kind.code: kind for kind in (
    StartBlocked, GoalBlocked, StartOutOfBounds, GoalOutOfBounds, Unreachable,
    UnreachableAtResolution, NotProved, BudgetExhausted, Cancelled, InvalidOption, InvalidInput,
    LimitExceeded)}


def _of_code(code, *arguments):
    return _BY_CODE[code](*arguments)
