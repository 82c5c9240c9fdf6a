# SPDX-License-Identifier: MIT
"""Type stubs, made from the tables of options and from the compiled module.

    python3 -m tutavia.stubs FOLDER            writes the stubs into a source folder
    python3 -m tutavia.stubs --check FOLDER    names those that are stale; exit code 1
"""

import inspect
import os
import re
import sys
import textwrap

from . import _native, algorithms

_HEAD = "# SPDX-License-Identifier: MIT\n# Written by `python3 -m tutavia.stubs`.\n"

# How pybind11 writes types, which differs from one version to another, and what stubs say.
_TYPES = (
    (r"numpy\.(?:typing\.NDArray|ndarray)\[[\w.]+\]", "numpy.ndarray"),
    (r"typing\.SupportsFloat(?: \| typing\.SupportsIndex)?", "float"),
    (r"typing\.SupportsInt(?: \| typing\.SupportsIndex)?", "int"),
    (r"\b(?:collections\.abc\.|typing\.)?(?:List|Sequence)\[", "list["),
    (r"\bOptional\[([\w.]+)\]", r"\1 | None"),
    (r"\b(?:object|handle)\b", "Any"),
    (r"\btutavia\._native\.|\btutavia\.(?=[A-Z])", ""),
    (r"\bself: \w+", "self"),
    (r"= inf\b", '= float("inf")'),
)


def algorithm_stub(kind: str) -> str:
    """The stub of tutavia.searches or tutavia.smoothers."""
    described = (algorithms.describe_searches() if kind == "search"
                 else algorithms.describe_smoothers())
    parts = [_HEAD, "from typing import Literal, Optional\n", "from .algorithms import Algorithm\n"]
    for algorithm in described.values():
        parameters = "".join(
            f",\n    {option.name}: {algorithms.annotation(option)} = "
            f"{algorithms.to_python(option)!r}" for option in algorithm.options)
        signature = f"(\n    *{parameters},\n)" if parameters else "()"
        signature = signature.replace("= inf", '= float("inf")')
        doc = textwrap.indent(algorithms.docstring(algorithm), "    ").strip()
        parts.append(f'\ndef {algorithm.name}{signature} -> Algorithm:\n    """{doc}"""\n')
    return "\n".join(parts)


def native_stub() -> str:
    """The stub of the compiled module: the classes that users see."""
    parts = [_HEAD, "from typing import Any\n", "import numpy\n",
             "from .samples import CurveSamples, SpeedSamples\n", "__version__: str\n"]
    for name, value in sorted(vars(_native).items()):
        if inspect.isclass(value) and not name.startswith("_"):
            parts.append(_class_stub(name, value))
    return "\n".join(parts)


def _class_stub(name, kind):
    lines = [f"\nclass {name}:", _doc(kind.__doc__, "    ")]
    for member, value in sorted(vars(kind).items()):
        if member.startswith("_") and member not in ("__init__", "__len__", "__getitem__"):
            continue
        if isinstance(value, property):
            signature, _ = _split(value.fget.__doc__ or "", "")
            returns = signature.rpartition(" -> ")[2] if signature else "Any"
            lines += ["    @property", f"    def {member}(self) -> {returns}:",
                      _doc(value.__doc__, "        ")]
            continue
        is_static = isinstance(value, staticmethod)
        function = value.__func__ if is_static else value
        if inspect.isfunction(function):  # added by tutavia/__init__.py
            signature = str(inspect.signature(function))
            doc = function.__doc__
        else:
            signature, doc = _split(function.__doc__ or "", member)
        if signature is None:
            continue
        if is_static:
            lines.append("    @staticmethod")
        returns = "" if "->" in signature else " -> Any"
        lines += [f"    def {member}{signature}{returns}:", _doc(doc, "        ")]
    return "\n".join(lines)


def _split(doc, name):
    """The signature that pybind11 puts before a docstring, and the rest."""
    match = re.match(rf"{name}(\(.*\) -> .*)\n?", doc)
    if match is None:
        return None, doc
    signature = match.group(1)
    for native, python in _TYPES:
        signature = re.sub(native, python, signature)
    return signature, doc[match.end():]


def _doc(doc, indent):
    text = inspect.cleandoc(doc or "").strip()
    if not text:
        return f"{indent}..."
    return f'{indent}"""' + textwrap.indent(text, indent).strip() + '"""'


def stubs():
    """The text of each stub, by the name of its file."""
    return {"_native.pyi": native_stub(), "searches.pyi": algorithm_stub("search"),
            "smoothers.pyi": algorithm_stub("smoother")}


def main(arguments):
    check = arguments[:1] == ["--check"]
    folders = arguments[1:] if check else arguments
    if len(folders) != 1:
        sys.stderr.write(__doc__)
        return 2
    stale = []
    for name, text in stubs().items():
        path = os.path.join(folders[0], name)
        if check:
            with open(path, encoding="utf-8") as file:
                if file.read() != text:
                    stale.append(name)
            continue
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    if stale:
        print(f"stale: {', '.join(stale)}; write them by python3 -m tutavia.stubs {folders[0]}")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
