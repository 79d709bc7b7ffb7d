/// The media on both sides of where a ray meets the surfaces of solids of glass that overlap or touch each
/// other. (Schmidt and Budge 2002, "Simple Nested Dielectrics in Ray Traced Images")
#pragma once

#include "rtcore/scene/media_list.h"
#include "rtcore/scene/scene.h"

#include <cstdint>

namespace rtcore {

/// A ray comes from one medium into another.
struct MediaCrossing {
    const Material* before = nullptr; ///< null: air
    const Material* after = nullptr;
    MediaList list;       ///< behind it
    bool visible = false; ///< the medium changes
};

/// Whether the triangle, of this material, bounds a medium: glass, and where an index of 1 and no tint are
/// all that there is to it, a bubble that covers nothing or has a priority. False where no solids can
/// overlap.
bool boundsMedium(const Scene& scene, std::uint32_t triangle, const Material& material);

/// Whether it bounds a solid that light is bent or absorbed in, whether or not some overlap.
bool boundsSolid(const Scene& scene, std::uint32_t triangle, const Material& material);

/// The crossing of such a triangle's surface, from `list`. Of the media that a point is in, that of the
/// highest priority is there; of equal ones, that which the ray came into last. One that it leaves without
/// having come into it counts as come into before all others.
MediaCrossing crossMedia(const Scene& scene, std::uint32_t triangle, bool fromInside, MediaList list);

/// The surface of a solid that a ray meets.
struct MediaFace {
    std::uint32_t triangle; ///< for which boundsMedium()
    bool fromInside;
};
/// What a ray is in at its start that meets these surfaces one after the other up to where it is outside of
/// all: those that it leaves without having come into them.
class MediaAtStart {
  public:
    void meet(const Scene& scene, MediaFace face);
    MediaList media() const { return start_; }

  private:
    MediaList start_, now_;
};

/// The medium that is there of the list; null: air.
const Material* mediumOf(const Scene& scene, MediaList list);

} // namespace rtcore
