#include "rtcore/render/tile.h"

#include "rtcore/render/tile_store.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace rtcore {

namespace {

/// Samples in a row of a tile.
constexpr int kSamples = 64;
constexpr std::uint32_t kNoTap = 0xFFFFFFFFU;

/// Of a sample, so that a pixel has some in all.
std::uint32_t lobeRaysOf(const RenderSettings& settings) {
    constexpr int kOfPixel = 16;
    return static_cast<std::uint32_t>(
        std::max(1, kOfPixel / (settings.antialiasing * settings.antialiasing)));
}
constexpr int kMaxSamples = 2 * kSamples; ///< where they are not all taken at once

/// The rays of one tile, block after block. `work` gets the block's first column and row, its width and
/// height, and the number of its first ray.
template <typename Work>
void forEachBlock(int width, int height, Work&& work) {
    std::size_t first = 0;
    for (int row = 0; row < height; row += kCameraBlock) {
        for (int column = 0; column < width; column += kCameraBlock) {
            const int w = std::min(kCameraBlock, width - column);
            const int h = std::min(kCameraBlock, height - row);
            work(column, row, w, h, first);
            first += static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
        }
    }
}

/// Calls `work` with the column and the row of each sample of a block that lies inside the image, in the
/// order of the rays.
template <typename Work>
void forEachSample(int width, int height, Work&& work) {
    for (int index = 0; index < kCameraBlockRays; ++index) {
        const int column = columnInBlock(index);
        const int row = rowInBlock(index);
        if (column < width && row < height) work(column, row);
    }
}

/// The part of a block's values that lies inside the image.
void copyPart(const float* block, int width, int height, float* to) {
    forEachSample(width, height, [&](int column, int row) { *to++ = block[indexInBlock(column, row)]; });
}

/// The pixel of each column of samples, or row, and its part in their number.
struct SampleAxis {
    std::array<std::uint16_t, kMaxSamples> pixel;
    std::array<std::uint32_t, kMaxSamples> sub;

