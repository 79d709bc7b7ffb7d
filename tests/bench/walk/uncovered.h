/// The pixels that a turn of the head brings into view.
#pragma once

#include "rtcore/scene/camera.h"

#include <vector>

namespace bench {

/// For each pixel of an image of `now`, row by row, whether its direction was outside of the image of
/// `before`. Of what a step uncovers it knows nothing: in a turn on the spot that is all that is new.
std::vector<bool> uncoveredByTurn(const rtcore::Camera& before, const rtcore::Camera& now, int width,
                                  int height);

} // namespace bench
