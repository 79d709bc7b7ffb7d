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
    asked_.clear();
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        LivePoint& point = present.at(pixels_[i].x, pixels_[i].y) = {};
        const std::uint32_t found = surfaces_.traits[i];
        if (found == 0) {
            point.depth = LivePoint::kFar;
            asked_.push({rays_.dx[i], rays_.dy[i], rays_.dz[i]}, {}, point.depth);
            continue;
        }
        const Vec3 position = surfaces_.position.at(i), normal = surfaces_.geometricNormal.at(i);
        point.depth = dot(plane.axis, position - plane.eye);
        point.normal = packNormal(normal);
        if ((found & (traits::kMirror | traits::kGeneral)) != 0) point.flags = LivePoint::kViewDependent;
        asked_.push(position, normal, point.depth);
    }
    recalled_.recall(task.past, asked_);
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        recalled_.takeLight(task.past, i, present.at(pixels_[i].x, pixels_[i].y));
}

// --- Pixels without rays ---

namespace {

constexpr std::array<std::array<int, 2>, 8> kAround{
    {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

/// The depth of a pixel if it sees the plane of a neighbour's surface.
float depthOnSurface(const LiveImage& present, Vec3 towards, Vec3 normal, int x, int y) {
    constexpr float kGrazing = 1e-4F, kMostChange = 0.3F;
    const float known = present.at(x, y).depth, slope = dot(normal, towards);
    if (!(slope * slope > kGrazing * kGrazing * dot(towards, towards))) return known;
    const float depth = dot(normal, present.offsetFromEye(x, y)) / slope;
    return std::fabs(depth - known) < kMostChange * known ? depth : known;
}

/// Neighbours of one surface, as far as can be told at a glance.
bool alike(const LivePoint& a, const LivePoint& b) {
    constexpr float kSame = 0.01F;
    return a.normal == b.normal && std::fabs(a.depth - b.depth) <= kSame * a.depth;
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

} // namespace

/// One for each surface around the pixel.
void GuidePass::collectGuesses(const Task& task, const LiveImage& present, int x, int y) {
    const ImagePlane& plane = present.plane;
    const Vec3 towards = plane.towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    const std::size_t first = guesses_.size();
    for (const auto& [dx, dy] : kAround) {
        const int u = x + dx, v = y + dy;
        if (u < 0 || v < 0 || u >= plane.width || v >= plane.height || !task.pattern.traced(u, v)) continue;
        const LivePoint& neighbour = present.at(u, v);
        const auto sameAs = [&](const Guess& other) {
            return alike(neighbour, present.at(other.neighbour.x, other.neighbour.y));
        };
        if (std::any_of(guesses_.begin() + static_cast<std::ptrdiff_t>(first), guesses_.end(), sameAs))
            continue;
        if (neighbour.far()) {
            guesses_.push_back({{x, y}, {u, v}, LivePoint::kFar});
            asked_.push(towards, {}, LivePoint::kFar);
            continue;
        }
        const Vec3 normal = unpackNormal(neighbour.normal);
        const float depth = depthOnSurface(present, towards, normal, u, v);
        guesses_.push_back({{x, y}, {u, v}, depth});
        asked_.push(plane.eye + towards * depth, normal, depth);
    }
}

/// The nearest of the surfaces around that the past saw there; else the nearest of all, in its light here.
LivePoint GuidePass::bestGuess(const Task& task, const LiveImage& present, std::size_t first,
                               std::size_t last) const {
    LivePoint best, nearest;
    for (std::size_t i = first; i < last; ++i) {
        const Guess& guess = guesses_[i];
        const LivePoint& neighbour = present.at(guess.neighbour.x, guess.neighbour.y);
        LivePoint point;
        point.depth = guess.depth;
        point.normal = neighbour.normal;
        point.flags = static_cast<std::uint8_t>(neighbour.flags & LivePoint::kViewDependent);
        const bool nearer = !best.known() || point.depth < best.depth;
        if (nearer && recalled_.wasSeen(i) && recalled_.takeLight(task.past, i, point)) best = point;
        if (best.known() || (nearest.known() && nearest.depth <= point.depth)) continue;
        borrowLight(neighbour, guess.neighbour.x - guess.pixel.x, guess.neighbour.y - guess.pixel.y, point);
        nearest = point;
    }
    return best.known() ? best : nearest;
}

void GuidePass::guess(const Task& task, const PixelArea& area, LiveImage& present) {
    asked_.clear();
    guesses_.clear();
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) {
            if (!task.pattern.traced(x, y)) collectGuesses(task, present, x, y);
        }
    }
    recalled_.recall(task.past, asked_);
    for (std::size_t first = 0; first < guesses_.size();) {
        const Pixel pixel = guesses_[first].pixel;
        std::size_t last = first;
        while (last < guesses_.size() && guesses_[last].pixel == pixel) ++last;
        present.at(pixel.x, pixel.y) = bestGuess(task, present, first, last);
        first = last;
    }
}

} // namespace rtcore
