#include "common/settings/settings_merge.h"

#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace app {

namespace {

bool sets(std::span<const rtcore::SettingAssignment> settings, std::string_view name) {
    return std::any_of(settings.begin(), settings.end(), [&](const auto& each) { return each.name == name; });
}

/// `number` in the ratio of `to` and `from`, within the range of a setting that counts pixels.
int inRatio(int number, int to, int from) {
    const rtcore::Setting& setting = rtcore::requireSetting("width");
    const double exact = static_cast<double>(number) * to / from;
    return static_cast<int>(std::lround(std::clamp(exact, setting.minimum, setting.maximum)));
}

/// With only the width or the height given, the image is scaled and keeps its aspect.
void keepAspect(std::span<const rtcore::SettingAssignment> named, int width, int height,
                rtcore::RenderSettings& settings) {
    if (sets(named, "width") == sets(named, "height")) return;
    if (sets(named, "width")) {
        settings.height = inRatio(settings.width, height, width);
    } else {
        settings.width = inRatio(settings.height, width, height);
    }
}

} // namespace

std::vector<rtcore::SettingAssignment> settingsOf(const rtcore::CameraFile& camera) {
    std::vector<rtcore::SettingAssignment> all;
    const auto add = [&](const char* name, const auto& value) {
        if (value) all.push_back({name, *value});
    };
    add("width", camera.width);
    add("height", camera.height);
    add("antialiasing", camera.antialiasing);
    add("bloom.radius", camera.bloom);
    add("exposure.value", camera.exposure);
    if (camera.exposure) all.push_back({"exposure.mode", "fixed"});
    return all;
}

rtcore::RenderSettings mergeSettings(const SettingSources& sources) {
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, sources.scene);
    rtcore::applySettings(settings, sources.settingsFile);
    if (sources.camera != nullptr) rtcore::applySettings(settings, settingsOf(*sources.camera));
    const int width = settings.width, height = settings.height;
    rtcore::applySettings(settings, sources.commandLine);
    keepAspect(sources.commandLine, width, height, settings);
    return settings;
}

namespace {

/// The ids that the scene lacks, parted by commas.
std::string switchLights(std::span<const int> ids, bool on, rtcore::Scene& scene) {
    std::string missing;
    for (const int id : ids) {
        const std::optional<std::size_t> light = rtcore::lightWithId(scene, id);
        if (light)
            scene.lights[*light].light.on = on ? 1 : 0;
        else
            missing += (missing.empty() ? "" : ", ") + std::to_string(id);
    }
    return missing;
}

std::string inOneList(const std::string& a, const std::string& b) {
    return a + (a.empty() || b.empty() ? "" : ", ") + b;
}

} // namespace

rtcore::Sentence applyCameraToScene(const rtcore::CameraFile& camera, const std::filesystem::path& file,
                                    rtcore::Scene& scene) {
    using rtcore::say;
    rtcore::Sentence other;
    if (camera.lights && camera.lights->size() > scene.lights.size()) {
        const std::size_t lights = camera.lights->size();
        other = say(lights == 1 ? "switches {0} light, but the scene has {1}"
                                : "switches {0} lights, but the scene has {1}",
                    lights, scene.lights.size());
    } else if (camera.lights) {
        for (std::size_t i = 0; i < camera.lights->size(); ++i)
            scene.lights[i].light.on = (*camera.lights)[i] ? 1U : 0U;
    }
    const std::string missing =
        inOneList(switchLights(camera.lightsOn, true, scene), switchLights(camera.lightsOff, false, scene));
    if (!missing.empty()) other = say("names lights that the scene lacks ({0})", missing);
    const auto count = static_cast<int>(scene.environments.size());
    if (camera.environment && *camera.environment > 0 && *camera.environment >= count) {
        const rtcore::Sentence asks = say("asks for environment {0} (counted from 0), but the scene has {1}",
                                          *camera.environment, count);
        other = other.empty() ? asks : say("{0} and {1}", other, asks);
    } else if (camera.environment) {
        scene.activeEnvironment = *camera.environment;
    }
    return other.empty() ? other : say("{0} {1}; these stay as they are", file.string(), other);
}

} // namespace app
