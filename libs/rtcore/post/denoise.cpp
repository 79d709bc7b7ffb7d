#include "rtcore/post/denoise.h"

#include "rtcore/platform/threads.h"
#include "rtcore/post/denoise_tap.h"
#include "rtcore/settings/integrator_traits.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rtcore {

namespace {

constexpr float kMinAlbedo = 0.01F;
constexpr float kPlane = 0.01F;  ///< fraction of the distance within which points lie in one plane
constexpr float kDeviations = 6; ///< standard deviations of the noise within which light is alike
constexpr int kNoiseBlock = 8;   ///< pixels a side, for the noise
/// The standard deviation of a pixel minus the mean of its four neighbours, relative to that of the pixel.
constexpr float kWithNeighbours = 1.1180F;

} // namespace

void Denoiser::resize(int width, int height) {
    width_ = width;
    height_ = height;
    const std::size_t count = row(height);
    for (Plane* const plane : {&nearness_, &across_, &down_, &bright_, &noise_}) plane->resize(count);
    for (std::size_t i = 0; i < 3; ++i) {
        for (Plane* const plane : {&normal_[i], &albedo_[i], &light_[i], &result_[i]}) plane->resize(count);
    }
    if (image_.width != width || image_.height != height) image_ = HdrImage(width, height);
}

/// `all`: light of the background is filtered, too. In a pixel that a surface covers in part, the background
/// then counts as what scatters all of its light, or the surface's part would seem to have it.
void Denoiser::fillGuides(const Aovs& aovs, bool all, [[maybe_unused]] int threads) {
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        for (std::size_t i = row(y); i < row(y + 1); ++i) {
            const AovPixel& pixel = aovs.pixels()[i];
            const Vec3 normal = normalize(pixel.normal);
            const bool there = pixel.covered > 0 && pixel.depth > 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                normal_[axis][i] = there ? normal[static_cast<int>(axis)] : 0;
            }
            nearness_[i] = there ? 1 / pixel.depth : 0;
            const float background = all && there ? 1 - pixel.covered : 0;
            albedo_[0][i] = std::max(pixel.albedo.r + background, kMinAlbedo);
            albedo_[1][i] = std::max(pixel.albedo.g + background, kMinAlbedo);
            albedo_[2][i] = std::max(pixel.albedo.b + background, kMinAlbedo);
        }
    }
}

/// Returns whether there is any.
bool Denoiser::fillLight(const HdrImage& picture, const Aovs& aovs, bool all, [[maybe_unused]] int threads) {
    bool any = false;
#pragma omp parallel for schedule(static) reduction(|| : any) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        for (std::size_t i = row(y); i < row(y + 1); ++i) {
            const Colour c = all ? picture.pixels[i] : aovs.pixels()[i].soft;
            const bool usable = isFinite(c);
            any = any || (usable && !isBlack(c));
            light_[0][i] = usable ? c.r / albedo_[0][i] : 0;
            light_[1][i] = usable ? c.g / albedo_[1][i] : 0;
            light_[2][i] = usable ? c.b / albedo_[2][i] : 0;
            bright_[i] = luminance({light_[0][i], light_[1][i], light_[2][i]});
        }
    }
    return any;
}

/// Each slope is the smaller of the steps to both sides, so that edges do not count.
void Denoiser::fillSlopes([[maybe_unused]] int threads) {
    const auto smaller = [](float before, float here, float after) {
        const float a = here - before, b = after - here;
        return std::fabs(a) < std::fabs(b) ? a : b;
    };
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        const float* const here = &nearness_[row(y)];
        const float* const above = &nearness_[row(std::max(y - 1, 0))];
        const float* const below = &nearness_[row(std::min(y + 1, height_ - 1))];
        for (int x = 0; x < width_; ++x) {
            const std::size_t i = row(y) + static_cast<std::size_t>(x);
            const int left = std::max(x - 1, 0), right = std::min(x + 1, width_ - 1);
            // At the border there is one side only.
            across_[i] = left == x    ? here[right] - here[x]
                         : right == x ? here[x] - here[left]
                                      : smaller(here[left], here[x], here[right]);
            down_[i] = y == 0             ? below[x] - here[x]
                       : y == height_ - 1 ? here[x] - above[x]
                                          : smaller(above[x], here[x], below[x]);
        }
    }
}

/// Whether both are of one surface, as far as neighbours can tell.
bool Denoiser::alike(std::size_t a, std::size_t b) const {
    const float cosine =
        normal_[0][a] * normal_[0][b] + normal_[1][a] * normal_[1][b] + normal_[2][a] * normal_[2][b];
    return cosine > 0.95F && std::fabs(nearness_[a] - nearness_[b]) < 0.05F * nearness_[a];
}

/// Statistics of the brightness of the surface around a pixel.
struct Denoiser::Around {
    float first = 0, second = 0; ///< the brightest of its neighbours
    float sum = 0, squares = 0;
    int count = 0;

