/// A list that is rendered while it is still written.
#pragma once

#include <filesystem>
#include <vector>

namespace app {
class Progress;
}

namespace renderer {

/// How long to wait for a list that has neither grown nor come to its end mark.
class ListFollower {
  public:
    ListFollower(std::filesystem::path list, double timeoutSeconds);

    /// Waits until the list names more than `known` cameras, has its end mark, or the time is up; the time in
    /// which no reader waits does not count. All cameras so far; a line without its end is not one yet.
    /// Throws rtcore::FileError: BadData, also when the list names fewer than before; NoInput; Stopped.
    std::vector<std::filesystem::path> waitBeyond(std::size_t known, app::Progress& progress);

    bool ended() const { return ended_; } ///< the end mark was seen

  private:
    std::filesystem::path list_;
    double timeoutSeconds_;
    bool ended_ = false;
};

} // namespace renderer
