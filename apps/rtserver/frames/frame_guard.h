/// Looks after the server while a frame takes long.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace rtserver {

/// A thread of its own calls `poll` every few milliseconds while a frame lasts, and sets `cancel` when that
/// returns true. `poll` never runs outside of a Watch, nor twice at once.
class FrameGuard {
  public:
    explicit FrameGuard(std::function<bool()> poll);
    ~FrameGuard();
    FrameGuard(const FrameGuard&) = delete;
    FrameGuard& operator=(const FrameGuard&) = delete;

    /// As long as it lives, a frame is drawn. When the destructor is done, so is `poll`.
    class Watch {
      public:
        Watch(FrameGuard& guard, std::atomic<bool>& cancel) : guard_(guard) { guard_.begin(&cancel); }
        ~Watch() { guard_.begin(nullptr); }
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;

      private:
        FrameGuard& guard_;
    };

  private:
    void begin(std::atomic<bool>* cancel);
    void watch(const std::stop_token& stop);

    std::function<bool()> poll_;
    std::mutex mutex_; ///< guards all below, and is held during poll_
    std::condition_variable_any wake_;
    std::atomic<bool>* cancel_ = nullptr; ///< of the frame that is drawn; null = none
    std::uint64_t frame_ = 0;             ///< counts changes of `cancel_`
    std::jthread thread_;                 ///< last: it starts when all else stands
};

} // namespace rtserver
