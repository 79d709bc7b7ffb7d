#include "rtcore/shading/light/shadow_media.h"

#include "rtcore/scattering/fresnel.h"
#include "rtcore/scene/media_crossing.h"
#include "rtcore/shading/surface/medium.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr std::uint32_t kNoMeeting = 0xFFFFFFFFU;

float indexOf(const Material* medium) { return medium != nullptr ? medium->indexOfRefraction : 1.0F; }

} // namespace

Passing passMedium(const Scene& scene, const MediaMeeting& at, MediaList& media) {
    const MediaCrossing crossing = crossMedia(scene, at.triangle, at.fromInside, media);
    media = crossing.list;
    const Colour left = crossing.before != nullptr ? absorption(extinctionOf(*crossing.before), at.distance)
                                                   : kWhite * at.fog;
    if (!crossing.visible) return {left, left};
    Colour through{};
    if (at.opacity < 1) {
        const float before = indexOf(crossing.before), after = indexOf(crossing.after);
        const float reflected =
            fresnelDielectric(at.cosine, std::max(before, after) / std::min(before, after));
        through = kWhite * (1 - at.opacity) * (1 - reflected);
        if (crossing.after != nullptr) through *= tintOnEntering(*crossing.after);
        if (crossing.before != nullptr) through *= left;
    }
    const float fog = crossing.before != nullptr ? 1.0F : at.fog;
    const Colour holes = kWhite * (1 - at.coverage);
    return {(holes + through * at.coverage) * fog, holes * fog};
}

void MediaMeetings::start(std::size_t rays) {
    links_.clear();
    last_.assign(rays, kNoMeeting);
}

void MediaMeetings::add(std::size_t ray, const MediaMeeting& at) {
    links_.push_back({at, last_[ray]});
    last_[ray] = static_cast<std::uint32_t>(links_.size() - 1);
}

Passing MediaMeetings::passing(const Scene& scene, std::size_t ray) {
    way_.clear();
    for (std::uint32_t i = last_[ray]; i != kNoMeeting; i = links_[i].before) way_.push_back(links_[i].at);
    std::reverse(way_.begin(), way_.end());
    MediaAtStart start;
    for (const MediaMeeting& at : way_) start.meet(scene, {at.triangle, at.fromInside});
    MediaList media = start.media();
    Passing passing;
    for (const MediaMeeting& at : way_) {
        const Passing one = passMedium(scene, at, media);
        passing.all *= one.all;
        passing.unbent *= one.unbent;
    }
    return passing;
}

} // namespace rtcore
