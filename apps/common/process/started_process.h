/// A program that this one starts, and that ends with it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// One thread.
class StartedProcess {
  public:
    /// Its output goes where this program's goes. Throws rtcore::FileError NoInput where it cannot be
    /// started.
    StartedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
    /// Asks it to stop, and waits for it, three seconds at most.
    ~StartedProcess();
    StartedProcess(const StartedProcess&) = delete;
    StartedProcess& operator=(const StartedProcess&) = delete;

    /// Its exit code, 1 after a signal, once it has ended. Never waits.
    std::optional<int> ended() noexcept;

  private:
    std::int64_t process_ = 0;
    std::optional<int> code_;
};

} // namespace app
