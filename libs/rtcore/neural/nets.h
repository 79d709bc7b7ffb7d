/// The nets that a program has read.
#pragma once

#include "rtcore/neural/net_files.h"

#include <array>
#include <filesystem>
#include <memory>

namespace rtcore {

/// Each is found and read when it is asked for first. Not for several threads at once.
class Nets {
  public:
    /// `chosen`: of an option, as in netFolders(); empty: none.
    explicit Nets(std::filesystem::path chosen = {}) : chosen_(std::move(chosen)) {}

    /// Throws FileError: NoInput where there is no such file, in words that say how to get it; what readNet()
    /// throws.
    std::shared_ptr<const UNet> of(Net net);

  private:
    std::filesystem::path chosen_;
    std::array<std::shared_ptr<const UNet>, kNetFiles.size()> nets_;
};

} // namespace rtcore
