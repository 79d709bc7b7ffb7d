/// A WebSocket until it has said who it is, and the way to its room from then on.
#pragma once

#include "bridge/hub.h"

#include <memory>

namespace bridge {

class Visitor : public Receiver {
  public:
    Visitor(Hub& hub, const std::shared_ptr<Outlet>& outlet)
        : hub_(hub), outlet_(outlet), address_(outlet->address()) {
        hub_.visitorCame();
    }

    void text(std::string_view message) override;
    void binary(std::span<const std::uint8_t> message) override;
    void ponged(double seconds) override;
    void writable() override;
    void leaves() override;
    void closed() override;
    /// Closes it where it said nothing for too long.
    void tick(double now);

    const std::string& address() const { return address_; }
    /// It has a place, but is in no room: it has not said hello, or leaves.
    bool isNewcomer() const { return room_ == nullptr && !isClosed_; }
    void drop(); ///< at once, without a word

  private:
    void hello(std::string_view message);
    void close(CloseCode code, const std::string& reason);
    void leaveRoom(bool inOrder);

    Hub& hub_;
    std::weak_ptr<Outlet> outlet_; ///< which holds this
    std::string address_, person_; ///< for the journal
    std::string own_;              ///< token; "": none
    Room* room_ = nullptr;         ///< null: before `hello`, and at the end
    SessionId id_ = 0;
    bool isClosed_ = false;
    double began_ = nowSeconds();
};

} // namespace bridge
