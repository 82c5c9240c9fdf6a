# SPDX-License-Identifier: MIT
"""The stubs are those of the tables, and the docstrings name every option."""

import ast
import inspect
import pathlib

import pytest

import tutavia
from tutavia import searches, smoothers, stubs

SOURCES = pathlib.Path(__file__).resolve().parents[1] / "tutavia"


@pytest.mark.parametrize("name", sorted(stubs.stubs()))
def test_no_stub_is_stale(name):
    if name == "_native.pyi" and tutavia._native._pybind11_major != 2:
        pytest.skip("pybind11 3 writes other signatures; the stubs are written with version 2")
    text = (SOURCES / name).read_text(encoding="utf-8")
    assert text == stubs.stubs()[name], "write them by python3 -m tutavia.stubs python/tutavia"


@pytest.mark.parametrize("name", sorted(stubs.stubs()))
def test_stubs_are_python(name):
    ast.parse(stubs.stubs()[name])


@pytest.mark.parametrize("module, described", [(searches, tutavia.describe_searches()),
                                               (smoothers, tutavia.describe_smoothers())])
def test_every_algorithm_is_a_function_that_takes_its_defaults(module, described):
    assert module.__all__ == list(described)
    for name, description in described.items():
        function = getattr(module, name)
        defaults = {p.name: p.default for p in inspect.signature(function).parameters.values()}
        assert list(defaults) == [option.name for option in description.options]
        assert all(f"{option}:" in function.__doc__ for option in defaults)
        given = function(**defaults)
        assert [text for _, text in given.options] == [
            text for _, text in sorted((option.key, _normal(option)) for option in
                                       description.options)]


def _normal(option):
    is_number = option.type.startswith("number") and option.default != "none"
    return repr(float(option.default)) if is_number else option.default


def test_everything_public_has_a_docstring():
    for name in tutavia.__all__:
        value = getattr(tutavia, name)
        assert inspect.getdoc(value), name
        if not inspect.isclass(value) or not value.__module__.startswith("tutavia"):
            continue
        for member, function in vars(value).items():
            if member.startswith("_") or not callable(function):
                continue
            assert inspect.getdoc(function), f"{name}.{member}"