    void fill(int first, int pixels, int n, int step) {
        std::size_t at = 0;
        for (int i = 0; i < pixels; ++i) {
            for (int k = 0; k < n; ++k) {
                pixel[at] = static_cast<std::uint16_t>(first + i);
                sub[at++] = static_cast<std::uint32_t>(k * step);
            }
        }
    }
};

/// Calls `work` with the place of each pixel in the image, and its index there, row by row.
template <typename Work>
void forEachPixel(const PixelArea& area, int width, Work&& work) {
    for (int y = area.top; y < area.top + area.rows; ++y) {
        for (int x = area.left; x < area.left + area.columns; ++x) {
            work(x, y,
                 static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
        }
    }
}

} // namespace

TileGrid::TileGrid(const RenderSettings& settings, bool secondaryRays)
    : width_(settings.width), height_(settings.height) {
    // 32 x 32 samples: what is known of them stays in the second cache. Secondary rays go everywhere, and
    // only waves of some thousands of them share work; so tiles are larger then, where there are enough for
    // all threads.
    constexpr std::int64_t kManyPixels = 1 << 18;
    const bool large = secondaryRays && std::int64_t{settings.width} * settings.height >= kManyPixels;
    const int samples = samplesAdaptively(settings) ? kMaxSamples : kSamples;
    side_ = settings.antialiasing == 1 ? (large ? kSamples : kSamples / 2)
                                       : std::max(4, samples / settings.antialiasing);
    columns_ = (width_ + side_ - 1) / side_;
    rows_ = (height_ + side_ - 1) / side_;
}

PixelArea TileGrid::area(int tile) const {
    const int left = tile % columns_ * side_, top = tile / columns_ * side_;
    return {left, top, std::min(side_, width_ - left), std::min(side_, height_ - top)};
}

void TileRenderer::begin(const FrameTask& task) {
    const View& view = task.view;
    settings_ = &view.settings;
    view_ = &task.samples;
    sameOrigin_ = false;
    needsSampleIds_ =
        WhittedIntegrator::needsSampleIds(view.scene, view.settings) || task.indirect != nullptr;
    samples_.clear();
    indirect_ = task.indirect;
    integrator_.setLobeRays(lobeRaysOf(view.settings));
    integrator_.collectTaps(indirect_ != nullptr, pixelSizeOf(task.samples.camera));
    integrator_.begin(view.scene, view.tracer, view.settings, task.materials, task.measureStages);
    integrator_.takeShadowsFrom(task.shadowMaps);
    integrator_.seeWhite(view.settings.falseColours.seesWhite());
    integrator_.stopWhen(&task.cancel);
    aovs_ = task.aovs;
    seen_ = task.seen;
    matter_ = task.matter;
    normals_ = task.normals;
    hidesBackground_ = task.hidesBackground;
    integrator_.hideBackground(hidesBackground_);
    integrator_.collectNormals(normals_ != nullptr);
    integrator_.collectPrimaryHits(aovs_ != nullptr   ? PrimaryHitParts::All
                                   : seen_ != nullptr ? PrimaryHitParts::Surface
                                                      : PrimaryHitParts::None);
}

void TileRenderer::render(const PixelArea& area, Frame& frame) {
    const auto all = [](const SampleId&) { return true; };
    forgetHits(area);
    if (!view_->plain() || hidesBackground_) {
        nameSamples(area, all);
        traceSamples();
        clearSums(area);
        addToSums(area);
        const int count = settings_->antialiasing * settings_->antialiasing;
        storeMeans(area, frame, [count](int, int) { return count; });
        return;
    }
    collectRays(area);
    integrator_.clock().lap(Stage::Rays);
    if (needsSampleIds_ || aovs_ != nullptr || seen_ != nullptr || normals_ != nullptr)
        nameSamples(area, all);
    traceRays();
    if (settings_->antialiasing == 1) {
        storePixels(area, frame);
    } else {
        averageSamples(area, frame);
    }
    integrator_.clock().lap(Stage::Store);
}

void TileRenderer::traceSamples() {
    makeSampleRays(*view_, samples_, rays_);
    integrator_.clock().lap(Stage::Rays);
    traceRays();
}

void TileRenderer::traceRays() {
    integrator_.trace(rays_, samples_);
    if (indirect_ != nullptr) addIndirect();
    if (aovs_ != nullptr) aovs_->add(integrator_.primaryHits(), samples_);
    if (seen_ != nullptr) keepHits();
    if (normals_ != nullptr) addNormals();
}

void TileRenderer::addIndirect() {
    const std::span<const IndirectTap> taps = integrator_.taps();
    receivers_.resize(taps.size());
    arriving_.resize(taps.size());
    std::ranges::transform(taps, receivers_.begin(), &IndirectTap::receiver);
    indirect_->cache().lookUp(receivers_, arriving_);
    integrator_.addIndirect(arriving_);
    if (integrator_.lobes().empty()) return;
    alongLobes_.resize(integrator_.lobes().size());
    indirect_->lookUp(integrator_.lobes(), alongLobes_, lobeScratch_);
    integrator_.addAlongLobes(alongLobes_);
}

void TileRenderer::addNormals() {
    const float weight = 1.0F / static_cast<float>(settings_->antialiasing * settings_->antialiasing);
    const std::span<const Vec3> normals = integrator_.normals();
    const auto width = static_cast<std::size_t>(settings_->width);
    for (std::size_t i = 0; i < samples_.size(); ++i)
        (*normals_)[samples_[i].y * width + samples_[i].x] += normals[i] * weight;
}

/// Keeps for each pixel the hit of the sample in its middle, or next to it; of another where that is not
/// traced. Pixels begin with none: see forgetHits().
void TileRenderer::keepHits() {
    const auto n = static_cast<std::uint32_t>(settings_->antialiasing);
    const std::uint32_t middle = n / 2 * n + n / 2;
    const std::span<const PrimaryHit> hits = integrator_.primaryHits();
    const auto width = static_cast<std::size_t>(settings_->width);
    if (matter_ != nullptr) findTaps();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const std::size_t pixel = samples_[i].y * width + samples_[i].x;
        SeenPoint& seen = (*seen_)[pixel];
        if (samples_[i].sub != middle && seen.any) continue;
        seen = SeenPoint(hits[i], integrator_.radiance().colourAt(i));
        if (matter_ != nullptr) (*matter_)[pixel] = matterOf(i, seen);
    }
}

void TileRenderer::findTaps() {
    tapOf_.assign(samples_.size(), kNoTap);
    const std::span<const IndirectTap> taps = integrator_.taps();
    for (std::uint32_t k = 0; k < taps.size(); ++k) {
        std::uint32_t& first = tapOf_[taps[k].sample];
        if (taps[k].primary && first == kNoTap) first = k;
    }
}

SeenMatter TileRenderer::matterOf(std::size_t sample, const SeenPoint& seen) const {
    const std::uint32_t k = tapOf_[sample];
    if (k == kNoTap) return {};
    const IndirectTap& tap = integrator_.taps()[k];
    const Colour surface = integrator_.radiance().colourAt(sample) * seen.surfaceFraction;
    return {surface, tap.light(arriving_[k].irradiance), tap};
}

/// Before the first samples of a tile.
void TileRenderer::forgetHits(const PixelArea& area) {
    if (seen_ == nullptr || settings_->antialiasing == 1) return; // each pixel's only sample is kept
    const auto columns = static_cast<std::size_t>(area.columns),
               width = static_cast<std::size_t>(settings_->width);
    for (int y = area.top; y < area.top + area.rows; ++y)
        std::fill_n(seen_->begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * width +
                                                                 static_cast<std::size_t>(area.left)),
                    columns, SeenPoint{});
}

