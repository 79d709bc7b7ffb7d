#!/usr/bin/env python3
"""Checks the pages (*.md): lines of prose have at most 120 columns, links lead to files and headings that are there, and
every image of docs is shown by a page. The modules of the bridge's page (*.js), which nothing formats, have at most 120
columns, too. Prints file:line: what to do; exits with 1 if there is anything.

  scripts/check_documents.py
"""
import os
import re
import subprocess
import sys

COLUMNS = 120
IMAGE = re.compile(r"\.(jpe?g|png|svg|gif)$")
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?[^)]*\)|<img\b[^>]*\bsrc=\"([^\"]+)\"")
ELSEWHERE = re.compile(r"^[a-z][a-z0-9+.-]*:")  # https:, mailto:


def linesOutsideCode(text):
    """Number and text of each line outside fenced and indented blocks."""
    fence = None
    for number, line in enumerate(text.split("\n"), 1):
        mark = re.match(r"\s*(```+|~~~+)", line)
        if mark and (fence is None or mark.group(1).startswith(fence)):
            fence = mark.group(1) if fence is None else None
        elif fence is None and not line.startswith("    "):
            yield number, line


def isTooLong(line):
    """Only lines that can be wrapped are: no row of a table, no heading, no single link or piece of code."""
    return len(line) > COLUMNS and not re.match(r"\s*(\||#+ )", line) and " " in re.sub(r"`[^`]*`", "", line).strip()


def slugOf(heading):
    """The anchor that a heading gets."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    text = re.sub(r"[^\w\- ]", "", text.strip().lower())
    return text.replace(" ", "-")


def anchorsOf(text):
    found, times = set(), {}
    for _, line in linesOutsideCode(text):
        found.update(re.findall(r"<a (?:name|id)=\"([^\"]+)\"", line))
        heading = re.match(r"#+ +(.*?) *#*$", line)
        if heading:
            slug = slugOf(heading.group(1))
            found.add(slug if slug not in times else "%s-%d" % (slug, times[slug]))
            times[slug] = times.get(slug, 0) + 1
    return found


def linksOf(text):
    """Line and target of each link that stays within the repository."""
    for number, line in linesOutsideCode(text):
        for link in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            target = link.group(1) or link.group(2)
            if not ELSEWHERE.match(target):
                yield number, target


def fileOf(page, target):
    """The path that a link of `page` leads to."""
    path = target.split("#")[0]
    return os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page


def parentsOf(name):
    parts = name.split("/")[:-1]
    return ["."] + ["/".join(parts[:count + 1]) for count in range(len(parts))]


def troubles(pages, files):
    """Page, line and remedy; `pages` are texts by their path, `files` all paths of the repository."""
    folders = {parent for name in files for parent in parentsOf(name)}
    for page, text in pages.items():
        for number, line in linesOutsideCode(text):
            if isTooLong(line):
                yield page, number, "%d columns: wrap the line at %d" % (len(line), COLUMNS)
        for number, target in linksOf(text):
            path = fileOf(page, target)
            if path not in files and path not in folders:
                yield page, number, "%s: there is no such file" % target
            elif "#" in target and path in pages and target.split("#")[1] not in anchorsOf(pages[path]):
                yield page, number, "%s: there is no such heading" % target
    shown = {fileOf(page, target) for page, text in pages.items() for _, target in linksOf(text)}
    for name in sorted(files):
        if name.startswith("docs/") and IMAGE.search(name) and name not in shown:
            yield name, 1, "no page shows it: remove it"


def longLines(modules):
    """Module, line and remedy; an import stands within one line (bundle.py)."""
    for name, text in modules.items():
        for number, line in enumerate(text.split("\n"), 1):
            if len(line) > COLUMNS and not line.startswith("import "):
                yield name, number, "%d columns: wrap the line at %d" % (len(line), COLUMNS)


LONG = "word " * 25
# Examples of faults, and of faultless text: a check that finds nothing checks nothing.
WRONG = (LONG, "- " + LONG, "[a](none.md)", "![a](none.png)", "[a](#none)", "[a](other.md#none)", '<img src="none.png">')
RIGHT = ("word " * 20, "| " + LONG + "|", "```\n" + LONG + "\n[a](none.md)\n```", "    " + LONG, "`" + LONG + "`,", "`[a](none.md)`", "[a](../x.h)", "[a](../docs)",
         "# A `b`: c\n[a](#a-b-c)", "[a](other.md#own)", "<a name=\"here\"></a>\n[a](#here)", "[a](https://x.org/" + "y" * 120 + ")",
         "## Twice\n## Twice\n[a](#twice-1)")


def checkItself():
    files = {"docs/page.md", "docs/other.md", "x.h"}
    for page, wrong in [(p, True) for p in WRONG] + [(p, False) for p in RIGHT]:
        if any(troubles({"docs/page.md": page, "docs/other.md": "# Own"}, files)) != wrong:
            print("check_documents: wrong about its own example: " + page, file=sys.stderr)
            sys.exit(1)
    if not any(troubles({"docs/page.md": ""}, files | {"docs/a.png"})):
        print("check_documents: it does not see that an image is not shown", file=sys.stderr)
        sys.exit(1)
    for module, wrong in ((LONG, True), ("import " + LONG, False), ("é" * COLUMNS, False)):
        if any(longLines({"a.js": module})) != wrong:
            print("check_documents: wrong about its own module: " + module, file=sys.stderr)
            sys.exit(1)


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    checkItself()
    names = subprocess.run(["git", "ls-files", "-z"], check=True, capture_output=True, text=True).stdout.split("\0")
    files = {name for name in names if name and os.path.exists(name)}
    texts = lambda ending, folder="": {name: open(name, encoding="utf-8").read() for name in sorted(files)
                                       if name.endswith(ending) and name.startswith(folder)}
    found = list(troubles(texts(".md"), files)) + list(longLines(texts(".js", "apps/bridge/page/js/")))
    for page, number, remedy in found:
        print("%s:%d: %s" % (page, number, remedy), file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
