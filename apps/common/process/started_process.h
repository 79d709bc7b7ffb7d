/// A program that this one starts, and that ends with it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// One thread.
class StartedProcess {
  public:
    enum class Role {
        Beside, ///< its streams are this program's
        Helper, ///< its input is what write() says, its output is dropped, and it leaves the processor to
                ///< others
    };
    /// Throws rtcore::FileError: NoInput where it cannot be started, TryAgain when resources are short.
    StartedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   Role role = Role::Beside);
    /// Asks it to stop, and waits for it, three seconds at most.
    ~StartedProcess();
    StartedProcess(const StartedProcess&) = delete;
    StartedProcess& operator=(const StartedProcess&) = delete;

    /// Its exit code, 1 after a signal, once it has ended. Never waits.
    std::optional<int> ended() noexcept;
    /// For the input of a helper, all of it or nothing; never waits. False: it takes no more.
    bool write(std::string_view text) noexcept;
    /// Asks it to stop, and returns at once.
    void askToStop() noexcept;

  private:
    std::int64_t process_ = 0;
    int input_ = -1; ///< of a helper
    std::optional<int> code_;
};

} // namespace app
