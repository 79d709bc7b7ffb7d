#include "rtcore/scene/scene_light.h"

#include "rtcore/scene/scene.h"

#include <algorithm>
#include <set>

namespace rtcore {

namespace {

int lowestFree(const std::set<int>& taken, int from) {
    int id = from;
    while (taken.contains(id)) ++id;
    return id;
}

std::set<int> idsOf(const Scene& scene) {
    std::set<int> ids;
    for (const SceneLight& each : scene.lights) ids.insert(each.notes.id);
    return ids;
}

} // namespace

std::vector<Light> lightsOf(std::span<const SceneLight> lights) {
    std::vector<Light> all;
    all.reserve(lights.size());
    for (const SceneLight& each : lights) all.push_back(each.light);
    return all;
}

bool shineAlike(std::span<const SceneLight> a, std::span<const SceneLight> b) {
    return std::ranges::equal(a, b, {}, &SceneLight::light, &SceneLight::light);
}

void numberLights(Scene& scene) {
    std::set<int> taken = idsOf(scene);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        int& id = scene.lights[i].notes.id;
        if (id > 0) continue;
        id = lowestFree(taken, static_cast<int>(i) + 1);
        taken.insert(id);
    }
}

std::optional<std::size_t> lightWithId(const Scene& scene, int id) {
    const auto found =
        std::ranges::find(scene.lights, id, [](const SceneLight& each) { return each.notes.id; });
    if (found == scene.lights.end()) return std::nullopt;
    return static_cast<std::size_t>(found - scene.lights.begin());
}

void eraseLight(Scene& scene, std::size_t light) {
    scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(light));
}

int nextLightId(const Scene& scene) {
    const std::set<int> taken = idsOf(scene);
    const int last = std::max(taken.empty() ? 0 : *taken.rbegin(), scene.removedLightId);
    return last < kMaxLightId ? last + 1 : lowestFree(taken, 1);
}

} // namespace rtcore
