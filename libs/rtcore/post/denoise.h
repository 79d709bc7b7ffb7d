/// Removes the noise of light that was sampled with few rays.
#pragma once

#include "rtcore/post/effect.h"
#include "rtcore/render/aovs.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <atomic>
#include <vector>

namespace rtcore {

/// Wavelets with holes (Dammertz, Sewtz, Hanika and Lensch 2010) over the sampled light - area lights and
/// ambient light; all light through a lens - divided by the albedo, so that textures, mirrored images and
/// hard shadows stay as they are. Neighbours are weighted by how far normals agree, by whether they lie in
/// one plane, and by whether their light differs by no more than the noise, which is measured in blocks of 8
/// x 8 pixels: where there is no noise, nothing changes. Of images by paths, single bright pixels are taken
/// out first.
class Denoiser final : public Effect {
  public:
    /// `picture` after settings.denoise.passes; itself when nothing was sampled, or there are no AOVs of
    /// its size. Parts of a preview keep their noise.
    const HdrImage& apply(const HdrImage& picture, const Aovs& aovs, const EffectRun& run) override;

    /// Memory that is kept for each pixel.
    static constexpr std::size_t bytesPerPixel() { return kPlanes * sizeof(float) + sizeof(Colour); }

  private:
    using Plane = std::vector<float>;
    static constexpr std::size_t kPlanes = 17; ///< members below

    void resize(int width, int height);
    void fillGuides(const Aovs& aovs, bool all, int threads);
    bool fillLight(const HdrImage& picture, const Aovs& aovs, bool all, int threads);
    void fillImage(const HdrImage& picture, const Aovs& aovs, bool all, int threads);
    void fillSlopes(int threads);
    bool alike(std::size_t a, std::size_t b) const;
    struct Around;
    void dropSpikes(int threads);
    void brighten(int threads);
    void measureNoise(int threads);
    void filter(int pass, int threads);
    void filterRow(int pass, int y, float* sums);
    void takeTap(int y, int dx, int dy, float kernel, float planeTolerance, float* sums) const;

    bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
    std::size_t row(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_); }

    const std::atomic<bool>* stop_ = nullptr;
    int width_ = 0, height_ = 0;
    Plane normal_[3];         ///< unit; zero for the background
    Plane nearness_;          ///< 1 / depth, which is linear over a plane's image
    Plane across_, down_;     ///< its slope, per pixel
    Plane albedo_[3];         ///< that light is divided by
    Plane light_[3], bright_; ///< and its luminance
    Plane result_[3];
    Plane noise_;                          ///< standard deviation of the luminance's noise
    std::vector<float> blocks_;            ///< the same for blocks
    std::vector<std::vector<float>> rows_; ///< by thread
    HdrImage image_;
};

extern const EffectRow kDenoiseEffect;

} // namespace rtcore
