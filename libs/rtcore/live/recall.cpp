#include "rtcore/live/recall.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/live/recall.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"

#ifndef RTCORE_LIVE_RECALL_TYPES
#define RTCORE_LIVE_RECALL_TYPES
namespace rtcore {

/// Where what is found of the points goes to.
struct RecalledArrays {
    std::uint32_t* from;
    float *across, *down;
    std::uint32_t* seen;
};

} // namespace rtcore
#endif

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

namespace {

constexpr float kSameNormal = 0.94F; ///< cosine of 20 degrees
constexpr float kSamePlane = 0.01F;  ///< of the depth
constexpr float kFarthest = 1.5F;    ///< pixels to where the light is from

/// LivePoints of pixels, of which each is so many words.
constexpr std::int32_t kWords = sizeof(LivePoint) / sizeof(std::uint32_t);
constexpr std::size_t kDepthWord = offsetof(LivePoint, depth) / sizeof(std::uint32_t);
constexpr std::size_t kNormalWord = offsetof(LivePoint, normal) / sizeof(std::uint32_t);
constexpr std::size_t kFlagsWord = offsetof(LivePoint, age) / sizeof(std::uint32_t);
static_assert(offsetof(LivePoint, normal) % 4 == 0 && offsetof(LivePoint, across) % 4 == 2 &&
              offsetof(LivePoint, down) % 4 == 3 && offsetof(LivePoint, age) % 4 == 0 &&
              offsetof(LivePoint, flags) % 4 == 1);

HWY_INLINE Uint gather(const LivePoint* points, std::size_t word, Int index) {
    const auto* const words = reinterpret_cast<const std::uint32_t*>(points) + word;
    return hn::GatherIndex(Uint::Tag(), words, index.raw);
}

/// As unpackNormal(), but of any length.
HWY_INLINE Float3 directionOf(Uint packed) {
    const auto coordinate = [](Uint bits) { return toFloat(toInt(bits & 255U)) * (2.0F / 255) - 1.0F; };
    const Float x = coordinate(packed), y = coordinate(shiftRight<8>(packed));
    const Float z = 1.0F - abs(x) - abs(y);
    const Mask below = z < 0.0F;
    return {select(below, (1.0F - abs(y)) * copySign(1.0F, x), x),
            select(below, (1.0F - abs(x)) * copySign(1.0F, y), y), z};
}

/// Tells of pixels of the past whether they saw the surface of a point.
struct Surface {
    Mask far;
    Float3 normal;
    Float limit, base, corner, right, down; ///< of the distance from its plane

    HWY_INLINE Surface(const ImagePlane& past, const Float3& position, const Float3& n, Float depth)
        : far(depth == LivePoint::kFar), normal(n), limit(kSamePlane * depth),
          base(dot(n, broadcast(past.eye) - position)), corner(dot(n, broadcast(past.towards(0.5F, 0.5F)))),
          right(dot(n, broadcast(past.right))), down(dot(n, broadcast(past.down))) {}

