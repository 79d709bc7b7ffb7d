/// A WebSocket until it has said who it is, and the way to its room from then on.
#pragma once

#include "bridge/clock.h"
#include "bridge/net/outlet.h"
#include "bridge/reception.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace bridge {

class Visitor : public Receiver {
  public:
    /// `reception` and `clock` must outlive it.
    Visitor(Reception& reception, const std::shared_ptr<Outlet>& outlet, const Clock& clock)
        : reception_(reception), clock_(clock), outlet_(outlet), address_(outlet->address()),
          began_(clock.seconds()) {}

    void text(std::string_view message) override;
    void binary(std::span<const std::uint8_t> message) override;
    void ponged(double seconds) override;
    void writable() override;
    void leaves() override;
    void closed() override;
    /// Closes it where it said nothing for too long.
    void tick();

    const std::string& address() const { return address_; }
    /// It has a place, but is in no room: it has not said hello, or leaves.
    bool isNewcomer() const { return room_ == nullptr && !isClosed_; }
    void drop(); ///< at once, without a word

  private:
    void hello(std::string_view message);
    void close(CloseCode code, const std::string& reason);
    void leaveRoom(bool inOrder);

    Reception& reception_;
    const Clock& clock_;
    std::weak_ptr<Outlet> outlet_; ///< which holds this
    std::string address_, person_; ///< for the journal
    std::string own_;              ///< token; "": none
    Room* room_ = nullptr;         ///< null: before `hello`, and at the end
    SessionId id_ = 0;
    bool isClosed_ = false;
    double began_;
};

} // namespace bridge
