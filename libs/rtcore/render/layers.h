/// What is known of the first surfaces of a picture, beside the light that reaches the camera.
#pragma once

#include "rtcore/sampling/sample_id.h"
#include "rtcore/scene/camera.h"
#include "rtcore/shading/first_hits.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

inline constexpr float kBackgroundDepth = 1e10F;

/// Of a pixel: means over its samples, with zero for those that saw the background, but for the depth.
struct LayerPixel {
    float depth = kBackgroundDepth; ///< of the nearest sample, scene units along the camera's axis
    Vec3 normal;                    ///< in the scene's axes; shorter than 1 where samples differ
    Colour albedo;                  ///< share of light that goes on: scattered, mirrored, let through
    Colour direct;                  ///< radiance by light that comes straight from lights
    Colour soft;                    ///< radiance by light that was sampled (FirstHit)
    float visible = 1;              ///< share of the light from everywhere that arrives: ambient occlusion
    float covered = 0;              ///< share of the samples that hit something
};

/// Samples are added by tiles, in any order of tiles: those of one pixel by one thread at a time, always in
/// the same order.
class FrameLayers {
  public:
    /// Starts a frame; keeps its memory.
    void begin(const Camera& camera, int width, int height);
    /// There are no layers. Gives memory back.
    void clear() { *this = {}; }
    bool empty() const { return pixels_.empty(); }

    /// samples[i] saw hits[i].
    void add(std::span<const FirstHit> hits, std::span<const SampleId> samples);
    /// Sums become means.
    void finish(int threads);

    int width() const { return width_; }
    int height() const { return height_; }
    /// Bytes that they take.
    static constexpr std::size_t bytesPerPixel() { return sizeof(LayerPixel) + sizeof(Sums); }
    /// Row by row from the top.
    const std::vector<LayerPixel>& pixels() const { return pixels_; }

  private:
    struct Sums {
        float arriving = 0, whole = 0;
        std::uint32_t samples = 0;
    };

    int width_ = 0, height_ = 0;
    Vec3 eye_, axis_;
    std::vector<LayerPixel> pixels_;
    std::vector<Sums> sums_;
};

} // namespace rtcore
