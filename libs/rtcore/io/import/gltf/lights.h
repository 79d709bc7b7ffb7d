/// Lights and cameras of a glTF file.
#pragma once

#include "rtcore/io/import/gltf/node_walk.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/model.h"

namespace rtcore::gltf {

/// Lights of KHR_lights_punctual and EXT_lights_ies, one for each node that has one, leaves first. Candela
/// count as W/sr, lux as W/m^2. Luminaires shine to all sides alike, with a warning.
void addLights(const Json& root, const NodeWalk& walk, ModelBuffers& model, ImportReport& report);

/// The same of cameras.
void addCameras(const Json& root, const NodeWalk& walk, ModelBuffers& model, ImportReport& report);

} // namespace rtcore::gltf
