#include "rtcore/live/recall.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr float kSameNormal = 0.94F; ///< cosine of 20 degrees
constexpr float kSamePlane = 0.01F;  ///< of the depth
constexpr float kFarthest = 1.5F;    ///< pixels to where the light is from

/// Tells of pixels of the past whether they saw the surface that is asked for.
class SameSurface {
  public:
    SameSurface(const LiveImage& past, const Asked& asked)
        : past_(past), normal_(asked.normal), far_(asked.depth == LivePoint::kFar),
          limit_(kSamePlane * asked.depth), packed_(packNormal(asked.normal)) {
        if (far_) return;
        base_ = dot(normal_, past.plane.eye - asked.position);
        const Vec3 first = past.plane.towards(0.5F, 0.5F);
        corner_ = dot(normal_, first);
        right_ = dot(normal_, past.plane.right);
        down_ = dot(normal_, past.plane.down);
    }

    bool operator()(const LivePoint& point, int x, int y) const {
        if (!point.known()) return false;
        if (far_ || point.far()) return far_ == point.far();
        const float slope = corner_ + static_cast<float>(x) * right_ + static_cast<float>(y) * down_;
        if (!(std::fabs(base_ + point.depth * slope) < limit_)) return false;
        return point.normal == packed_ || dot(unpackNormal(point.normal), normal_) > kSameNormal;
    }

  private:
    const LiveImage& past_;
    Vec3 normal_;
    bool far_;
    float limit_;
    std::uint16_t packed_;
    float base_ = 0, corner_ = 0, right_ = 0, down_ = 0;
};

ImagePlane::Position positionIn(const LiveImage& past, const Asked& asked) {
    const bool far = asked.depth == LivePoint::kFar;
    return past.plane.find(far ? asked.position : asked.position - past.plane.eye);
}

std::int8_t inSteps(float pixels) {
    return static_cast<std::int8_t>(std::lround(std::clamp(pixels * kOffsetSteps, -127.0F, 127.0F)));
}

} // namespace

bool recallLight(const LiveImage& past, const Asked& asked, LivePoint& point) {
    const ImagePlane::Position seen = positionIn(past, asked);
    if (!seen.inside) return false;
    const SameSurface same(past, asked);
    // The four pixels around.
    const int column = static_cast<int>(seen.x + 0.5F), row = static_cast<int>(seen.y + 0.5F);
    const int right = std::min(column, past.plane.width - 1), bottom = std::min(row, past.plane.height - 1);
    float nearest = kFarthest * kFarthest, across = 0, down = 0;
    const LivePoint* found = nullptr;
    for (int y = std::max(row - 1, 0); y <= bottom; ++y) {
        for (int x = std::max(column - 1, 0); x <= right; ++x) {
            const LivePoint& candidate = past.at(x, y);
            if (!candidate.lit()) continue;
            const float dx = static_cast<float>(x) + 0.5F + candidate.across / kOffsetSteps - seen.x;
            const float dy = static_cast<float>(y) + 0.5F + candidate.down / kOffsetSteps - seen.y;
            const float square = dx * dx + dy * dy;
            if (square >= nearest || !same(candidate, x, y)) continue;
            nearest = square;
            across = dx;
            down = dy;
            found = &candidate;
        }
    }
    if (found == nullptr) return false;
    point.light = found->light;
    point.lights = found->lights;
    point.across = inSteps(across);
    point.down = inSteps(down);
    point.age = static_cast<std::uint8_t>(std::min(found->age + 1, 255));
    point.flags = static_cast<std::uint8_t>(point.flags | LivePoint::kLit);
    return true;
}

bool wasSeen(const LiveImage& past, const Asked& asked) {
    const ImagePlane::Position seen = positionIn(past, asked);
    if (!seen.inside) return false;
    const int x = static_cast<int>(seen.x), y = static_cast<int>(seen.y);
    return SameSurface(past, asked)(past.at(x, y), x, y);
}

} // namespace rtcore
