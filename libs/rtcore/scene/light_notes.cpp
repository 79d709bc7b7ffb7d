#include "rtcore/scene/light_notes.h"

#include "rtcore/scene/scene.h"

#include <algorithm>
#include <set>
#include <vector>

namespace rtcore {

namespace {

int leastFree(const std::set<int>& taken, int from) {
    int id = from;
    while (taken.contains(id)) ++id;
    return id;
}

template <typename T>
void eraseAt(std::vector<T>& list, std::size_t i) {
    if (i < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
}

std::set<int> idsOf(const Scene& scene) {
    std::set<int> ids;
    for (const LightNotes& notes : scene.lightNotes) ids.insert(notes.id);
    return ids;
}

} // namespace

void numberLights(Scene& scene) {
    scene.lightNames.resize(scene.lights.size());
    scene.lightNotes.resize(scene.lights.size());
    std::set<int> taken = idsOf(scene);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        int& id = scene.lightNotes[i].id;
        if (id > 0) continue;
        id = leastFree(taken, static_cast<int>(i) + 1);
        taken.insert(id);
    }
}

std::optional<std::size_t> lightWithId(const Scene& scene, int id) {
    const auto found = std::ranges::find(scene.lightNotes, id, &LightNotes::id);
    if (found == scene.lightNotes.end()) return std::nullopt;
    return static_cast<std::size_t>(found - scene.lightNotes.begin());
}

void eraseLight(Scene& scene, std::size_t light) {
    eraseAt(scene.lights, light);
    eraseAt(scene.lightNames, light);
    eraseAt(scene.lightNotes, light);
}

int nextLightId(const Scene& scene) {
    const std::set<int> taken = idsOf(scene);
    const int last = std::max(taken.empty() ? 0 : *taken.rbegin(), scene.removedLightId);
    return last < kMostLightId ? last + 1 : leastFree(taken, 1);
}

} // namespace rtcore
