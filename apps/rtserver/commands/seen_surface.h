/// The surface that is seen at a point of the image.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/math/vec.h"

#include <optional>

namespace rtserver {

struct SeenSurface {
    rtcore::Vec3 position;
    rtcore::Vec3 normal; ///< geometric, unit length, to the side that is seen
    float distance = 0;  ///< from where the ray starts, scene units
};

/// The first one along the ray through that place: 0..1 from the left and from the top. Nothing: the ray
/// meets none. `document` is ready.
std::optional<SeenSurface> surfaceAt(const Document& document, float right, float down);

} // namespace rtserver
