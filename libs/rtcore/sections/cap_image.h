/// Caps in an image, as a drawing shows them: flat, whatever light there is.
#pragma once

#include "rtcore/scene/camera.h"
#include "rtcore/scene/image.h"
#include "rtcore/sections/section_caps.h"

#include <span>

namespace rtcore {

/// Paints the caps that the camera looks at over an image of what it sees, as a display shows it. What
/// was before a cap is taken away; mirrors do not show them. Each shape in the colour of its material, of
/// which `colours` has one for each, or in the one of `style`, its edges dark. By one thread, with 64 MB
/// beside the image at most.
void paintCaps(const SectionCaps& caps, const CapStyle& style, std::span<const Colour> colours,
               const Camera& camera, LdrImage& image);

} // namespace rtcore
