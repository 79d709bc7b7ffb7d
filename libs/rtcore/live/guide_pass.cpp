#include "rtcore/live/guide_pass.h"

#include "rtcore/live/recall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtcore {

bool GuidePattern::traced(int x, int y) const {
    const auto n = static_cast<int>(number & 3U);
    if (period == 1) return true;
    if (period == 2) return ((x + y + n) & 1) == 0;
    return (turnOf(x, y) >> 4 & 3U) == (number & 3U);
}

// --- Rays ---

void GuidePass::collectGrid(const Task& task, const PixelArea& area, int left, int top, int step,
                            const ImagePlane& plane) {
    const auto fraction = static_cast<float>(step) * 0.5F - 0.5F; // from the middle of a cell to its pixel's
    const float cornerX = static_cast<float>(left) - fraction, cornerY = static_cast<float>(top) - fraction;
    const int right = std::min(area.left + area.columns, plane.width),
              bottom = std::min(area.top + area.rows, plane.height);
    for (int row = 0; top + row * step < bottom; row += kCameraBlock) {
        for (int column = 0; left + column * step < right; column += kCameraBlock) {
            float directions[3][kCameraBlockRays];
            task.rays.directions({cornerX, cornerY, column, row, static_cast<float>(step)}, directions[0],
                                 directions[1], directions[2]);
            for (int i = 0; i < kCameraBlockRays; ++i) {
                const int x = left + (column + columnInBlock(i)) * step,
                          y = top + (row + rowInBlock(i)) * step;
                if (x >= right || y >= bottom) continue;
                pixels_.push_back({x, y});
                rays_.dx.push_back(directions[0][i]);
                rays_.dy.push_back(directions[1][i]);
                rays_.dz.push_back(directions[2][i]);
            }
        }
    }
}

void GuidePass::collectRays(const Task& task, const PixelArea& area, const LiveImage& present) {
    rays_.clear();
    pixels_.clear();
    const ImagePlane& plane = present.plane;
    if (task.pattern.period == 1) {
        collectGrid(task, area, area.left, area.top, 1, plane);
    } else {
        for (int y = area.top; y < area.top + 2; ++y) {
            for (int x = area.left; x < area.left + 2; ++x) {
                if (task.pattern.traced(x, y)) collectGrid(task, area, x, y, 2, plane);
            }
        }
    }
    const std::size_t count = pixels_.size();
    rays_.ox.assign(count, plane.eye.x);
    rays_.oy.assign(count, plane.eye.y);
    rays_.oz.assign(count, plane.eye.z);
    rays_.tMin.assign(count, 0.0F);
    rays_.tMax.assign(count, std::numeric_limits<float>::max());
}

void GuidePass::trace(const Task& task, const PixelArea& area, LiveImage& present) {
    collectRays(task, area, present);
    statistics_.count(RayKind::Primary, rays_.size());
    task.tracer.intersect(RayKind::Primary, rays_, hits_);
    surfaces_.fill(task.scene.mesh(), task.materials, rays_, hits_);
    const ImagePlane& plane = present.plane;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        LivePoint point;
        Asked asked;
        const std::uint32_t found = surfaces_.traits[i];
        if (found == 0) {
            asked = {{rays_.dx[i], rays_.dy[i], rays_.dz[i]}, {}, LivePoint::kFar};
        } else {
            const Vec3 position = surfaces_.position.at(i);
            asked = {position, surfaces_.geometricNormal.at(i), dot(plane.axis, position - plane.eye)};
            point.normal = packNormal(asked.normal);
            if ((found & (traits::kMirror | traits::kGeneral)) != 0) point.flags = LivePoint::kViewDependent;
        }
        point.depth = asked.depth;
        recallLight(task.past, asked, point);
        present.at(pixels_[i].x, pixels_[i].y) = point;
    }
}

// --- Pixels without rays ---

namespace {

/// What a pixel sees if it sees the surface of a neighbour: the depth of that surface's plane.
Asked onSurfaceOf(const LiveImage& present, int x, int y, int neighbourX, int neighbourY) {
    const LivePoint& neighbour = present.at(neighbourX, neighbourY);
    const ImagePlane& plane = present.plane;
    const Vec3 towards = plane.towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    if (neighbour.far()) return {towards, {}, LivePoint::kFar};
    constexpr float kGrazing = 1e-4F, kMostChange = 0.3F;
    const Vec3 normal = unpackNormal(neighbour.normal);
    const Vec3 there = present.offsetFromEye(neighbourX, neighbourY);
    const float slope = dot(normal, towards);
    float depth = std::fabs(slope) > kGrazing * length(towards) ? dot(normal, there) / slope : 0;
    if (!(std::fabs(depth - neighbour.depth) < kMostChange * neighbour.depth)) depth = neighbour.depth;
    return {plane.eye + towards * depth, normal, depth};
}

/// The light of a neighbour that is (dx, dy) pixels away.
void borrowLight(const LivePoint& neighbour, int dx, int dy, LivePoint& point) {
    if (!neighbour.lit()) return;
    constexpr int kPixel = static_cast<int>(kOffsetSteps);
    const auto moved = [](int offset, int pixels) {
        return static_cast<std::int8_t>(std::clamp(offset + pixels * kPixel, -127, 127));
    };
    point.light = neighbour.light;
    point.lights = neighbour.lights;
    point.across = moved(neighbour.across, dx);
    point.down = moved(neighbour.down, dy);
    point.age = neighbour.age;
    point.flags = neighbour.flags;
}

/// The nearest of the surfaces around that the past saw here; else the nearest of all, in its light there.
LivePoint guess(const GuidePass::Task& task, const LiveImage& present, int x, int y) {
    constexpr std::array<std::array<int, 2>, 8> kAround{
        {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
    constexpr float kSame = 0.01F;
    const ImagePlane& plane = present.plane;
    LivePoint best, nearest;
    std::array<float, kAround.size()> tried{};
    std::size_t tries = 0;
    for (const auto& [dx, dy] : kAround) {
        const int u = x + dx, v = y + dy;
        if (u < 0 || v < 0 || u >= plane.width || v >= plane.height || !task.pattern.traced(u, v)) continue;
        const LivePoint& neighbour = present.at(u, v);
        const Asked asked = onSurfaceOf(present, x, y, u, v);
        bool again = false;
        for (std::size_t k = 0; k < tries; ++k)
            again = again || std::fabs(tried[k] - asked.depth) <= kSame * asked.depth;
        if (again) continue;
        tried[tries++] = asked.depth;
        LivePoint point;
        point.depth = asked.depth;
        point.normal = neighbour.normal;
        point.flags = static_cast<std::uint8_t>(neighbour.flags & LivePoint::kViewDependent);
        if (!best.known() || point.depth < best.depth) {
            if (wasSeen(task.past, asked) && recallLight(task.past, asked, point)) best = point;
        }
        if (best.known() || (nearest.known() && nearest.depth <= point.depth)) continue;
        borrowLight(neighbour, dx, dy, point);
        nearest = point;
    }
    return best.known() ? best : nearest;
}

} // namespace

void guessPoints(const GuidePass::Task& task, const PixelArea& area, LiveImage& present) {
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) {
            if (!task.pattern.traced(x, y)) present.at(x, y) = guess(task, present, x, y);
        }
    }
}

} // namespace rtcore
