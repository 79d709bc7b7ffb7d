#!/usr/bin/env python3
"""Joins an ES module and all that it imports into one, so that a page costs one request in place of thirty.

  bundle.py MODULE.js FOLDER... -o OUTPUT.js

Modules are looked for by name in the folders. Each becomes a function that is run once, after those that it imports, and
gives what it exports. `import()` stays as it is. Understood is what the page's modules consist of: imports and exports at the
beginning of a line, each import within one line, no exported variables that change, comments of whole lines. All else fails, with file and line.
"""
import os
import re
import sys

IMPORT = re.compile(r'import (?:\{ ([^{}]+) \}|(\w+)) from "\./([\w.]+)";$')
DECLARED = re.compile(r"export (?:async )?(?:function|class|const) (\w+)")
CONSTANTS = re.compile(r"export const ((?:\w+ = [\w.]+, )+\w+ = [\w.]+);")
DEFAULT = "export default "


class Wrong(Exception):
    pass


def variable(name):
    return "m_" + re.sub(r"\W", "_", name)


def exported_names(line):
    """What a line that begins with `export` declares."""
    several = CONSTANTS.match(line)
    if several:
        return [each.split(" = ")[0] for each in several.group(1).split(", ")]
    one = DECLARED.match(line)
    return [one.group(1)] if one else []


def waits_itself(statement):
    """Whether a statement of a module, not a function in it, waits for something."""
    before, found, _ = statement.partition("await ")
    return bool(found) and not re.search(r"=>|\bfunction\b|^class\b", before)


def code_lines(path):
    """Lines with their numbers, without empty ones and those that are nothing but comment: browsers need none."""
    with open(path, encoding="utf-8") as source:
        lines = source.read().splitlines()
    inside = False
    for number, line in enumerate(lines, 1):
        text = line.strip()
        if inside or text.startswith("/*"):
            inside = not text.endswith("*/")
            if "*/" in text and inside:
                raise Wrong("%s:%d: code behind a comment" % (path, number))
        elif text and not text.startswith("//"):
            yield number, line


class Module:
    """One module: `imports` are names of files; `body` is its function's; `exports` are names."""

    def __init__(self, path):
        self.path, self.imports, self.exports, self.body, self.wanted = path, [], [], [], []
        for number, line in code_lines(path):
            try:
                self.take(line)
            except Wrong as wrong:
                raise Wrong("%s:%d: %s" % (path, number, wrong)) from None

    def take(self, line):
        if line.startswith("import ") or line.startswith("import{"):
            return self.take_import(line)
        if line.startswith(DEFAULT):
            self.exports.append("default")
            line = "const default_ = " + line[len(DEFAULT):]
        elif line.startswith("export"):
            names = exported_names(line)
            if not names:
                raise Wrong("an export of a kind that bundle.py does not know")
            self.exports += names
            line = line[len("export "):]
        return self.body.append(line)

    def take_import(self, line):
        found = IMPORT.match(line)
        if not found:
            raise Wrong("an import of a kind that bundle.py does not know")
        names, whole, file = found.groups()
        self.imports.append(file)
        if whole:
            self.wanted.append((file, "default"))
            return self.body.append("const %s = %s.default;" % (whole, variable(file)))
        parts = [each.strip().split(" as ") for each in names.split(",")]
        self.wanted += [(file, part[0]) for part in parts]
        chosen = ", ".join(": ".join(part) for part in parts)
        return self.body.append("const { %s } = %s;" % (chosen, variable(file)))

    def text(self):
        """The module as a statement. It may wait for what it loads."""
        code = "\n".join(self.body)
        waits = any(waits_itself(statement) for statement in re.split(r"\n(?=[^\s/*})\]])", code))
        given = ", ".join("default: default_" if name == "default" else name for name in self.exports)
        head, tail = ("await (async () => {", "})();") if waits else ("(() => {", "})();")
        return "const %s = %s\n%s\nreturn { %s };\n%s\n" % (variable(os.path.basename(self.path)), head, code, given, tail)


def collect(name, folders, known, under_way):
    """All modules that `name` needs and itself, each after what it imports."""
    if name in known:
        return
    if name in under_way:
        raise Wrong("%s imports itself by way of %s" % (name, ", ".join(under_way)))
    path = next((each for each in (os.path.join(folder, name) for folder in folders) if os.path.exists(each)), None)
    if path is None:
        raise Wrong("there is no module %s, which %s imports" % (name, under_way[-1] if under_way else "the command line"))
    module = Module(path)
    for needed in module.imports:
        collect(needed, folders, known, under_way + [name])
    for file, wanted in module.wanted:
        if wanted not in known[file].exports:
            raise Wrong("%s imports %s, which %s does not export" % (path, wanted, file))
    known[name] = module


def main(arguments):
    if len(arguments) < 4 or arguments[-2] != "-o":
        sys.exit(__doc__)
    modules = {}
    try:
        collect(arguments[0], arguments[1:-2], modules, [])
    except (Wrong, OSError) as wrong:
        print("bundle.py: %s" % wrong, file=sys.stderr)
        return 1
    with open(arguments[-1], "w", encoding="utf-8") as output:
        output.write("/* Made by bundle.py. */\n" + "".join(module.text() for module in modules.values()))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
