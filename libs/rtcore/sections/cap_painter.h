/// The caps of a scene as it changes, painted over image after image.
#pragma once

#include "rtcore/scene/image.h"
#include "rtcore/scene/scene.h"
#include "rtcore/sections/cap_colours.h"
#include "rtcore/sections/section_caps.h"
#include "rtcore/sections/uncut_cover.h"

#include <memory>
#include <mutex>
#include <optional>

namespace rtcore {

/// Keeps what it found of a scene until its sections, its hidden parts or its model are others. Several
/// threads take turns.
class CapPainter {
  public:
    /// Over an image of the scene by this camera (cap_image.h), where no part that is left whole stands
    /// before them. Nothing where no section cuts it.
    void paint(const Scene& scene, const Camera& camera, LdrImage& image); ///< nothing of a panorama
    /// Whether paint() would do anything to an image that shows them.
    static bool paints(const Scene& scene);
    /// Names of parts that the scene's sections cut and that are not closed: they have no caps.
    std::vector<std::string> openParts(const Scene& scene);

  private:
    const SectionCaps& capsOf(const Scene& scene);

    std::mutex mutex_;
    std::shared_ptr<const void> model_; ///< owns what `pieces_` knows of
    std::optional<Model> known_;
    std::optional<ClosedPieces> pieces_;
    std::vector<SectionPlane> planes_;
    PartSet hidden_, uncut_;
    Vec3 up_;
    SectionCaps caps_;
    CapMaterialColours colours_;
    std::optional<UncutCover> cover_; ///< where there are caps, and parts that are left whole
    LdrImage before_;
};

} // namespace rtcore
