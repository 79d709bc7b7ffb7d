#!/usr/bin/env python3
"""Looks for places of the window that would take text for markup: labels, messages, titles and tool tips that do not go
through view/plain_widgets and models/plain_text. Prints file:line: what to do; exits with 1 if there are any.

  scripts/check_plain_text.py
"""
import os
import re
import subprocess
import sys

HELPER = "apps/gui/view/plain_widgets."
# Code by which Qt takes text for markup, and the remedy.
BANNED = (
    (r"\bnew QLabel\b|\bQLabel\s+\w+\s*[({;,]|\bQLabel\s*\(|\bmake_unique<QLabel>|:\s*public QLabel\b",
     "make a PlainLabel (view/plain_widgets.h)"),
    (r"\bnew QMessageBox\b|\bQMessageBox\s+\w+\s*[({;]|\bQMessageBox::(about|aboutQt|critical|information|question|warning)\s*\(",
     "make it by plainBox() (view/plain_widgets.h)"),
    (r"\bQ(ProgressDialog|ErrorMessage|InputDialog|SplashScreen|WizardPage)\b",
     "it has labels of its own; use a dialog with a PlainLabel"),
    (r"\b(setInformativeText|setDetailedText|setWhatsThis|setMarkdown|insertHtml|appendHtml)\s*\(",
     "it takes text for markup; show it in a PlainLabel"),
    (r"\bQToolTip::showText\b|\bQWhatsThis::showText\b", "set a tool tip by plainTip() (models/plain_text.h)"),
    (r"\bQt::(RichText|MarkdownText|AutoText)\b", "use markupLabel() for markup of our own (view/plain_widgets.h)"),
)
# Files that may set HTML, since they escape each piece of text where they put it in.
ESCAPED = ("apps/gui/dialogs/keys_dialog.cpp",)
HTML = ((r"\bsetHtml\s*\(", "show it in a PlainLabel"),)
ROLE = re.compile(r"\bToolTipRole\b(?![^;]*\bplainTip\s*\()")
TIP = re.compile(r"\b(setToolTip|setWindowTitle)\s*\(")
SAFE_TIP = re.compile(r"^(\s*(\d+|column)\s*,)?\s*((gui::)?(plainTip|optionTip|settingTip|plainTitle)\s*\(|QString\s*\(\s*\)\s*$)")
WORDS = re.compile(r'(\w+::)?tr\s*\(\s*("([^"\\]|\\.)*"\s*)+\)|(QStringLiteral|QLatin1String)\s*\(\s*("([^"\\]|\\.)*"\s*)+\)|QString\s*\(\s*\)')


def argument(text, start):
    """The text between the parenthesis that opens before `start` and the one that closes it."""
    depth, quoted, at = 1, False, start
    while at < len(text) and depth > 0:
        c = text[at]
        if quoted:
            at += c == "\\"
            quoted = c != '"'
        elif c == '"':
            quoted = True
        else:
            depth += (c == "(") - (c == ")")
        at += 1
    return text[start:at - 1]


def isSafeTip(words):
    """Through plainTip(), or nothing but sentences of our own, maybe one of two."""
    if SAFE_TIP.match(words):
        return True
    rest = WORDS.sub("", re.sub(r"^\s*\d+\s*,", "", words))
    rest = re.sub(r"^[^?\"]*\?(?=\s*:\s*$)", "", rest)
    return re.fullmatch(r"[\s+:?]*", rest) is not None


def withoutComments(text):
    """Blanks comments, so that the text keeps its length."""
    return re.sub(r"//[^\n]*", lambda match: " " * len(match.group()), text)


def troubles(name, text):
    """Offset and remedy of each place in the source `text`."""
    text = withoutComments(text)
    for banned, say in BANNED + HTML * (name not in ESCAPED):
        for match in re.finditer(banned, text):
            yield match.start(), "%s: %s" % (match.group().strip(), say)
    for match in TIP.finditer(text):
        if not isSafeTip(argument(text, match.end())):
            yield match.start(), match.group(1) + ": give it plainTip(...), plainTitle(...) (models/plain_text.h)"
    for match in ROLE.finditer(text):
        yield match.start(), "ToolTipRole: give it plainTip(...) (models/plain_text.h)"


# Examples of faults, and of faultless code: a check that finds nothing checks nothing.
WRONG = ("auto* a = new QLabel(name);", "QLabel b(name);", "QLabel member_;", "auto c = std::make_unique<QLabel>(name);",
         "new QMessageBox(QMessageBox::Warning, tr(\"x\"), path);", "QMessageBox::warning(this, tr(\"x\"), path);",
         "w->setToolTip(name);", "w->setToolTip(tr(\"%1\").arg(name));", "item->setToolTip(0, name);",
         "item->setToolTip(0, on ? name : QString());", "item->setData(0, Qt::ToolTipRole, name);",
         "dialog->setWindowTitle(name);", "page->setHtml(name);", "label->setTextFormat(Qt::RichText);", "QProgressDialog wait(name);")
RIGHT = ("auto* a = new PlainLabel(name);", "QLabel* first = form.labelForField(field);", "w->setToolTip(tr(\"x\"));",
         "w->setToolTip(plainTip(name));", "setWindowTitle(plainTitle(name));", "item->setToolTip(0, on ? tr(\"x\") : QString());", "w->setToolTip(optionTip(row));")


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    deaf = [line for line in WRONG if not any(troubles("", line))] + [line for line in RIGHT if any(troubles("", line))]
    for line in deaf:
        print("check_plain_text: wrong about its own example: " + line, file=sys.stderr)
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "apps/gui"], check=True,
                           capture_output=True, text=True).stdout
    found = len(deaf)
    for name in sorted(names.split("\0")):
        if not name.endswith((".cpp", ".h")) or name.startswith(HELPER) or not os.path.isfile(name):
            continue
        with open(name, encoding="utf-8") as file:
            text = file.read()
        for at, what in troubles(name, text):
            print("%s:%d: %s" % (name, text.count("\n", 0, at) + 1, what), file=sys.stderr)
            found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
