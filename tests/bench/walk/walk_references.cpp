#include "bench/walk/walk_references.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/effects.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/light_meter.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace bench {

namespace {

/// (Fowler, Noll and Vo)
std::uint64_t hashOf(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash;
}

} // namespace

WalkReferences::WalkReferences(const WalkOptions& options)
    : folder_(options.references),
      scene_(fmt::format("{} {}", options.scene.string(),
                         std::filesystem::last_write_time(options.scene).time_since_epoch().count())) {
    if (options.preset)
        scene_ += fmt::format(" {}", rtcore::kLightingPresetNames[static_cast<std::size_t>(*options.preset)]);
    std::filesystem::create_directories(folder_);
}

std::filesystem::path WalkReferences::file(const rtcore::View& view) const {
    rtcore::CameraFile camera;
    camera.camera = view.camera;
    camera.camera.nameOffset = 0;
    std::string key = scene_ + "\n" + rtcore::formatCameraFile(camera);
    for (const rtcore::SettingAssignment& a : rtcore::settingAssignments(view.settings, true))
        key += fmt::format("{}={}\n", a.name, rtcore::settingText(a.value));
    return folder_ / fmt::format("{:016x}.png", hashOf(key));
}

bool WalkReferences::has(const rtcore::View& view) const { return std::filesystem::exists(file(view)); }

rtcore::LdrImage WalkReferences::picture(const rtcore::View& view) const {
    const std::filesystem::path path = file(view);
    if (std::filesystem::exists(path)) return rtcore::readLdrImage(path);
    rtcore::FrameRenderer renderer;
    renderer.collectAovs(rtcore::effectsNeedAovs(view.settings));
    rtcore::RenderControl control;
    rtcore::Frame frame;
    renderer.render(view, control, frame);
    std::optional<float> white;
    if (view.settings.exposure.mode == rtcore::ExposureMode::Incident)
        white = rtcore::LightMeter().white(view, control);
    rtcore::PictureDeveloper developer;
    const float exposure = developer.exposure(frame, view.settings, white, control.threads);
    rtcore::LdrImage image;
    developer.develop(frame, view.settings, exposure, control.threads, image);
    rtcore::writeImage(path, image);
    return image;
}

} // namespace bench
