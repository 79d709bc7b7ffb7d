/// Exceptions must not leave an OpenMP region: the first is kept and thrown again by the thread that waits
/// for the threads.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>

namespace rtcore {

class TaskErrors {
  public:
    template <typename Work>
    void guard(Work&& work) {
        try {
            work();
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            if (first_ == nullptr) first_ = std::current_exception();
            any_.store(true, std::memory_order_relaxed);
        }
    }
    /// Something failed already, so that further work is in vain.
    bool any() const { return any_.load(std::memory_order_relaxed); }
    /// Call when no task runs any more.
    void rethrow() const {
        if (first_ != nullptr) std::rethrow_exception(first_);
    }

  private:
    std::atomic<bool> any_{false};
    std::mutex mutex_;
    std::exception_ptr first_;
};

} // namespace rtcore
