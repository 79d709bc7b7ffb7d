/// A model whose triangles a plane has really cut: what a section is compared with.
#pragma once

#include "rtcore/scene/model.h"
#include "rtcore/scene/section_planes.h"

namespace rtbench {

/// What the plane leaves, as rays meet it (SectionClip): triangles that it cuts become one or two of new
/// corners. Parts, materials and textures are the model's, which must outlive it.
rtcore::Model cutModel(const rtcore::Model& model, const rtcore::SectionPlane& plane);

} // namespace rtbench
