/// A single frame, on all cores, with memory of its own.
#pragma once

#include "rtcore/post/develop.h"
#include "rtcore/render/frame_renderer.h"

namespace test {

inline bool renderFrame(const rtcore::View& view, rtcore::RenderControl& control, rtcore::Frame& frame) {
    return rtcore::FrameRenderer().render(view, control, frame);
}

inline float exposureFor(const rtcore::Frame& frame, const rtcore::ExposureSettings& settings) {
    return rtcore::PictureDeveloper().exposure(frame, settings, 0);
}

inline rtcore::LdrImage develop(const rtcore::Frame& frame, const rtcore::RenderSettings& settings,
                                float exposure) {
    rtcore::LdrImage image;
    rtcore::PictureDeveloper().develop(frame, settings, exposure, 0, image);
    return image;
}

} // namespace test
