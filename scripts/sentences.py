#!/usr/bin/env python3
"""The forms of all sentences that clients can show in another language (libs/rtcore/platform/sentence.h), and their
translations.

  scripts/sentences.py            bring apps/gui/translations/sentences_cs.ts up to date: new ones come in as unfinished
  scripts/sentences.py --check    change nothing; print what has no translation, and where something is refused in words
                                  that have none; exit with 1 if there is any
"""
import glob
import os
import re
import sys
import xml.etree.ElementTree as ET
from xml.sax.saxutils import escape

FILE = "apps/gui/translations/sentences_cs.ts"
# Whose refusals and messages reach people through clients.
SERVERS = ("apps/rtserver/commands", "apps/rtserver/document", "apps/rtserver/frames", "apps/rtserver/loop", "apps/rtserver/walk",
           "apps/rtserver/failure.cpp", "apps/rtserver/messages.cpp", "apps/common/commands", "apps/common/plans", "apps/common/settings/settings_merge.cpp", "apps/common/settings/guess_text.cpp", "apps/bridge/control", "apps/bridge/room")
LIBRARIES = ("libs/rtcore", "libs/ipc")
# Programs whose messages the window shows in the logs of its jobs.
JOBS = ("apps/renderer", "apps/bspbuilder", "apps/common/cli/import_options.cpp", "apps/common/cli/run_program.cpp")
SAYS = r"(?:say|form|Refusal|BadValue|Refused|UsageError|FileError|badImage|cannotEncode|wrongShape|refuse|refuseMesh|refuseToExport|Error)"
CALL = re.compile(r"(?<!class )(?<!explicit )\b%s\(" % SAYS)
# What a command line lacks is said in the words of command lines.
CALL_OF_JOBS = re.compile(r"\b(?:say|form|FileError|refuse)\(")
LITERALS = re.compile(r'(?:"(?:[^"\\\n]|\\.)*"\s*)+')
ONE = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
# Arguments that are texts of their own.
TEXTS = re.compile(r"\b(?:std::string|format|printable|inQuotes|shortestText|string)\(")
THROW = re.compile(r"\bthrow (?:app::|rtcore::)?(\w+)\(|\bthrow std::(runtime_error|invalid_argument)\(")
# A comparison's literals are none; nor are pieces that are put together.
COMPARED = re.compile(r'[=!]= "[^"]*"')
# Words that stand in places, in a table of their own.
LIGHT_KINDS = ("libs/rtcore/scene/light.h", re.compile(r'(?m)^    \{"(\w+)", (?:true|false)'))
HEADERS = ("apps/common/commands/told_forms.h", "apps/common/commands/pack_words.h", "libs/rtcore/io/import/import_forms.h")


def inside(text, start):
    """The text between the parenthesis that opens before `start` and the one that closes it."""
    depth, at = 1, start
    while at < len(text) and depth > 0:
        if text[at] == '"':
            at += 1
            while text[at] != '"':
                at += 2 if text[at] == "\\" else 1
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    return text[start:at - 1]


def without_texts(argument):
    """Without calls whose literals are no forms."""
    while True:
        found = TEXTS.search(argument)
        if not found:
            return argument
        inner = inside(argument, found.end())
        argument = argument[:found.start()] + "text" + argument[found.end() + len(inner) + 1:]


def literals(code):
    for found in LITERALS.finditer(code):
        text = "".join(ONE.findall(found.group()))
        text = text.replace('\\"', '"').replace("\\\\", "\\")
        # Punctuation and places alone are the same in each language.
        if re.search(r"[A-Za-z]", re.sub(r"\{\d\}", "", text)):
            yield text


def sources(folders):
    for folder in folders:
        for name in [folder] if os.path.isfile(folder) else sorted(glob.glob(folder + "/**/*", recursive=True)):
            if name.endswith((".cpp", ".h")):
                with open(name, encoding="utf-8") as source:
                    yield name, re.sub(r"(?m)(?<!:)//.*$", "", source.read())


