/// A room's server as the room knows it: link, scene and status.
#pragma once

#include "bridge/control/scene_facts.h"
#include "bridge/control/server_link.h"

#include "ipc/layout/status.h"

#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <optional>

namespace bridge {

/// Times are seconds of the room's clock.
struct KnownServer {
    std::optional<ServerLink> link; ///< nothing until it was looked for
    rtcore::Sentence why;           ///< it is gone or refuses
    SceneFacts facts;
    ipc::Status status;     ///< the last one, which may be that of one that is gone
    bool hasStatus = false; ///< it is this one's
    double statusAt = 0;    ///< when it came
    double lastFrame = 0;   ///< when one was seen, here or in the status

    bool isThere() const { return link == ServerLink::There || link == ServerLink::Busy; }
    /// A live frame is quick where the whole one, which follows at rest, is not.
    double longestFrame() const { return std::max(status.frameSeconds, status.wholeSeconds); }
};

} // namespace bridge
