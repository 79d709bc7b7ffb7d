#include "rtcore/io/import/materials/relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

namespace {

/// How high white is, in widths of the image.
constexpr float kHeightOfWhite = 0.1F;

/// The texel beside `i`; `step` is -1 or 1.
int neighbour(int i, int step, int size, TextureWrap wrap) {
    const int next = i + step;
    return wrap == TextureWrap::Repeat ? (next + size) % size : std::clamp(next, 0, size - 1);
}

float heightOf(Rgba8 p) { return static_cast<float>(p.r + p.g + p.b) / (3 * 255.0F); }

std::uint8_t codeOf(float component) {
    return static_cast<std::uint8_t>(std::lround((component * 0.5F + 0.5F) * 255));
}

/// Slopes of the relief, clamped to what codes of a byte can express: even the code of a level texel is off
/// by half a code.
std::vector<Vec2> slopesOf(const LdrImage& heights, const HeightUse& use) {
    constexpr float kSteepest = 4;
    const int width = heights.width, height = heights.height;
    const auto at = [&](int x, int y) {
        return heightOf(heights.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                       static_cast<std::size_t>(x)]);
    };
    const auto slope = [&](float difference, int texels) {
        const float rise = difference * 0.5F * kHeightOfWhite * use.scale * static_cast<float>(texels);
        return std::clamp(rise, -kSteepest, kSteepest);
    };
    std::vector<Vec2> slopes;
    slopes.reserve(heights.pixels.size());
    for (int y = 0; y < height; ++y) {
        const int above = neighbour(y, -1, height, use.v), below = neighbour(y, 1, height, use.v);
        for (int x = 0; x < width; ++x) {
            const int left = neighbour(x, -1, width, use.u), right = neighbour(x, 1, width, use.u);
            slopes.push_back(
                {slope(at(right, y) - at(left, y), width), slope(at(x, above) - at(x, below), height)});
        }
    }
    return slopes;
}

/// A colour that no height has, of the length of a normal.
bool isNormal(Rgba8 p) {
    const auto component = [](std::uint8_t code) { return static_cast<float>(code) / 127.5F - 1; };
    const Vec3 n{component(p.r), component(p.g), component(p.b)};
    const bool grey = p.r == p.g && p.g == p.b;
    return !grey && n.z > 0 && std::fabs(dot(n, n) - 1) < 0.3F;
}

} // namespace

NormalImage normalsOfHeights(const LdrImage& heights, const HeightUse& use) {
    const std::vector<Vec2> slopes = slopesOf(heights, use);
    float steepest = 0;
    for (const Vec2 s : slopes) steepest = std::max({steepest, std::fabs(s.x), std::fabs(s.y)});
    NormalImage out{heights, steepest > 0 ? steepest : 1};
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const Vec3 n = normalize(Vec3{-slopes[i].x / out.scale, -slopes[i].y / out.scale, 1});
        out.image.pixels[i] = {codeOf(n.x), codeOf(n.y), codeOf(n.z), 255};
    }
    return out;
}

bool holdsNormals(const LdrImage& image) {
    const auto normals = static_cast<std::size_t>(std::ranges::count_if(image.pixels, isNormal));
    return normals * 10 > image.pixels.size() * 9;
}

} // namespace rtcore
