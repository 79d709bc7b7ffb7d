"""The image at rest as the window asks for it: FLIP of what is shown so many seconds after the request, and from one
image to the next.

Seconds are those of an image of 512 x 310: processor time over two threads, so that a busy machine does not matter, times
what the pixels are fewer. What runs on one thread alone counts half. The references are developed by the exposure of the
last image. Sheets: what was sampled for the image at each time, what is shown, and the reference.
"""
import os

import display
import images
import numpy
from flip import flip
from preview import Preview
from rendering import RAW

TIMES = (0.3, 1, 3, 10, 30)
THREADS = 2
PIXELS = 512 * 310
SHEET_SAMPLES = 16
WINDOW = ("--integrator=path", "--setting=exposure.recorded=automatic", "--setting=path.filter=4",
          "--setting=denoise.net=automatic")  # as the window's own, apps/gui/models/still_quality.cpp
CURVE = ("--setting=toneMapping=luminance",)  # that of display.py; models without settings have another
WORSE = 0.001  # that one image may be than the one before


def camera_of(view):
    return next((word.partition("=")[2] for word in view if word.startswith("--camera=")), "")


def shown_frames(setting, view):
    command = [setting.renderer.program, *view, *WINDOW, *CURVE, "-w", str(setting.size[0]), "-h", str(setting.size[1])]
    with Preview(command, "rest%d" % os.getpid(), THREADS) as preview:
        scale = PIXELS / (setting.size[0] * setting.size[1])
        return [frame._replace(seconds=frame.seconds * scale)
                for frame in preview.frames(view[0], camera_of(view), TIMES[-1] / scale)]


def at_times(frames):
    """The index of the frame that stands at each time, None while there is none; the last one stays."""
    for time in TIMES:
        before = [i for i, frame in enumerate(frames) if frame.seconds <= time]
        yield before[-1] if before else None


def measure(setting, name, view):
    reference = setting.renderer.reference(name, view, setting.reference)
    frames = shown_frames(setting, view)
    truth = display.shown(reference.mean, frames[-1].exposure)
    errors = [flip(frame.codes / 255, truth) for frame in frames]
    for frame, error, before in zip(frames, errors, [errors[0], *errors]):
        print("%-14s %6.2f s (%6.2f s by the clock), %3d samples: FLIP %.4f, %+.4f%s" % (
            name, frame.seconds, frame.wall, frame.samples, error, error - before,
            " WORSE" if error - before > WORSE else ""), flush=True)
    row = ["none" if i is None else "%.4f at %d" % (errors[i], frames[i].samples) for i in at_times(frames)]
    print("| %s | %s |" % (name, " | ".join(row)), flush=True)
    _write_sheet(setting, name, view, frames, truth)


def _write_sheet(setting, name, view, frames, truth):
    """A row for each time that has an image of its own."""
    shown = {frames[i].samples: frames[i] for i in at_times(frames) if i is not None}
    rows = [numpy.concatenate((_raw(setting, name, view, samples, frames[-1].exposure), frame.codes / 255, truth), axis=1)
            for samples, frame in shown.items()]
    images.write_shown(os.path.join(setting.folder, name + "-rest.png"), numpy.concatenate(rows))


def _raw(setting, name, view, samples, exposure):
    """What was sampled for it: black where pixels share samples, and where it takes long."""
    if not 0 < samples <= SHEET_SAMPLES:
        return numpy.zeros((*setting.size[::-1], 3))
    output = os.path.join(setting.folder, "%s-rest-raw-%d.pfm" % (name, samples))
    if not images.exists(output):
        setting.renderer.render(view, output, samples, 0, RAW)
    return display.shown(images.read_pfm(output), exposure)


def run(setting, views):
    for name, view in views:
        measure(setting, name, view)
