/// The names of the temporary files that this process has open, where a signal handler can find them.
#pragma once

#include <string>

namespace rtcore {

enum class TemporaryKind { File, Folder };

/// Holds one name for the lifetime of the object. The table has room for 32 names; a file beyond that is
/// still written correctly, only a signal leaves it behind. Safe from many threads.
class TemporaryName {
  public:
    explicit TemporaryName(const std::string& path, TemporaryKind kind = TemporaryKind::File) noexcept;
    ~TemporaryName();
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

  private:
    int slot_;
};

} // namespace rtcore
