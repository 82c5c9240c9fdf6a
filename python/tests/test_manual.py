# SPDX-License-Identifier: MIT
"""The snippets of the manual's page print what stands below them."""

import contextlib
import io
import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "manual" / "python.md"


def test_the_snippets_of_the_manual_print_what_it_says():
    blocks = re.findall(r"```python\n(.*?)```\n(?:\n```text\n(.*?)```)?", PAGE.read_text(), re.S)
    assert len(blocks) >= 5
    names = {}
    for program, expected in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(program, str(PAGE), "exec"), names)
        assert printed.getvalue() == expected
