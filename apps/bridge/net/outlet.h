/// Between the sockets and what is sent over them: neither side knows the other's libraries. All of it on one
/// thread.
#pragma once

#include "bridge/stream/wire.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace bridge {

enum class CloseCode : std::uint16_t {
    GoingAway = 1001,
    NoHello = 4001,
    BadMessage = 4002,
    BadToken = 4003,
    NoInstance = 4004,
    UsedLink = 4005,
    Flood = 4008,
    Silent = 4009,
    OtherVersion = 4010,
};

/// One WebSocket, towards the client. Nothing throws but std::bad_alloc; after a close all of it does
/// nothing.
class Outlet {
  public:
    virtual ~Outlet() = default;
    /// A JSON message, kept until there is room. A client that lets more than a few megabytes pile up is
    /// closed.
    virtual void sendText(std::string text) = 0;
    /// A binary message; of `shipment` nothing for an echo.
    virtual void sendBinary(const Header& header, const Shipment* shipment) = 0;
    /// Whether something is still being written: frames wait then.
    virtual bool busy() const = 0;
    virtual void ping() = 0;
    virtual void close(CloseCode code, const std::string& reason) = 0;
    /// Ends it at once, without a word: the receiver is told before this returns.
    virtual void drop() = 0;
    virtual const std::string& address() const = 0; ///< "127.0.0.1", "unix"; for limits
};

/// The events of an Outlet. Not called after closed().
class Receiver {
  public:
    virtual ~Receiver() = default;
    virtual void text(std::string_view message) = 0;
    virtual void binary(std::span<const std::uint8_t> message) = 0;
    virtual void ponged(double seconds) = 0; ///< after ping(): there and back
    virtual void writable() = 0;             ///< not busy any more
    virtual void leaves() = 0;               ///< it says that it closes; nothing follows but closed()
    virtual void closed() = 0;
};

} // namespace bridge
