#include "rtcore/live/hole_filling.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr float kElsewhere = 1e-3F; ///< weight of light from another surface

bool sameSurface(const LiveImage& image, int x, int y, int u, int v) {
    const LivePoint &a = image.at(x, y), &b = image.at(u, v);
    if (a.far() || b.far()) return a.far() == b.far();
    constexpr float kSameNormal = 0.94F, kSamePlane = 0.01F;
    const Vec3 normal = unpackNormal(a.normal);
    if (!(dot(normal, unpackNormal(b.normal)) > kSameNormal)) return false;
    const Vec3 between = image.offsetFromEye(u, v) - image.offsetFromEye(x, y);
    return std::fabs(dot(normal, between)) < kSamePlane * a.depth;
}

Colour filled(const LiveImage& image, int x, int y) {
    constexpr int kReach = 1, kWidest = 16;
    for (int step = 1; step <= kWidest; step *= 2) {
        Colour sum;
        float weights = 0;
        for (int j = -kReach; j <= kReach; ++j) {
            for (int i = -kReach; i <= kReach; ++i) {
                const int u = x + i * step, v = y + j * step;
                if (u < 0 || v < 0 || u >= image.plane.width || v >= image.plane.height) continue;
                const LivePoint& point = image.at(u, v);
                if (!point.lit()) continue;
                const float weight = (sameSurface(image, x, y, u, v) ? 1.0F : kElsewhere) /
                                     static_cast<float>(1 + i * i + j * j);
                sum += unpackLight(point.light) * weight;
                weights += weight;
            }
        }
        if (weights > (step < kWidest ? 2 * kElsewhere * kReach : 0.0F)) return sum / weights;
    }
    return {};
}

} // namespace

void showPoints(const LiveImage& image, const PixelArea& area, Frame& frame) {
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) {
            const std::size_t i = image.index(x, y);
            const LivePoint& point = image.points[i];
            frame.radiance.pixels[i] = point.lit() ? unpackLight(point.light) : filled(image, x, y);
            frame.covered[i] = point.far() ? 0 : 255;
        }
    }
}

} // namespace rtcore
