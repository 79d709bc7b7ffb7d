/// Whether another process still runs.
#pragma once

#include <cstdint>

namespace app {

/// Any process of this machine, not only a parent or a child. On Linux the watch is on the process that has
/// the number when it is made, and a zombie has ended; elsewhere on whichever process has the number.
class ProcessWatch {
  public:
    /// `process` > 0. One that does not exist has ended. Does not throw.
    explicit ProcessWatch(std::int64_t process) noexcept;
    ~ProcessWatch();
    ProcessWatch(ProcessWatch&& other) noexcept;
    ProcessWatch& operator=(ProcessWatch&& other) noexcept;

    /// Costs one system call at most.
    bool ended() noexcept;

  private:
    std::int64_t process_;
    int handle_ = -1; ///< where the system has such a thing
    bool ended_ = false;
};

} // namespace app
