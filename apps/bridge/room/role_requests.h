/// Requests of pages about who drives, which the bridge answers itself. Pure.
#pragma once

#include "bridge/control/roles.h"

#include "rtcore/platform/sentence.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace bridge {

struct RoleAnswer {
    bool ok = true;
    rtcore::Sentence text{};          ///< for people
    std::optional<SessionId> toAsk{}; ///< the driver, who is to be told that `by` asks
};

/// Whether it is `ask`, `give`, `keep`, `release` or `name`.
bool isRoleRequest(const nlohmann::json& request);
/// Does one. Never throws but std::bad_alloc, whatever else `request` holds.
RoleAnswer doRoleRequest(Roles& roles, SessionId by, const nlohmann::json& request, double now);

} // namespace bridge
