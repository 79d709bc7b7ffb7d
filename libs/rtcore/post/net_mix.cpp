#include "rtcore/post/net_mix.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/mix_squares.h"
#include "rtcore/post/pixel_blocks.h"
#include "rtcore/post/usual_display.h"
#include "rtcore/settings/render_settings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr double kExactCodes = 0.25, kNoisyCodes = 0.5; ///< standard errors: not seen, and nearly seen
/// Those of a pool, beyond which a pixel without noise has missed light that others around have found.
constexpr double kEvenCodes = 5, kUnevenCodes = 10;

std::size_t pixelIndex(const HdrImage& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

/// Sums over pixels that are covered alike, of squares by UsualDisplay::weight().
struct BlockPool {
    double apart = 0;  ///< D: net's image less sampled one
    double noise = 0;  ///< V, variance of the sampled image
    double kept = 0;   ///< C, of its noise in the net's image
    double nets = 0;   ///< variance of the mean of the nets of the halves
    double unsure = 0; ///< variance of a pixel's D - V + C due to noise
    double pixels = 0;

    void add(const BlockPool& other, double times) {
        apart += other.apart * times;
        noise += other.noise * times;
        kept += other.kept * times;
        nets += other.nets * times;
        unsure += other.unsure * times;
        pixels += other.pixels * times;
    }
};

BlockPool poolOf(const NetMixInput& input, std::size_t i, double weight) {
    const Colour a = input.halves.first.pixels[i], b = input.halves.second.pixels[i];
    const Colour netA = input.netFirst.pixels[i], netB = input.netSecond.pixels[i];
    const Colour between = a - b;
    BlockPool pool{.apart = squared(input.net.pixels[i] - input.sampled.pixels[i]) * weight,
                   .noise = noiseOfMean(input.halves) * squared(between) * weight,
                   .kept = ((meanProduct(netA - b, between) - meanProduct(netB - a, between)) / 2 -
                            squared(between) / 2) /
                           2 * weight,
                   .nets = squared(netA - netB) / 4 * weight,
                   .pixels = 1};
    pool.unsure = pool.noise * (pool.noise + 2 * pool.apart);
    return pool;
}

/// Expected squares of a pixel, by its pool.
struct ExpectedSquares {
    double net;   ///< of the net's image: its error, E
    double noise; ///< of the sampled image, V
    double kept;  ///< of the noise that both have, C
    double sure;  ///< E - C, less a standard error

    explicit ExpectedSquares(const BlockPool& pool) {
        const double apart = pool.apart / pool.pixels, all = pool.noise / pool.pixels;
        kept = std::clamp(pool.kept / pool.pixels, 0.0, all);
        // Halves that share the strata of a sequence differ by more than their noise explains.
        noise = std::min(all, apart + 2 * kept);
        const double wrong = apart - all + kept;
        sure = std::max(wrong - std::sqrt(pool.unsure) / pool.pixels, 0.0);
        net = std::max(apart - noise + 2 * kept, pool.nets / pool.pixels);
    }
};

/// The variance of the mean at a pixel, by those around it that are covered alike.
double noiseAround(const NetMixInput& input, int x, int y, PixelCoverage coverage) {
    const HdrImage& first = input.halves.first;
    double sum = 0;
    int pixels = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, first.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, first.width - 1); ++u) {
            const std::size_t i = pixelIndex(first, u, v);
            if (input.coverage[i] != coverage) continue;
            sum += squared(first.pixels[i] - input.halves.second.pixels[i]);
            ++pixels;
        }
    }
    return noiseOfMean(input.halves) * sum / pixels;
}

