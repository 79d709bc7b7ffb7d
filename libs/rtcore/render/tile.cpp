#include "rtcore/render/tile.h"

#include "rtcore/render/tile_store.h"

#include <algorithm>
#include <limits>

namespace rtcore {

namespace {

constexpr std::size_t kBlockRays = std::size_t{kCameraBlock} * kCameraBlock;

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

/// The part of a block of 8 x 8 values that lies inside the picture, row by row.
void copyPart(const float* block, int width, int height, float* to) {
    for (int y = 0; y < height; ++y) to = std::copy_n(block + y * kCameraBlock, width, to);
}

} // namespace

TileGrid::TileGrid(const RenderSettings& settings, bool secondaryRays) {
    // 32 x 32 samples: what is known of them stays in the second cache. Secondary rays go everywhere, and
    // only waves of some thousands of them share work; so tiles are larger then, where there are enough for
    // all threads.
    constexpr std::int64_t kManyPixels = 1 << 18;
    const bool large = secondaryRays && std::int64_t{settings.width} * settings.height >= kManyPixels;
    side_ = settings.antialiasing == 1 ? (large ? 64 : 32) : std::max(4, 64 / settings.antialiasing);
    columns_ = (settings.width + side_ - 1) / side_;
    rows_ = (settings.height + side_ - 1) / side_;
}

void TileRenderer::begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                         const MaterialTable& materials, const CameraRays& camera,
                         const std::atomic<bool>& cancel, bool measureStages) {
    settings_ = &settings;
    camera_ = &camera;
    sameOrigin_ = false;
    integrator_.begin(scene, tracer, settings, materials, measureStages);
    integrator_.stopWhen(&cancel);
}

void TileRenderer::render(const TileGrid& grid, int tile, Frame& frame) {
    const int left = grid.left(tile), top = grid.top(tile);
    const Area area{left, top, std::min(grid.side(), settings_->width - left),
                    std::min(grid.side(), settings_->height - top)};
    collectRays(area);
    integrator_.clock().lap(Stage::Rays);
    integrator_.trace(rays_);
    if (settings_->antialiasing == 1) {
        storePixels(area, frame);
    } else {
        averageSamples(area, frame);
    }
    integrator_.clock().lap(Stage::Store);
}

void TileRenderer::collectRays(const Area& area) {
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

void TileRenderer::collectDirections(const Area& area) {
    const int n = settings_->antialiasing;
    const float step = 1.0F / static_cast<float>(n);
    const auto left = static_cast<float>(area.left), top = static_cast<float>(area.top);
    forEachBlock(area.columns * n, area.rows * n, [&](int column, int row, int w, int h, std::size_t first) {
        const CameraRays::Block block{left, top, column, row, step};
        if (w == kCameraBlock && h == kCameraBlock) {
            camera_->directions(block, &rays_.dx[first], &rays_.dy[first], &rays_.dz[first]);
            return;
        }
        float directions[3][kBlockRays];
        camera_->directions(block, directions[0], directions[1], directions[2]);
        copyPart(directions[0], w, h, &rays_.dx[first]);
        copyPart(directions[1], w, h, &rays_.dy[first]);
        copyPart(directions[2], w, h, &rays_.dz[first]);
    });
}

void TileRenderer::storePixels(const Area& area, Frame& frame) {
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
        const auto columns = static_cast<std::size_t>(w), rows = static_cast<std::size_t>(h);
        for (std::size_t y = 0; y < rows; ++y) {
            for (std::size_t x = 0; x < columns; ++x) {
                pixels[y * width + x] = radiance.colourAt(first + y * columns + x);
                covered[y * width + x] = static_cast<std::uint8_t>(255 * hit[first + y * columns + x]);
            }
        }
    });
}

void TileRenderer::averageSamples(const Area& area, Frame& frame) {
    const int n = settings_->antialiasing;
    const int width = area.columns * n, height = area.rows * n;
    const auto at = [width](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    slot_.resize(rays_.size());
    forEachBlock(width, height, [&](int column, int row, int w, int h, std::size_t first) {
        auto next = static_cast<std::uint32_t>(first);
        for (int y = row; y < row + h; ++y) {
            for (int x = column; x < column + w; ++x) slot_[at(x, y)] = next++;
        }
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
