// Lights, by their ids.
#include "rtserver/document.h"

#include "rtcore/sky/scene_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

/// "only number 3", "numbers 1 to 4", "numbers 1, 3 and 4".
std::string idsOf(const rtcore::Scene& scene) {
    std::vector<int> ids;
    for (const rtcore::SceneLight& each : scene.lights) ids.push_back(each.notes.id);
    std::ranges::sort(ids);
    if (ids.empty()) return "none";
    if (ids.size() == 1) return fmt::format("only number {}", ids.front());
    constexpr std::size_t kMost = 20;
    const bool inRow = std::cmp_equal(ids.back() - ids.front() + 1, ids.size());
    if (inRow || ids.size() > kMost) return fmt::format("numbers {} to {}", ids.front(), ids.back());
    const int last = ids.back();
    ids.pop_back();
    return fmt::format("numbers {} and {}", fmt::join(ids, ", "), last);
}

/// But for which of them are on.
bool sameLights(const rtcore::Scene& a, const rtcore::Scene& b) {
    const auto alike = [](rtcore::Light one, const rtcore::Light& other) {
        one.on = other.on;
        return one == other;
    };
    return std::ranges::equal(a.lights, b.lights, alike, &rtcore::SceneLight::light,
                              &rtcore::SceneLight::light);
}

} // namespace

std::size_t ServerState::lightOf(int id) const {
    const std::optional<std::size_t> light = rtcore::lightWithId(*scene_, id);
    if (!light)
        throw std::invalid_argument(
            fmt::format("there is no light {}; the scene has {}", id, idsOf(*scene_)));
    return *light;
}

void ServerState::switchLight(int id, std::optional<bool> on) {
    rtcore::Scene edited = *scene_;
    std::uint32_t& state = edited.lights[lightOf(id)].light.on;
    state = on.value_or(state == 0) ? 1 : 0;
    publish(std::move(edited));
}

void ServerState::changeLight(int id, const std::function<void(rtcore::LightDescription&)>& change) {
    const std::size_t light = lightOf(id);
    rtcore::LightDescription description = rtcore::describeLight(*scene_, light);
    change(description);
    rtcore::Scene edited = *scene_;
    rtcore::putLight(edited, light, description);
    publish(std::move(edited));
}

int ServerState::addLight(rtcore::LightDescription light) {
    light.id = rtcore::nextLightId(*scene_);
    rtcore::Scene edited = *scene_;
    rtcore::putLight(edited, edited.lights.size(), light);
    rtcore::moveSunBehind(edited);
    publish(std::move(edited));
    return light.id;
}

void ServerState::removeLight(int id) {
    const std::size_t light = lightOf(id);
    rtcore::Scene edited = *scene_;
    edited.removedLightId = std::max(edited.removedLightId, id);
    rtcore::eraseLight(edited, light);
    publish(std::move(edited));
}

// Cameras of a recording say which lights are on, not what they are like: a film of it would show other
// light.
void ServerState::endOutdatedRecording(const rtcore::Scene& edited) {
    if (!recording_ || sameLights(edited, *scene_)) return;
    endRecording("the lights were edited");
    messages_.warn(recordingFailure_);
}

} // namespace rtserver