    void add(float bright) {
        second = std::max(second, std::min(first, bright));
        first = std::max(first, bright);
        sum += bright;
        squares += bright * bright;
        ++count;
    }
    /// Whether it is far brighter than the neighbours, the brightest of them apart, make likely.
    bool isSpike(float bright) const {
        constexpr int kEnough = 4;
        constexpr float kSpike = 4; // standard deviations
        if (count < kEnough || bright <= second) return false;
        const auto others = static_cast<float>(count - 1);
        const float mean = (sum - first) / others;
        const float variance = std::max((squares - first * first) / others - mean * mean, 0.0F);
        return bright > mean + kSpike * std::sqrt(variance);
    }
};

/// A path that found a small bright thing by chance makes a pixel that is far brighter than all around it. It
/// counts as bright as the second brightest of its neighbours: edges, lines and patches stay, dots and pairs
/// of dots do not.
void Denoiser::dropSpikes([[maybe_unused]] int threads) {
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const std::size_t i = row(y) + static_cast<std::size_t>(x);
            Around around;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height_ - 1); ++v) {
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width_ - 1); ++u) {
                    const std::size_t j = row(v) + static_cast<std::size_t>(u);
                    if (j != i && alike(i, j)) around.add(bright_[j]);
                }
            }
            const float kept = around.isSpike(bright_[i]) ? around.second / bright_[i] : 1;
            for (std::size_t c = 0; c < 3; ++c) result_[c][i] = light_[c][i] * kept;
        }
    }
    for (std::size_t c = 0; c < 3; ++c) light_[c].swap(result_[c]);
    brighten(threads);
}

/// Computes the brightness of the light as it is now.
void Denoiser::brighten([[maybe_unused]] int threads) {
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        for (std::size_t i = row(y); i < row(y + 1); ++i)
            bright_[i] = luminance({light_[0][i], light_[1][i], light_[2][i]});
    }
}

void Denoiser::measureNoise([[maybe_unused]] int threads) {
    const int columns = (width_ + kNoiseBlock - 1) / kNoiseBlock,
              rows = (height_ + kNoiseBlock - 1) / kNoiseBlock;
    blocks_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int block = 0; block < columns * rows; ++block) {
        float sum = 0;
        int count = 0;
        const int left = block % columns * kNoiseBlock, top = block / columns * kNoiseBlock;
        for (int y = std::max(top, 1); y < std::min(top + kNoiseBlock, height_ - 1); ++y) {
            for (int x = std::max(left, 1); x < std::min(left + kNoiseBlock, width_ - 1); ++x) {
                const std::size_t i = row(y) + static_cast<std::size_t>(x);
                const std::size_t around[4] = {i - 1, i + 1, i - row(1), i + row(1)};
                if (!std::all_of(around, around + 4, [&](std::size_t j) { return alike(i, j); })) continue;
                const float mean = 0.25F * (bright_[around[0]] + bright_[around[1]] + bright_[around[2]] +
                                            bright_[around[3]]);
                const float difference = bright_[i] - mean;
                sum += difference * difference;
                ++count;
            }
        }
        const float variance = count > 0 ? sum / static_cast<float>(count) : 0;
        blocks_[static_cast<std::size_t>(block)] = std::sqrt(variance) / kWithNeighbours;
    }

    const auto between = [](int pixel, int size) {
        const float position = (static_cast<float>(pixel) + 0.5F) / kNoiseBlock - 0.5F;
        const int before = static_cast<int>(position + 1) - 1; // place > -1
        struct {
            int before, after;
            float fraction;
        } found{std::max(before, 0), std::min(before + 1, size - 1), position - static_cast<float>(before)};
        return found;
    };
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        const auto down = between(y, rows);
        for (int x = 0; x < width_; ++x) {
            const auto across = between(x, columns);
            const auto mixed = [&](int line) {
                return blocks_[static_cast<std::size_t>(line * columns + across.before)] *
                           (1 - across.fraction) +
                       blocks_[static_cast<std::size_t>(line * columns + across.after)] * across.fraction;
            };
            noise_[row(y) + static_cast<std::size_t>(x)] =
                mixed(down.before) * (1 - down.fraction) + mixed(down.after) * down.fraction;
        }
    }
}

/// Adds what the pixels (dx, dy) away give to those of row `y`: sums are weights, red, green, blue, then
/// 1 / the difference of light that counts.
void Denoiser::takeTap(int y, int dx, int dy, float kernel, float planeTolerance, float* sums) const {
    const int begin = std::max(0, -dx), end = std::min(width_, width_ - dx);
    if (begin >= end) return;
    const auto width = static_cast<std::size_t>(width_), x = static_cast<std::size_t>(begin);
    const auto rowFrom = [this](std::size_t i) -> NoisyRow {
        return {&normal_[0][i], &normal_[1][i], &normal_[2][i], &nearness_[i],
                &bright_[i],    &light_[0][i],  &light_[1][i],  &light_[2][i]};
    };
    const std::size_t first = row(y) + x, other = row(y + dy) + static_cast<std::size_t>(begin + dx);
    const DenoiseTap tap{.pixels = rowFrom(first),
                         .neighbours = rowFrom(other),
                         .across = &across_[first],
                         .down = &down_[first],
                         .alike = sums + 4 * width + x,
                         .stepX = static_cast<float>(dx),
                         .stepY = static_cast<float>(dy),
                         .kernel = kernel,
                         .tolerance = planeTolerance,
                         .weights = sums + x,
                         .red = sums + width + x,
                         .green = sums + 2 * width + x,
                         .blue = sums + 3 * width + x};
    addTap(tap, static_cast<std::size_t>(end - begin));
}

