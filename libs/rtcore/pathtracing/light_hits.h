/// Area lights hit by scattered rays: the other strategy for light that next event samples. The camera does
/// not see lights that have a position; mirrors and glass that bends show those that are set to be seen so
/// (lights/mirrored_light.h). Discs are seen by all.
#pragma once

#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_batch.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/shading/wave.h"

namespace rtcore {

/// Sets surfaces.contribution to the radiance of area lights with a position that each ray of the wave meets
/// before its surface, weighted by the power heuristic against next event. The wave is that of the batch.
void addLightHits(const LightRows& lights, SamplingStrategy strategy, PathBatch& batch, Wave& wave);

/// The density with which next event samples the direction of each ray of the wave that meets no surface,
/// where it samples the surroundings, into `densities`: room for a block more. The others become undefined.
void densitiesOfEscaped(const EnvironmentRows& surroundings, const VisibilityRows& visible,
                        const PathBatch& batch, const Wave& wave, float* densities);

/// The radiance of the disc of a light, where a ray that leaves the scene meets it; else black.
Colour discSeen(const Light& light, Vec3 direction);

/// The density with which next event at the origin of the scattered ray `i` samples the light `k`, whose disc
/// the ray meets.
float densityOfDisc(const LightRows& lights, const PathBatch& batch, std::size_t i, std::uint32_t k);
/// The probability that next event there selects that cluster of emitters, or the surroundings.
float probabilityOfEmitters(const LightRows& lights, const PathBatch& batch, std::size_t i,
                            std::uint32_t cluster);
float probabilityOfSurroundings(const LightRows& lights, const PathBatch& batch, std::size_t i);

} // namespace rtcore
