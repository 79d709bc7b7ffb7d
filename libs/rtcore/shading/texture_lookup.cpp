#include "rtcore/shading/texture_lookup.h"

#include <array>
#include <cmath>

namespace rtcore {

namespace {

const std::array<float, 256>& linearOfCode() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgbDecode(static_cast<float>(i) / 255);
        return t;
    }();
    return table;
}

/// Texel index and weight of its neighbour for a coordinate in units of the whole picture.
struct Tap {
    std::uint32_t first, second;
    float share;
};

Tap tapAt(float coordinate, std::uint32_t size) {
    const float wrapped = coordinate - std::floor(coordinate);
    if (!(wrapped >= 0 && wrapped <= 1)) return {0, 0, 0}; // not finite
    const float x = wrapped * static_cast<float>(size) - 0.5F;
    const float whole = std::floor(x);
    // From -1 to size, since float rounds: wrapped by comparisons, which cost less than a remainder.
    const auto base = static_cast<std::int64_t>(whole);
    const auto n = static_cast<std::int64_t>(size);
    const auto wrap = [n](std::int64_t i) { return static_cast<std::uint32_t>(i < 0 ? i + n : i >= n ? i - n : i); };
    return {wrap(base), wrap(base + 1), x - whole};
}

TextureSample sampleOf(Rgba8 p) {
    const std::array<float, 256>& linear = linearOfCode();
    return {{linear[p.r], linear[p.g], linear[p.b]},
            static_cast<float>(p.a) / 255,
            {static_cast<float>(p.r) / 255, static_cast<float>(p.g) / 255, static_cast<float>(p.b) / 255}};
}

/// Exact where both are equal, so that what is solid all over has no hole.
TextureSample mix(const TextureSample& a, const TextureSample& b, float share) {
    return {a.colour + (b.colour - a.colour) * share, a.alpha + (b.alpha - a.alpha) * share,
            a.stored + (b.stored - a.stored) * share};
}

} // namespace

TextureSample sampleTexture(const Model& model, const Texture& texture, Vec2 uv) {
    const Tap x = tapAt(uv.x, texture.width);
    const Tap y = tapAt(1 - uv.y, texture.height);
    const auto texel = [&](std::uint32_t column, std::uint32_t row) {
        return sampleOf(model.texels[texture.firstTexel + std::uint64_t{row} * texture.width + column]);
    };
    const TextureSample upper = mix(texel(x.first, y.first), texel(x.second, y.first), x.share);
    const TextureSample lower = mix(texel(x.first, y.second), texel(x.second, y.second), x.share);
    return mix(upper, lower, y.share);
}

} // namespace rtcore
