#!/usr/bin/env python3
"""Makes the module with the labels of settings whose name alone says too little, from the window's table.

  setting_labels.py setting_labels.cpp -o setting_label_table.js

Fails when it finds no table there.
"""
import json
import re
import sys

TABLE = re.compile(r"\bkLabels\[\] = \{(.*?)\};", re.S)
ROW = re.compile(r'\{\s*"([\w.]+)",\s*"((?:[^"\\]|\\.)*)"\s*\}')


def main(arguments):
    if len(arguments) != 3 or arguments[1] != "-o":
        sys.exit(__doc__)
    with open(arguments[0], encoding="utf-8") as source:
        table = TABLE.search(source.read())
    rows = ROW.findall(table.group(1)) if table else []
    if not rows or len(rows) != table.group(1).count("{"):
        print("setting_labels.py: %s: no table kLabels of names and texts" % arguments[0], file=sys.stderr)
        return 1
    with open(arguments[2], "w", encoding="utf-8") as module:
        module.write("/** Made by setting_labels.py from the labels of the window. */\nexport default ")
        json.dump({name: json.loads('"%s"' % text) for name, text in rows}, module, ensure_ascii=False, indent=1)
        module.write(";\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
