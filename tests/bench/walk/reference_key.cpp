#include "bench/walk/reference_key.h"

#include "rtcore/io/text/cam.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

namespace bench {

namespace {

/// (Fowler, Noll and Vo)
std::uint64_t hashOf(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash;
}

} // namespace

std::string sceneKey(const WalkOptions& options) {
    std::string key = fmt::format(
        "{} {} {}", options.scene.string(),
        std::filesystem::last_write_time(options.scene).time_since_epoch().count(),
        std::filesystem::is_regular_file(options.scene) ? std::filesystem::file_size(options.scene) : 0);
    if (options.preset)
        key += fmt::format(" {}", rtcore::kLightingPresetNames[static_cast<std::size_t>(*options.preset)]);
    return key;
}

std::uint64_t referenceKey(const std::string& scene, const rtcore::Camera& camera,
                           std::span<const rtcore::SettingAssignment> settings) {
    rtcore::CameraFile file;
    file.camera = camera;
    file.camera.nameOffset = 0;
    std::string key = scene + "\n" + rtcore::formatCameraFile(file);
    for (const rtcore::SettingAssignment& a : settings)
        key += fmt::format("{}={}\n", a.name, rtcore::settingText(a.value));
    return hashOf(key);
}

} // namespace bench
