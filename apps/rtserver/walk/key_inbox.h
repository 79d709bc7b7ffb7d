/// The keys of all clients between two updates of the state.
#pragma once

#include "ipc/layout/key_state.h"

namespace rtserver {

/// One thread at a time.
class KeyInbox {
  public:
    /// Takes the result of ipc::Server::keys(). True when the state does not know it yet.
    bool add(const ipc::KeyState& keys);
    /// The keys that are down, and the presses since the last call.
    ipc::KeyState take();

  private:
    ipc::KeyState keys_;
    decltype(ipc::KeyState::down) taken_;
};

} // namespace rtserver
