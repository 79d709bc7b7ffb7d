#!/usr/bin/env python3
"""Looks for words that docs/style.md replaces by others. Prints file:line: word: say ...; exits with 1 if there are any.

  scripts/check_words.py
"""
import os
import re
import subprocess
import sys

CODE = r"\.(cpp|h)$"
DOCS = r"\.(md|ts)$"
ALL = r"\.(cpp|h|md|ts|txt|cmake|in|desktop|xml)$"
LIGHT = r"^(libs/rtcore/(shading|surface|light|lights|fog|render|post)|apps)/.*\.(cpp|h)$"

# What is banned, what to say, and in which files.
BANNED = (
    (r"\b[Ll]amps?\b", "light, area light", ALL),
    (r"\b[a-z]*Lamp[A-Z]\w*|\b\w*Lamps?\b|\blamp[A-Z]\w*", "Light, AreaLight", CODE),
    (r"\b[Gg]low(s|ing)?\b|\b\w+Glow\b|\bglow_", "emission (surfaces), bloom (lens)", ALL),
    (r"\b[Ll]ight from everywhere\b|\b\w*FromEverywhere\b", "ambient light", ALL),
    (r"\b[Gg]rain(y|s)?\b|\bgrain_", "noise", ALL),
    (r"(?<!bloom)\.share\b(?!\()|\bshare_\b", "weight, throughput, fraction", LIGHT),
    (r"\b[Ff]irst_?[Hh]its?\b|\bFirstHits?\w*", "primary hit", ALL),
    (r"\b[Oo]nward\b|\bkOnward\b", "secondary, specular", ALL),
    (r"\bFrameLayers\b|\bLayerPixel\b|--layers\b|\bcollectLayers\b", "AOV, --aovs", ALL),
    (r"\bSampleChoice\b|\b\w*LampDraw\b|\bDraw::", "AdaptiveSampler, AreaLightSampler, SampleDimension", CODE),
    (r"\benlarge[ds]?\b(?! by `)", "upsample", ALL),
    (r"\b[Kk]ept models?\b|\bkeptModels\b|--built-model\b", "model cache, cached model", ALL),
    (r"\b[Hh]and-?over\b|\bHandOver\w*", "exchange", ALL),
    (r"\bforsaken\b|\btellStatus\b|\banswerWho\w+", "orphaned, publishStatus, answer...Waiters", CODE),
    (r"\bFedProcess\b|\brunAttached\b|\bRawList\b|\busableRadiance\b|\bDesk\b",
     "PipedProcess, runForeground, UninitializedArray, sanitizeRadiance, GuiContext", CODE),
    (r"(?<![\w/.\-`])[Pp]ictures?(?![\w/.`]\w|[\w/`])", "image; frame when it is live", DOCS),
    (r"\b(frames|rays|samples?) a (second|pixel|point)\b", "per ...", ALL),
    (r"\b[Pp]resent view\b", "current view", ALL),
    (r"\b([Ss]omebody|[Nn]obody|[Ww]hoever)\b|\b(by|for|of|to) who\b", "the client, the walker, the process ...",
     r"^(libs|apps|docs|README).*\.(cpp|h|md|ts)$"),
)

# Data, records of decisions, foreign files, and the places where a former name must stand.
EXCEPT = re.compile(
    r"^(data|docs/decisions|docs/images|tests/image/scenes|tests/unit/(bsp|import))/|"
    r"^(docs/style\.md|scripts/check_words\.py|packaging/changelog)$")
FORMER = re.compile(r'formerly|former name|stillGlow"|keptModels"|"--(layers|built-model)|"(lampSamples|bloomShare)\b|name = .?"lamp|"lamp & co"|lamps\.jpg|user nobody')


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    names = subprocess.run(["git", "ls-files", "-z"], check=True, capture_output=True, text=True).stdout.split("\0")
    rules = [(re.compile(banned), say, re.compile(where)) for banned, say, where in BANNED]
    found = 0
    for name in names:
        mine = [(banned, say) for banned, say, where in rules if where.search(name)]
        if not mine or EXCEPT.search(name) or not os.path.isfile(name):
            continue
        with open(name, encoding="utf-8", errors="replace") as lines:
            for number, line in enumerate(lines, 1):
                if FORMER.search(line):
                    continue
                for banned, say in mine:
                    for match in banned.finditer(line):
                        print("%s:%d: %s: say %s" % (name, number, match.group(), say), file=sys.stderr)
                        found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
