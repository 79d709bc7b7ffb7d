"""Error by samples and kind of denoising: relMSE by two references, PSNR and FLIP; and how many times the samples an image
without denoising needs for the same error.

relMSE is without the 0.1 % of the pixels that are the worst of the references; with them; and without the image's own
worst ones: what paths found by rare chance lies in pixels of its own in each image.
"""
import math
from collections import namedtuple

import display
from flip import flip
from rendering import KINDS, sampled

TIMES_AT = (4, 16)  # samples at which it is told how many times fewer they are
Errors = namedtuple("Errors", "trimmed whole own psnr flip")


def measure(setting, name, view):
    reference = setting.renderer.reference(name, view, setting.reference)
    half = display.exposure(reference.mean)
    truth = display.shown(reference.mean, half)

    def errors(image):
        shown = display.shown(image, half)
        return Errors(*reference.rel_mse(image), display.psnr(shown, truth), flip(shown, truth))

    found = {}
    for samples in setting.samples:
        for kind in setting.kinds:
            exr = setting.renderer.image(name, view, samples, kind)
            if ("raw", samples) not in found:
                found["raw", samples] = errors(sampled(exr))
                _tell(name, "raw", samples, found)
            found[kind, samples] = errors(exr.colours())
            _tell(name, kind, samples, found)
    return found


def _tell(name, kind, samples, found):
    print("%-14s %4d %-7s relMSE %9.3g, with worst %9.3g, without own %9.3g   PSNR %5.2f   FLIP %.4f" % (
        name, samples, kind, *found[kind, samples]), flush=True)


def times_fewer_by_flip(found, kind, samples, all_samples):
    """By straight lines of raw FLIP over the logarithm of samples; beyond the last the ratio is only known to be more."""
    wanted = found[kind, samples].flip
    for few, many in zip(all_samples, all_samples[1:]):
        high, low = found["raw", few].flip, found["raw", many].flip
        if few >= samples and high >= wanted >= low:
            share = (high - wanted) / max(high - low, 1e-12)
            return "%.2g" % (math.exp(math.log(few) + share * math.log(many / few)) / samples)
    return "< 1" if wanted > found["raw", samples].flip else "> %d" % (all_samples[-1] // samples)


def rows(results, setting):
    """As Markdown."""
    kinds, times = ("raw", *setting.kinds), [n for n in TIMES_AT if n in setting.samples]

    def table(title, cell):
        yield "\n| %s | %s |" % (title, " | ".join(kinds))
        for name, found in results.items():
            for samples in setting.samples:
                yield "| %s, %d | %s |" % (name, samples, " | ".join(cell(found[k, samples]) for k in kinds))

    yield from table("relMSE, FLIP", lambda e: "%s, %s" % (_short(e.trimmed), _short(e.flip, 3)))
    yield from table("relMSE with the worst, without the own worst; PSNR",
                     lambda e: "%s, %s; %.1f" % (_short(e.whole), _short(e.own), e.psnr))
    yield "\n| times fewer samples by relMSE; without the own worst; by FLIP | %s |" % " | ".join(
        "%s, %d" % (kind, n) for kind in setting.kinds for n in times)
    for name, found in results.items():
        yield "| %s | %s |" % (name, " | ".join(
            "%.2g; %.2g; %s" % (found["raw", n].trimmed / found[kind, n].trimmed, found["raw", n].own / found[kind, n].own,
                                times_fewer_by_flip(found, kind, n, setting.samples))
            for kind in setting.kinds for n in times))


def _short(value, digits=4):
    """Two or three digits that count, without a leading zero."""
    text = ("%.*f" % (digits, value) if abs(value) < 0.1 else "%.3g" % value)
    return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text


def run(setting, views):
    results = {name: measure(setting, name, view) for name, view in views}
    print()
    print("\n".join(rows(results, setting)))
