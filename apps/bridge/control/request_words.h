/// An argument of a request, as the word of a command that stands for it.
#pragma once

#include "bridge/control/requests.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace bridge {

/// Numbers are written anew, other words are those of tables; the text and the author of a note are as
/// rtcore::noteText() has them, and as long as rtcore::problemOf() lets them be. Throws Refused:
/// of another type, too long, unknown, or of an argument that is other text or a path, which no page gives.
std::string wordOf(const app::CommandArgument& argument, const nlohmann::json& value,
                   const RequestContext& context);

} // namespace bridge
