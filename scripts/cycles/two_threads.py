"""The speedup of paths by two threads, over that of rays in rtbench, for scripts/performance/cycles.sh.

    two_threads.py FOLDER WIDTH HEIGHT ROUNDS RENDERER RTBENCH MODELS NAME...

Wall time, so the machine must have nothing else to do. The fastest round of each number of threads counts.
"""
import json
import math
import os
import statistics
import sys
import time

import programs
import scenes
import write_scene

FEW, MANY = 8, 136  # samples; their difference takes what is done once out


def rendering(ours, path, size, samples, threads):
    start = time.monotonic()
    ours.render(path, path + "-timed.pfm", size, samples, threads=threads)
    return time.monotonic() - start


def speed_of_rays(rtbench, path, threads):
    report = path + "-rays.json"
    programs.run([rtbench, path + ".obj", "--rays=bounce,shadow", "--embree=off", "--threads=%d" % threads, "--rounds=5",
                  "--size=512", "--json=" + report, "--progress=none"], path + "-rays.log")
    with open(report, encoding="utf-8") as file:
        rays = json.load(file)["scenes"][0]["rays"]
    return math.exp(statistics.fmean(math.log(one["ours"]) for one in rays.values()))


def main():
    folder, width, height, rounds, renderer, rtbench, models = sys.argv[1:8]
    ours, size = programs.Ours(renderer), (int(width), int(height))
    for name in sys.argv[8:]:
        scene = scenes.find(name, models, folder)
        if scene is None:
            print("%-12s skipped: its model is not there" % name)
            continue
        path = os.path.join(folder, name)
        write_scene.write(scene, path)
        best = {}
        for _ in range(int(rounds)):
            for threads in (1, 2):
                few, many = (rendering(ours, path, size, samples, threads) for samples in (FEW, MANY))
                best[threads] = min(best.get(threads, math.inf), many - few)
        paths = best[1] / best[2]
        rays = speed_of_rays(rtbench, path, 2) / speed_of_rays(rtbench, path, 1)
        print("%-12s two threads: paths %.3f times one, rays of rtbench %.3f, ratio %.3f" % (name, paths, rays, paths / rays),
              flush=True)


if __name__ == "__main__":
    main()
