/// The light that falls on what a view shows, as a photographer's incident meter measures it.
#pragma once

#include "rtcore/render/frame.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/image_renderer.h"
#include "rtcore/render/view.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace rtcore {

/// Measures one view after another and keeps its memory. Not for several threads at once: it uses those of
/// the control itself.
class LightMeter {
  public:
    /// The radiance of a surface that scatters all light, in light that a tenth of what is seen has more of:
    /// of a small image by the settings' integrator, each pixel's luminance over what its surface scatters.
    /// The background, what shines by itself, and what mostly mirrors or lets light through are left out;
    /// where nearly all shines, as in games that were made without lights, such surfaces count as what they
    /// scatter and give off, if they scatter a tenth. Nothing where little else is seen, where no light
    /// falls, or when control.cancel was set. A function of the scene, the camera, the settings and the
    /// image's aspect alone: the same bits for any size of the image, any number of threads and any
    /// instruction set.
    std::optional<float> white(const View& view, RenderControl& control);
    /// The same by one sample for each pixel of a smaller image, a twentieth of the work: within some
    /// percent. For images that move.
    std::optional<float> roughWhite(const View& view, RenderControl& control);
    /// Images to come by rays are lit by this, which must outlive them; null: each by what it has learned
    /// itself, on which alone white() is what it says.
    void lightIndirectlyFrom(const IndirectLight* light) { light_ = light; }
    /// Where each image learns itself: as ViewLight::beginWith().
    void beginWith(std::shared_ptr<const IndirectState> kept) { images_.beginWith(std::move(kept)); }

  private:
    std::optional<float> whiteOf(const View& small, RenderControl& control);
    bool render(const View& view, RenderControl& control);
    bool findSurfaces(const View& view, RenderControl& control);
    enum class Metered { Lit, Shining };
    /// The white of such surfaces, in the view that was rendered last.
    std::optional<float> whiteOn(Metered what);

    ImageRenderers images_;
    FrameRenderer rays_; ///< for AOVs that do not come with the image, and for light of the cache
    const IndirectLight* light_ = nullptr;
    Frame frame_, surfaces_;
    std::vector<float> whites_; ///< of the pixels that count
};

} // namespace rtcore
