/// Arbitrary output variables (AOVs) of an image: properties of the first surfaces.
#pragma once

#include "rtcore/sampling/sample_id.h"
#include "rtcore/scene/camera.h"
#include "rtcore/shading/primary_hits.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

inline constexpr float kBackgroundDepth = 1e10F;

/// AOVs of a pixel: means over its samples, with zero for those that saw the background, but for the depth.
struct AovPixel {
    float depth = kBackgroundDepth; ///< of the nearest sample, scene units along the camera's axis;
                                    ///< of a panorama along its ray
    Vec3 normal;                    ///< in the scene's axes; shorter than 1 where samples differ
    Colour albedo;                  ///< fraction of light that is scattered, mirrored or transmitted
    Colour direct;                  ///< radiance due to direct light
    Colour soft;                    ///< radiance of sampled light (PrimaryHit)
    float visible = 1;              ///< fraction of the ambient light that arrives: ambient occlusion
    float covered = 0;              ///< fraction of the samples that hit something
    float matte =
        0; ///< mean of PrimaryHit::matte where that is more than what is mirrored of every sample, else 0
    float shining = 0; ///< fraction of the samples that hit something that shines by itself
};

/// Samples are added by tiles, in any order of tiles: those of one pixel by one thread at a time, always in
/// the same order.
class Aovs {
  public:
    /// Starts a frame; keeps its memory.
    void begin(const Camera& camera, int width, int height);
    /// Empty, with the memory given back.
    void clear() { *this = {}; }
    bool empty() const { return pixels_.empty(); }

    /// samples[i] saw hits[i].
    void add(std::span<const PrimaryHit> hits, std::span<const SampleId> samples);
    /// Sums become means.
    void finish(int threads);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Bytes that they take.
    static constexpr std::size_t bytesPerPixel() { return sizeof(AovPixel) + sizeof(Sums); }
    /// Row by row from the top.
    const std::vector<AovPixel>& pixels() const { return pixels_; }

  private:
    struct Sums {
        float arriving = 0, whole = 0;
        std::uint32_t samples = 0, matte = 0;
    };

    int width_ = 0, height_ = 0;
    Vec3 eye_, axis_;
    bool panorama_ = false;
    std::vector<AovPixel> pixels_;
    std::vector<Sums> sums_;
};

} // namespace rtcore
