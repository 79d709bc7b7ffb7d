/// How the bridge stands with a server.
#pragma once

#include <cstdint>

namespace bridge {

enum class ServerLink : std::uint8_t {
    There,
    Busy, ///< it lives, and does not look after its clients for the moment
    Gone,
    Refused, ///< it does not let the bridge in
};

/// For messages and reports.
inline const char* nameOf(ServerLink link) {
    switch (link) {
    case ServerLink::There:
        return "there";
    case ServerLink::Busy:
        return "busy";
    case ServerLink::Gone:
        return "gone";
    case ServerLink::Refused:
        break;
    }
    return "refused";
}

} // namespace bridge
