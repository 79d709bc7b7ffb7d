/// The primary hits of a wave's samples, before mirrors and glass.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/indirect_taps.h"
#include "rtcore/shading/light/hemisphere_wave.h"
#include "rtcore/shading/sample_sums.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// Undefined, but for any(), where nothing was hit.
struct PrimaryHit {
    Vec3 position;
    Vec3 normal;        ///< the shading normal, unit, on the side of the viewer
    Colour albedo;      ///< fraction of light that the surface scatters, mirrors or transmits
    float mirrored = 0; ///< luminance of the part of it that is mirrored or transmitted, 0..1
    float matte = 0;    ///< luminance of the rest
    Colour direct;      ///< radiance due to direct light, once scattered
    Colour soft; ///< radiance by sampled, and so noisy, light: of area lights, ambient light and the sky
    float arriving = 0, whole = 0; ///< ambient light or the sky's, and what there would be without occlusion
    std::uint32_t wave = 0;        ///< of the sample, in which it was hit; 0: nothing was
    Colour surfaceLight;           ///< radiance from there itself, not mirrored and not transmitted
    /// How far away what it mostly mirrors or transmits seems to be along the primary ray; infinite of the
    /// background; below 0 where something curved bends it, as in Path::length; 0: nothing is mirrored.
    float specularDistance = 0;
    float specularWeight = 0;  ///< of the path that it is that of
    Colour tint;               ///< fraction of the light arriving there that is mirrored or transmitted
    std::uint32_t bounces = 0; ///< of the path that ended here: so often mirrored, refracted or passed
    bool shines = false;       ///< by itself
    float curvature = 0; ///< the mean of its surface, where that mirrors; above 0 bulges towards the viewer

    bool any() const { return wave != 0; }
};

/// Which parts of hits are recorded.
enum class PrimaryHitParts {
    None,
    Surface, ///< all but light: direct, soft, arriving, whole
    All
};

/// One for each thread; keeps its memory.
class PrimaryHits {
  public:
    /// Forgets the hits; the waves of so many samples are to come.
    void start(std::size_t samples);
    /// Takes from a wave the hits of samples that had none so far: what their rays see first, holes passed.
    /// For the other samples it takes what their hits mirror and transmit.
    void take(const Wave& wave, const Mesh& mesh, const MaterialTable& materials);
    /// Takes the light of the hits that the wave taken last found: all that the sums have by now.
    void takeSurfaceLight(const Wave& wave, const SampleSums& sums);
    /// Adds surfaces.contribution, the light of one light, at the hits that the wave taken last found.
    void addLight(const Wave& wave, bool areaLight);
    /// The same of ambient light as far as it is not occluded, or of the sky's.
    void addSurroundings(const Wave& wave, const HemisphereWave& light);

    /// Tells which of the points of the wave taken last are primary hits.
    void noteTaps(std::span<IndirectTap> taps) const {
        for (IndirectTap& tap : taps) tap.primary = hits_[tap.sample].wave == wave_;
    }
    /// Adds indirect light to the hit of a sample.
    void addIndirect(std::size_t sample, Colour light) {
        hits_[sample].soft += light;
        hits_[sample].surfaceLight += light;
    }

    /// By sample.
    std::span<const PrimaryHit> hits() const { return hits_; }

  private:
    void takeSpecular(const Wave& wave, std::size_t i, PrimaryHit& hit) const;
    template <typename Use>
    void forEachPresent(const Wave& wave, Use&& use);

    std::vector<PrimaryHit> hits_;
    std::uint32_t wave_ = 0;
};

} // namespace rtcore