    HWY_INLINE Mask isThat(Float depth, Uint packed, Float x, Float y) const {
        const Mask background = depth == LivePoint::kFar;
        const Mask onPlane = abs(base + depth * (corner + x * right + y * down)) < limit;
        const Float3 there = directionOf(packed);
        const Float cosine = dot(there, normal);
        const Mask alike =
            (cosine > 0.0F) & (cosine * cosine > (kSameNormal * kSameNormal) * dot(there, there));
        return (far & background) | (onPlane & alike & (depth > 0.0F) & !(far | background));
    }
};

void recallAll(const LiveImage& past, const AskedPoints& asked, const RecalledArrays& to) {
    const ImagePlane& plane = past.plane;
    const LivePoint* const points = past.points.data();
    const auto width = static_cast<float>(plane.width), height = static_cast<float>(plane.height);
    using Value = AskedPoints::Value;
    for (std::size_t i = 0; i < asked.size(); i += lanes()) {
        const auto get = [&](Value value) { return load(asked.values(value) + i); };
        const Float depth = get(Value::Depth);
        const Float3 position{get(Value::X), get(Value::Y), get(Value::Z)};
        const Surface surface(plane, position,
                              {get(Value::NormalX), get(Value::NormalY), get(Value::NormalZ)}, depth);
        const Float3 offset = select(surface.far, position, position - broadcast(plane.eye));
        const Float along = dot(offset, broadcast(plane.axis));
        const Float atX = dot(offset, broadcast(plane.column)) / along;
        const Float atY = dot(offset, broadcast(plane.row)) / along;
        const Mask inside = (along > 0.0F) & (atX >= 0.0F) & (atY >= 0.0F) & (atX < width) & (atY < height);
        Float nearest = kFarthest * kFarthest, across = 0.0F, down = 0.0F;
        Int from = -1;
        Mask seen = noLanes();
        if (any(inside)) {
            const Float x = selectOrZero(inside, atX), y = selectOrZero(inside, atY);
            const Float ownX = floor(x), ownY = floor(y), right = floor(x + 0.5F), lower = floor(y + 0.5F);
            for (int tap = 0; tap < 4; ++tap) {
                const Float u = right - static_cast<float>(tap & 1);
                const Float v = lower - static_cast<float>(tap >> 1);
                const Mask within = inside & (u >= 0.0F) & (v >= 0.0F) & (u < width) & (v < height);
                const Int index =
                    truncate(selectOrZero(within, v)) * plane.width + truncate(selectOrZero(within, u));
                const Int word = index * kWords;
                const Uint shape = gather(points, kNormalWord, word);
                const Mask same =
                    within & surface.isThat(floatOf(gather(points, kDepthWord, word)), shape, u, v);
                seen = seen | (same & (u == ownX) & (v == ownY));
                const auto pixels = [](Int steps) { return toFloat(steps) * (1 / kOffsetSteps); };
                const Float dx = u + 0.5F + pixels(shiftRight<24>(shiftLeft<8>(toInt(shape)))) - x;
                const Float dy = v + 0.5F + pixels(shiftRight<24>(toInt(shape))) - y;
                const Float square = dx * dx + dy * dy;
                const Uint flags = gather(points, kFlagsWord, word);
                const Mask lit = (flags & (std::uint32_t{LivePoint::kLit} << 8)) != 0U;
                const Mask closer = same & lit & (square < nearest);
                nearest = select(closer, square, nearest);
                across = select(closer, dx, across);
                down = select(closer, dy, down);
                from = select(closer, index, from);
            }
        }
        store(toUint(from), to.from + i);
        store(across, to.across + i);
        store(down, to.down + i);
        store(selectOrZero(seen, Uint(1U)), to.seen + i);
    }
}

} // namespace

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(recallAll);

namespace {

constexpr std::size_t kRoom = 64; ///< no vector has more lanes

std::int8_t inSteps(float pixels) {
    return static_cast<std::int8_t>(std::lround(std::clamp(pixels * kOffsetSteps, -127.0F, 127.0F)));
}

} // namespace

void AskedPoints::push(Vec3 position, Vec3 normal, float depth) {
    if (values_[0].size() < size_ + kRoom) {
        for (std::vector<float>& values : values_) values.resize(2 * size_ + kRoom);
    }
    const float all[] = {position.x, position.y, position.z, normal.x, normal.y, normal.z, depth};
    for (std::size_t value = 0; value < kValues; ++value) values_[value][size_] = all[value];
    ++size_;
}

void RecalledPoints::recall(const LiveImage& past, const AskedPoints& asked) {
    const std::size_t room = asked.size() + kRoom;
    if (from_.size() < room) {
        from_.resize(room);
        across_.resize(room);
        down_.resize(room);
        seen_.resize(room);
    }
    HWY_DYNAMIC_DISPATCH(recallAll)(past, asked, {from_.data(), across_.data(), down_.data(), seen_.data()});
}

bool RecalledPoints::takeLight(const LiveImage& past, std::size_t i, LivePoint& point) const {
    if (from_[i] == kNone) return false;
    const LivePoint& found = past.points[from_[i]];
    point.light = found.light;
    point.lights = found.lights;
    point.across = inSteps(across_[i]);
    point.down = inSteps(down_[i]);
    point.age = static_cast<std::uint8_t>(std::min(found.age + 1, 255));
    point.flags = static_cast<std::uint8_t>(point.flags | LivePoint::kLit);
    return true;
}

} // namespace rtcore
#endif
