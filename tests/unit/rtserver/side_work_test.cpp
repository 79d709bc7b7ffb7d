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
#include <vector>

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

TEST(SideWork, AnswersAllThatShareAName) {
    SideWork work;
    const auto go = std::make_shared<std::atomic<bool>>(false);
    const auto counted = std::make_shared<std::atomic<int>>(0);
    const auto found = [go, counted]() -> Finish {
        go->wait(false);
        return [n = ++*counted] { return std::to_string(n); };
    };
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    for (std::uint64_t i = 1; i <= 100; ++i) work.start(command(i), found, stop, "storey 1");
    for (std::uint64_t i = 1; i < SideWork::kMaxShared; ++i)
        work.start(command(200 + i), found, {}, std::to_string(i));
    EXPECT_THROW(work.start(command(300), found, {}, "another"), rtcore::FileError);
    work.start(command(400), found);
    work.start(command(101), found, stop, "storey 1");
    work.stopWhere([](const ipc::Command& each) { return each.sequence <= 100; });
    EXPECT_FALSE(stop->load()) << "one still wants it";
    *go = true;
    go->notify_all();
    work.waitFor(10s);
    const std::vector<SideWork::Done> done = work.takeDone();
    ASSERT_EQ(done.size(), 101U + SideWork::kMaxShared);
    for (const SideWork::Done& each : done) EXPECT_EQ(each.finish().text, each.finish().text);
    EXPECT_EQ(counted->load(), 1 + static_cast<int>(SideWork::kMaxShared));
    while (rtserver::tasksAtWork() > 0) std::this_thread::yield();
}

TEST(SideWork, GivenUpAnswersNoCommandThatComesLater) {
    SideWork work;
    const auto stop = std::make_shared<std::atomic<bool>>(false);
    const auto waits = [stop]() -> Finish {
        stop->wait(false);
        return [] { return std::string("given up"); };
    };
    work.start(command(1), waits, stop, "storey 1");
    work.stopWhere([](const ipc::Command&) { return true; });
    stop->notify_all();
    work.start(
        command(2), [] { return Finish([] { return std::string("found"); }); }, {}, "storey 1");
    work.waitFor(10s);
    const std::vector<SideWork::Done> done = work.takeDone();
    ASSERT_EQ(done.size(), 2U);
    EXPECT_EQ(done[1].finish().text, "found");
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
