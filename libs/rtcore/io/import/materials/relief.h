/// Normal maps of images of heights, as MTL's `bump` and others name them.
#pragma once

#include "rtcore/scene/model.h"

namespace rtcore {

/// How heights become a relief.
struct HeightUse {
    TextureWrap u = TextureWrap::Repeat, v = TextureWrap::Repeat; ///< beyond the edges of the image
    float scale = 1;                                              ///< of the heights
};

struct NormalImage {
    LdrImage image;
    float scale = 1; ///< Material::normalScale that gives the relief its slopes
};

/// By central differences of the mean of red, green and blue. At a scale of 1 white stands a tenth of the
/// image's width (of its height, for slopes along v) above black, whatever the resolution: the formats leave
/// the unit open. Slopes end at 4, 76 degrees; up to there the steepest one uses the whole range of the
/// codes.
NormalImage normalsOfHeights(const LdrImage& heights, const HeightUse& use);

/// Its texels are normals, not heights.
bool holdsNormals(const LdrImage& image);

} // namespace rtcore
