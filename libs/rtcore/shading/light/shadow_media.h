/// Light that goes straight on through solids of glass that overlap or touch each other.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/shading/surface/surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Transmittance of a surface, and its part through a hole or a thin pane.
struct Passing {
    Colour all = kWhite, unbent = kWhite;
};

/// Where such light meets the surface of a solid.
struct MediaMeeting {
    std::uint32_t triangle;
    bool fromInside;
    float distance; ///< from the surface of a solid before, or the start
    float cosine;   ///< of the smooth normal
    float opacity, coverage;
    float fog; ///< transmittance along the distance, outside of solids
};

/// Of the way up to such a surface and the surface itself; `media` is updated to what lies behind it. Each
/// surface that is to be seen takes its Fresnel reflectance from the side of the lower index: total
/// reflection would make solids opaque to straight rays.
Passing passMedium(const Scene& scene, const MediaMeeting& at, MediaList& media);

/// Surfaces of solids that rays of light meet one after the other. What a ray is in at its start is known
/// once it has left all: so they are gathered first. One for each thread; keeps its memory.
class MediaMeetings {
  public:
    void start(std::size_t rays);
    /// Of a ray that has met all those before.
    void add(std::size_t ray, const MediaMeeting& at);
    /// Of all the surfaces that the ray met. A solid that it leaves without having come into it was around
    /// its start.
    Passing passing(const Scene& scene, std::size_t ray);

  private:
    struct Link {
        MediaMeeting at;
        std::uint32_t before; ///< the number of the ray's meeting before this one
    };
    std::vector<Link> links_;
    std::vector<std::uint32_t> last_; ///< by ray
    std::vector<MediaMeeting> way_;   ///< of one ray
};

} // namespace rtcore
