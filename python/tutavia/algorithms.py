# SPDX-License-Identifier: MIT
"""Algorithms by name, with their options as keyword arguments.

Everything here is made from the tables of options that the library has: `searches` and `smoothers`
hold one function for each algorithm, which checks its options and returns them with the name.
"""

import inspect
import numbers
from typing import Any, Dict, NamedTuple, Tuple

from . import _native
from .failures import InvalidOption


class Option(NamedTuple):
    """An option of an algorithm."""

    name: str  #: as a keyword argument
    key: str  #: as the library calls it, with a point where Python has an underscore
    type: str  #: "number", "whole number" or "a|b|c", with "|none" if it need not be given
    unit: str
    default: str  #: as a text that sets it
    sentence: str


class Description(NamedTuple):
    """An algorithm in words."""

    name: str
    sentence: str
    on_lattice: bool  #: whether it works on a LatticeSpace
    on_cells: bool  #: whether it works on a CellSpace
    options: Tuple[Option, ...]


class Algorithm:
    """A search or smoother with options, as `search=` and `smoother=` take it.

    Made by the functions of `tutavia.searches` and `tutavia.smoothers`. Two of the same name and
    options are equal.
    """

    __slots__ = ("kind", "name", "options")

    def __init__(self, kind: str, name: str, options: Dict[str, Any]):
        described = _described(kind, name)
        texts = {}
        for keyword, value in options.items():
            option = next((o for o in described.options if keyword in (o.name, o.key)), None)
            if option is None:
                raise InvalidOption(unknown_option(
                    f"{kind} {name}", keyword, [o.name for o in described.options]))
            texts[option.key] = to_text(f"{name}: {keyword}", value)
        self.kind = kind
        self.name = name
        self.options = tuple(sorted(texts.items()))

    def __eq__(self, other):
        return isinstance(other, Algorithm) and self._key() == other._key()

    def __hash__(self):
        return hash(self._key())

    def __repr__(self):
        options = ", ".join(f"{key}={text}" for key, text in self.options)
        return f"{self.name}({options})"

    def __reduce__(self):
        return (Algorithm, (self.kind, self.name, dict(self.options)))

    def _key(self):
        return (self.kind, self.name, self.options)

    def _stage(self):
        return (self.name, list(self.options))


def unknown_option(whose, word, names):
    """The message for an option that is not known, with the nearest one."""
    near = _native._nearest_name(word, names)
    if near:
        return f"{whose}: unknown option \"{word}\"; did you mean {near}?"
    known = ", ".join(names) if names else "there are none"
    return f"{whose}: unknown option \"{word}\"; known: {known}"


def to_text(what, value):
    """The text of an option's value, as the library reads it."""
    if value is None:
        return "none"
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    raise InvalidOption(f"{what}: expected a number, a string, a bool or None, got {value!r}")


def _read(describe):
    described = {}
    for name, sentence, on_lattice, on_cells, options in describe():
        described[name] = Description(
            name, sentence, on_lattice, on_cells,
            tuple(Option(key.replace(".", "_"), key, *rest) for key, *rest in options))
    return described


_DESCRIPTIONS = {"search": _read(_native._describe_searches),
                 "smoother": _read(_native._describe_smoothers)}


def describe_searches() -> Dict[str, Description]:
    """Every search with its options, by name."""
    return dict(_DESCRIPTIONS["search"])


def describe_smoothers() -> Dict[str, Description]:
    """Every smoother with its options, by name."""
    return dict(_DESCRIPTIONS["smoother"])


def _described(kind, name):
    known = _DESCRIPTIONS[kind]
    if name not in known:
        near = _native._nearest_name(name, list(known)) if isinstance(name, str) else None
        hint = f"did you mean {near}?" if near else "known: " + ", ".join(known)
        raise InvalidOption(f"{kind}: unknown name {name!r}; {hint}")
    return known[name]


def to_python(option: Option):
    """The default value of an option."""
    if option.default == "none":
        return None
    if option.default in ("true", "false"):
        return option.default == "true"
    if option.type.startswith("whole number"):
        return int(option.default)
    if option.type.startswith("number"):
        return float(option.default)
    return option.default


def annotation(option: Option) -> str:
    """The type of an option, as Python writes it."""
    names = option.type.split("|")
    optional = names[-1] == "none"
    if optional:
        names.pop()
    if names == ["number"]:
        text = "float"
    elif names == ["whole number"]:
        text = "int"
    elif names == ["false", "true"]:
        text = "bool"
    else:
        text = "Literal[" + ", ".join(f'"{name}"' for name in names) + "]"
    return f"Optional[{text}]" if optional else text


def docstring(described: Description) -> str:
    """The docstring of an algorithm's function."""
    spaces = " and ".join(
        name for name, works in (("LatticeSpace", described.on_lattice),
                                 ("CellSpace", described.on_cells)) if works)
    lines = [described.sentence + ".", "", f"On {spaces}."]
    if described.options:
        lines.append("")
    for option in described.options:
        unit = f" [{option.unit}]" if option.unit else ""
        lines.append(f"{option.name}: {option.sentence}{unit}.")
    return "\n".join(lines)


def make_functions(kind: str, namespace: Dict[str, Any]):
    """Puts a function for every algorithm of a kind into a module's namespace."""
    for described in _DESCRIPTIONS[kind].values():
        namespace[described.name] = _make_function(kind, described, namespace["__name__"])
    namespace["__all__"] = list(_DESCRIPTIONS[kind])


def _make_function(kind, described, module):
    def make(**options):
        return Algorithm(kind, described.name, options)

    make.__name__ = make.__qualname__ = described.name
    make.__module__ = module
    make.__doc__ = docstring(described)
    make.__signature__ = inspect.Signature([
        inspect.Parameter(option.name, inspect.Parameter.KEYWORD_ONLY, default=to_python(option))
        for option in described.options])
    return make
