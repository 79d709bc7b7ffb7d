/// Who lets visitors in: the Hub, or something else in tests.
#pragma once

#include "bridge/admission.h"
#include "bridge/control/roles.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace bridge {

class Room;

/// On the thread of the sockets.
class Reception {
  public:
    virtual ~Reception() = default;

    virtual Right rightOf(std::string_view token) = 0;
    virtual Room* room(const std::string& name) = 0; ///< "": the first; null: none
    virtual std::string instanceList() const = 0;

    struct Entrance {
        SessionId id = 0;
        std::string own; ///< the page's own token, for left(); ""
        nlohmann::json welcome;
    };
    /// A page comes into the room by a token that has this right.
    virtual Entrance enter(const Room& room, std::string_view token, Right right) = 0;
    /// It is not in the room any more; `inOrder`: it said so.
    virtual void left(std::string_view own, bool inOrder) = 0;
    /// The connection is closed: its place is free.
    virtual void closed() = 0;

    virtual void refused(const char* reason, const std::string& address) = 0;
    virtual void note(const std::string& text) = 0; ///< for the journal
};

} // namespace bridge
