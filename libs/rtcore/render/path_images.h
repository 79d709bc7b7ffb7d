/// Images by path tracing, shown after each round of samples.
#pragma once

#include "rtcore/render/image_renderer.h"
#include "rtcore/render/path_renderer.h"

namespace rtcore {

class PathImages : public ImageRenderer {
  public:
    bool render(const View& view, RenderControl& control, const ImageRequest& request, Frame& frame) override;
    bool rendersAovs() const override { return false; }
    std::vector<ImageRemark> remarks() const override;

  private:
    bool findSurfaces(const View& view, int threads, int samples);

    PathRenderer paths_;
    FrameRenderer rays_;
    Frame surfaces_; ///< by rays
};

} // namespace rtcore
