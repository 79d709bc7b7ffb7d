/// The programs that are packaged.
#pragma once

#include "bspbuilder/builder_options.h"
#include "cui/cui_spec.h"
#include "renderer/renderer_options.h"
#include "rtserver/server_options.h"

#ifdef RT_HAS_BRIDGE
#include "bridge/bridge_options.h"
#endif
#ifdef RT_HAS_GUI
#include "gui/gui_spec.h"
#endif

#include <vector>

namespace test {

inline std::vector<const app::ProgramSpec*> packagedPrograms() {
    return {
#ifdef RT_HAS_BRIDGE
        &bridge::bridgeSpec(),
#endif
#ifdef RT_HAS_GUI
        &gui::guiSpec(),
#endif
        &renderer::rendererSpec(), &bspbuilder::builderSpec(), &rtserver::serverSpec(), &cui::cuiSpec()};
}

} // namespace test
