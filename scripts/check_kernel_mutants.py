#!/usr/bin/env python3
"""Breaks the kernels, one rule (a widening, a bound or a condition) at a time, and looks whether their tests notice.
Builds in a copy of the sources. A mutant that survives is an error: a rule that no test guards; so is one whose rule does
not stand in the sources any more.
  scripts/check_kernel_mutants.py [part of a name...]     without: all; with --list: their names;
                                                          with --check: only whether each rule stands in the sources"""
import os
import sys

import mutants

KERNELS = "libs/rtcore/kernels/"
PROGRAMS = [["test_kernels"], ["test_leaks"]]
# The broken rule; then the file, the text that stands there, and its replacement.
MUTANTS = [
    ("packets: planes are not widened", [
        ("packet-inl.h", "kDown = kPlaneDown;",
         "kDown = 1;"),
        ("packet-inl.h", "kUp = kPlaneUp;",
         "kUp = 1;"),
    ]),
    ("packets: nothing is searched beyond what was hit", [
        ("packet-inl.h", "return hn::Add(best, slack);",
         "return best;"),
    ]),
    ("packets: shears of beams are not widened", [
        ("packet_leaves-inl.h", "MinOfLanes(d, shear)) - kWider",
         "MinOfLanes(d, shear))"),
    ]),
    ("packets: places of beams are not widened", [
        ("packet_leaves-inl.h", "hn::Set(d, kWider));",
         "hn::Zero(d));"),
    ]),
    ("packets: a plane before all rays is behind them", [
        ("packet-inl.h", "if (planes.lo * kDown > interval.hi) return near;",
         "if (planes.lo * kDown > interval.hi) return far;"),
    ]),
    ("packets: ranges of inverses are those of the first ray", [
        ("group_shape-inl.h", "{1 / direction[axis].hi, 1 / direction[axis].lo}",
         "{1 / direction[axis].hi, 1 / direction[axis].hi}"),
    ]),
    ("bundles: planes are not widened", [
        ("bundle-inl.h", "hn::Mul(hn::Min(p, q), hn::Set(d, kPlaneDown))",
         "hn::Min(p, q)"),
        ("bundle-inl.h", "hn::Mul(hn::Max(p, q), hn::Set(d, kPlaneUp))",
         "hn::Max(p, q)"),
    ]),
    ("bundles: nothing is searched beyond what was hit", [
        ("bundle-inl.h", " + bundle_.slack[p];",
         ";"),
    ]),
    ("bundles: their reach is that of the first vector", [
        ("bundle-inl.h", "max = hn::Max(max, hn::Load(d, packet.best + at));",
         "max = hn::Max(max, hn::Load(d, packet.best));"),
    ]),
    ("bundles: they begin no earlier than their rays", [
        ("bundle_tracer-inl.h", "std::max(interval.lo - slack, 0.0F)",
         "interval.lo"),
    ]),
    ("bundles: they end where their rays do", [
        ("bundle_tracer-inl.h", "end = interval.hi + slack;",
         "end = interval.hi;"),
    ]),
    ("bundles: the box is not widened", [
        ("bundle_tracer-inl.h", "std::min(in * lo, in * hi) * kPlaneDown",
         "std::min(in * lo, in * hi)"),
        ("bundle_tracer-inl.h", "std::max(out * lo, out * hi) * kPlaneUp",
         "std::max(out * lo, out * hi)"),
    ]),
    ("bundles: shears of beams are not widened down", [
        ("bundle_tracer-inl.h", "range.lo - Beam::kWider",
         "range.lo"),
    ]),
    ("bundles: shears of beams are not widened up", [
        ("bundle_tracer-inl.h", "range.hi + Beam::kWider",
         "range.hi"),
    ]),
    ("bundles: packets of another origin join", [
        ("bundle-inl.h", "return from == origin && std::equal",
         "return std::equal"),
    ]),
    ("bundles: packets of other signs join", [
        ("bundle-inl.h", "from == origin && std::equal(signs, signs + 3, negative)",
         "from == origin"),
    ]),
    ("streams: planes are not widened", [
        ("ray_lists-inl.h", "max(hn::Mul(t, hn::Set(d, kPlaneDown)), t0)",
         "max(t, t0)"),
        ("ray_lists-inl.h", "min(hn::Mul(t, hn::Set(d, kPlaneUp)), t1)",
         "min(t, t1)"),
    ]),
    ("streams: nothing is searched beyond what was hit", [
        ("stream-inl.h", "hn::Add(best, hn::Set(d, slack_))",
         "best"),
    ]),
    ("all: the box is not widened", [
        ("ray_box-inl.h", "hn::Mul(enter, hn::Set(d, kPlaneDown))",
         "enter"),
        ("ray_box-inl.h", "hn::Mul(leave, hn::Set(d, kPlaneUp))",
         "leave"),
    ]),
    ("all: rays begin where they say", [
        ("ray_box-inl.h", "hn::Max(hn::Sub(ray.tMin, slack), hn::Zero(d))",
         "hn::Max(ray.tMin, hn::Zero(d))"),
    ]),
    ("all: rays end where they say", [
        ("ray_box-inl.h", "hn::Add(ray.tMax, slack)}",
         "ray.tMax}"),
    ]),
    ("all: of one surface the higher index wins", [
        ("single_ray.cpp", "if (found.triangle > hit.triangle) return;",
         "if (found.triangle < hit.triangle) return;"),
    ]),
    ("all: an edge belongs to one side only", [
        ("leaf_test-inl.h", "hn::Ge(hn::Min(hn::Min(u, v), w), zero)",
         "hn::Gt(hn::Min(hn::Min(u, v), w), zero)"),
    ]),
    ("narrow: no distance is in doubt", [
        ("narrow_leaf-inl.h", "hn::AndNot(hn::Ge(hn::Abs(outcome.sum), hn::Set(FloatTag(), noise)), outcome.inside)",
         "hn::And(hn::Lt(hn::Abs(outcome.sum), hn::Set(FloatTag(), 0 * noise)), outcome.inside)"),
    ]),
    ("narrow: single rays take them for common ones", [
        ("watertight.h", "noise > 0 && isDoubtful(sum, noise)",
         "noise > 0 && isDoubtful(sum, 0)"),
    ]),
    ("filter: bundles hit hidden triangles", [
        ("bundle-inl.h", "if (isHidden<kSearch>(scene_, triangles.triangle[i])) continue;",
         ""),
    ]),
    ("filter: packets hit hidden triangles", [
        ("leaf_test-inl.h", "if (isHidden<kSearch>(scene, corners.triangle)) return hn::FirstN(FloatTag(), 0);",
         ""),
    ]),
    ("filter: narrow triangles are not hidden", [
        ("narrow_leaf-inl.h", "if (isHidden<kSearch>(scene, corners.triangle)) return;",
         ""),
    ]),
    ("filter: narrow triangles have no holes", [
        ("narrow_leaf-inl.h", "filter<kSearch>(scene, corners.triangle, tMin, inCell, found, outcome);",
         ""),
    ]),
    ("filter: one ray against many triangles hits all", [
        ("triangle_block-inl.h", "open = hitsOf(open, outcome);",
         ""),
    ]),
]


def caught(build):
    return mutants.first_failure_of(build, PROGRAMS, os.environ | {"RT_LEAK_RAYS": "3000000"})


if __name__ == "__main__":
    sys.exit(mutants.main("check_kernel_mutants", KERNELS, MUTANTS, [program for program, *_ in PROGRAMS], caught))
