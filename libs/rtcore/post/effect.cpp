#include "rtcore/post/effect.h"

#include <algorithm>

namespace rtcore {

const HdrImage& Effect::apply(const HdrImage& picture, const Aovs& /*aovs*/, const EffectRun& /*run*/) {
    return picture;
}

bool Effect::beginRows(const HdrImage& /*coarse*/, int /*block*/, const EffectRun& /*run*/) { return false; }

void Effect::changeRow(const RowPart& part, const Colour* radiance, Colour* changed) const {
    if (radiance != changed) std::copy(radiance + part.left, radiance + part.right, changed + part.left);
}

} // namespace rtcore
