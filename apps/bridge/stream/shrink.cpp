#include "bridge/stream/shrink.h"

#include <algorithm>
#include <cstdint>

namespace bridge {

namespace {

/// A pixel of a row or column, and its weight in the sum.
struct Weight {
    int pixel;
    float part;
};

/// The source pixels, `from` in all, that each of `to` pixels covers, with weights that add up to 1.
class Covering {
  public:
    Covering(int from, int to) {
        // In units in which a pixel of `from` is `to` wide, and one of `to` is `from` wide.
        const std::int64_t is = to, wanted = from;
        for (std::int64_t i = 0; i < to; ++i) {
            starts_.push_back(weights_.size());
            const std::int64_t start = i * wanted, end = start + wanted;
            for (std::int64_t j = start / is; j * is < end; ++j) {
                const std::int64_t covered = std::min((j + 1) * is, end) - std::max(j * is, start);
                weights_.push_back(
                    {static_cast<int>(j), static_cast<float>(covered) / static_cast<float>(wanted)});
            }
        }
        starts_.push_back(weights_.size());
    }
    std::span<const Weight> of(int i) const {
        const auto at = static_cast<std::size_t>(i);
        return std::span(weights_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
    }

  private:
    std::vector<Weight> weights_;
    std::vector<std::size_t> starts_;
};

} // namespace

Pixels shrink(const Pixels& pixels, int width, int height, std::vector<std::byte>& out) {
    const Covering across(pixels.width, width), down(pixels.height, height);
    const auto* const in = reinterpret_cast<const unsigned char*>(pixels.bytes.data());
    const std::size_t row = 4 * static_cast<std::size_t>(pixels.width);
    std::vector<float> sums(row);
    out.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    auto* to = reinterpret_cast<unsigned char*>(out.data());
    for (int y = 0; y < height; ++y) {
        std::fill(sums.begin(), sums.end(), 0.5F); // rounds
        for (const Weight& weight : down.of(y)) {
            const unsigned char* const line = in + row * static_cast<std::size_t>(weight.pixel);
            for (std::size_t i = 0; i < row; ++i) sums[i] += weight.part * static_cast<float>(line[i]);
        }
        for (int x = 0; x < width; ++x, to += 4) {
            float mean[3] = {};
            for (const Weight& weight : across.of(x))
                for (std::size_t c = 0; c < 3; ++c)
                    mean[c] += weight.part * sums[4 * static_cast<std::size_t>(weight.pixel) + c];
            for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<unsigned char>(std::min(mean[c], 255.0F));
            to[3] = 255;
        }
    }
    return {out, width, height};
}

} // namespace bridge
