"""Shows models of other people by the Renderer and by an independent program, from the same side, and compares masks
and base colours. Run by hand; docs/import.md, "Beside other programs", says what was found.

Each model that both read is seen along one oblique direction, without perspective, framed by its bounds. The bounds
also tell how the other program turned and scaled it. Results are kept in OUTPUT/table.csv, a line for each model, so
that a run that was stopped goes on; images of both and of where they differ in OUTPUT/NAME.png: ours, theirs, and the
masks (white: both, red: ours alone, blue: theirs alone).
"""
import argparse
import csv
import os
import shutil
import sys

sys.dont_write_bytecode = True

import numpy  # noqa: E402

import ours as our_programs  # noqa: E402
import programs  # noqa: E402
import theirs as their_programs  # noqa: E402

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "tools"))
import pictures  # noqa: E402

ALIKE = 0.97         # intersection over union of the masks
NEAR = 0.02          # median over the pixels of both of the largest difference of a channel, of linear base colours
COLUMNS = ("model", "program", "verdict", "iou", "colour", "colour95", "triangles", "theirTriangles", "parts",
           "theirParts", "opacity", "bounds", "turn", "scale", "reason")
VERDICTS = ("models", "same", "mask", "colour", "opacity", "ours", "theirs", "both")
AXES = "xyz"


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, epilog=(
        "verdicts: same; mask, colour, opacity (constants of materials): these differ; ours, theirs, both: that "
        "program does not read it."))
    parser.add_argument("models", help="folder of models, searched through")
    parser.add_argument("output", help="folder for the table and the images")
    parser.add_argument("--only", action="append", default=[], metavar="WORD", help="models whose path holds this")
    parser.add_argument("--again", action="store_true", help="compare those that are in the table, too")
    parser.add_argument("--side", type=int, default=256, metavar="N", help="pixels along each side [256]")
    parser.add_argument("--programs", default="", metavar="FOLDER", help="of Renderer and rtimport [those in PATH]")
    parser.add_argument("--blender", default="blender", metavar="FILE", help="Blender 3.4")
    parser.add_argument("--f3d", default="f3d", metavar="FILE",
                        help="f3d 1.3, for 3DS; without it these are left out")
    parser.add_argument("--osgconv", default="osgconv", metavar="FILE",
                        help="of OpenSceneGraph 3.6, for further ones; without it these are left out")
    return parser.parse_args()


def names_in(folder, endings):
    for path, folders, files in os.walk(folder):
        folders.sort()
        for file in sorted(files):
            if os.path.splitext(file)[1].lower() in endings:
                yield os.path.relpath(os.path.join(path, file), folder)


def shrunk(mask):
    """Without the pixels at its edge, whose colours are of one surface here and of another one there."""
    result = mask.copy()
    for axis in (0, 1):
        for step in (1, -1):
            result &= numpy.roll(mask, step, axis)
    return result


def apart(albedo, emitted, colours):
    """The largest difference of a channel. What is black and emits may be unlit: then that is its base colour."""
    difference, unlit = (abs(its - colours).max(axis=2) for its in (albedo, emitted))
    return numpy.where(albedo.max(axis=2) > 0, difference, numpy.minimum(difference, unlit))


def compare(mine, their_mask, their_colours, coloured):
    mask, albedo, emitted = mine
    both = (mask | their_mask).sum()
    found = {"iou": (mask & their_mask).sum() / both if both else 1.0}
    inside = shrunk(mask & coloured)
    if inside.sum() > 50:
        differences = apart(albedo, emitted, their_colours)[inside]
        found["colour"], found["colour95"] = numpy.median(differences), numpy.quantile(differences, 0.95)
    wrong = [name for name, bad in (("mask", found["iou"] < ALIKE), ("colour", found.get("colour", 0) > NEAR)) if bad]
    return found, "+".join(wrong) or "same"


def opacities(mine, other):
    """The materials of which both say how much light does not pass, and say another number."""
    return ", ".join("%s: %.2f, theirs %.2f" % (name, mine[name], other[name]) for name in sorted(mine)
                     if name in other and abs(mine[name] - other[name]) > NEAR)


def picture(path, mine, their_mask, their_colours, coloured):
    mask, albedo, emitted = mine
    our_colours = numpy.where(albedo.max(axis=2)[..., None] > 0, albedo, emitted)
    panes = []
    for its, covered in ((our_colours, mask), (numpy.where(coloured[..., None], their_colours, 0.5), their_mask)):
        shown = numpy.clip(its, 0, 1) ** (1 / 2.2)
        panes.append(numpy.where(covered[..., None], shown, (0.15, 0.2, 0.3)))
    both = (mask & their_mask)[..., None] * numpy.ones(3)
    panes.append(both + (mask & ~their_mask)[..., None] * numpy.array((1, 0, 0))
                 + (their_mask & ~mask)[..., None] * numpy.array((0.2, 0.4, 1)))
    rows = (255 * numpy.concatenate(panes, axis=1) + 0.5).astype(numpy.uint8)
    pictures.write_png(path, rows.shape[1], rows.shape[0], [row.tobytes() for row in rows])


