/// The cost of sections: frames of one scene with and without them, in turns.
#pragma once

#include "rtcore/io/scene_loader.h"
#include "rtcore/scene/section_planes.h"
#include "rtcore/settings/render_settings.h"

namespace rtbench {

/// Renders, one after the other in each of `rounds` rounds, by one thread: the scene without a section by its
/// surfaces, and by what it is shown by; with a plane that misses the model; with `plane`, where light falls
/// in, and where it stays; where it falls in, `withRebuilt` asks for the same by a tree of what is left, too;
/// and the model whose triangles `plane` has cut, by a tree of its own. Prints medians and minima of the
/// processor time, and the medians of its ratios within a round and the ratios of minima. Sections of the
/// scene do not count.
void raceSections(const rtcore::LoadedScene& loaded, const rtcore::RenderSettings& settings,
                  const rtcore::SectionPlane& plane, int rounds, bool withRebuilt);

} // namespace rtbench
