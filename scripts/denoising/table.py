"""Error by samples and kind of denoising: relMSE by two references, without the worst 0.1 % of the pixels and with them,
PSNR and FLIP; and how many times the samples an image without denoising needs for the same error."""
import math

import display
from flip import flip
from rendering import KINDS, sampled

TIMES_AT = (4, 16)  # samples at which it is told how many times fewer they are


def measure(setting, name, view):
    reference = setting.renderer.reference(name, view, setting.reference)
    half = display.exposure(reference.mean)
    truth = display.shown(reference.mean, half)

    def errors(image):
        shown = display.shown(image, half)
        return (*reference.rel_mse(image), display.psnr(shown, truth), flip(shown, truth))

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
    trimmed, whole, ratio, difference = found[kind, samples]
    print("%-14s %4d %-7s relMSE %9.3g, with worst %9.3g   PSNR %5.2f   FLIP %.4f" % (
        name, samples, kind, trimmed, whole, ratio, difference), flush=True)


def times_fewer_by_flip(found, kind, samples, all_samples):
    """By straight lines of raw FLIP over the logarithm of samples; beyond the last the ratio is only known to be more."""
    wanted = found[kind, samples][3]
    for few, many in zip(all_samples, all_samples[1:]):
        high, low = found["raw", few][3], found["raw", many][3]
        if few >= samples and high >= wanted >= low:
            share = (high - wanted) / max(high - low, 1e-12)
            return "%.2g" % (math.exp(math.log(few) + share * math.log(many / few)) / samples)
    return "< 1" if wanted > found["raw", samples][3] else "> %d" % (all_samples[-1] // samples)


def rows(results, setting):
    """As Markdown: each cell relMSE and FLIP; then PSNR, relMSE with the worst pixels, and times fewer samples."""
    kinds = ("raw", *setting.kinds)
    yield "| relMSE, FLIP | %s |" % " | ".join(kinds)
    for name, found in results.items():
        for samples in setting.samples:
            yield "| %s, %d | %s |" % (name, samples, " | ".join(
                "%s, %s" % (_short(found[k, samples][0]), _short(found[k, samples][3], 3)) for k in kinds))
    yield "\n| PSNR; relMSE with the worst 0.1 %% | %s |" % " | ".join(kinds)
    for name, found in results.items():
        for samples in setting.samples:
            yield "| %s, %d | %s |" % (name, samples, " | ".join(
                "%.1f; %s" % (found[k, samples][2], _short(found[k, samples][1])) for k in kinds))
    yield "\n| times fewer samples by relMSE (by FLIP) | %s |" % " | ".join(
        "%s, %d" % (kind, n) for kind in setting.kinds for n in TIMES_AT if n in setting.samples)
    for name, found in results.items():
        yield "| %s | %s |" % (name, " | ".join(
            "%.2g (%s)" % (found["raw", n][0] / found[kind, n][0], times_fewer_by_flip(found, kind, n, setting.samples))
            for kind in setting.kinds for n in TIMES_AT if n in setting.samples))


def _short(value, digits=4):
    """Two or three digits that count, without a leading zero."""
    text = ("%.*f" % (digits, value) if abs(value) < 0.1 else "%.3g" % value)
    return text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text


def run(setting, views):
    results = {name: measure(setting, name, view) for name, view in views}
    print()
    print("\n".join(rows(results, setting)))
