/// The programs that are packaged.
#pragma once

#include "bspbuilder/builder_options.h"
#include "cui/cui_spec.h"
#include "renderer/renderer_options.h"
#include "rtserver/server_options.h"

#include <array>

namespace test {

inline std::array<const app::ProgramSpec*, 4> packagedPrograms() {
    return {&renderer::rendererSpec(), &bspbuilder::builderSpec(), &rtserver::serverSpec(), &cui::cuiSpec()};
}

} // namespace test
