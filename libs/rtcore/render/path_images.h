/// Images by path tracing, shown after each round of samples.
#pragma once

#include "rtcore/render/image_renderer.h"
#include "rtcore/render/path_renderer.h"
#include "rtcore/render/steady_image.h"

#include <memory>
#include <mutex>

namespace rtcore {

class PathImages : public ImageRenderer {
  public:
    bool render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) override;
    bool rendersAovs() const override { return false; }
    void beginWith(const std::shared_ptr<const IndirectState>& kept) override { kept_ = kept; }
    std::vector<ImageRemark> remarks() const override;
    double fraction(const RenderControl& control) const override;

  private:
    /// The part of an image's time that the work at hand takes, which its control counts.
    struct Span {
        double before = 0, size = 0;
    };
    void enter(const Span& span, RenderControl& control);
    void setSpan(const Span& span);
    Span span() const;
    bool findSteady(const View& view, RenderControl& control, Frame& frame);
    bool findSteadyMeanwhile(const View& view, RenderControl& control, Frame& frame);
    bool findSurfaces(const View& view, RenderControl& control, int samples);
    bool findGuides(const View& view, RenderControl& control, GuideRays rays, Frame& frame);
    bool showCoarse(const View& view, RenderControl& control, const ImageRequest& request);
    bool renderPaths(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame);

    std::shared_ptr<const IndirectState> kept_; ///< light that steady images begin with
    PathRenderer paths_;
    FrameRenderer rays_;
    Frame surfaces_; ///< by rays
    Frame coarse_;   ///< the first that is shown
    GuideRays guideRays_ = GuideRays::All;
    mutable std::mutex mutex_; ///< guards all below
    Span span_;
    std::unique_ptr<SteadyImage> steady_; ///< while it is rendered
};

} // namespace rtcore
