/// The truth of a walk - images that should be seen - by the method that the options ask for.
#pragma once

#include "bench/walk/light_errors.h"
#include "bench/walk/played_walk.h"
#include "bench/walk/walk_options.h"

#include "rtcore/scene/camera.h"
#include "rtcore/scene/image.h"
#include "support/flip.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace bench {

/// A picture as it is shown, and as it should be: of one size.
struct PicturePair {
    rtcore::LdrImage shown, wanted;
    float pixelsPerDegree = test::Flip::kPixelsPerDegree; ///< where both fill the window
    std::optional<LightErrors> light = {};                ///< of radiance, where it is known
    std::optional<LightErrors> uncovered = {}; ///< of what a turn from the camera before brought into view
};

class WalkTruth {
  public:
    virtual ~WalkTruth() = default;

    /// Work that takes long, before the walk. Returns early when the program was asked to stop; the next run
    /// goes on from there.
    virtual void prepare() {}
    /// The pair of a picture that is seen at the moment of that camera, one that is compared.
    virtual PicturePair pairOf(const Published& picture, std::size_t camera) = 0;
};

/// All must outlive it.
std::unique_ptr<WalkTruth> makeTruth(const WalkOptions& options, const LiveServer& server,
                                     const std::vector<rtcore::Camera>& cameras);

} // namespace bench
