/// How much two images differ to an eye: by the means of small blocks, so that single pixels at edges do
/// not count.
#pragma once

#include "rtcore/scene/image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace test {

struct PictureDifference {
    double mean = 0;       ///< of |a - b| over all pixels and channels, in codes of 255
    double worstBlock = 0; ///< the largest difference of the means of a block
};

inline PictureDifference comparePictures(const rtcore::LdrImage& a, const rtcore::LdrImage& b) {
    constexpr int kBlock = 8;
    PictureDifference result;
    for (int top = 0; top < a.height; top += kBlock) {
        for (int left = 0; left < a.width; left += kBlock) {
            double signedSum[3] = {0, 0, 0};
            int pixels = 0;
            for (int y = top; y < std::min(top + kBlock, a.height); ++y) {
                for (int x = left; x < std::min(left + kBlock, a.width); ++x, ++pixels) {
                    const int d[3] = {a.at(x, y).r - b.at(x, y).r, a.at(x, y).g - b.at(x, y).g,
                                      a.at(x, y).b - b.at(x, y).b};
                    for (int c = 0; c < 3; ++c) {
                        signedSum[c] += d[c];
                        result.mean += std::abs(d[c]);
                    }
                }
            }
            for (const double sum : signedSum)
                result.worstBlock = std::max(result.worstBlock, std::fabs(sum) / pixels);
        }
    }
    result.mean /= 3.0 * static_cast<double>(a.pixels.size());
    return result;
}

/// |a - b| times eight.
inline rtcore::LdrImage differencePicture(const rtcore::LdrImage& a, const rtcore::LdrImage& b) {
    rtcore::LdrImage result(a.width, a.height);
    const auto amplify = [](int x, int y) {
        return static_cast<std::uint8_t>(std::min(255, 8 * std::abs(x - y)));
    };
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const rtcore::Rgba8 p = a.pixels[i];
        const rtcore::Rgba8 q = b.pixels[i];
        result.pixels[i] = {amplify(p.r, q.r), amplify(p.g, q.g), amplify(p.b, q.b), 255};
    }
    return result;
}

} // namespace test
