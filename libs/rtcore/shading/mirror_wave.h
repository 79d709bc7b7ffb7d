/// The mirrored rays of a wave.
#pragma once

#include "rtcore/shading/frame_context.h"
#include "rtcore/shading/paths/path_queue.h"
#include "rtcore/shading/wave.h"

namespace rtcore {

/// Appends a mirrored ray to `queue` for each point with the trait kSpecular whose ray was mirrored or
/// refracted less than settings.maxDepth times and matters (minContribution). The direction is bent back
/// where a smooth normal would send it below the real surface. Where a highlight stands for them, rays do not
/// see the discs of lights (Path::lobeSeesDiscs).
void addMirroredRays(const FrameContext& frame, const Wave& wave, PathQueue& queue);

} // namespace rtcore
