/// An image with all light that has no noise: Whitted's rays, lit by irradiance records of the view alone. It
/// depends on no seed and no number of samples, and is wrong here and there: it has no caustics, and where
/// light comes by small bright patches the records know little.
#pragma once

#include "rtcore/render/ray_images.h"

#include <cstddef>
#include <memory>

namespace rtcore {

/// The settings by which Whitted's rays render it.
RenderSettings steadySettings(const RenderSettings& settings);

/// Renders one, as RayImages do with `indirect.mode = "live"`. Its memory goes with it: some 10 to 80 MB of
/// records, cells and samples.
class SteadyImage {
  public:
    /// As ViewLight::beginWith(); the light is of steadySettings().
    void beginWith(const std::shared_ptr<const IndirectState>& kept) { rays_.beginWith(kept); }
    /// Into frame.steady, without the background where frame.transmitted tells of it; the rest of `frame`
    /// stays. False when control.cancel was set.
    bool render(const View& view, RenderControl& control, Frame& frame);
    /// Progress of render(), 0..1. Any thread.
    double fraction(const RenderControl& control) const { return rays_.fraction(control); }

    static constexpr std::size_t kBytesPerPixel = sizeof(Colour);

  private:
    RayImages rays_;
};

} // namespace rtcore
