// The cost of a step of the walk-through mode: random walks from random places on the floors of a scene, and
// standing still there.
//   bench_motion scene [metres-per-unit [walks]]
#include "rtcore/io/scene_loader.h"
#include "rtcore/motion/walker.h"
#include "support/random_keys.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>
#include <vector>

namespace {

constexpr int kTicks = 240;
constexpr int kRounds = 3; ///< of the same walk; the fastest time of each step counts

struct World {
    rtcore::LoadedScene scene;
    rtcore::WorldFrame frame;
    rtcore::WalkShape shape;
};

double microseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::micro>(now).count();
}

rtcore::Vec3d randomPlace(const World& world, test::Random& random) {
    const rtcore::Box3& box = world.scene.tree.bounds;
    const float x = random.number(box.lo.x, box.hi.x), y = random.number(box.lo.y, box.hi.y);
    return world.frame.toMetres({x, y, random.number(box.lo.z, box.hi.z)});
}

/// Times of all steps of one walk: it takes the same way each time.
std::vector<double> timeWalk(const World& world, std::uint64_t seed, bool still) {
    std::vector<double> best;
    for (int round = 0; round < kRounds; ++round) {
        test::Random random(seed);
        rtcore::Walker walker(world.scene.tree, world.scene.scene.mesh(), world.frame, world.shape);
        if (!walker.enter(randomPlace(world, random))) return {};
        for (int i = 0; i < 2 * kTicks && !walker.atRest(); ++i) walker.tick({});
        if (!walker.atRest()) return {};
        test::RandomKeys keys(random);
        for (std::size_t i = 0; i < kTicks; ++i) {
            const rtcore::WalkInput input = still ? rtcore::WalkInput{} : keys.next();
            const double start = microseconds();
            const bool inside = walker.tick(input);
            const double took = microseconds() - start;
            if (!inside) return best;
            if (round == 0) best.push_back(took);
            best[i] = std::min(best[i], took);
        }
    }
    return best;
}

void measure(const World& world, int walks, bool still) {
    std::vector<double> all;
    for (int i = 0; i < walks; ++i) {
        const std::vector<double> one = timeWalk(world, static_cast<std::uint64_t>(i), still);
        all.insert(all.end(), one.begin(), one.end());
    }
    if (all.empty()) return;
    std::sort(all.begin(), all.end());
    const auto quantile = [&](double fraction) {
        return all[static_cast<std::size_t>(fraction * static_cast<double>(all.size() - 1))];
    };
    std::printf("%-8s %8zu steps: median %.1f us, 99%% %.1f us, 99.9%% %.1f us, worst %.1f us\n",
                still ? "standing" : "walking", all.size(), quantile(0.5), quantile(0.99), quantile(0.999),
                all.back());
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_motion scene [metres-per-unit [walks]]\n");
        return 2;
    }
    try {
        rtcore::LoadedScene scene = rtcore::loadScene(argv[1]);
        const double given = argc > 2 ? std::atof(argv[2]) : 0;
        const rtcore::Vec3 up = scene.scene.up;
        const double unit = given > 0 ? given : double{scene.units.metresPerUnit};
        const World world{std::move(scene), rtcore::WorldFrame(up, unit), rtcore::WalkShape()};
        std::printf("%zu triangles, %g metres per unit\n", world.scene.scene.mesh().triangles.size(), unit);
        const int walks = argc > 3 ? std::atoi(argv[3]) : 200;
        measure(world, walks, false);
        measure(world, walks / 4, true);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_motion: %s\n", e.what());
        return 1;
    }
    return 0;
}
