#include "rtcore/scene/image_summary.h"

#include <algorithm>
#include <cstdint>

namespace rtcore {

namespace {

/// How often each code occurs: the transfer curve is evaluated 256 times, whatever the size.
class CodeCounts {
  public:
    void add(Rgba8 p) {
        ++count_[0][p.r];
        ++count_[1][p.g];
        ++count_[2][p.b];
        ++count_[3][p.a];
    }

    ImageSummary summary(std::size_t texels) const {
        const auto total = static_cast<double>(texels);
        std::array<double, 4> linear{}, code{};
        for (std::size_t v = 0; v < 256; ++v) {
            const float encoded = static_cast<float>(v) / 255;
            for (std::size_t c = 0; c < 4; ++c) {
                const double fraction = static_cast<double>(count_[c][v]) / total;
                linear[c] += fraction * srgbDecode(encoded);
                code[c] += fraction * encoded;
            }
        }
        ImageSummary s;
        s.meanColour = {static_cast<float>(linear[0]), static_cast<float>(linear[1]),
                        static_cast<float>(linear[2])};
        for (std::size_t c = 0; c < 4; ++c) s.meanChannel[c] = static_cast<float>(code[c]);
        s.transparent = count_[3][255] != texels;
        s.dark = count_[0][255] != texels;
        return s;
    }

  private:
    std::array<std::array<std::uint64_t, 256>, 4> count_{};
};

/// Block by block, those of the right and of the lower edge as far as they are in the image.
CodeCounts countBlocks(const Model& model, const Texture& texture) {
    CodeCounts counts;
    const TexelBlock* block = model.blocks.data() + texture.firstTexel;
    for (std::uint32_t top = 0; top < texture.height; top += kBlockSide) {
        const std::uint32_t rows = std::min(kBlockSide, texture.height - top);
        for (std::uint32_t left = 0; left < texture.width; left += kBlockSide, ++block) {
            const std::uint32_t columns = std::min(kBlockSide, texture.width - left);
            for (std::uint32_t y = 0; y < rows; ++y)
                for (std::uint32_t x = 0; x < columns; ++x) counts.add(texelOf(*block, kBlockSide * y + x));
        }
    }
    return counts;
}

} // namespace

ImageSummary summarise(std::span<const Rgba8> texels) {
    CodeCounts counts;
    for (const Rgba8 p : texels) counts.add(p);
    return counts.summary(texels.size());
}

ImageSummary summarise(const Model& model, const Texture& texture) {
    const std::size_t texels = std::size_t{texture.width} * texture.height;
    if (texture.inBlocks()) return countBlocks(model, texture).summary(texels);
    return summarise(model.texels.subspan(texture.firstTexel, texels));
}

} // namespace rtcore
