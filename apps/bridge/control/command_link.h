/// Commands and keys of one instance, by a client of its own: one that waits for frames cannot press keys
/// meanwhile.
#pragma once

#include "bridge/stream/histogram.h"

#include "common/commands/key_restraint.h"

#include "ipc/endpoint/client.h"

#include <bitset>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace bridge {

using KeySet = std::bitset<256>;

enum class ServerState { There, Busy, Gone, Refused };

/// What the thread of a CommandLink tells. Called from that thread; must not throw.
struct CommandLinkEvents {
    std::function<void(ServerState, std::string why)> server; ///< at first, and when it changes
    std::function<void(const ipc::Status&)> status;           ///< when it changed, ten times a second at most
    std::function<void(std::string report)>
        state; ///< the answer to `state`, when it changed, or after refresh()
    std::function<void(std::string lines)> messages; ///< new ones of the server
    std::function<void(std::string lines)> bindings; ///< the answer to `bindings`, asked for with the state
};

/// Figures of a CommandLink so far.
struct CommandFigures {
    double cpuSeconds = 0;   ///< of its thread
    std::uint64_t epoch = 0; ///< of the server that it found last
    Histogram keys;          ///< from setKeys() or tap() to the key bits of the server
};

/// One thread of its own. Without anyone() it leaves the server's slot to others and only looks whether it
/// lives.
class CommandLink {
  public:
    CommandLink(std::string instance, app::KeyRestraint restraint, CommandLinkEvents events);
    /// Releases the keys.
    ~CommandLink();
    CommandLink(const CommandLink&) = delete;
    CommandLink& operator=(const CommandLink&) = delete;

    // All of these from any thread; none waits.

    void setAnyone(bool anyone);
    /// All keys that are to be down.
    void setKeys(const KeySet& down);
    void tap(std::span<const std::uint8_t> keys);
    /// Degrees; what comes while a turn is under way is added up.
    void turn(double right, double up);
    void dropTurn();
    /// `done` is called from the thread, once, also when the server ends or does not answer within a minute.
    void request(std::string command, std::function<void(ipc::Reply)> done);
    /// Asks for the state soon.
    void refresh();
    CommandFigures figures() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace bridge
