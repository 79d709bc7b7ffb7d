/// Area lights that scattered rays meet: the other way to find what next event samples. Those that have a
/// place are not seen by the camera, and in mirrors and through glass that bends those alone that are to be
/// (lights/mirrored_light.h); discs are.
#pragma once

#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_batch.h"
#include "rtcore/pathtracing/sampling_strategy.h"
#include "rtcore/shading/wave.h"

namespace rtcore {

/// Sets surfaces.contribution to what each ray of the wave meets of area lights that have a place before its
/// surface, weighted by the power heuristic against next event. The wave is that of the batch.
void addLightHits(const LightRows& lights, SamplingStrategy strategy, PathBatch& batch, Wave& wave);

/// environmentDensity() of the directions of those rays of the wave that meet no surface, into
/// `densities`: room for a block more. The others become undefined.
void densitiesOfEscaped(const EnvironmentRows& surroundings, const Wave& wave, float* densities);

/// The radiance of the disc of a light, where a ray that leaves the scene meets it; else black.
Colour discSeen(const Light& light, Vec3 direction);

/// With which probability density the point that the ray `i` of the batch was scattered at sampled the light
/// `k`, whose disc the ray meets; with which probability it sampled the emitters, or the surroundings.
float densityOfDisc(const LightRows& lights, const PathBatch& batch, std::size_t i, std::uint32_t k);
/// With which probability that point sampled the emitters, or the surroundings.
float probabilityOfEmitters(const LightRows& lights, const PathBatch& batch, std::size_t i);
float probabilityOfSurroundings(const LightRows& lights, const PathBatch& batch, std::size_t i);

} // namespace rtcore
