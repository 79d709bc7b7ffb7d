/// Commands and keys of a server, as a room gives them: CommandLink in the bridge, something else in tests.
#pragma once

#include "bridge/control/server_link.h"
#include "bridge/stream/histogram.h"

#include "ipc/endpoint/client.h"

#include "rtcore/platform/sentence.h"

#include <bitset>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace bridge {

using KeySet = std::bitset<256>;

/// News of a server. Called from any thread; must not throw.
struct ServerEvents {
    std::function<void(ServerLink, rtcore::Sentence why)> server; ///< at first, and when it changes
    std::function<void(const ipc::Status&)> status; ///< when it changed, ten times a second at most
    std::function<void(std::string report)>
        state; ///< the answer to `state`, when it changed, or after refresh()
    std::function<void(std::string lines, std::string details)> messages; ///< new ones of the server
    std::function<void(std::string lines)> bindings; ///< the answer to `bindings`, asked for with the state
};

/// Figures so far.
struct CommandFigures {
    double cpuSeconds = 0;   ///< of the thread
    std::uint64_t epoch = 0; ///< of the server that was found last
    Histogram keys;          ///< from setKeys() or tap() to the key bits of the server
};

/// All of it from any thread; none waits.
class ServerCommands {
  public:
    virtual ~ServerCommands() = default;

    /// Without anyone the server's slot is left to others.
    virtual void setAnyone(bool anyone) = 0;
    /// All keys that are to be down.
    virtual void setKeys(const KeySet& down) = 0;
    virtual void tap(std::span<const std::uint8_t> keys) = 0;
    /// Degrees; what comes while a turn is under way is added up.
    virtual void turn(double right, double up) = 0;
    virtual void dropTurn() = 0;
    /// `done` is called from any thread, once, also when the server ends or does not answer within a minute.
    virtual void request(std::string command, std::function<void(ipc::Reply)> done) = 0;
    /// Asks for the state soon.
    virtual void refresh() = 0;
    virtual CommandFigures figures() const = 0;
};

} // namespace bridge
