/// A warning of statements that a reader does not understand.
#pragma once

#include "rtcore/io/import/import_report.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rtcore {

/// Counts them in one file, and remembers the first.
class OddStatements {
  public:
    /// `line` counts from 1.
    void add(std::uint64_t line, std::string_view keyword) {
        if (count_++ > 0) return;
        line_ = line;
        keyword_ = keyword;
    }
    /// One warning for all of them.
    void warn(const std::filesystem::path& file, ImportReport& report) const;

  private:
    std::uint64_t count_ = 0, line_ = 0;
    std::string keyword_;
};

} // namespace rtcore
