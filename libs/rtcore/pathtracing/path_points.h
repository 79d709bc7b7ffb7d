/// Points of a wave of paths that vector code alone cannot shade: textured, perforated, transparent ones.
/// Where light divides between holes, glass and the rest, a path takes one of them at random.
#pragma once

#include "rtcore/pathtracing/path_batch.h"
#include "rtcore/pathtracing/path_names.h"
#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/point_materials.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One for each thread; keeps its memory.
class PathPoints {
  public:
    struct Task {
        const FrameContext& frame;
        PathNames names;
        bool caustics;          ///< PathSettings::caustics
        const PathBatch* paths; ///< of the wave's rays; null for those of the camera
    };
    /// Completes the points of surfaces.notPlain(): albedo, normal, weights, hits of samples. Those whose
    /// path goes on behind the surface are no points any more; their rays are appended to `next`.
    void complete(const Task& task, Wave& wave, SampleSums& sums, PathBatch& next);
    /// Emission times the path's weight of each such point.
    const std::vector<Colour>& emitted() const { return emitted_; }

  private:
    Colour completeGeneral(const Task& task, Wave& wave, std::size_t i, SampleSums& sums, PathBatch& next);

    std::vector<Colour> emitted_;
    PointMaterials materials_;
};

} // namespace rtcore
