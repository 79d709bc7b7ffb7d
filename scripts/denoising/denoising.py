#!/usr/bin/env python3
"""How good denoising is, by the Renderer itself. docs/lab/denoising.md has what was found. Needs numpy.

    denoising.py table|error|flicker|time|rest [OPTION]... [SCENE]...

table: relMSE, PSNR and FLIP beside the image without denoising; error: the estimated error beside the true one;
flicker: the deviation between seeds; time: seconds to a relMSE of 0.01 beside Cycles (Debian package blender); rest:
what the window shows at rest by seconds.
"""
import argparse
import os
import shutil

import paths  # noqa: F401 (where the others find theirs)

import duration
import error_bar
import flicker
import programs
import rest
import table
from rendering import KINDS, PART, Renderer
from views import VIEWS, Views

MODES = {"table": (table, (1, 4, 16, 64), tuple(KINDS), tuple(VIEWS)),
         "error": (error_bar, (16, 64, 256), ("base",), tuple(VIEWS)[:7]),
         "flicker": (flicker, (16, 64), ("base", "large"), ("sponza", "sibenik", "lamborghini")),
         "time": (duration, (), ("base", "large"), duration.SCENES),
         "rest": (rest, (), (), ("nave", "sponza", "sibenik", "room", "mirrors"))}


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mode", choices=MODES)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="of: %s; for time: %s" % (
        " ".join(VIEWS), " ".join(duration.SCENES)))
    parser.add_argument("-o", "--output", default=os.path.join(paths.PROJECT, "output", "denoising"),
                        help="folder in which images are kept, so that a second run is quick [output/denoising]")
    parser.add_argument("--samples", type=_numbers, help="per pixel, with commas between")
    parser.add_argument("--kinds", help="of: %s" % ",".join(KINDS))
    parser.add_argument("--reference", type=int, default=2 * PART, help="samples of each of the two references [%(default)s]")
    parser.add_argument("--cycles-reference", type=int, default=128, help="the same of those by Cycles [%(default)s]")
    parser.add_argument("--size", type=_size, default=(320, 180), help="[320x180]")
    parser.add_argument("--models", default=os.environ.get("RT_TEST_SCENES", ""), help="folder of models [$RT_TEST_SCENES]")
    parser.add_argument("--cameras", default="", help=".cam files of a walk through the scenes, with commas between, in "
                        "place of their own views; not for time")
    parser.add_argument("--renderer", default=os.path.join(paths.PROJECT, "build", "release", "bin", "Renderer"))
    parser.add_argument("--blender", default="blender")
    return parser.parse_intermixed_args()


def _numbers(text):
    return tuple(int(word) for word in text.split(","))


def _size(text):
    width, height = map(int, text.split("x"))
    return width, height


class Setting:
    def __init__(self, words):
        _, samples, kinds, _ = MODES[words.mode]
        self.samples = words.samples or samples
        self.kinds = tuple(words.kinds.split(",")) if words.kinds else kinds
        self.reference, self.cycles_reference = words.reference, words.cycles_reference
        self.size, self.models = words.size, words.models
        self.folder, self.blender = words.output, shutil.which(words.blender)
        self.renderer = Renderer(words.renderer, words.output, words.size)
        self.cameras = [file for file in words.cameras.split(",") if file]


def found(names, setting):
    views = Views(setting.models, setting.folder)
    for name in names:
        view = views.find(name)
        if view is None:
            print("%-14s skipped: its model is not there" % name)
        elif not setting.cameras:
            yield name, view
        for file in setting.cameras if view else ():
            stem = os.path.splitext(os.path.basename(file))[0]
            yield "%s-%s" % (name, stem), [word for word in view if not word.startswith("--camera=")] + [
                "--camera=" + file]


def main():
    words = options()
    mode, _, _, names = MODES[words.mode]
    if not os.path.isfile(words.renderer):
        raise SystemExit("%s: there is no such program; scripts/build.sh builds the Renderer" % words.renderer)
    setting, names = Setting(words), words.scenes or names
    try:
        mode.run(setting, names if mode is duration else found(names, setting))
    except (programs.Failed, KeyError) as error:
        raise SystemExit("denoising: %s" % error)


if __name__ == "__main__":
    main()
