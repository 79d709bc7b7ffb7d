/// The materials of a wave's points where textures, colours of vertices, holes and glass make each of them
/// its own: what SurfaceWave::notPlain() lists.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/surface/surface.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

/// surfaceAt() of a point of the wave, which has its shape already.
Surface surfaceOfPoint(const FrameContext& frame, const Wave& wave, std::size_t point);

/// Visits those points. One for each thread.
class PointMaterials {
  public:
    /// Calls `general(k, i)` for each with the trait kGeneral, and `coloured(k, i, albedo)` for each other;
    /// k is its place in notPlain(), i in the wave. Textured ones may come later than those behind them.
    template <typename Coloured, typename General>
    void visit(const FrameContext& frame, const Wave& wave, Coloured&& coloured, General&& general) {
        const std::span<const std::uint32_t> points = wave.surfaces.notPlain();
        for (std::uint32_t k = 0; k < points.size(); ++k) {
            const std::uint32_t i = points[k];
            if ((wave.surfaces.traits[i] & traits::kGeneral) != 0) {
                general(k, i);
            } else if (!isTextured(frame, wave, i)) {
                coloured(k, i, untexturedAt(*frame.scene, wave.hits.hit(i)));
            } else {
                point_[count_] = i;
                place_[count_++] = k;
                if (count_ == kWaveBlock) visitTextured(frame, wave, coloured);
            }
        }
        visitTextured(frame, wave, coloured);
    }

  private:
    static bool isTextured(const FrameContext& frame, const Wave& wave, std::size_t point) {
        return frame.settings->textures &&
               frame.scene->material(wave.surfaces.material[point]).diffuseTexture != kNoTexture;
    }
    template <typename Coloured>
    void visitTextured(const FrameContext& frame, const Wave& wave, Coloured&& coloured) {
        if (count_ == 0) return;
        lookUpAlbedos(frame, wave);
        for (std::size_t i = 0; i < count_; ++i) coloured(place_[i], point_[i], albedo_[i]);
        count_ = 0;
    }
    void lookUpAlbedos(const FrameContext& frame, const Wave& wave);

    /// Textured points that wait until there is a block of them.
    std::size_t count_ = 0;
    std::uint32_t point_[kWaveBlock], place_[kWaveBlock];
    Colour albedo_[kWaveBlock];
};

} // namespace rtcore
