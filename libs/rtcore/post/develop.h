/// From radiance to what a display shows: exposure, tone mapping, sRGB, eight bits. (thesis 3.2)
#pragma once

#include "rtcore/render/frame_renderer.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

namespace rtcore {

/// The constant c of L = Y / (Y + c): the fixed value, or what suits the frame (exposure.h).
float exposureFor(const Frame& frame, const ExposureSettings& settings);

/// Tone maps with the constant `exposure` and quantises. The same input gives the same bits.
LdrImage develop(const Frame& frame, const RenderSettings& settings, float exposure);

} // namespace rtcore
