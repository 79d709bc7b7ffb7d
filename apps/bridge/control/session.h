/// One page: what it may do, what it is sent.
#pragma once

#include "bridge/control/input_state.h"
#include "bridge/control/roles.h"
#include "bridge/net/doorkeeper.h"
#include "bridge/net/outlet.h"
#include "bridge/stream/delivery.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace bridge {

struct Session {
    SessionId id = 0;
    std::string name;
    bool mayDrive = false;
    std::shared_ptr<Outlet> outlet;
    Delivery delivery;
    InputState input;
    int requests = 0;           ///< without an answer
    TokenBucket own{4, 8};      ///< of requests that the bridge answers itself, a second
    TokenBucket asked{50, 100}; ///< of those that viewers may send
    double began = 0;
    double lastLink = 0, lastPing = 0;
    std::uint64_t linkSent = 0, linkBytes = 0, bytes = 0, lastLinkBytes = 0;
    std::string lastStatus;

    /// When which input was given to the server.
    struct Given {
        std::uint32_t sequence;
        std::int64_t ns; ///< of the steady clock
    };
    std::deque<Given> given;
    std::int64_t writing = 0; ///< when the frame was published that is being written, if it came just then
};

} // namespace bridge