def turn_name(turn):
    return " ".join("-+"[sign > 0] + AXES[axis] for axis, sign in turn)


def judge(model, stem, mine, other, side):
    """A line of the table."""
    line, reasons = {"program": other.name}, {}
    try:
        bounds = mine.bounds(model, stem)
    except programs.Failed as failed:
        bounds, reasons["ours"] = None, str(failed)
    # Whether the other program reads what ours does not is worth knowing, too.
    guess = bounds or {"low": [-1, -1, -1], "high": [1, 1, 1], "zero": [0, 0, 0]}
    try:
        answer, *image = other.render(model, stem, guess, side)
    except (programs.Failed, OSError, ValueError) as failed:
        reasons["theirs"] = str(failed)
    if not reasons:
        try:
            image_of_ours = mine.render(stem, answer["view"], side)
        except programs.Failed as failed:
            reasons["ours"] = str(failed)
    if reasons:
        line["verdict"] = "both" if len(reasons) == 2 else next(iter(reasons))
        line["reason"] = " | ".join(reasons.values())
        return line
    found, line["verdict"] = compare(image_of_ours, *image)
    picture(stem + ".png", image_of_ours, *image)
    line.update({name: "%.4f" % value for name, value in found.items()})
    line["opacity"] = opacities(bounds["opacities"], answer.get("opacities", {}))
    if line["opacity"]:
        line["verdict"] = "opacity" if line["verdict"] == "same" else line["verdict"] + "+opacity"
    line.update(triangles=bounds["triangles"], parts=bounds["parts"], theirTriangles=answer["triangles"] or "",
                theirParts=answer["parts"] or "", bounds="%.4f" % answer["apart"], scale="%.6g" % answer["scale"],
                turn="usual" if answer["usual"] else turn_name(answer["turn"]))
    return line


def read_table(path):
    if not os.path.exists(path):
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        return {line["model"]: line for line in csv.DictReader(file)}


def write_table(path, lines):
    with open(path + ".new", "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(lines[name] for name in sorted(lines))
    os.replace(path + ".new", path)


def report(lines):
    """How many of each format came to which verdict."""
    counts = {}
    for name, line in lines.items():
        ending = os.path.splitext(name)[1].lower()
        of_ending = counts.setdefault(ending, dict.fromkeys(VERDICTS, 0))
        of_ending["models"] += 1
        for verdict in line["verdict"].split("+"):
            of_ending[verdict] += 1
    print("%-8s %s" % ("format", " ".join("%7s" % verdict for verdict in VERDICTS)))
    for ending in sorted(counts):
        print("%-8s %s" % (ending, " ".join("%7d" % counts[ending][verdict] for verdict in VERDICTS)))


def main():
    chosen = options()
    mine = our_programs.Ours(*(os.path.join(chosen.programs, name) for name in ("rtimport", "Renderer")))
    blender = their_programs.Blender(chosen.blender)
    others = [blender, their_programs.F3d(chosen.f3d), their_programs.OpenSceneGraph(chosen.osgconv, blender)]
    if not shutil.which(blender.program):
        raise SystemExit("%s: there is no such program (scripts/setup.sh --peers)" % blender.program)
    others = [other for other in others if shutil.which(other.program)]
    os.makedirs(chosen.output, exist_ok=True)
    table = os.path.join(chosen.output, "table.csv")
    lines = read_table(table)
    for name in names_in(chosen.models, set().union(*(other.endings for other in others))):
        if (name in lines and not chosen.again) or not all(word in name for word in chosen.only):
            continue
        other = next(other for other in others if os.path.splitext(name)[1].lower() in other.endings)
        stem = os.path.join(os.path.abspath(chosen.output), name.replace(os.sep, "__"))
        model = os.path.abspath(os.path.join(chosen.models, name))
        line = lines[name] = {"model": name, **judge(model, stem, mine, other, chosen.side)}
        told = [line.get(column, "") for column in ("verdict", "iou", "colour", "model", "reason")]
        print("%-11s %6s %6s  %s  %s" % tuple(told), flush=True)
        write_table(table, lines)
    report(lines)


if __name__ == "__main__":
    main()
