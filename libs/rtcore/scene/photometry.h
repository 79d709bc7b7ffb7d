/// The distribution of a luminaire's light over directions, as goniophotometers measure it. Angles are those
/// of C-planes: gamma from the axis on, C around it, counter-clockwise where one looks along the axis.
#pragma once

#include "rtcore/scene/light.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// What a file says of it: intensities at all pairs of these angles, bilinear in them between, 0 beyond the
/// gammas.
struct PhotometricWeb {
    std::vector<double> gammas;  ///< degrees, ascending, 0..180; two or more
    std::vector<double> planes;  ///< degrees, ascending, over 360 exactly; the last one is the first again
    std::vector<double> candela; ///< of each plane its gammas; finite, not negative, some above 0
    friend bool operator==(const PhotometricWeb&, const PhotometricWeb&) = default;
};

/// The luminous flux, lm: the exact integral of the bilinear function.
double lumensOf(const PhotometricWeb& web);
double maxCandela(const PhotometricWeb& web);

/// The same for vector code, in radians; 1 where it is brightest.
struct Photometry {
    const float* gammas = nullptr;
    const float* planes = nullptr;
    const float* relative = nullptr;
    std::uint32_t gammaCount = 0, planeCount = 0;
    bool turned = true;  ///< C counts: not all planes are alike
    float mean = 1;      ///< over all directions
    float cosReach = -1; ///< cosine of the largest gamma with light
    /// A bound: at an angle a from the axis it is at most the cosine of a less the spread, and 0 beyond
    /// spread + edge. (light_tree.h)
    float cosSpread = -1, cosEdge = 1;
};

/// The number by which lights name it, above 0; that of an earlier one where they are equal. It is kept as
/// long as the process runs, since lights are plain records that anyone may copy: some 5 to 300 KB each.
/// Safe from many threads. Throws Refusal after kMaxPhotometries.
std::uint32_t keepPhotometry(const PhotometricWeb& web);
inline constexpr std::size_t kMaxPhotometries = 4096;

/// Of number 0, and of none that was kept: the same to all sides.
const Photometry& photometry(std::uint32_t number);
inline const Photometry& photometryOf(const Light& light) { return photometry(light.photometry); }

} // namespace rtcore
