#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prepares a file of the sources for Doxygen, and prints it: cmake/docs_filter.py FILE

Markdown is written for GitHub. Its headings get the names by which links find them there, and links
to pages, headers and examples become those of Doxygen. Other links lead nowhere outside the
sources: their text stays. In headers, the examples that comments name become links. An example
becomes its page: what its first comment says.
"""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
HEADING = re.compile(r"#+ (.*)")
DEFINITION = re.compile(r"^\[([^\]]+)\]: (\S+)$")


def slug(heading):
    """The name that GitHub gives to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def label(page, anchor=""):
    """The name of a page or a heading, unique among all pages."""
    if page == "README.md" and not anchor:
        return "index"
    return re.sub(r"\W", "_", f"{page} {anchor}" if anchor else page)


def reference(page, target):
    """What Doxygen finds a target of a link by; None if it has no page."""
    path, _, anchor = target.partition("#")
    full = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
    if full.endswith(".md"):
        return label(full, anchor)
    if re.fullmatch(r"include/tutavia/(\w+/)?\w+\.hpp", full):  # machinery has no pages
        return full.removeprefix("include/")
    if full.startswith("examples/") and full.endswith(".cpp"):
        return os.path.basename(full)
    return None


def parent(page):
    """The page that lists a page, in whose part of the contents it stands."""
    folder, name = os.path.split(page)
    if page == "docs/README.md":
        return "README.md"
    is_listed_beside = folder and name != "README.md" and (ROOT / folder / "README.md").exists()
    return f"{folder}/README.md" if is_listed_beside else "docs/README.md"


def replaced(page, found, listed):
    image, text, target = found.groups()
    if "://" in target or target.startswith("mailto:"):
        return found[0]
    if image:
        return f"![{text}]({os.path.basename(target)})"
    to, text = reference(page, target), " ".join(text.split())  # one line, as Doxygen demands
    full = os.path.normpath(os.path.join(os.path.dirname(page), target))
    if full.endswith(".md") and full != "README.md" and parent(full) == page and to not in listed:
        listed.add(to)
        return f'@subpage {to} "{text.replace(chr(34), "")}"'
    return f"[{text}](@ref {to})" if to else text


def markdown(page, text):
    is_title, listed = True, set()
    text = re.sub(r"\A<!--.*?-->\s*", "", text)  # Doxygen finds a title in the first line alone
    for part in re.split(r"(^ *```.*?^ *```$)", text, flags=re.M | re.S):
        if part.lstrip().startswith("```"):
            yield part
            continue
        part = LINK.sub(lambda found: replaced(page, found, listed), part)
        for line in part.splitlines(keepends=True):
            heading, definition = HEADING.match(line), DEFINITION.match(line)
            if heading:
                name = label(page, "" if is_title else slug(heading[1]))
                is_title = False
                if name != "index":
                    line = f"{heading[0]} {{#{name}}}\n"
            elif definition and (to := reference(page, definition[2])):
                line = f"[{definition[1]}]: @ref {to}\n"
            yield line


def example(name, text):
    comment = re.match(r"(?://.*\n)*", text)[0].splitlines()[1:]  # without the licence line
    return "\n".join([f"/** \\example {name}", *(line[2:] for line in comment), "*/"])


def main():
    sys.stdout.reconfigure(encoding="utf-8")
    path = pathlib.Path(sys.argv[1]).resolve()
    name, text = path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")
    if name.endswith(".md"):
        print("".join(markdown(name, text)), end="")
    elif name.startswith("examples/"):
        print(example(path.name, text))
    else:
        print(re.sub(r"\bexamples/(\w+\.cpp)\b", r"@ref \1", text), end="")


if __name__ == "__main__":
    main()
