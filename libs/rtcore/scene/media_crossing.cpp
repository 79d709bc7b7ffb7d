#include "rtcore/scene/media_crossing.h"

#include <array>
#include <span>

namespace rtcore {

namespace {

float priorityOf(const Scene& scene, std::uint16_t medium) { return scene.material(medium - 1U).priority; }

/// 0: air.
std::uint16_t actual(const Scene& scene, MediaList list) {
    std::uint16_t best = 0;
    for (int i = 0; i < MediaList::kMax && list[i] != 0; ++i) {
        if (best == 0 || priorityOf(scene, list[i]) > priorityOf(scene, best)) best = list[i];
    }
    return best;
}

/// A bubble that lies in no glass is air.
bool isOpen(const Scene& scene, MediaList list) {
    for (int i = 0; i < MediaList::kMax && list[i] != 0; ++i) {
        if (!isVeil(scene.material(list[i] - 1U))) return false;
    }
    return true;
}

/// One of the surfaces that lie there.
struct Face {
    std::uint16_t medium;
    bool leaving;
};
class Faces {
  public:
    Faces(const Scene& scene, std::uint32_t triangle, bool fromInside)
        : faces_{Face{scene.solids->medium[triangle], fromInside}} {
        const GlassSolids::Twin* const twin = scene.solids->twinOf(triangle);
        if (twin == nullptr) return;
        const Material& material = scene.material(scene.mesh().shading[twin->other].material);
        if (boundsMedium(scene, twin->other, material))
            faces_[count_++] = {scene.solids->medium[twin->other], twin->sameSide == fromInside};
    }
    std::span<const Face> all() const { return {faces_.data(), count_}; }

  private:
    std::array<Face, 2> faces_;
    std::size_t count_ = 1;
};

} // namespace

bool boundsMedium(const Scene& scene, std::uint32_t triangle, const Material& m) {
    if (scene.solids == nullptr || !scene.solids->overlap) return false;
    if (triangle >= scene.solids->medium.size() || scene.solids->medium[triangle] == 0) return false;
    if (!(m.opacity < 1)) return false;
    const bool covers = m.opacity > 0 || hasHoles(m) || m.transmissionTexture != kNoTexture;
    return !isVeil(m) || !covers || m.priority > 0;
}

bool boundsSolid(const Scene& scene, std::uint32_t triangle, const Material& m) {
    if (scene.solids == nullptr) return false;
    if (scene.solids->overlap) return boundsMedium(scene, triangle, m);
    return triangle < scene.solids->medium.size() && scene.solids->medium[triangle] != 0 && m.opacity < 1 &&
           !isVeil(m);
}

const Material* mediumOf(const Scene& scene, MediaList list) {
    return isOpen(scene, list) ? nullptr : &scene.material(actual(scene, list) - 1U);
}

void MediaAtStart::meet(const Scene& scene, MediaFace met) {
    const Faces faces(scene, met.triangle, met.fromInside);
    for (const Face& face : faces.all()) {
        if (face.leaving && !now_.leave(face.medium)) start_.enterFirst(face.medium);
    }
    for (const Face& face : faces.all()) {
        if (!face.leaving) now_.enter(face.medium);
    }
}

MediaCrossing crossMedia(const Scene& scene, std::uint32_t triangle, bool fromInside, MediaList list) {
    const Faces faces(scene, triangle, fromInside);
    MediaList before = list;
    for (const Face& face : faces.all()) {
        if (face.leaving && !list.leave(face.medium)) before.enterFirst(face.medium);
    }
    for (const Face& face : faces.all()) {
        if (!face.leaving) list.enter(face.medium);
    }
    // A solid may have several materials: that of the face counts where a ray comes into it or leaves it.
    const std::uint16_t own = scene.solids->medium[triangle];
    const auto there = [&](MediaList media, bool here) {
        if (isOpen(scene, media)) return static_cast<const Material*>(nullptr);
        const std::uint16_t medium = actual(scene, media);
        return &scene.material(here && medium == own ? scene.mesh().shading[triangle].material : medium - 1U);
    };
    return {there(before, fromInside), there(list, !fromInside), list,
            actual(scene, before) != actual(scene, list)};
}

} // namespace rtcore
