// A writer that is killed leaves the old file or all of the new one.
#include "bsp_support.h"

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace {

[[noreturn]] void writeForEver(const std::filesystem::path& path, const rtcore::Model& small,
                               const rtcore::Model& large) {
    try {
        while (true) {
            rtcore::writeBsp(path, large, nullptr, {1, 1, 0});
            rtcore::writeBsp(path, small, nullptr, {2, 2, 0});
        }
    } catch (...) {
        ::_exit(1);
    }
}

} // namespace

TEST(BspKill, FileIsReadableWheneverItsWriterIsKilled) {
    const test::TemporaryFolder folder;
    const auto path = folder / "f.bsp";
    const rtcore::Model small = rtcore::makeModel(test::SampleModel(1).make(100));
    const rtcore::Model large = rtcore::makeModel(test::SampleModel(2).make(3000));
    rtcore::writeBsp(path, small, nullptr, {});
    std::mt19937 random(5);
    int larges = 0;
    for (int i = 0; i < 50; ++i) {
        const pid_t writer = ::fork();
        if (writer == 0) writeForEver(path, small, large);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 6000));
        ASSERT_EQ(::kill(writer, SIGKILL), 0);
        int status = 0;
        ASSERT_EQ(::waitpid(writer, &status, 0), writer);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the writer failed by itself";
        const rtcore::BspContent content = rtcore::readBsp(path);
        const bool isLarge = content.identity.sourceSize == 1;
        larges += isLarge ? 1 : 0;
        test::expectEqual(content.model, isLarge ? large : small);
    }
    RecordProperty("larges", larges);
}
