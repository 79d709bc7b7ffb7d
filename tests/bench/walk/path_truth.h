/// The truth of a walk with all of its light: that of paths.
#pragma once

#include "bench/walk/path_references.h"
#include "bench/walk/walk_truth.h"

#include "rtcore/post/develop.h"
#include "rtcore/render/frame_renderer.h"
#include "rtcore/render/light_meter.h"

namespace bench {

/// In the pixels of the references, each image with its own exposure: the walk's picture with the one that it
/// was shown with, the mean of the references with that which suits it.
class PathTruth : public WalkTruth {
  public:
    /// `settings` develop the references. All but them must outlive it.
    PathTruth(const WalkOptions& options, const LiveServer& server,
              const std::vector<rtcore::Camera>& cameras, const rtcore::RenderSettings& settings);

    void prepare() override { references_.renderMissing(); }
    PicturePair pairOf(const Published& picture, std::size_t camera) override;

  private:
    void addEffects(rtcore::HdrImage& radiance);
    void findCover(const rtcore::Camera& camera, rtcore::Frame& frame);
    float exposureOf(const rtcore::Camera& camera, const rtcore::Frame& frame);
    rtcore::LdrImage develop(const rtcore::HdrImage& radiance, const rtcore::RenderSettings& settings,
                             float exposure);

    const WalkOptions& options_;
    const LiveServer& server_;
    const std::vector<rtcore::Camera>& cameras_;
    rtcore::RenderSettings settings_;
    PathReferences references_;
    rtcore::FrameRenderer rays_;
    rtcore::LightMeter meter_;
    rtcore::PictureDeveloper developer_;
};

} // namespace bench
