#include "rtserver/messages.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace {

// In a process of its own, for stderr is one of all tests.
[[noreturn]] void printWhereNobodyReads() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_NONBLOCK) != 0) ::_exit(1);
    const std::array<char, 4096> full{};
    while (::write(ends[1], full.data(), full.size()) > 0) {
    }
    ::fcntl(ends[1], F_SETFL, 0); // from here on a write would wait
    ::dup2(ends[1], STDERR_FILENO);
    ::alarm(10);
    rtserver::Messages::print("nobody reads this");
    ::_exit(0);
}

TEST(Messages, NeverWaitForAReader) { EXPECT_EXIT(printWhereNobodyReads(), testing::ExitedWithCode(0), ""); }

TEST(Messages, AreCutAndComplaintsAreRare) {
    testing::internal::CaptureStderr();
    rtserver::Messages::print("all of it");
    rtserver::Messages::print(std::string(100'000, 'x'));
    rtserver::Messages messages;
    for (int i = 0; i < 1000; ++i) messages.complain("something failed");
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_EQ(text.rfind("RTServer: all of it\n", 0), 0U);
    EXPECT_LT(text.size(), 5000U);
    EXPECT_EQ(text.find("something failed"), text.rfind("something failed"));
}

} // namespace
