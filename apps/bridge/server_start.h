/// An RTServer that the bridge starts, and that ends with it.
#pragma once

#include "common/process/exit_codes.h"

#include <filesystem>
#include <optional>
#include <string>

#include <sys/types.h>

namespace bridge {

class StartedServer {
  public:
    /// Throws rtcore::FileError: NoInput when the program or the scene is missing.
    StartedServer(const std::filesystem::path& scene, const std::string& instance);
    /// Asks it to end, and waits for it, three seconds at most.
    ~StartedServer();
    StartedServer(const StartedServer&) = delete;
    StartedServer& operator=(const StartedServer&) = delete;

    /// Its exit code once it has ended.
    std::optional<int> ended();

  private:
    pid_t process_ = -1;
    std::optional<int> code_;
};

} // namespace bridge
