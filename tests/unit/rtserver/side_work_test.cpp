#include "rtserver/commands/side_work.h"
#include "rtserver/loop/server_run.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/temporary_names.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

using namespace std::chrono_literals;
using rtserver::Finish;
using rtserver::SideWork;

ipc::Command command(std::uint64_t sequence) { return {0, 1, sequence, true, "screenshot /a.png"}; }

TEST(SideWork, GivesWhatTheWorkGaveOrThrew) {
    SideWork work;
    EXPECT_FALSE(work.underWay());
    work.start(command(1), [] { return Finish([] { return std::string("12 frames"); }); });
    work.start(command(2), []() -> Finish { throw std::runtime_error("full"); });
    work.waitFor(10s);
    EXPECT_TRUE(work.anyDone());
    std::vector<SideWork::Done> done = work.takeDone();
    ASSERT_EQ(done.size(), 2U);
    EXPECT_EQ(done[0].command.sequence, 1U);
    EXPECT_EQ(done[0].finish().text, "12 frames");
    EXPECT_THROW(done[1].finish(), std::runtime_error);
    EXPECT_FALSE(work.underWay());
    while (rtserver::tasksAtWork() > 0) std::this_thread::yield();
}

TEST(SideWork, NobodyWaitsForWhatDoesNotEnd) {
    const auto end = std::make_shared<std::atomic<bool>>(false);
    {
        SideWork work;
        const auto hangs = [end]() -> Finish {
            end->wait(false);
            return [] { return std::string(); };
        };
        for (int i = 0; i < 64; ++i) work.start(command(1), hangs);
        EXPECT_THROW(work.start(command(2), hangs), rtcore::FileError) << "there is an end to it";
        work.waitFor(20ms);
        EXPECT_FALSE(work.anyDone());
        EXPECT_TRUE(work.takeDone().empty());
    }
    EXPECT_EQ(rtserver::tasksAtWork(), 64);
    *end = true;
    end->notify_all();
    while (rtserver::tasksAtWork() > 0) std::this_thread::yield();
}

// In a process of its own.
[[noreturn]] void endWhileAFileHangs(const std::filesystem::path& file) {
    std::ofstream(file) << "half";
    const rtcore::TemporaryName name(file.string());
    const rtserver::DetachedTask<int> hangs([]() -> int {
        while (true) std::this_thread::sleep_for(1h);
    });
    rtserver::endProcess(75);
}

TEST(EndProcess, WaitsForNoFileAndLeavesNoHalf) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "half.png";
    EXPECT_EXIT(endWhileAFileHangs(file), testing::ExitedWithCode(75), "");
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_EXIT(rtserver::endProcess(3), testing::ExitedWithCode(3), "");
}

} // namespace
