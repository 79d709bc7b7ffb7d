/// Keys as state: what the driver's page says is held, for as long as it goes on saying so. Pure.
#pragma once

#include "bridge/control/server_commands.h"
#include "bridge/stream/wire.h"

#include <cstdint>

namespace bridge {

/// One thread.
class InputState {
  public:
    static constexpr double kHeartbeat = 0.5; ///< seconds without input after which keys are released

    /// False: an old message, which changes nothing.
    bool apply(const InputMessage& input, double now) {
        if (input.sequence <= sequence_) return false;
        sequence_ = input.sequence;
        held_.reset();
        for (const std::uint8_t key : input.held) held_.set(key);
        held_.reset(0); // no key
        last_ = now;
        return true;
    }
    /// True: keys were held and are released now, since no input came.
    bool expire(double now) {
        if (held_.none() || now - last_ < kHeartbeat) return false;
        held_.reset();
        return true;
    }
    /// Releases all keys, as the session drives no more.
    void release() { held_.reset(); }
    const KeySet& held() const { return held_; }
    std::uint32_t sequence() const { return sequence_; }

  private:
    KeySet held_;
    std::uint32_t sequence_ = 0;
    double last_ = 0;
};

} // namespace bridge
