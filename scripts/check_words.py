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
SOURCES = r"\.(cpp|h|js)$"
COMMENTED = r"(\.(cpp|h|js|py|sh|cmake)|CMakeLists\.txt)$"
# Sources in which no word has another sense; the window and the bridge share and draw what is not sampled.
MEASURED = r"^(libs|apps/(common|renderer|rtserver)|tests/(unit|support|bench|trees|walks|oracle|image))/.*\.(cpp|h)$"
SAMPLED = r"^(libs/rtcore|tests/unit)/(lights|pathtracing|sampling|scattering|shading)/.*\.(cpp|h)$"
POINTS = r"^(libs/rtcore|tests/unit)/(lights|live|look|pathtracing|sampling|scattering)/.*\.(cpp|h)$"
LIVE = r"^(libs/rtcore|tests/unit)/live/.*\.(cpp|h)$"

# Banned words, their replacements, and the files in which they are banned.
BANNED = (
    (r"\b[Ll]amps?\b", "light, area light", ALL),
    (r"\b[a-z]*Lamp[A-Z]\w*|\b\w*Lamps?\b|\blamp[A-Z]\w*", "Light, AreaLight", CODE),
    (r"\b[Gg]low(s|ing)?\b|\b\w+Glow\b|\bglow_", "emission (surfaces), bloom (lens)", ALL),
    (r"\b[Ll]ight from everywhere\b|\b\w*FromEverywhere\b", "ambient light", ALL),
    (r"\b[Gg]rain(y|s)?\b|\bgrain_", "noise", ALL),
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
    (r"\bk(Most|Least)(?=[A-Z]|\b)\w*", "kMax..., kMin...", ALL),
    (r"\b(Light|Emitter|Environment|Direction|Interval)Draws?\b|\bdraw(Light|Emitter|Environment|Density|Index)\b",
     "LightDirectionSample, EmitterSample, EnvironmentSampler, sample...", ALL),
    (r"\b(LightShares|probabilityOfShare|LightFinding)\b", "selection, selectionProbability, SamplingStrategy", ALL),
    (r"\b(SamplePicture|PixelChoice)\b", "Reconstruction, PixelSelector", ALL),
    (r"\b(stoodFor|guessUpAndUnit|[Ss]eenPlaces?)\b|\brtcore::UpAndUnit\b",
     "hasProxyLight, ModelUnits, VisiblePoint", ALL),
    (r"\b(Light|Request|rtcore::|rtserver::)Surroundings\b", "LightingOptions, RequestContext, SceneExtent, services", ALL),
    # Questions may.
    (r"^\s*(///?|#|/\*\*|\*) (What|Of) (?!.*\?\s*(\*/)?$)", "in a comment what the thing is, by its noun", COMMENTED),
    (r"\b(LookLights|lookNamed|kLookNames)\b|\brtcore::Look\b", "LightingPreset, PresetLighting", ALL),
)

# The same for names alone: words that are plain English in comments, strings and pages.
NAMES = (
    # The least welcome connection and whether most parts are hidden are no bounds.
    (r"\b(most|least)_?\b|\b(most|least)(?!Welcome\b|Hidden\b)[A-Z]\w*|\b(MOST|LEAST)(_[A-Z]\w*)?\b",
     "max, min", SOURCES),
    (r"(?<!bloom\.)(?<!Bloom::)\bk?[sS]hares?_?\b(?! = 0\.15F)|\b[a-z]\w*Shares?\b",
     "weight, throughput, fraction, probability, selection", MEASURED),
    (r"\b[a-zA-Z]*[dD]raw(s|n|ing)?_?\b|\bdraw(s|n)?[A-Z]\w*", "sample, sampler, random number", SAMPLED),
    (r"\b([a-zA-Z]*[a-z])?([wW]ay|[pP]lace)s?_?(?<!\baway)(?<![Aa]lways)(?<!InTheWay)\b",
     "direction, offset, position, point, index", POINTS),
    (r"\b[a-zA-Z]*[uU]rgen(t|cy|cies)\w*", "priority, selected", LIVE),
    (r"\b(own|mirrored)\b", "surface, specular (layer)", LIVE),
    (r"\b(carry|carryTo|relight|follows|wanders|kWanders|keepParts)\b",
     "reproject, invalidate, canReuse, unreliable, seedParts", LIVE),
)
CODE_ALONE = {
    ".js": re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`", re.S),
    ".cpp": re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<end>[^()\\\s]{0,16})\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"|'
                       r"(?<![0-9a-fA-F\w])'(?:\\.|[^'\\\n])*'|^[ \t]*#[^\n]*", re.S | re.M),
}
CODE_ALONE[".h"] = CODE_ALONE[".cpp"]

# Data, records of decisions, foreign files, and the places where a former name must stand.
EXCEPT = re.compile(
    r"^(data|docs/decisions|docs/images|tests/image/scenes|tests/unit/(bsp|import))/|"
    r"^(docs/style\.md|scripts/check_words\.py|packaging/changelog)$")
FORMER = re.compile(r'formerly|former name|stillGlow"|keptModels"|"--(layers|built-model)|"(lampSamples|bloomShare)\b|name = .?"lamp|"lamp & co"|lamps\.jpg|user nobody')


def compiled(rules):
    return [(re.compile(banned), say, re.compile(where)) for banned, say, where in rules]


def found(name, text, rules):
    """How many banned words are in the text; tells each. Lines keep their numbers."""
    count = 0
    rules = [(banned, say) for banned, say in rules if banned.search(text)]
    for number, line in enumerate(text.split("\n") if rules else [], 1):
        if FORMER.search(line):
            continue
        for banned, say in rules:
            for match in banned.finditer(line):
                print("%s:%d: %s: say %s" % (name, number, match.group(), say), file=sys.stderr)
                count += 1
    return count


def codeOf(name, text):
    """Code without comments, strings and directives, line by line."""
    pattern = CODE_ALONE.get(os.path.splitext(name)[1])
    return pattern.sub(lambda match: re.sub(r"[^\n]+", " ", match.group()), text) if pattern else ""


def main():
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    names = subprocess.run(["git", "ls-files", "-z"], check=True, capture_output=True, text=True).stdout.split("\0")
    words, identifiers = compiled(BANNED), compiled(NAMES)
    count = 0
    for name in names:
        mine = [(banned, say) for banned, say, where in words if where.search(name)]
        named = [(banned, say) for banned, say, where in identifiers if where.search(name)]
        if not (mine or named) or EXCEPT.search(name) or not os.path.isfile(name):
            continue
        with open(name, encoding="utf-8", errors="replace", newline="\n") as file:
            text = file.read()
        count += found(name, text, mine)
        if named:
            count += found(name, codeOf(name, text), named)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
