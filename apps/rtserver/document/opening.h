/// How a scene is shown at first.
#pragma once

#include "rtserver/document/variant_book.h"
#include "rtserver/document/world.h"
#include "rtserver/server_options.h"

#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"

namespace rtserver {

struct Opening {
    rtcore::Scene scene;
    rtcore::RenderSettings settings;
    VariantBook variants;
};

/// With the camera and the settings that `world` and `options` say; world.loaded.camera is the first view
/// then. `last`: the settings of the scene that is shown now, whose frames keep their size; null: this is the
/// first scene, which gets what the command line says of camera, size, parts and lights. Throws FileError.
Opening openingOf(World& world, const Options& options, const rtcore::RenderSettings* last);

} // namespace rtserver
