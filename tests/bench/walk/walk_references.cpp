#include "bench/walk/walk_references.h"

#include "bench/walk/reference_key.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/post/develop.h"
#include "rtcore/post/effects.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/light_meter.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/format.h>

#include <optional>

namespace bench {

WalkReferences::WalkReferences(const WalkOptions& options)
    : folder_(options.references), scene_(sceneKey(options)) {
    std::filesystem::create_directories(folder_);
}

std::filesystem::path WalkReferences::file(const rtcore::View& view) const {
    const auto settings = rtcore::settingAssignments(view.settings, true);
    return folder_ / fmt::format("{:016x}.png", referenceKey(scene_, view.camera, settings));
}

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
