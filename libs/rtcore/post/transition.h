/// From an image to a better one of the same view, part by part: no jump is seen.
#pragma once

#include "rtcore/post/effect_chain.h"
#include "rtcore/post/exposure.h"
#include "rtcore/post/false_colours.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rtcore {

/// Keeps its memory. One thread at a time.
class Transition {
  public:
    static constexpr std::size_t kBytesPerPixel = sizeof(Colour) + sizeof(Rgba8) + 1; ///< beside its effects

    /// Begins with the radiance of `before`, of any size up to that of the settings, upsampled to it. Nothing
    /// is shown before expose(). `threads` = 0: all cores.
    void begin(const Frame& before, const RenderSettings& settings, int threads);
    /// False colours of images from expose() on; nothing: none.
    void showBy(const std::optional<FalseColours>& falseColours) { falseColours_ = falseColours; }
    /// From here on all is shown with that exposure, and with the settings' effects, as far as parts can have
    /// them (developPart()). By the calling thread.
    void expose(float exposure);
    /// These areas of `after`, of the size of the settings, have all their light. Half of it is seen now, all
    /// of it in the next step. Reads no other pixels of `after`.
    void step(const std::vector<PixelArea>& finished, const HdrImage& after);
    /// How much brighter the surfaces of the image are than at the beginning, for the exposure
    /// (LuminanceHistogram): an estimate from few of its pixels.
    float brightening();
    /// As it is shown.
    const LdrImage& image() const { return image_; }

  private:
    void develop(const PixelArea& area);
    template <typename Use>
    void forEachSparse(Use&& use) const;
    std::optional<float> sparseAverage();

    RenderSettings settings_;
    float exposure_ = 1;
    std::optional<FalseColours> falseColours_;
    EffectChain effects_;
    HdrImage radiance_;
    LdrImage image_;
    std::vector<PixelArea> halved_; ///< areas that show half of what is before them
    /// The pixels by which the brightness is measured.
    std::vector<Colour> sparse_;
    std::vector<std::uint8_t> sparseCovered_;
    LuminanceHistogram sparseHistogram_;
    std::optional<float> averageBefore_;
};

} // namespace rtcore
