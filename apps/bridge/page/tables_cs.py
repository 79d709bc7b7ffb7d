#!/usr/bin/env python3
"""Makes the modules with Czech texts from the window's translations: tables_cs.js for settings, edits, lights, sky and
materials, sentences_cs.js for what the server and the bridge say.

  tables_cs.py tables_cs.ts sentences_cs.ts gui_cs.ts MODULE.js... -o FOLDER

The tables have all of the contexts Settings, Edits, LightKinds and SectionsPanel, and of other contexts what the modules
ask for by of("Context", "text"). Fails when such a text has no translation.
"""
import json
import os
import re
import sys
import xml.etree.ElementTree as ET

WHOLE = ("Settings", "Edits", "LightKinds", "SectionsPanel")
SENTENCES = "Server"
ASKED = re.compile(r'\bof\("(\w+)", "((?:[^"\\]|\\.)*)"')


def translations(files):
    """Translated texts by context and English text; a context of the window goes without its gui::, texts without &."""
    found = {}
    for file in files:
        for context in ET.parse(file).getroot().iter("context"):
            texts = found.setdefault(context.findtext("name").replace("gui::", ""), {})
            for message in context.iter("message"):
                english, other = message.findtext("source"), message.find("translation")
                if other is not None and other.text and other.get("type") is None:
                    texts[english.replace("&", "")] = other.text.replace("&", "")
    return found


def asked_texts(modules):
    """(context, text) of all that modules ask for."""
    found = set()
    for module in modules:
        with open(module, encoding="utf-8") as source:
            found.update((context, text.replace('\\"', '"')) for context, text in ASKED.findall(source.read()))
    return sorted(found)


def write(path, texts):
    with open(path, "w", encoding="utf-8") as module:
        module.write("/** Made by tables_cs.py from the translations of the window. */\nexport default ")
        json.dump(texts, module, ensure_ascii=False, separators=(",", ":"))
        module.write(";\n")


def main(arguments):
    if len(arguments) < 4 or arguments[-2] != "-o":
        sys.exit(__doc__)
    inputs, folder = arguments[:-2], arguments[-1]
    known = translations(name for name in inputs if name.endswith(".ts"))
    chosen = {context: known[context] for context in WHOLE}
    missing = 0
    for context, text in asked_texts(name for name in inputs if name.endswith(".js")):
        if text not in known.get(context, {}):
            print("tables_cs.py: %s: no translation of '%s'" % (context, text), file=sys.stderr)
            missing += 1
        elif context not in WHOLE:
            chosen.setdefault(context, {})[text] = known[context][text]
    if missing:
        return 1
    write(os.path.join(folder, "tables_cs.js"), chosen)
    write(os.path.join(folder, "sentences_cs.js"), known[SENTENCES])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
