#include "rtcore/shading/surface/texture_lookup.h"

#include "rtcore/shading/surface/texture-inl.h"

#include <algorithm>
#include <array>

namespace rtcore {

namespace {

namespace plain = HWY_NAMESPACE;

/// Linear light of each code.
const std::array<float, 256> kLinear = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgbDecode(static_cast<float>(i) / 255);
    return t;
}();

plain::Taps<float> tapsAt(float coordinate, std::uint32_t size, TextureWrap wrap) {
    if (wrap == TextureWrap::Repeat) return plain::tapsAt<true, float>(coordinate, size, 0);
    return plain::tapsAt<false, float>(coordinate, size, static_cast<std::uint32_t>(wrap));
}

Colour colourOf(Rgba8 p) { return {kLinear[p.r], kLinear[p.g], kLinear[p.b]}; }

TextureSample sampleOf(Rgba8 p) {
    return {colourOf(p),
            static_cast<float>(p.a) / 255,
            {static_cast<float>(p.r) / 255, static_cast<float>(p.g) / 255, static_cast<float>(p.b) / 255}};
}

Colour mix(Colour a, Colour b, float share) { return plain::mix(a, b, share); }
TextureSample mix(const TextureSample& a, const TextureSample& b, float share) {
    return {mix(a.colour, b.colour, share), plain::mix(a.alpha, b.alpha, share),
            plain::mix(a.stored, b.stored, share)};
}

/// `valueOf` a texel, bilinear.
template <typename ValueOf>
auto lookUp(const Model& model, const Texture& texture, Vec2 uv, ValueOf&& valueOf) {
    const plain::Taps<float> x = tapsAt(uv.x, texture.width, texture.wrapU);
    const plain::Taps<float> y = tapsAt(1 - uv.y, texture.height, texture.wrapV);
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
