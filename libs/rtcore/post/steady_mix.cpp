#include "rtcore/post/steady_mix.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/mix_squares.h"
#include "rtcore/post/pixel_blocks.h"
#include "rtcore/post/usual_display.h"

#include <algorithm>
#include <cstddef>

namespace rtcore {

namespace {

constexpr double kFlickerCosts = 2; ///< of the net's variance, beside squared errors
/// Variances of the k of places around that of the image: before anything is known of it, and after.
constexpr double kUnknownSpread = 0.08, kSpread = 0.02;
constexpr double kFarApart = 17; ///< D over F from which on the steady image rather is wrong

/// Sums over pixels that are covered alike.
struct SteadyPool {
    double gain = 0;    ///< G
    double apart = 0;   ///< D
    double flicker = 0; ///< F
    double around = 0;  ///< F of the blocks around, too
    double unsure = 0;  ///< variance of `gain`
    double pixels = 0;

    void add(const SteadyPool& other, double times) {
        gain += other.gain * times;
        apart += other.apart * times;
        flicker += other.flicker * times;
        around += other.around * times;
        unsure += other.unsure * times;
        pixels += other.pixels * times;
    }
    double whole() const { return apart + kFlickerCosts * flicker; }
    double fraction() const { return gain / whole(); }
    double variance() const { return unsure / (whole() * whole()); }
};

SteadyPool steadyPoolOf(const SteadyMixInput& input, const NetImages& net, std::size_t i, double weight) {
    const Colour between = input.halves.first.pixels[i] - input.halves.second.pixels[i];
    const Colour ofNets = net.first.pixels[i] - net.second.pixels[i];
    const Colour away = input.steady.pixels[i] - net.all.pixels[i];
    const Colour fromSampled = input.steady.pixels[i] - input.sampled.pixels[i];
    SteadyPool pool{.gain = (meanProduct(fromSampled, away) - meanProduct(ofNets, between) / 4) * weight,
                    .apart = squared(away) * weight,
                    .flicker = squared(ofNets) / 4 * weight,
                    .pixels = 1};
    pool.unsure = noiseOfMean(input.halves) * squared(between) * weight * pool.apart;
    return pool;
}

bool takesSteady(const HdrImage& steady, const std::vector<PixelCoverage>& coverage, std::size_t i) {
    return coverage[i] != PixelCoverage::None && isFinite(steady.pixels[i]);
}

/// The k of the whole image.
double usualFraction(const std::vector<SteadyPool>& pools) {
    double all = 0, sum = 0;
    for (const SteadyPool& pool : pools) {
        if (pool.whole() <= 0) continue;
        const double sure = pool.pixels / (pool.variance() + kUnknownSpread);
        all += sure;
        sum += sure * pool.fraction();
    }
    return all > 0 ? std::clamp(sum / all, 0.0, 1.0) : 1;
}

/// Pools of all blocks, and of a pixel by those around it, without seams.
class SteadyPools {
  public:
    SteadyPools(const SteadyMixInput& input, const NetImages& net, [[maybe_unused]] int threads)
        : blocks_{input.sampled.width, input.sampled.height},
          pools_(2 * static_cast<std::size_t>(blocks_.columns()) * static_cast<std::size_t>(blocks_.rows())) {
        const UsualDisplay display(input.sampled, threads);
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
        for (int row = 0; row < blocks_.rows(); ++row) {
            for (int column = 0; column < blocks_.columns(); ++column) fill(input, net, display, column, row);
        }
        for (int row = 0; row < blocks_.rows(); ++row) {
            for (int column = 0; column < blocks_.columns(); ++column) {
                lookAround(column, row, PixelCoverage::Part);
                lookAround(column, row, PixelCoverage::Full);
            }
        }
    }