/// `count`: how many samples the pixel (x, y) has.
template <typename Count>
void TileRenderer::storeMeans(const PixelArea& area, Frame& frame, Count&& count) {
    auto sum = sums_.begin();
    forEachPixel(area, frame.radiance.width, [&](int x, int y, std::size_t pixel) {
        const int samples = count(x, y);
        frame.radiance.pixels[pixel] = sum->radiance / static_cast<float>(samples);
        frame.covered[pixel] = static_cast<std::uint8_t>(255 * sum->hits / samples);
        if (hidesBackground_)
            frame.transmitted.pixels[pixel] = sum->transmitted / static_cast<float>(samples);
        ++sum;
    });
    integrator_.clock().lap(Stage::Store);
}

void TileRenderer::renderFirst(const PixelArea& area, AdaptiveSampler& sampler, Frame& frame) {
    const int n = settings_->antialiasing;
    forgetHits(area);
    nameSamples(area, [n](const SampleId& id) { return isFirstSample(id.sub, n); });
    traceSamples();
    clearSums(area);
    addToSums(area);
    auto sum = sums_.begin();
    forEachPixel(area, frame.radiance.width, [&](int, int, std::size_t pixel) {
        frame.radiance.pixels[pixel] = sum->radiance;
        frame.covered[pixel] = static_cast<std::uint8_t>(sum->hits);
        ++sum;
    });
    const ArraysOf3& radiance = integrator_.radiance();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        sampler.add(samples_[i].x, samples_[i].y, radiance.colourAt(i));
    }
    integrator_.clock().lap(Stage::Store);
}

void TileRenderer::renderRest(const PixelArea& area, const AdaptiveSampler& sampler, Frame& frame) {
    const int n = settings_->antialiasing;
    nameSamples(area,
                [&](const SampleId& id) { return sampler.refined(id.x, id.y) && !isFirstSample(id.sub, n); });
    sums_.clear();
    forEachPixel(area, frame.radiance.width, [&](int, int, std::size_t pixel) {
        sums_.push_back({frame.radiance.pixels[pixel], frame.covered[pixel]});
    });
    if (!samples_.empty()) {
        traceSamples();
        addToSums(area);
    }
    storeMeans(area, frame, [&](int x, int y) { return sampler.refined(x, y) ? n * n : firstSamples(n); });
}

void TileRenderer::renderPixels(std::span<const SampleId> pixels, const RenderedPixels& to) {
    const int count = settings_->antialiasing * settings_->antialiasing;
    samples_.clear();
    for (const SampleId& pixel : pixels) {
        for (int sub = 0; sub < count; ++sub)
            samples_.push_back({pixel.x, pixel.y, static_cast<std::uint32_t>(sub)});
    }
    sameOrigin_ = false;
    integrator_.remember(to.visibility);
    if (!to.seen.empty()) integrator_.collectPrimaryHits(PrimaryHitParts::Surface);
    const IndirectLight* const light = std::exchange(indirect_, nullptr); // taps() tell where it is missing
    integrator_.setLobeRays(1);
    traceSamples();
    indirect_ = light;
    integrator_.remember({});
    const ArraysOf3& found = integrator_.radiance();
    for (std::size_t i = 0; i < to.seen.size(); ++i)
        to.seen[i] = SeenPoint(integrator_.primaryHits()[i], found.colourAt(i));
    std::size_t sample = 0;
    for (Colour& pixel : to.radiance) {
        Colour sum;
        for (int sub = 0; sub < count; ++sub) sum += found.colourAt(sample++);
        pixel = sum / static_cast<float>(count);
    }
    integrator_.clock().lap(Stage::Store);
}

void TileRenderer::collectRays(const PixelArea& area) {
    const auto n = static_cast<std::size_t>(settings_->antialiasing);
    const std::size_t count =
        static_cast<std::size_t>(area.columns) * static_cast<std::size_t>(area.rows) * n * n;
    if (!sameOrigin_ || rays_.size() != count) {
        rays_.resize(count);
        std::fill(rays_.ox.begin(), rays_.ox.end(), view_->camera.eye().x);
        std::fill(rays_.oy.begin(), rays_.oy.end(), view_->camera.eye().y);
        std::fill(rays_.oz.begin(), rays_.oz.end(), view_->camera.eye().z);
        std::fill(rays_.tMin.begin(), rays_.tMin.end(), 0.0F);
        std::fill(rays_.tMax.begin(), rays_.tMax.end(), std::numeric_limits<float>::max());
        sameOrigin_ = true;
    }
    collectDirections(area);
}

