#include "rtcore/shading/texture_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

/// Linear light of each code.
const std::array<float, 256> kLinear = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgbDecode(static_cast<float>(i) / 255);
    return t;
}();

/// std::floor() without a call; -0 becomes 0.
float floorOf(float x) {
    constexpr float kWholeFromHere = 0x1p23F;
    if (!(std::fabs(x) < kWholeFromHere)) return x;
    const auto whole = static_cast<float>(static_cast<std::int32_t>(x));
    return whole > x ? whole - 1 : whole;
}

/// Texel index and weight of its neighbour for a coordinate in units of the whole picture.
struct Tap {
    std::uint32_t first, second;
    float share;
};

/// Where in the picture a coordinate lies, 0..1, or nowhere: not a number.
float wrapped(float coordinate, TextureWrap wrap) {
    if (wrap == TextureWrap::Repeat) return coordinate - floorOf(coordinate);
    if (wrap == TextureWrap::ClampToEdge) return std::min(std::max(coordinate, 0.0F), 1.0F);
    const float pair = coordinate * 0.5F;
    return 1 - std::fabs(1 - 2 * (pair - floorOf(pair)));
}

Tap tapAt(float coordinate, std::uint32_t size, TextureWrap wrap) {
    const float inside = wrapped(coordinate, wrap);
    if (!(inside >= 0 && inside <= 1)) return {0, 0, 0}; // not a number
    const float x = inside * static_cast<float>(size) - 0.5F;
    const float whole = floorOf(x);
    // From -1 to size, since float rounds: brought back by comparisons, which cost less than a remainder.
    const auto base = static_cast<std::int64_t>(whole);
    const auto n = static_cast<std::int64_t>(size);
    const bool repeats = wrap == TextureWrap::Repeat;
    const auto texel = [n, repeats](std::int64_t i) {
        const std::int64_t below = repeats ? i + n : 0, above = repeats ? i - n : n - 1;
        return static_cast<std::uint32_t>(i < 0 ? below : i >= n ? above : i);
    };
    return {texel(base), texel(base + 1), x - whole};
}

Colour colourOf(Rgba8 p) { return {kLinear[p.r], kLinear[p.g], kLinear[p.b]}; }

TextureSample sampleOf(Rgba8 p) {
    return {colourOf(p),
            static_cast<float>(p.a) / 255,
            {static_cast<float>(p.r) / 255, static_cast<float>(p.g) / 255, static_cast<float>(p.b) / 255}};
}

/// Exact where both are equal, so that what is solid all over has no hole.
Colour mix(Colour a, Colour b, float share) { return a + (b - a) * share; }
TextureSample mix(const TextureSample& a, const TextureSample& b, float share) {
    return {mix(a.colour, b.colour, share), a.alpha + (b.alpha - a.alpha) * share,
            a.stored + (b.stored - a.stored) * share};
}

/// `valueOf` a texel, bilinear.
template <typename ValueOf>
auto lookUp(const Model& model, const Texture& texture, Vec2 uv, ValueOf&& valueOf) {
    const Tap x = tapAt(uv.x, texture.width, texture.wrapU);
    const Tap y = tapAt(1 - uv.y, texture.height, texture.wrapV);
    const Rgba8* const texels = model.texels.data() + texture.firstTexel;
    const Rgba8* const upperRow = texels + std::uint64_t{y.first} * texture.width;
    const Rgba8* const lowerRow = texels + std::uint64_t{y.second} * texture.width;
    const auto upper = mix(valueOf(upperRow[x.first]), valueOf(upperRow[x.second]), x.share);
    const auto lower = mix(valueOf(lowerRow[x.first]), valueOf(lowerRow[x.second]), x.share);
    return mix(upper, lower, y.share);
}

} // namespace

const float* linearOfCodes() { return kLinear.data(); }

TextureSample sampleTexture(const Model& model, const Texture& texture, Vec2 uv) {
    return lookUp(model, texture, uv, sampleOf);
}

Colour sampleColour(const Model& model, const Texture& texture, Vec2 uv) {
    return lookUp(model, texture, uv, colourOf);
}

} // namespace rtcore
