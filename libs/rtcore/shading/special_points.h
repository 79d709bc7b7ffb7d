/// Points of a wave that vector code alone cannot shade: textured, coloured, perforated, transparent ones.
#pragma once

#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/secondary_rays.h"
#include "rtcore/shading/surface/surface.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One for each thread; keeps its memory from wave to wave.
class SpecialPoints {
  public:
    /// Completes the points of surfaces.notPlain(): albedo, normal, weights, hits of samples; hands what lets
    /// light through to `secondary`. `ambient`: the ambient light that nothing occludes.
    void complete(const FrameContext& frame, Colour ambient, Wave& wave, SampleSums& sums,
                  SecondaryRays& secondary);
    /// Of each such point, what it emits, and reflects of the ambient light, towards its sample.
    const std::vector<Colour>& emitted() const { return emitted_; }

  private:
    /// What complete() got.
    struct Task {
        const FrameContext& frame;
        Colour ambient;
        Wave& wave;
        SampleSums& sums;
        SecondaryRays& secondary;
    };
    static Surface surfaceOf(const Task& task, std::size_t point);
    Colour completeGeneral(const Task& task, std::size_t point) const;
    Colour setAlbedo(const Task& task, std::size_t point, Colour albedo) const;
    void completeTextured(const Task& task);

    std::vector<Colour> emitted_;
    /// Points that wait until there is a block of them: which, and their index in emitted_.
    struct TexturedPoints {
        std::size_t count = 0;
        std::uint32_t point[kWaveBlock], index[kWaveBlock];
    } textured_;
};

} // namespace rtcore
