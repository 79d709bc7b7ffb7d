/// Images by any integrator: whose renderer is which is known here alone.
#pragma once

#include "rtcore/gathering/indirect_state.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/render/background.h"
#include "rtcore/render/frame.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/pixel_area.h"
#include "rtcore/render/view.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace rtcore {

/// An image that is yet to be finished.
struct ImagePass {
    const Frame& frame;
    int block;             ///< pixels a side of the squares that share one sample
    std::uint32_t samples; ///< of each pixel, or square
    const Aovs* surfaces;  ///< of the view, where its noise may be filtered before it is shown; else null
    const Guides* guides;  ///< the same for a net, where the request asks for guides; else null
};

struct ImageRequest {
    bool aovs = false;
    bool guides = false; ///< in the frame; those by Whitted's rays, whose noise no net takes away, have none
    Background background = Background::Shown;
    /// Gets what there is before the image itself, which it may read until it returns; empty: only the image
    /// is wanted.
    std::function<void(const ImagePass&)> show = {};
};

/// A remark on an image for people.
struct ImageRemark {
    Sentence text;
    bool detail;  ///< only for those who ask for details
    bool ofScene; ///< all images of a scene have the same
};

/// Renders one image after another and keeps its memory. Not for several threads at once: it uses all of
/// those of the control itself.
class ImageRenderer {
  public:
    virtual ~ImageRenderer() = default;

    /// Renders into `frame`, whose memory is reused when the size fits. The image has the same bits for every
    /// number of threads, and whatever is shown before it. False when control.cancel was set, with `frame`
    /// undefined.
    virtual bool render(const View& view, RenderControl& control, const ImageRequest& request,
                        Frame& frame) = 0;
    /// Whether AOVs come with the image, at no other cost than their memory; else they are rendered after it.
    virtual bool rendersAovs() const = 0;
    /// Remarks on the last image.
    virtual std::vector<ImageRemark> remarks() const { return {}; }

    /// Indirect light of images to come begins with that, as ViewLight::beginWith().
    virtual void beginWith(const std::shared_ptr<const IndirectState>& /*kept*/) {}

    /// Progress of render(), 0..1. Any thread.
    virtual double fraction(const RenderControl& control) const { return control.fraction(); }
    /// Parts of the image itself that are done since the last call, while it is rendered with
    /// request.show. Any thread.
    virtual std::vector<PixelArea> takeFinishedTiles() { return {}; }
};

std::unique_ptr<ImageRenderer> makeImageRenderer(Integrator integrator);

/// One for each integrator, made when it is asked for.
class ImageRenderers {
  public:
    ImageRenderer& of(Integrator integrator);
    /// As ViewLight::beginWith().
    void beginWith(std::shared_ptr<const IndirectState> kept);

  private:
    std::shared_ptr<const IndirectState> kept_;
    std::vector<std::unique_ptr<ImageRenderer>> renderers_;
};

} // namespace rtcore
