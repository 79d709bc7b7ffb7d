/// One tile of the picture: its rays are traced as one wave.
#pragma once

#include "rtcore/render/camera_rays.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/shading/whitted.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// How a picture is cut into square tiles, in pixels. Depends on the picture alone, never on threads.
class TileGrid {
  public:
    explicit TileGrid(const RenderSettings& settings);

    int count() const { return columns_ * rows_; }
    int side() const { return side_; }
    int left(int tile) const { return tile % columns_ * side_; }
    int top(int tile) const { return tile / columns_ * side_; }

  private:
    int side_, columns_, rows_;
};

/// Renders tiles one after another; one for each thread, reuses its memory.
class TileRenderer {
  public:
    TileRenderer(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                 const CameraRays& camera, const std::atomic<bool>& cancel);

    /// Writes the pixels of one tile into `frame`; soon returns, with them undefined, when `cancel` is set.
    void render(const TileGrid& grid, int tile, Frame& frame);
    const RayStatistics& statistics() const { return integrator_.statistics(); }

  private:
    void collectRays(int left, int top, int columns, int rows);
    void averageSamples(int left, int top, int columns, int rows, Frame& frame);

    const RenderSettings& settings_;
    const CameraRays& camera_;
    WhittedIntegrator integrator_;
    RayWave rays_;
    std::vector<std::uint32_t> place_; ///< of each ray: row * width + column in the tile's grid of samples
    std::vector<Colour> radiance_;
    std::vector<std::uint8_t> hit_;
    std::vector<Colour> gridRadiance_; ///< the same by place
    std::vector<std::uint8_t> gridHit_;
};

} // namespace rtcore
