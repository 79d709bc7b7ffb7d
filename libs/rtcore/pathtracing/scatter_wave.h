/// How paths go on from the points of a wave: mirrored, scattered by a lobe, or not at all.
#pragma once

#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/next_event.h"
#include "rtcore/pathtracing/path_batch.h"
#include "rtcore/pathtracing/path_names.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/wave.h"

namespace rtcore {

struct ScatterTask {
    const MaterialTable& materials;
    const LightSet& lights;
    PathSettings limits;
    std::uint32_t maxDepth; ///< RenderSettings::maxDepth
    PathNames names;
    const LightSamples* samples; ///< of the points that sampled a light; null: none did
};

/// Appends to `next`, which has room for them, a ray for each point with the trait kPoint whose path goes on.
/// `paths`: of the wave's rays; null for those of the camera.
void scatterPaths(const ScatterTask& task, const Wave& wave, PathBatch* paths, PathBatch& next);

} // namespace rtcore
