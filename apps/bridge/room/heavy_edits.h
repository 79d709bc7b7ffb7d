/// Edits after which frames last for seconds: they lock their own author out, so that what was before comes
/// back. Pure.
#pragma once

#include "bridge/control/own_edits.h"
#include "bridge/control/requests.h"
#include "bridge/room/known_server.h"

#include <map>
#include <string>
#include <vector>

namespace bridge {

/// Each edit that may be one is watched until the whole frame was quick. Seconds of any clock; one thread.
class HeavyEdits {
  public:
    /// It goes to the server, whose state is still that from before.
    void sent(const PlannedCommand& planned, const KnownServer& server, const OwnEdits& edits, double now);
    void answered(const PlannedCommand& planned, double now);
    void clear() { watched_.clear(); }

    struct Back {
        std::string name; ///< of what was changed, for pages: a setting, "size", "lastEdit"
        std::string line; ///< the command that brings back what was before
    };
    /// All that are watched, and none of them any more, where a frame lasts too long; else nothing.
    std::vector<Back> takeHeavy(const KnownServer& server, double now);
    /// The whole frame is there, and it was quick.
    void settle(double now);

  private:
    struct Watched {
        std::string back; ///< the command that brings back what was before
        double since;     ///< the last time that it was made
    };
    std::map<std::string, Watched> watched_; ///< by what it changed
};

} // namespace bridge
