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

plain::Taps<float> tapsAt(float coordinate, std::uint32_t size, TextureWrap wrap, TextureFilter filter) {
    const plain::Taps<float> taps =
        wrap == TextureWrap::Repeat
            ? plain::tapsAt<true, float>(coordinate, size, 0)
            : plain::tapsAt<false, float>(coordinate, size, static_cast<std::uint32_t>(wrap));
    return filter == TextureFilter::Linear ? taps : plain::sharpened<float>(taps, true);
}

Colour colourOf(Rgba8 p) { return {kLinear[p.r], kLinear[p.g], kLinear[p.b]}; }

TextureSample sampleOf(Rgba8 p) {
    return {colourOf(p),
            static_cast<float>(p.a) / 255,
            {static_cast<float>(p.r) / 255, static_cast<float>(p.g) / 255, static_cast<float>(p.b) / 255}};
}

Colour mix(Colour a, Colour b, float fraction) { return plain::mix(a, b, fraction); }
TextureSample mix(const TextureSample& a, const TextureSample& b, float fraction) {
    return {mix(a.colour, b.colour, fraction), plain::mix(a.alpha, b.alpha, fraction),
            plain::mix(a.stored, b.stored, fraction)};
}

/// Texels of one row, by columns.
struct PlainRow {
    const Rgba8* texels;
    PlainRow(const Model& model, const Texture& texture, std::uint32_t y)
        : texels(model.texels.data() + texture.firstTexel + std::uint64_t{y} * texture.width) {}
    Rgba8 operator[](std::uint32_t x) const { return texels[x]; }
};
struct BlockRow {
    const TexelBlock* blocks;
    std::uint32_t row;
    BlockRow(const Model& model, const Texture& texture, std::uint32_t y)
        : blocks(model.blocks.data() + texture.firstTexel), row(plain::rowInBlocks(y, texture.width)) {}
    Rgba8 operator[](std::uint32_t x) const { return texelIn(blocks, row + plain::columnInBlocks(x)); }
};

/// `valueOf` a texel, bilinear.
template <typename Row, typename ValueOf>
auto lookUpIn(const Model& model, const Texture& texture, Vec2 uv, ValueOf&& valueOf) {
    const plain::Taps<float> x = tapsAt(uv.x, texture.width, texture.wrapU, texture.filter);
    const plain::Taps<float> y = tapsAt(1 - uv.y, texture.height, texture.wrapV, texture.filter);
    const Row upperRow(model, texture, y.first), lowerRow(model, texture, y.second);
    const auto upper = mix(valueOf(upperRow[x.first]), valueOf(upperRow[x.second]), x.fraction);
    const auto lower = mix(valueOf(lowerRow[x.first]), valueOf(lowerRow[x.second]), x.fraction);
    return mix(upper, lower, y.fraction);
}

template <typename ValueOf>
auto lookUp(const Model& model, const Texture& texture, Vec2 uv, ValueOf&& valueOf) {
    return texture.inBlocks() ? lookUpIn<BlockRow>(model, texture, uv, valueOf)
                              : lookUpIn<PlainRow>(model, texture, uv, valueOf);
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
