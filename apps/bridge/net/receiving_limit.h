/// How much a client may send.
#pragma once

#include "bridge/clock.h"
#include "bridge/net/doorkeeper.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

namespace boost::beast {
class rate_policy_access;
}

namespace bridge {

/// Counts bytes where they arrive: what makes no message, such as parts of one that never ends, is known here
/// only. Over the limit hardly anything more is read. A RatePolicy of Beast's basic_stream. One thread.
class ReceivingLimit {
  public:
    /// `rate` bytes a second after `burst`, and `unfinished` between two messages.
    ReceivingLimit(double rate, double burst, std::size_t unfinished)
        : bytes_(rate, burst), maxUnfinished_(unfinished) {}

    /// From now on messages are told; `flooded` is called once, when more came than may, while it is read.
    void watchMessages(std::function<void()> flooded) {
        flooded_ = std::move(flooded);
        unfinished_ = 0;
    }
    void messageCame() { unfinished_ = 0; }

  private:
    friend class boost::beast::rate_policy_access;
    static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

    std::size_t available_read_bytes() const { return over_ ? 0 : kAll; }
    std::size_t available_write_bytes() const { return kAll; }
    void transfer_read_bytes(std::size_t count) {
        unfinished_ += flooded_ ? count : 0;
        if (over_ || (bytes_.take(nowSeconds(), static_cast<double>(count)) && unfinished_ <= maxUnfinished_))
            return;
        over_ = true;
        if (flooded_) flooded_();
    }
    void transfer_write_bytes(std::size_t) {}
    void on_timer() {}

    TokenBucket bytes_;
    std::size_t maxUnfinished_, unfinished_ = 0;
    std::function<void()> flooded_;
    bool over_ = false;
};

} // namespace bridge
