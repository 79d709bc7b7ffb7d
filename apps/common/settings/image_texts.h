/// Texts in image files on how the images were made.
#pragma once

#include "rtcore/io/images/image_notes.h"
#include "rtcore/settings/render_settings.h"

#include <vector>

namespace app {

/// "Software" with the version, "integrator" (whitted or path) and "samples", of each pixel: nothing that
/// differs from machine to machine. Files of all programs get these.
std::vector<rtcore::ImageText> imageTexts(rtcore::Integrator integrator, int samples);

/// The same of an image with all samples that the settings ask for; where they are adaptive, at most.
std::vector<rtcore::ImageText> imageTexts(const rtcore::RenderSettings& settings);

} // namespace app
