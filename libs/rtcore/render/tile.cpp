#include "rtcore/render/tile.h"

#include "rtcore/render/tile_store.h"

#include <algorithm>
#include <limits>

namespace rtcore {

namespace {

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

/// Calls `work` with the column and the row of each sample of a block that lies inside the picture, in the
/// order of the rays.
template <typename Work>
void forEachSample(int width, int height, Work&& work) {
    for (int index = 0; index < kCameraBlockRays; ++index) {
        const int column = columnInBlock(index);
        const int row = rowInBlock(index);
        if (column < width && row < height) work(column, row);
    }
}

/// The part of a block's values that lies inside the picture.
void copyPart(const float* block, int width, int height, float* to) {
    forEachSample(width, height, [&](int column, int row) { *to++ = block[indexInBlock(column, row)]; });
}

} // namespace

TileGrid::TileGrid(const RenderSettings& settings, bool secondaryRays)
    : width_(settings.width), height_(settings.height) {
    // 32 x 32 samples: what is known of them stays in the second cache. Secondary rays go everywhere, and
    // only waves of some thousands of them share work; so tiles are larger then, where there are enough for
    // all threads.
    constexpr std::int64_t kManyPixels = 1 << 18;
    const bool large = secondaryRays && std::int64_t{settings.width} * settings.height >= kManyPixels;
    side_ = settings.antialiasing == 1 ? (large ? 64 : 32) : std::max(4, 64 / settings.antialiasing);
    columns_ = (width_ + side_ - 1) / side_;
    rows_ = (height_ + side_ - 1) / side_;
}

PixelArea TileGrid::area(int tile) const {
    const int left = tile % columns_ * side_, top = tile / columns_ * side_;
    return {left, top, std::min(side_, width_ - left), std::min(side_, height_ - top)};
}

void TileRenderer::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                         const MaterialTable& materials, const CameraRays& camera,
                         const std::atomic<bool>& cancel, bool measureStages) {
    settings_ = &settings;
    camera_ = &camera;
    sameOrigin_ = false;
    drawsSamples_ = WhittedIntegrator::drawsSamples(scene, settings);
    samples_.clear();
    integrator_.begin(scene, tracer, settings, materials, measureStages);
    integrator_.stopWhen(&cancel);
}

void TileRenderer::render(const PixelArea& area, Frame& frame) {
    collectRays(area);
    integrator_.clock().lap(Stage::Rays);
    if (drawsSamples_) nameSamples(area);
    integrator_.trace(rays_, samples_);
    if (settings_->antialiasing == 1) {
        storePixels(area, frame);
    } else {
        averageSamples(area, frame);
    }
    integrator_.clock().lap(Stage::Store);
}

void TileRenderer::collectRays(const PixelArea& area) {
    const auto n = static_cast<std::size_t>(settings_->antialiasing);
    const std::size_t count =
        static_cast<std::size_t>(area.columns) * static_cast<std::size_t>(area.rows) * n * n;
    if (!sameOrigin_ || rays_.size() != count) {
        rays_.resize(count);
        std::fill(rays_.ox.begin(), rays_.ox.end(), camera_->eye().x);
        std::fill(rays_.oy.begin(), rays_.oy.end(), camera_->eye().y);
        std::fill(rays_.oz.begin(), rays_.oz.end(), camera_->eye().z);
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
            camera_->directions(block, &rays_.dx[first], &rays_.dy[first], &rays_.dz[first]);
            return;
        }
        float directions[3][kCameraBlockRays];
        camera_->directions(block, directions[0], directions[1], directions[2]);
        copyPart(directions[0], w, h, &rays_.dx[first]);
        copyPart(directions[1], w, h, &rays_.dy[first]);
        copyPart(directions[2], w, h, &rays_.dz[first]);
    });
}

void TileRenderer::nameSamples(const PixelArea& area) {
    const int n = settings_->antialiasing;
    samples_.clear();
    forEachBlock(area.columns * n, area.rows * n, [&](int column, int row, int w, int h, std::size_t) {
        forEachSample(w, h, [&](int x, int y) {
            const int across = column + x, down = row + y;
            samples_.push_back({static_cast<std::uint16_t>(area.left + across / n),
                                static_cast<std::uint16_t>(area.top + down / n),
                                static_cast<std::uint32_t>(down % n * n + across % n)});
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
