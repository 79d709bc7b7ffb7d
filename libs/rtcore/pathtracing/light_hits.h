/// Area lights that scattered rays meet: the other way to find what next event samples. Lights are not seen
/// by the camera, nor in mirrors and through glass that bends.
#pragma once

#include "rtcore/pathtracing/light_finding.h"
#include "rtcore/pathtracing/light_set.h"
#include "rtcore/pathtracing/path_batch.h"
#include "rtcore/shading/wave.h"

namespace rtcore {

/// Sets surfaces.added to what each ray of the wave meets of area lights before its surface, weighted by the
/// power heuristic against next event. The wave is that of the batch.
void addLightHits(const LightRows& lights, LightFinding finding, PathBatch& batch, Wave& wave);

/// EnvironmentDraw::density() of the directions of those rays of the wave that meet no surface, into
/// `densities`: room for a block more. The others become undefined.
void densitiesOfEscaped(const EnvironmentRows& surroundings, const Wave& wave, float* densities);

/// With which probability the point that the ray `i` of the batch was scattered at sampled the emitters, or
/// the surroundings.
float probabilityOfEmitters(const LightRows& lights, const PathBatch& batch, std::size_t i);
float probabilityOfSurroundings(const LightRows& lights, const PathBatch& batch, std::size_t i);

} // namespace rtcore
