/// Lights and cameras of a glTF file.
#pragma once

#include "rtcore/io/import/gltf/luminaires.h"
#include "rtcore/io/import/gltf/node_walk.h"
#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/model.h"

namespace rtcore::gltf {

/// Lights of KHR_lights_punctual and EXT_lights_ies, one for each node that has one, leaves first. Candela of
/// the former count as W/sr, lux as W/m^2; beside luminaires 683 lm are a watt, as they are of these. A
/// luminaire whose profile cannot be read shines to all sides alike.
void addLights(const Json& root, const NodeWalk& walk, Luminaires& luminaires, ModelBuffers& model,
               ImportReport& report);

/// The same of cameras.
void addCameras(const Json& root, const NodeWalk& walk, ModelBuffers& model, ImportReport& report);

} // namespace rtcore::gltf