void Denoiser::filterRow(int pass, int y, float* sums) {
    constexpr float kSpline[5] = {1.0F / 16, 1.0F / 4, 3.0F / 8, 1.0F / 4, 1.0F / 16};
    const int step = 1 << pass;
    const auto width = static_cast<std::size_t>(width_);
    const std::size_t first = row(y);
    const float middle = kSpline[2] * kSpline[2];
    // Each pass leaves less than half of the noise.
    const float deviations = kDeviations / static_cast<float>(step);
    for (std::size_t x = 0; x < width; ++x) {
        sums[x] = middle;
        for (std::size_t c = 0; c < 3; ++c) sums[(c + 1) * width + x] = middle * light_[c][first + x];
        sums[4 * width + x] =
            1 / std::max(deviations * noise_[first + x], 1e-6F * bright_[first + x] + 1e-30F);
    }
    const float tolerance = kPlane * static_cast<float>(pass + 1);
    for (int j = -2; j <= 2; ++j) {
        if (y + j * step < 0 || y + j * step >= height_) continue;
        for (int i = -2; i <= 2; ++i) {
            if (i == 0 && j == 0) continue;
            takeTap(y, i * step, j * step, kSpline[i + 2] * kSpline[j + 2], tolerance, sums);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t x = 0; x < width; ++x) result_[c][first + x] = sums[(c + 1) * width + x] / sums[x];
    }
}

void Denoiser::filter(int pass, int threads) {
    const int team = threadsFor(threads);
    if (rows_.size() < static_cast<std::size_t>(team)) rows_.resize(static_cast<std::size_t>(team));
    for (std::vector<float>& sums : rows_) sums.resize(5 * row(1));
#pragma omp parallel for schedule(static) num_threads(team)
    for (int y = 0; y < height_; ++y) {
        if (!stopped()) filterRow(pass, y, rows_[static_cast<std::size_t>(threadNumber())].data());
    }
    for (std::size_t c = 0; c < 3; ++c) light_[c].swap(result_[c]);
    brighten(threads);
}

/// Adds the filtered light, as the surfaces show it, to the light that was not filtered.
void Denoiser::fillImage(const HdrImage& picture, const Aovs& aovs, bool all, [[maybe_unused]] int threads) {
#pragma omp parallel for schedule(static) num_threads(threadsFor(threads))
    for (int y = 0; y < height_; ++y) {
        for (std::size_t i = row(y); i < row(y + 1); ++i) {
            const Colour smooth{light_[0][i] * albedo_[0][i], light_[1][i] * albedo_[1][i],
                                light_[2][i] * albedo_[2][i]};
            const Colour noisy = all ? picture.pixels[i] : aovs.pixels()[i].soft;
            // NaN stays as it is.
            const Colour rest = isFinite(noisy) ? picture.pixels[i] - noisy : picture.pixels[i];
            image_.pixels[i] = rest + smooth;
        }
    }
}

const HdrImage& Denoiser::apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run) {
    const int passes = filterPasses(run.settings);
    const bool whole = aovs.width() == picture.width && aovs.height() == picture.height;
    if (passes <= 0 || aovs.empty() || !whole) return picture;
    stop_ = run.stop;
    const bool noisy = traitsOf(run.settings.integrator).samplesAllLight;
    // Behind a lens the albedos of a pixel are mixed.
    const bool all = noisy || run.settings.depthOfField.on;
    resize(picture.width, picture.height);
    fillGuides(aovs, all, run.threads);
    if (!fillLight(picture, aovs, all, run.threads)) return picture;
    if (noisy) dropSpikes(run.threads);
    if (!stopped()) fillSlopes(run.threads);
    if (!stopped()) measureNoise(run.threads);
    for (int pass = 0; pass < passes && !stopped(); ++pass) filter(pass, run.threads);
    if (stopped()) return picture;
    fillImage(picture, aovs, all, run.threads);
    return image_;
}

constinit const EffectRow kDenoiseEffect{
    .name = "denoise",
    .stage = EffectStage::Radiance,
    .wanted = [](const RenderSettings& settings) { return filterPasses(settings) > 0; },
    .bytesPerPixel = Denoiser::bytesPerPixel(),
    .needsAovs = true,
    .needsGuides = false,
    .make = &makeEffect<Denoiser>};

} // namespace rtcore
