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
    const auto base = static_cast<std::int64_t>(whole);
    const auto n = static_cast<std::int64_t>(size);
    return {static_cast<std::uint32_t>((base + n) % n), static_cast<std::uint32_t>((base + 1) % n), x - whole};
}

} // namespace

TextureSample sampleTexture(const Model& model, const Texture& texture, Vec2 uv) {
    const std::array<float, 256>& linear = linearOfCode();
    const Tap x = tapAt(uv.x, texture.width);
    const Tap y = tapAt(1 - uv.y, texture.height);
    const auto texel = [&](std::uint32_t column, std::uint32_t row) {
        return model.texels[texture.firstTexel + std::uint64_t{row} * texture.width + column];
    };
    TextureSample sum{{}, 0, 0};
    const auto add = [&](std::uint32_t column, std::uint32_t row, float weight) {
        const Rgba8 p = texel(column, row);
        sum.colour += Colour{linear[p.r], linear[p.g], linear[p.b]} * weight;
        sum.alpha += static_cast<float>(p.a) / 255 * weight;
        sum.mask += static_cast<float>(p.r) / 255 * weight;
    };
    add(x.first, y.first, (1 - x.share) * (1 - y.share));
    add(x.second, y.first, x.share * (1 - y.share));
    add(x.first, y.second, (1 - x.share) * y.share);
    add(x.second, y.second, x.share * y.share);
    return sum;
}

} // namespace rtcore
