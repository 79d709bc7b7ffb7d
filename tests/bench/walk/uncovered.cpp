#include "bench/walk/uncovered.h"

#include "rtcore/render/camera_rays.h"

#include <cstddef>

namespace bench {

std::vector<bool> uncoveredByTurn(const rtcore::Camera& before, const rtcore::Camera& now, int width,
                                  int height) {
    const rtcore::CameraRays was(before, width, height), is(now, width, height);
    const auto [corner, right, down] = was.plane();
    const float across = dot(right, right), along = dot(down, down);
    std::vector<bool> uncovered(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::size_t pixel = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++pixel) {
            const rtcore::Vec3 direction =
                is.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F).direction;
            const float ahead = dot(direction, was.forward());
            if (ahead <= 0) {
                uncovered[pixel] = true;
                continue;
            }
            const rtcore::Vec3 at = (1 / ahead) * direction - corner;
            const float column = dot(at, right) / across, row = dot(at, down) / along;
            uncovered[pixel] = column < 0 || column > static_cast<float>(width) || row < 0 ||
                               row > static_cast<float>(height);
        }
    }
    return uncovered;
}

} // namespace bench
