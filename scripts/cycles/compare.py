"""Renders scenes by the Renderer and by Cycles and compares them, for scripts/compare-cycles.sh.

    compare.py FOLDER WIDTH HEIGHT SAMPLES LIMIT RENDERER BLENDER MODELS NAME...
"""
import os
import sys

import images
import programs
import scenes
import write_scene

PLANE_SAMPLES = 64
PLANE_LIMIT = 0.5


def main():
    folder, width, height, samples, limit, renderer, blender, models = sys.argv[1:9]
    size, samples, limit = (int(width), int(height)), int(samples), float(limit)
    ours, theirs = programs.Ours(renderer), programs.Theirs(blender)
    print("%s; %d x %d; in %% of the mean" % (theirs.version, *size))
    print("%-18s %7s %9s %9s %8s %6s %8s %8s %9s %9s %7s %7s" % (
        "scene", "samples", "ours", "Cycles", "bias", "+-", "blocks", "noise", "relMSE", "and worst", "ours, s", "Cycles"))
    wrong = []
    for name in sys.argv[9:]:
        scene = scenes.find(name, models, folder)
        if scene is None:
            print("%-18s skipped: its model is not there" % name)
            continue
        path = os.path.join(folder, name)
        checksum = write_scene.write(scene, path)
        plain = name.startswith("plane-")
        count = min(samples, PLANE_SAMPLES) if plain else samples
        try:
            first, seconds = programs.cached(ours, path, checksum, count, size, count)
            second, their_seconds = programs.cached(theirs, path, checksum, count, size, count)
        except programs.Failed as error:
            print("%-18s %s" % (name, error))
            wrong.append(name)
            continue
        one, two = images.read_pfm(first), images.read_pfm(second)
        found = images.differences(one, two)
        print("%-18s %7d %9.5f %9.5f %+8.3f %6.3f %8.3f %8.3f %9.2e %9.2e %7.1f %7.1f" % (
            name, count, found["ours"], found["theirs"], found["bias"], found["sure"], found["blocks"], found["noise"],
            found["relMSE"], found["relMSE with worst"], seconds, their_seconds), flush=True)
        images.write_beside(path + ".png", one, two)
        # Noise alone may move the mean by some standard errors.
        if abs(found["bias"]) > (min(limit, PLANE_LIMIT) if plain else limit) + 3 * found["sure"]:
            wrong.append(name)
    if wrong:
        raise SystemExit("differ by more than %g %%, or failed: %s" % (limit, " ".join(wrong)))


if __name__ == "__main__":
    main()
