/// The rules that a model must keep so that nothing behind it needs to ask again.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/model.h"

#include <optional>

namespace rtcore {

/// Positions, lengths and intensities up to here: their squares and products stay finite in the tracer.
inline constexpr float kLargestNumber = 1e18F;

/// Checks sizes against each other, every index, and every number: finite, at most kLargestNumber, and inside
/// the range that scene/*.h documents. Normals are of unit length or zero; colours may carry a rounding
/// error. Nothing when all is well, else "section: what is wrong". Linear time, a few milliseconds per
/// million triangles.
std::optional<Sentence> checkModel(const Model& model);

/// Its part for what is not geometry.
std::optional<Sentence> checkMaterials(const Model& model);
std::optional<Sentence> checkTextures(const Model& model);
std::optional<Sentence> checkLights(const Model& model);
std::optional<Sentence> checkCameras(const Model& model);

} // namespace rtcore
