#include "rtcore/sections/cap_painter.h"

#include "rtcore/sections/cap_image.h"

namespace rtcore {

const SectionCaps& CapPainter::capsOf(const Scene& scene) {
    const bool sameModel = known_ && model_ == scene.model.storage;
    if (sameModel && planes_ == scene.sections.planes && hidden_ == scene.hiddenParts &&
        uncut_ == scene.uncutParts && up_ == scene.up)
        return caps_;
    if (!sameModel) {
        pieces_.reset();
        model_ = scene.model.storage;
        known_ = scene.model;
        pieces_.emplace(*known_);
    }
    caps_ = sectionCapsOf(scene, *pieces_);
    if (!sameModel || hidden_ != scene.hiddenParts || uncut_ != scene.uncutParts) cover_.reset();
    if (scene.uncutParts != nullptr && !caps_.empty() && !cover_) cover_.emplace(scene);
    planes_ = scene.sections.planes;
    hidden_ = scene.hiddenParts;
    uncut_ = scene.uncutParts;
    up_ = scene.up;
    return caps_;
}

bool CapPainter::paints(const Scene& scene) {
    return !scene.sections.empty() && scene.sections.caps.colours != CapColours::None;
}

std::vector<std::string> CapPainter::openParts(const Scene& scene) {
    if (!paints(scene)) return {};
    const std::lock_guard lock(mutex_);
    return capsOf(scene).openParts;
}

void CapPainter::paint(const Scene& scene, const Camera& camera, LdrImage& image) {
    if (camera.kind == CameraKind::Panorama) return;
    if (!paints(scene)) return;
    const std::lock_guard lock(mutex_);
    const SectionCaps& caps = capsOf(scene);
    if (cover_) before_ = image;
    const bool own = scene.sections.caps.colours == CapColours::Own;
    paintCaps(caps, scene.sections.caps, own ? colours_.of(scene, caps) : std::vector<Colour>(), camera,
              image);
    if (cover_) cover_->restore(scene, camera, before_, image);
}

} // namespace rtcore
