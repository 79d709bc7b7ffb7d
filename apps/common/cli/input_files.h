/// The files that a run reads, so that nothing it writes destroys them.
#pragma once

#include "rtcore/platform/files.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>

namespace app {

/// A set of files, known by what they are and not by their names: links to one of them, symbolic or hard,
/// are in it, too.
class InputFiles {
  public:
    /// Ignores a path that does not exist: there is nothing to destroy.
    void add(const std::filesystem::path& path);
    void add(std::span<const std::filesystem::path> paths);

    /// The name under which this file was added; nothing when it was not.
    std::optional<std::filesystem::path> find(const std::filesystem::path& path) const;

    /// Throws UsageError when `output` is one of them.
    void refuse(const std::filesystem::path& output) const;

  private:
    std::map<rtcore::FileIdentity, std::filesystem::path> names_;
};

} // namespace app
