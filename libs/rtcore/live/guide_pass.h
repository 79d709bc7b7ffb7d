/// Finds what pixels see, and what light is known of it.
#pragma once

#include "rtcore/kernels/ray_statistics.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/live/live_points.h"
#include "rtcore/live/recall.h"
#include "rtcore/render/camera_rays.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/surface/surface_wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

/// Which pixels of a frame have primary rays.
struct GuidePattern {
    int period = 1;           ///< 1: all; 2: those of a chequerboard; 4: one of each square of 2 x 2
    std::uint32_t number = 0; ///< of the frame: pixels take turns

    bool traced(int x, int y) const;
};

/// One for each thread; keeps its memory from tile to tile and from frame to frame.
class GuidePass {
  public:
    /// What tiles of a frame have in common; it all must outlive the frame.
    struct Task {
        const Scene& scene;
        const RayTracer& tracer;
        const MaterialTable& materials;
        const CameraRays& rays;
        GuidePattern pattern;
        const LiveImage& past;
    };
    void begin() { statistics_ = {}; }
    /// Writes those points of the area that have rays, with the light that the past knows of them.
    void trace(const Task& task, const PixelArea& area, LiveImage& present);
    /// Guesses the points of the area that have no rays: what their neighbours' surfaces and the past make
    /// likely. All points that have rays must be there, those of neighbouring areas, too.
    void guess(const Task& task, const PixelArea& area, LiveImage& present);
    const RayStatistics& statistics() const { return statistics_; }

  private:
    struct Pixel {
        int x, y;
        friend bool operator==(const Pixel&, const Pixel&) = default;
    };
    /// That a pixel sees the surface of a neighbour.
    struct Guess {
        Pixel pixel, neighbour;
        float depth;
    };
    void collectRays(const Task& task, const PixelArea& area, const LiveImage& present);
    void collectGrid(const Task& task, const PixelArea& area, int left, int top, int step,
                     const ImagePlane& plane);
    void collectGuesses(const Task& task, const LiveImage& present, int x, int y);
    LivePoint bestGuess(const Task& task, const LiveImage& present, std::size_t first,
                        std::size_t last) const;

    RayWave rays_;
    HitWave hits_;
    SurfaceWave surfaces_;
    std::vector<Pixel> pixels_;  ///< of the rays
    std::vector<Guess> guesses_; ///< those of a pixel follow each other
    AskedPoints asked_;          ///< of the rays, or of the guesses
    RecalledPoints recalled_;
    RayStatistics statistics_;
};

} // namespace rtcore
