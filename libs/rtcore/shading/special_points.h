/// Points of a wave that vector code alone cannot shade: textured, coloured, perforated, transparent ones.
#pragma once

#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/point_materials.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/secondary_rays.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// One for each thread; keeps its memory from wave to wave.
class SpecialPoints {
  public:
    /// Completes the points of surfaces.notPlain(): albedo, normal, weights, hits of samples; hands what lets
    /// light through to `secondary`. `ambient`: the ambient light that nothing occludes.
    void complete(const FrameContext& frame, Colour ambient, Wave& wave, SampleSums& sums,
                  SecondaryRays& secondary);
    /// Light that each such point emits, or reflects of the ambient light, towards its sample.
    const std::vector<Colour>& emitted() const { return emitted_; }

  private:
    /// Arguments of complete().
    struct Task {
        const FrameContext& frame;
        Colour ambient;
        Wave& wave;
        SampleSums& sums;
        SecondaryRays& secondary;
    };
    Colour completeGeneral(const Task& task, std::size_t point) const;
    Colour setAlbedo(const Task& task, std::size_t point, Colour albedo) const;

    std::vector<Colour> emitted_;
    PointMaterials materials_;
};

} // namespace rtcore
