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

TEST(Messages, AreKeptForThoseWhoLookOn) {
    testing::internal::CaptureStderr();
    rtserver::Messages messages;
    EXPECT_EQ(messages.since(0), "");
    messages.warn("a texture\nis missing");
    messages.tell("light 2 off");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "RTServer: warning: a texture\\x0ais missing\n")
        << "what keys did is not printed";
    EXPECT_EQ(messages.since(0), "1 warning a texture\\x0ais missing\n2 event light 2 off");
    EXPECT_EQ(messages.since(1), "2 event light 2 off");
    EXPECT_EQ(messages.since(2), "");
    EXPECT_EQ(messages.since(7), "") << "more than there are";
    EXPECT_EQ(messages.detailsSince(1), R"(["light 2 off"])");
    messages.offer("this or that");
    messages.withdrawOffers();
    messages.tell(rtcore::say("{0}: {1}", std::string("a\nb"), rtcore::say("all is lost")));
    EXPECT_EQ(messages.detailsSince(1), "[\"light 2 off\"]\n[\"{0}: {1}\",\"a\\\\x0ab\",[\"all is lost\"]]")
        << "a line for each of since()";
    messages.forget();
    EXPECT_EQ(messages.since(0), "");
    EXPECT_EQ(messages.count(), 4U);
    for (int i = 0; i < 1000; ++i) messages.tell(std::string(10'000, 'x'));
    EXPECT_EQ(messages.count(), 1004U);
    EXPECT_LT(messages.since(0).size(), 65'520U) << "as much as an answer holds";
    EXPECT_EQ(messages.since(1003).rfind("1004 event xxx", 0), 0U);
}

} // namespace
