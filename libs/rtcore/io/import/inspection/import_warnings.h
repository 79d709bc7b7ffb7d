/// Warnings of an import about a model that it could read.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/model.h"

#include <span>
#include <string>

namespace rtcore {

/// Surface that is lost: triangles whose coordinates or corners are damaged, or without area where these are
/// many. Copies that were left out.
void warnOfLostTriangles(const ModelBuffers& model, ImportReport& report);
void warnOfMissingTextures(std::span<const std::string> names, ImportReport& report);
/// No material lets anything be seen.
void warnWhenInvisible(const ModelBuffers& model, ImportReport& report);
/// Without the outermost twentieth on each side of each axis; at least one vertex.
Box3 bulkOf(std::span<const Vertex> vertices);
Box3 bulkOf(std::span<const Vec3> positions);
/// `coarseness` of the file's positions can be seen.
void warnOfCoarseness(double coarseness, const ModelBuffers& model, ImportReport& report);
/// Nearly all of the model is so small beside the rest that it cannot be seen.
void warnOfOutliers(const ModelBuffers& model, ImportReport& report);

} // namespace rtcore