    /// Needs a pixel that surfaces cover.
    SteadyPool at(int x, int y, PixelCoverage coverage) const {
        const NearBlocks across(x, blocks_.columns()), down(y, blocks_.rows());
        SteadyPool pool;
        for (const auto& [row, times] : down.both()) {
            for (const auto& [column, timesAcross] : across.both())
                pool.add(pools_[indexOf(column, row, coverage)], times * timesAcross);
        }
        return pool;
    }
    const std::vector<SteadyPool>& all() const { return pools_; }

  private:
    void fill(const SteadyMixInput& input, const NetImages& net, const UsualDisplay& display, int column,
              int row) {
        blocks_.forEach(column, row, [&](int x, int y) {
            const std::size_t i = blocks_.pixel(x, y);
            if (!takesSteady(input.steady, input.coverage, i)) return;
            const double weight = display.weight(luminance(net.all.pixels[i]));
            pools_[indexOf(column, row, input.coverage[i])].add(steadyPoolOf(input, net, i, weight), 1);
        });
    }
    /// The mean variance of 3 x 3 blocks, for as many pixels as the middle one has.
    void lookAround(int column, int row, PixelCoverage coverage) {
        double flicker = 0, pixels = 0;
        for (int v = std::max(row - 1, 0); v <= std::min(row + 1, blocks_.rows() - 1); ++v) {
            for (int u = std::max(column - 1, 0); u <= std::min(column + 1, blocks_.columns() - 1); ++u) {
                const SteadyPool& pool = pools_[indexOf(u, v, coverage)];
                flicker += pool.flicker;
                pixels += pool.pixels;
            }
        }
        SteadyPool& middle = pools_[indexOf(column, row, coverage)];
        middle.around = pixels > 0 ? flicker / pixels * middle.pixels : 0;
    }
    std::size_t indexOf(int column, int row, PixelCoverage coverage) const {
        return 2 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks_.columns()) +
                    static_cast<std::size_t>(column)) +
               (coverage == PixelCoverage::Full ? 1 : 0);
    }

    PixelBlocks blocks_;
    std::vector<SteadyPool> pools_;
};

/// k: 1 where both images are the same.
double fractionOfNet(const SteadyPool& pool, double usual) {
    if (pool.whole() <= 0) return 1;
    const double variance = pool.variance();
    const double known = (pool.fraction() * kSpread + usual * variance) / (kSpread + variance);
    const double k = std::clamp(known, 0.0, 1.0);
    const double apart = squared(pool.apart), varies = squared(kFarApart * pool.around);
    return apart > 0 ? k + (1 - k) * (apart / (apart + varies)) : k;
}

Colour between(Colour steady, Colour net, float k) { return k == 1 ? net : steady + (net - steady) * k; }

} // namespace

void mixWithSteady(const SteadyMixInput& input, const NetImages& net, [[maybe_unused]] int threads) {
    const SteadyPools pools(input, net, threads);
    const double usual = usualFraction(pools.all());
    const PixelBlocks pixels{input.steady.width, input.steady.height};
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < pixels.height; ++y) {
        for (int x = 0; x < pixels.width; ++x) {
            const std::size_t i = pixels.pixel(x, y);
            if (!takesSteady(input.steady, input.coverage, i)) continue;
            const auto k = static_cast<float>(fractionOfNet(pools.at(x, y, input.coverage[i]), usual));
            for (HdrImage* image : {&net.all, &net.first, &net.second})
                image->pixels[i] = between(input.steady.pixels[i], image->pixels[i], k);
        }
    }
}

void mixEvenly(const HdrImage& steady, const std::vector<PixelCoverage>& coverage, HdrImage& net,
               [[maybe_unused]] int threads) {
    const PixelBlocks pixels{steady.width, steady.height};
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < pixels.height; ++y) {
        for (int x = 0; x < pixels.width; ++x) {
            const std::size_t i = pixels.pixel(x, y);
            if (takesSteady(steady, coverage, i))
                net.pixels[i] = between(steady.pixels[i], net.pixels[i], 0.5F);
        }
    }
}

} // namespace rtcore
