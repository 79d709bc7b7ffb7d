/// Figures of ImageSums as a whole.
#pragma once

#include "rtcore/render/image_sums.h"

#include <cstdint>

namespace test {

/// Samples in all pixels together.
inline std::uint64_t samplesOf(const rtcore::ImageSums& sums) {
    std::uint64_t count = 0;
    for (int y = 0; y < sums.height(); ++y)
        for (int x = 0; x < sums.width(); ++x) count += sums.pixel(x, y).samples;
    return count;
}

inline rtcore::HdrImage meanOf(const rtcore::ImageSums& sums) {
    rtcore::HdrImage image;
    sums.mean(image);
    return image;
}

} // namespace test
