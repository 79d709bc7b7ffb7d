#include "rtcore/render/tile.h"

#include <algorithm>

namespace rtcore {

namespace {

/// Rays of one 8 x 8 block lie together in a wave: neighbours take the same way through the tree.
constexpr int kBlock = 8;

} // namespace

TileGrid::TileGrid(const RenderSettings& settings) {
    // 32 x 32 samples at least, so that waves are large, and about 64 x 64 with antialiasing.
    side_ = settings.antialiasing == 1 ? 32 : std::max(4, 64 / settings.antialiasing);
    columns_ = (settings.width + side_ - 1) / side_;
    rows_ = (settings.height + side_ - 1) / side_;
}

TileRenderer::TileRenderer(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                           const CameraRays& camera, const std::atomic<bool>& cancel)
    : settings_(settings), camera_(camera), integrator_(scene, tracer, settings) {
    integrator_.stopWhen(&cancel);
}

void TileRenderer::render(const TileGrid& grid, int tile, Frame& frame) {
    const int left = grid.left(tile);
    const int top = grid.top(tile);
    const int columns = std::min(grid.side(), settings_.width - left);
    const int rows = std::min(grid.side(), settings_.height - top);
    collectRays(left, top, columns, rows);
    radiance_.resize(rays_.size());
    hit_.resize(rays_.size());
    integrator_.trace(rays_, radiance_, hit_);
    averageSamples(left, top, columns, rows, frame);
}

void TileRenderer::collectRays(int left, int top, int columns, int rows) {
    const int n = settings_.antialiasing;
    const int width = columns * n;
    const int height = rows * n;
    const float step = 1.0F / static_cast<float>(n);
    rays_.clear();
    place_.clear();
    for (int blockY = 0; blockY < height; blockY += kBlock) {
        for (int blockX = 0; blockX < width; blockX += kBlock) {
            for (int y = blockY; y < std::min(blockY + kBlock, height); ++y) {
                for (int x = blockX; x < std::min(blockX + kBlock, width); ++x) {
                    rays_.push(camera_.at(static_cast<float>(left) + (static_cast<float>(x) + 0.5F) * step,
                                          static_cast<float>(top) + (static_cast<float>(y) + 0.5F) * step));
                    place_.push_back(static_cast<std::uint32_t>(y * width + x));
                }
            }
        }
    }
}

void TileRenderer::averageSamples(int left, int top, int columns, int rows, Frame& frame) {
    const int n = settings_.antialiasing;
    gridRadiance_.resize(radiance_.size());
    gridHit_.resize(hit_.size());
    for (std::size_t i = 0; i < place_.size(); ++i) {
        gridRadiance_[place_[i]] = radiance_[i];
        gridHit_[place_[i]] = hit_[i];
    }
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            Colour sum;
            int hits = 0;
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    const auto at =
                        static_cast<std::size_t>(y * n + j) * static_cast<std::size_t>(columns * n) +
                        static_cast<std::size_t>(x * n + i);
                    sum += gridRadiance_[at];
                    hits += gridHit_[at];
                }
            }
            frame.radiance.at(left + x, top + y) = sum / static_cast<float>(n * n);
            const auto pixel = static_cast<std::size_t>(top + y) * static_cast<std::size_t>(settings_.width) +
                               static_cast<std::size_t>(left + x);
            frame.covered[pixel] = static_cast<std::uint8_t>(255 * hits / (n * n));
        }
    }
}

} // namespace rtcore
