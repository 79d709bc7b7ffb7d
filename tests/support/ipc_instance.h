/// A server name and a folder that no other test has, and nothing left of them afterwards.
#pragma once

#include "ipc/platform/names.h"
#include "ipc/platform/segment.h"
#include "ipc/platform/system.h"
#include "support/temporary_folder.h"

#include <cstdlib>
#include <string>

namespace test {

class IpcInstance {
  public:
    IpcInstance()
        : name_(prefix() + std::to_string(ipc::processId()) + "-" +
                std::to_string(ipc::randomTag() % 100000)) {
        ::setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); // for what programs write there
    }
    ~IpcInstance() {
        for (const std::string& segment : segments()) ipc::Segment::remove(segment);
    }
    IpcInstance(const IpcInstance&) = delete;
    IpcInstance& operator=(const IpcInstance&) = delete;

    const std::string& name() const { return name_; }
    ipc::Names names() const { return ipc::Names(name_); }
    /// The names of the instance's segments in shared memory.
    std::vector<std::string> segments() const { return ipc::segmentNames(names().prefix()); }
    const TemporaryFolder& folder() const { return folder_; }

  private:
    // Who may have to kill tests can tell their names from others.
    static std::string prefix() {
        const char* asked = std::getenv("RT_TEST_INSTANCE");
        return asked == nullptr ? "t" : asked;
    }

    TemporaryFolder folder_;
    std::string name_;
};

} // namespace test
