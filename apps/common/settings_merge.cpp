#include "common/settings_merge.h"

#include "rtcore/platform/error.h"

#include <string>

namespace app {

namespace {

void applyCameraFields(const rtcore::CameraFile& camera, rtcore::RenderSettings& settings) {
    const auto set = [&](const char* name, const auto& value) {
        if (value) rtcore::setSetting(settings, name, *value);
    };
    set("width", camera.width);
    set("height", camera.height);
    set("antialiasing", camera.antialiasing);
    set("bloom", camera.bloom);
    set("exposure.value", camera.exposure);
    if (camera.exposure) settings.exposure.mode = rtcore::ExposureMode::Fixed;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& message) {
    throw rtcore::FileError(rtcore::FailureKind::BadData, file.string(), message);
}

} // namespace

rtcore::RenderSettings mergeSettings(const SettingSources& sources) {
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, sources.scene);
    rtcore::applySettings(settings, sources.settingsFile);
    if (sources.camera != nullptr) applyCameraFields(*sources.camera, settings);
    rtcore::applySettings(settings, sources.commandLine);
    return settings;
}

void applyCameraToScene(const rtcore::CameraFile& camera, const std::filesystem::path& file,
                        rtcore::Scene& scene) {
    if (camera.lights) {
        if (camera.lights->size() > scene.lights.size()) {
            refuse(file, "switches " + std::to_string(camera.lights->size()) + " lights, but the scene has " +
                             std::to_string(scene.lights.size()));
        }
        for (std::size_t i = 0; i < camera.lights->size(); ++i)
            scene.lights[i].on = (*camera.lights)[i] ? 1U : 0U;
    }
    if (camera.environment) {
        const auto count = static_cast<int>(scene.environments.size());
        if (*camera.environment > 0 && *camera.environment >= count) {
            refuse(file, "asks for environment " + std::to_string(*camera.environment) +
                             " (counted from 0), but the scene has " + std::to_string(count));
        }
        scene.activeEnvironment = *camera.environment;
    }
}

} // namespace app
