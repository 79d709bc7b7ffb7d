/// Where sections stand in the model's box, and where a hand takes hold of them.
#pragma once

#include "gui/models/scene_image.h"
#include "gui/models/space_polygon.h"

#include "rtcore/math/box.h"
#include "rtcore/scene/section_planes.h"

#include <cstddef>
#include <optional>

namespace gui {

/// One plane; scene units from the scene's zero.
struct SectionMark {
    SpacePolygon outline; ///< what other sections leave of it in the box; empty: it misses the box
    rtcore::Vec3d normal; ///< of unit length
    rtcore::Vec3d middle; ///< of the box, moved along the normal into the plane
    double back = 0,
           on = 0; ///< how far it can go along its normal before it leaves the box: from <= 0 to >= 0
};

/// `number`: from 0, one of them. Of a plane that others take away as a whole the outline is that without
/// them. `bounds` of the model are not empty.
SectionMark markOf(const rtcore::SectionPlanes& sections, std::size_t number, const rtcore::Box3& bounds);

/// A point of the plane: the middle of what the image shows of its outline, a little away from the edges. Of
/// a plane that misses the box beside its middle. Nothing where neither is seen.
std::optional<rtcore::Vec3d> holdOf(const SectionMark& mark, const SceneImage& image);

} // namespace gui