/// From 1 at `low` to 0 at `high`.
double fall(double low, double high, double x) {
    const double t = std::clamp((high - x) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}
/// 1 where the standard error is not seen, 0 where it is, or where the pool is so noisy that this says
/// nothing.
double exactness(double standardErrorInCodes, double ofPool) {
    return fall(kExactCodes, kNoisyCodes, standardErrorInCodes) * fall(kEvenCodes, kUnevenCodes, ofPool);
}

/// Squared errors of a row of blocks.
struct RowError {
    double sum = 0, largestBlock = 0;

    void add(double ofBlock, int pixels) {
        sum += ofBlock;
        largestBlock = std::max(largestBlock, ofBlock / pixels);
    }
};

void sumUp(const std::vector<RowError>& rows, EstimatedError& error) {
    double sum = 0, largest = 0;
    for (const RowError& row : rows) {
        sum += row.sum;
        largest = std::max(largest, row.largestBlock);
    }
    error.all = static_cast<float>(std::sqrt(sum / static_cast<double>(error.pixels.size())));
    error.largestBlock = static_cast<float>(std::sqrt(largest));
}

/// Pools of all blocks, and of a pixel by those around it, without seams.
class BlockPools {
  public:
    BlockPools(const NetMixInput& input, const UsualDisplay& display, [[maybe_unused]] int threads)
        : blocks_{input.sampled.width, input.sampled.height},
          pools_(2 * static_cast<std::size_t>(blocks_.columns()) * static_cast<std::size_t>(blocks_.rows())) {
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
        for (int row = 0; row < blocks_.rows(); ++row) {
            for (int column = 0; column < blocks_.columns(); ++column) fill(input, display, column, row);
        }
    }

    /// Needs a pixel that surfaces cover.
    BlockPool at(int x, int y, PixelCoverage coverage) const {
        const NearBlocks across(x, blocks_.columns()), down(y, blocks_.rows());
        BlockPool pool;
        for (const auto& [row, times] : down.both()) {
            for (const auto& [column, timesAcross] : across.both())
                pool.add(pools_[indexOf(column, row, coverage)], times * timesAcross);
        }
        return pool;
    }

    /// The same without its neighbours.
    const BlockPool& ofBlock(int x, int y, PixelCoverage coverage) const {
        return pools_[indexOf(x / PixelBlocks::kSide, y / PixelBlocks::kSide, coverage)];
    }

  private:
    void fill(const NetMixInput& input, const UsualDisplay& display, int column, int row) {
        blocks_.forEach(column, row, [&](int x, int y) {
            const std::size_t i = pixelIndex(input.sampled, x, y);
            if (input.coverage[i] == PixelCoverage::None) return;
            const double weight = display.weight(luminance(input.net.pixels[i]));
            pools_[indexOf(column, row, input.coverage[i])].add(poolOf(input, i, weight), 1);
        });
    }
    std::size_t indexOf(int column, int row, PixelCoverage coverage) const {
        return 2 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks_.columns()) +
                    static_cast<std::size_t>(column)) +
               (coverage == PixelCoverage::Full ? 1 : 0);
    }

    PixelBlocks blocks_;
    std::vector<BlockPool> pools_;
};

/// A mixed pixel with what its squared error is estimated to be, in codes.
struct MixedPixel {
    Colour colour;
    double error = 0;
};

/// k that leaves the smallest error; of less where the pixel's own noise is larger than that of its pool.
double fractionOfSampled(const ExpectedSquares& squares, double noiseAround) {
    const double noise = std::max(squares.noise, noiseAround) - squares.kept;
    return squares.sure > 0 ? squares.sure / (squares.sure + std::max(noise, 0.0)) : 0;
}

MixedPixel mixedPixel(const NetMixInput& input, const BlockPools& pools, const UsualDisplay& display, int x,
                      int y) {
    const std::size_t i = pixelIndex(input.sampled, x, y);
    const Colour sampled = input.sampled.pixels[i];
    const PixelCoverage coverage = input.coverage[i];
    if (coverage == PixelCoverage::None) return {sampled};
    const Colour net = input.net.pixels[i];
    const float light = luminance(net);
    const double weight = display.weight(light), codes = squared(display.codes(light));
    const double around = noiseAround(input, x, y, coverage);
    const ExpectedSquares smooth(pools.at(x, y, coverage)), block(pools.ofBlock(x, y, coverage));
    const bool mixes = input.halves.samples >= static_cast<std::uint32_t>(kMixedSamples);
    const double k =
        mixes ? std::max(fractionOfSampled(smooth, around * weight),
                         exactness(std::sqrt(around * codes), std::sqrt(smooth.noise / weight * codes)))
              : 0;
    const double error = squared(1 - k) * block.net + 2 * k * (1 - k) * block.kept + squared(k) * block.noise;
    return {k == 1 ? sampled : net + (sampled - net) * static_cast<float>(k),
            squared(display.codesOf(light, std::sqrt(std::max(error, 0.0) / weight)))};
}

} // namespace

EstimatedError mixWithNet(const NetMixInput& input, HdrImage& shown, int threads) {
    const HdrImage& sampled = input.sampled;
    const UsualDisplay display(sampled, threads);
    const BlockPools pools(input, display, threads);
    if (shown.width != sampled.width || shown.height != sampled.height)
        shown = HdrImage(sampled.width, sampled.height);
    const PixelBlocks blocks{sampled.width, sampled.height};
    EstimatedError error;
    error.pixels.resize(sampled.pixels.size());
    std::vector<RowError> rows(static_cast<std::size_t>(blocks.rows()));
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int row = 0; row < blocks.rows(); ++row) {
        RowError& ofRow = rows[static_cast<std::size_t>(row)];
        for (int column = 0; column < blocks.columns(); ++column) {
            double sum = 0;
            int pixels = 0;
            blocks.forEach(column, row, [&](int x, int y) {
                const MixedPixel mixed = mixedPixel(input, pools, display, x, y);
                shown.at(x, y) = mixed.colour;
                error.pixels[pixelIndex(sampled, x, y)] = static_cast<float>(std::sqrt(mixed.error));
                sum += mixed.error;
                ++pixels;
            });
            ofRow.add(sum, pixels);
        }
    }
    sumUp(rows, error);
    return error;
}

} // namespace rtcore