void TileRenderer::collectDirections(const PixelArea& area) {
    const int n = settings_->antialiasing;
    const float step = 1.0F / static_cast<float>(n);
    const auto left = static_cast<float>(area.left), top = static_cast<float>(area.top);
    forEachBlock(area.columns * n, area.rows * n, [&](int column, int row, int w, int h, std::size_t first) {
        const CameraRays::Block block{left, top, column, row, step};
        if (w == kCameraBlock && h == kCameraBlock) {
            view_->camera.directions(block, &rays_.dx[first], &rays_.dy[first], &rays_.dz[first]);
            return;
        }
        float directions[3][kCameraBlockRays];
        view_->camera.directions(block, directions[0], directions[1], directions[2]);
        copyPart(directions[0], w, h, &rays_.dx[first]);
        copyPart(directions[1], w, h, &rays_.dy[first]);
        copyPart(directions[2], w, h, &rays_.dz[first]);
    });
}

void TileRenderer::clearSums(const PixelArea& area) {
    sums_.assign(static_cast<std::size_t>(area.columns) * static_cast<std::size_t>(area.rows), {});
}

void TileRenderer::addToSums(const PixelArea& area) {
    const ArraysOf3& radiance = integrator_.radiance();
    const std::uint8_t* const hit = integrator_.hit().data();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        const int x = samples_[i].x - area.left, y = samples_[i].y - area.top;
        PixelSum& sum = sums_[static_cast<std::size_t>(y) * static_cast<std::size_t>(area.columns) +
                              static_cast<std::size_t>(x)];
        sum.radiance += radiance.colourAt(i);
        sum.hits += hit[i];
        if (hidesBackground_) sum.transmitted += integrator_.transmitted().colourAt(i);
    }
}

template <typename Wanted>
void TileRenderer::nameSamples(const PixelArea& area, Wanted&& wanted) {
    const int n = settings_->antialiasing;
    SampleAxis columns, rows;
    columns.fill(area.left, area.columns, n, 1);
    rows.fill(area.top, area.rows, n, n);
    samples_.clear();
    forEachBlock(area.columns * n, area.rows * n, [&](int column, int row, int w, int h, std::size_t) {
        forEachSample(w, h, [&](int x, int y) {
            const auto across = static_cast<std::size_t>(column + x),
                       down = static_cast<std::size_t>(row + y);
            const SampleId id{columns.pixel[across], rows.pixel[down], columns.sub[across] + rows.sub[down]};
            if (wanted(id)) samples_.push_back(id);
        });
    });
}

void TileRenderer::storePixels(const PixelArea& area, Frame& frame) {
    const auto width = static_cast<std::size_t>(settings_->width);
    const ArraysOf3& radiance = integrator_.radiance();
    const std::uint8_t* const hit = integrator_.hit().data();
    forEachBlock(area.columns, area.rows, [&](int column, int row, int w, int h, std::size_t first) {
        const std::size_t pixel =
            static_cast<std::size_t>(area.top + row) * width + static_cast<std::size_t>(area.left + column);
        Colour* const pixels = &frame.radiance.pixels[pixel];
        std::uint8_t* const covered = &frame.covered[pixel];
        if (w == kCameraBlock && h == kCameraBlock) {
            storeBlock(radiance.x + first, radiance.y + first, radiance.z + first, hit + first, width, pixels,
                       covered);
            return;
        }
        std::size_t next = first;
        forEachSample(w, h, [&](int x, int y) {
            const std::size_t at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            pixels[at] = radiance.colourAt(next);
            covered[at] = static_cast<std::uint8_t>(255 * hit[next++]);
        });
    });
}

void TileRenderer::averageSamples(const PixelArea& area, Frame& frame) {
    const int n = settings_->antialiasing;
    const int width = area.columns * n, height = area.rows * n;
    const auto at = [width](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    slot_.resize(rays_.size());
    forEachBlock(width, height, [&](int column, int row, int w, int h, std::size_t first) {
        auto next = static_cast<std::uint32_t>(first);
        forEachSample(w, h, [&](int x, int y) { slot_[at(column + x, row + y)] = next++; });
    });
    const ArraysOf3& radiance = integrator_.radiance();
    for (int y = 0; y < area.rows; ++y) {
        for (int x = 0; x < area.columns; ++x) {
            Colour sum;
            int hits = 0;
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const std::uint32_t slot = slot_[at(x * n + i, y * n + j)];
                    sum += radiance.colourAt(slot);
                    hits += integrator_.hit()[slot];
                }
            }
            frame.radiance.at(area.left + x, area.top + y) = sum / static_cast<float>(n * n);
            const auto pixel =
                static_cast<std::size_t>(area.top + y) * static_cast<std::size_t>(settings_->width) +
                static_cast<std::size_t>(area.left + x);
            frame.covered[pixel] = static_cast<std::uint8_t>(255 * hits / (n * n));
        }
    }
}

} // namespace rtcore
