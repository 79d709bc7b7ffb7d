/// Scenes in which indirect light is learned step by step.
#pragma once

#include "rtcore/gathering/indirect_light.h"

#include "support/random_numbers.h"
#include "support/small_scene.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace test {

inline rtcore::Receiver receiverAt(rtcore::Vec3 position, rtcore::Vec3 normal, float pixel) {
    return {position, normal, normal, pixel};
}

/// The light of a scene at points that are seen from anywhere.
class GatheringScene {
  public:
    explicit GatheringScene(rtcore::Scene scene, rtcore::RenderSettings with = exactSettings())
        : traced(std::move(scene)), settings(with) {
        settings.path.emitters = rtcore::EmitterLight::On;
        light.begin(traced.scene, traced.tracer, settings);
    }

    /// So many steps, each with some of the receivers; the first with all.
    void learn(int steps, std::size_t some = 2000, int threads = 0) {
        std::vector<rtcore::Receiver> now = receivers;
        std::vector<rtcore::ArrivingLight> arriving;
        for (int step = 0; step < steps; ++step) {
            if (step > 0 && receivers.size() > some) {
                now.clear();
                for (std::size_t i = 0; i < some; ++i)
                    now.push_back(receivers[random.index(receivers.size())]);
            }
            arriving.resize(now.size());
            light.step(now, arriving, budget, threads);
        }
    }
    rtcore::Colour at(const rtcore::Receiver& receiver) const {
        rtcore::ArrivingLight arriving;
        light.cache().lookUp({&receiver, 1}, {&arriving, 1});
        return arriving.irradiance;
    }
    rtcore::Colour mean() const {
        std::vector<rtcore::ArrivingLight> arriving(receivers.size());
        light.cache().lookUp(receivers, arriving);
        rtcore::Colour sum;
        for (const rtcore::ArrivingLight& each : arriving) sum += each.irradiance;
        return sum / static_cast<float>(receivers.size());
    }
    /// Adds points of a parallelogram, evenly.
    void addReceivers(rtcore::Vec3 corner, rtcore::Vec3 a, rtcore::Vec3 b, rtcore::Vec3 normal,
                      std::size_t count, float pixel) {
        for (std::size_t i = 0; i < count; ++i)
            receivers.push_back(
                receiverAt(corner + a * random.number(0, 1) + b * random.number(0, 1), normal, pixel));
    }
    /// Those of the six faces of a box, seen from inside.
    void addReceiversOfBox(rtcore::Vec3 lo, rtcore::Vec3 hi, std::size_t ofFace, float pixel) {
        const rtcore::Vec3 size = hi - lo, x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
        addReceivers(lo, y, z, {1, 0, 0}, ofFace, pixel);
        addReceivers(lo + x, y, z, {-1, 0, 0}, ofFace, pixel);
        addReceivers(lo, x, z, {0, 1, 0}, ofFace, pixel);
        addReceivers(lo + y, x, z, {0, -1, 0}, ofFace, pixel);
        addReceivers(lo, x, y, {0, 0, 1}, ofFace, pixel);
        addReceivers(lo + z, x, y, {0, 0, -1}, ofFace, pixel);
    }

    TracedScene traced;
    rtcore::RenderSettings settings;
    rtcore::IndirectLight light;
    rtcore::GatherBudget budget{8192, 1024};
    std::vector<rtcore::Receiver> receivers;
    Random random{5};
};

/// Adds the faces of a box that face inwards: floor and ceiling along y.
inline void addRoom(SceneBuilder& b, rtcore::Vec3 lo, rtcore::Vec3 hi, std::uint32_t material) {
    b.quad({lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, lo.y, lo.z}, material);
    b.quad({lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z}, material);
    b.quad({lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z}, material);
    b.quad({lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, lo.y, hi.z}, material);
    b.quad({lo.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {lo.x, hi.y, hi.z}, {lo.x, lo.y, hi.z}, material);
    b.quad({hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, hi.y, lo.z}, material);
}

/// A furnished room under a sky that a window shows, with a pane, a mirror, an emitter and a light.
inline rtcore::Scene furnishedRoom() {
    SceneBuilder b;
    const auto white = b.material(matte(0.7F)), mirrored = b.material(mirror(0.9F));
    rtcore::Material pane = glass();
    pane.opacity = 0.1F;
    const auto window = b.material(pane), shining = b.material(emitter({3, 2, 1}));
    b.quad({0, 0, 0}, {0, 0, 4}, {4, 0, 4}, {4, 0, 0}, white);
    b.quad({0, 3, 0}, {4, 3, 0}, {4, 3, 4}, {0, 3, 4}, white);
    b.quad({0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, white);
    b.quad({0, 0, 4}, {0, 3, 4}, {4, 3, 4}, {4, 0, 4}, mirrored);
    b.quad({0, 0, 0}, {0, 3, 0}, {0, 3, 4}, {0, 0, 4}, white);
    b.quad({4, 0, 0}, {4, 0, 4}, {4, 1, 4}, {4, 1, 0}, white);
    b.quad({4, 1, 0}, {4, 1, 4}, {4, 3, 4}, {4, 3, 0}, window);
    b.box({1, 0, 1}, {2, 1, 2}, white);
    b.box({2.5F, 0, 2.5F}, {2.8F, 0.3F, 2.8F}, shining);
    rtcore::Scene scene = b.finish();
    scene.background = {0.4F, 0.6F, 1};
    scene.lights = {pointLight({2, 2.5F, 2}, 2)};
    return scene;
}

} // namespace test
