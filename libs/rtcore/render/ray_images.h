/// Images by Whitted's ray tracing, shown from coarse to fine.
#pragma once

#include "rtcore/render/image_renderer.h"
#include "rtcore/render/refinement.h"
#include "rtcore/render/view_light.h"

#include <atomic>
#include <memory>

namespace rtcore {

class RayImages : public ImageRenderer {
  public:
    bool render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) override;
    bool rendersAovs() const override { return true; }
    void beginWith(const std::shared_ptr<const IndirectState>& kept) override { light_.beginWith(kept); }
    double fraction(const RenderControl& control) const override;
    std::vector<PixelArea> takeFinishedTiles() override { return refinement_.finishedTiles().take(); }

  private:
    bool learnAndRender(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame);
    bool learn(const View& view, RenderControl& control);

    FrameRenderer renderer_;
    ViewLight light_;
    Refinement refinement_;
    std::atomic<bool> refines_{false};      ///< the image is shown meanwhile
    std::atomic<bool> learns_{false};       ///< indirect light, before the image is rendered
    std::atomic<double> learningPart_{0.0}; ///< of the work: 0..1
};

} // namespace rtcore
