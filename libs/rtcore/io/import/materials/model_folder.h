/// The folder in which files lie that a model may have read.
#pragma once

#include <array>
#include <filesystem>

namespace rtcore {

class ModelFolder {
  public:
    explicit ModelFolder(const std::filesystem::path& model);

    /// Whether a file is in the model's folder or below, or in that to which a link to the model's file
    /// leads, links resolved. False for one that is not there.
    bool holds(const std::filesystem::path& file) const;

  private:
    std::array<std::filesystem::path, 2> homes_; ///< without links
};

} // namespace rtcore
