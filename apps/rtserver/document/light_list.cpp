#include "rtserver/document/light_list.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/sky/scene_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

/// "only number 3", "numbers 1 to 4", "numbers 1, 3 and 4".
rtcore::Sentence idsOf(const rtcore::Scene& scene) {
    std::vector<int> ids;
    for (const rtcore::SceneLight& each : scene.lights) ids.push_back(each.notes.id);
    std::ranges::sort(ids);
    if (ids.empty()) return rtcore::say("none");
    if (ids.size() == 1) return rtcore::say("only number {0}", ids.front());
    constexpr std::size_t kMax = 20;
    const bool inRow = std::cmp_equal(ids.back() - ids.front() + 1, ids.size());
    if (inRow || ids.size() > kMax) return rtcore::say("numbers {0} to {1}", ids.front(), ids.back());
    const int last = ids.back();
    ids.pop_back();
    return rtcore::say("numbers {0} and {1}", fmt::format("{}", fmt::join(ids, ", ")), last);
}

} // namespace

std::size_t lightOf(const rtcore::Scene& scene, int id) {
    const std::optional<std::size_t> light = rtcore::lightWithId(scene, id);
    if (!light)
        throw rtcore::BadValue(rtcore::say("there is no light {0}; the scene has {1}", id, idsOf(scene)));
    return *light;
}

void switchLight(Document& document, int id, std::optional<bool> on) {
    rtcore::Scene edited = *document.scene();
    std::uint32_t& state = edited.lights[lightOf(edited, id)].light.on;
    state = on.value_or(state == 0) ? 1 : 0;
    document.publish(std::move(edited));
}

void changeLight(Document& document, int id, const std::function<void(rtcore::LightDescription&)>& change) {
    rtcore::Scene edited = *document.scene();
    const std::size_t light = lightOf(edited, id);
    rtcore::LightDescription description = rtcore::describeLight(edited, light);
    change(description);
    rtcore::putLight(edited, light, description);
    document.publish(std::move(edited));
}

int addLight(Document& document, rtcore::LightDescription light) {
    rtcore::Scene edited = *document.scene();
    light.id = rtcore::nextLightId(edited);
    rtcore::putLight(edited, edited.lights.size(), light);
    rtcore::moveSunBehind(edited);
    document.publish(std::move(edited));
    return light.id;
}

void removeLight(Document& document, int id) {
    rtcore::Scene edited = *document.scene();
    const std::size_t light = lightOf(edited, id);
    edited.removedLightId = std::max(edited.removedLightId, id);
    rtcore::eraseLight(edited, light);
    document.publish(std::move(edited));
}

} // namespace rtserver