def forms():
    found = {}
    for name, text in sources(SERVERS + LIBRARIES + JOBS):
        call_here = CALL_OF_JOBS if name.startswith(JOBS) else CALL
        if name in HEADERS:
            for each in literals(re.sub(r'(?m)^#.*$', "", text)):
                found.setdefault(each, name)
        for call in call_here.finditer(text):
            argument = without_texts(inside(text, call.end()))
            for each in literals(COMPARED.sub("", argument)):
                found.setdefault(each, name)
        if name == LIGHT_KINDS[0]:
            for each in LIGHT_KINDS[1].findall(text):
                found.setdefault(each, name)
    return found


def library_pieces():
    """Sentences of the libraries that are no forms."""
    for name, text in sources(LIBRARIES):
        for call in CALL.finditer(text):
            argument = inside(text, call.end())
            pieces = r'" \+ |\+ "|\bfmt::format\(\s*"[^"]*[A-Za-z]{3}|\bstd::string\("[^"]*[A-Za-z]{3}'
            if call.group() != "say(" and "say(" not in argument and re.search(pieces, argument):
                yield "%s:%d: say it in a form with places" % (name, text.count("\n", 0, call.start()) + 1)


def refused_plainly():
    """Exceptions for people whose text is put together, so that it has no translation."""
    yield from library_pieces()
    for name, text in sources(SERVERS):
        for found in THROW.finditer(text):
            argument = inside(text, found.end())
            line = text.count("\n", 0, found.start()) + 1
            if found.group(2):
                yield "%s:%d: throw an rtcore::Refusal or BadValue" % (name, line)
            elif re.fullmatch(SAYS, found.group(1)):
                bare = re.sub(r"\bsay\(", "(", without_texts(argument))
                put_together = re.search(r"\bfmt::format\(|what\(\)", argument) and "say(" not in argument
                if put_together or (" + " in bare and "say(" not in argument):
                    yield "%s:%d: say it in a form with places: say(\"... {0} ...\", ...)" % (name, line)


def known():
    translations = {}
    if os.path.exists(FILE):
        for message in ET.parse(FILE).getroot().iter("message"):
            other = message.find("translation")
            if other is not None and other.text and other.get("type") is None:
                translations[message.findtext("source")] = other.text
    return translations


def written(all_forms, translations):
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", '<TS version="2.1" language="cs" sourcelanguage="en">',
             "<context>", "    <name>Server</name>"]
    for each in sorted(all_forms):
        other = translations.get(each)
        lines += ["    <message>", "        <source>%s</source>" % escape(each),
                  "        <translation>%s</translation>" % escape(other) if other
                  else '        <translation type="unfinished"></translation>', "    </message>"]
    return "\n".join(lines + ["</context>", "</TS>", ""])


def places(text):
    return sorted(set(re.findall(r"\{\d\}", text)))


def main(arguments):
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    all_forms, translations = forms(), known()
    if arguments == ["--check"]:
        wrong = list(refused_plainly())
        for each, name in sorted(all_forms.items()):
            if each not in translations:
                wrong.append("%s: '%s' has no translation: run scripts/sentences.py, then translate it in %s" % (name, each, FILE))
            elif places(each) != places(translations[each]):
                wrong.append("%s: the translation of '%s' has other places" % (FILE, each))
        wrong += ["%s: nobody says '%s': run scripts/sentences.py" % (FILE, each) for each in sorted(set(translations) - set(all_forms))]
        for each in wrong:
            print(each)
        return 1 if wrong else 0
    if arguments:
        sys.exit(__doc__)
    with open(FILE, "w", encoding="utf-8") as file:
        file.write(written(all_forms, translations))
    print("sentences: %d forms, %d to be translated in %s"
          % (len(all_forms), len(set(all_forms) - set(translations)), FILE))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
