#include "bridge/net/doorkeeper.h"

#include "common/cli/command_line.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace {

bridge::Names namesOf() {
    bridge::Names names;
    names.hosts = {"192.168.1.7:8443"};
    return names;
}

TEST(Hosts, OnlyOurOwnNames) {
    const bridge::Names names = namesOf();
    for (const char* host : {"127.0.0.1:8931", "localhost:8931", "LOCALHOST:8931", "[::1]:8931", "localhost",
                             "192.168.1.7:8443"})
        EXPECT_TRUE(bridge::isOurHost(names, host)) << host;
    for (const char* host : {"", "evil.example", "evil.example:8931", "127.0.0.1.evil.example:8931",
                             "localhost.evil.example", "192.168.1.7", "192.168.1.7:80", "127.0.0.1:",
                             "127.0.0.1:x", "127.0.0.1:123456", "localhost:8931@evil", " localhost"})
        EXPECT_FALSE(bridge::isOurHost(names, host)) << host;
}

TEST(Hosts, NeedNoPortWhereBrowsersLeaveItOut) {
    bridge::Names names;
    names.hosts = {"node7:443", "node7", "*:443", "*"};
    for (const char* host : {"node7", "node7:443", "10.0.0.1", "[fe80::1]", "10.0.0.1:443"})
        EXPECT_TRUE(bridge::isOurHost(names, host)) << host;
    for (const char* host : {"node8", "10.0.0.1:80", "evil.example", ""})
        EXPECT_FALSE(bridge::isOurHost(names, host)) << host;
}

TEST(Hosts, AreAllNumericOnesWhereAllAddressesAreListenedTo) {
    bridge::Names names;
    names.hosts = {"node7:8443", "*:8443"};
    for (const char* host :
         {"192.168.1.7:8443", "10.0.0.1:8443", "[fe80::1]:8443", "Node7:8443", "localhost"})
        EXPECT_TRUE(bridge::isOurHost(names, host)) << host;
    for (const char* host : {"192.168.1.7", "192.168.1.7:80", "192.168.1.7.evil.example:8443",
                             "evil.example:8443", "[evil]:8443", "[]:8443", ":8443", "1e5.evil:8443", ""})
        EXPECT_FALSE(bridge::isOurHost(names, host)) << host;
}

TEST(Origins, OnlyThePageOfTheVeryHost) {
    bridge::Names names = namesOf();
    names.origins = {"https://viz.example"};
    EXPECT_TRUE(bridge::isOurOrigin(names, "127.0.0.1:8931", "http://127.0.0.1:8931"));
    EXPECT_TRUE(bridge::isOurOrigin(names, "127.0.0.1:9000", "http://127.0.0.1:9000"))
        << "a tunnel's own port";
    EXPECT_TRUE(bridge::isOurOrigin(names, "127.0.0.1:8931", "https://viz.example"));
    for (const char* origin :
         {"http://127.0.0.1:8932", "http://localhost:8931", "https://127.0.0.1:8931", "null", "",
          "http://evil.example", "http://127.0.0.1:8931.evil.example", "http://127.0.0.1:89310",
          "https://viz.example.evil", "https://viz.example:444"})
        EXPECT_FALSE(bridge::isOurOrigin(names, "127.0.0.1:8931", origin)) << origin;
    EXPECT_FALSE(bridge::isOurOrigin(names, "127.0.0.1:8931", std::nullopt));
    names.allowNoOrigin = true;
    EXPECT_TRUE(bridge::isOurOrigin(names, "127.0.0.1:8931", std::nullopt));
    EXPECT_FALSE(bridge::isOurOrigin(names, "127.0.0.1:8931", "http://evil.example"))
        << "a page is still a page";
    names.tls = true;
    EXPECT_TRUE(bridge::isOurOrigin(names, "192.168.1.7:8443", "https://192.168.1.7:8443"));
    EXPECT_FALSE(bridge::isOurOrigin(names, "192.168.1.7:8443", "http://192.168.1.7:8443"));
}

TEST(Origins, AreTakenApart) {
    EXPECT_EQ(bridge::parseOrigin("https://viz.example:443/").origin, "https://viz.example")
        << "as browsers say";
    EXPECT_EQ(bridge::parseOrigin("http://viz.example:80").host, "viz.example");
    EXPECT_EQ(bridge::parseOrigin("http://viz.example:443").host, "viz.example:443");
    const bridge::OriginOption option = bridge::parseOrigin("https://Viz.example:444/node7/8931/");
    EXPECT_EQ(option.origin, "https://viz.example:444");
    EXPECT_EQ(option.host, "viz.example:444");
    EXPECT_EQ(option.prefix, "/node7/8931");
    for (const char* wrong :
         {"", "viz.example", "ftp://viz.example", "https://", "https:///x", "https://a@b/", "https://a/?x"})
        EXPECT_THROW(bridge::parseOrigin(wrong), app::UsageError) << wrong;
}

TEST(TokenBucket, LetsBurstsThroughAndFloodsNot) {
    bridge::TokenBucket bucket(250, 500);
    int taken = 0;
    for (int i = 0; i < 1000; ++i) taken += bucket.take(0) ? 1 : 0;
    EXPECT_EQ(taken, 500);
    for (int i = 0; i < 1000; ++i) taken += bucket.take(1) ? 1 : 0;
    EXPECT_EQ(taken, 750);
}

TEST(TokenBucket, TakesAmounts) {
    bridge::TokenBucket bucket(100, 1000);
    EXPECT_FALSE(bucket.take(0, 1001));
    EXPECT_TRUE(bucket.take(0, 1000));
    EXPECT_FALSE(bucket.take(1, 101));
    EXPECT_TRUE(bucket.take(1, 100));
}

// One that opens connections without end pushes out its own ones.
TEST(Newcomers, ThatMakeRoomAreOfTheAddressThatHasMost) {
    const std::vector<std::string> crowd{"a", "b", "c", "b", "a", "b"};
    EXPECT_EQ(bridge::leastWelcome(crowd), 1U);
    EXPECT_EQ(bridge::leastWelcome(std::vector<std::string>{"a"}), 0U);
    EXPECT_EQ(bridge::leastWelcome(std::vector<std::string>{"a", "b"}), 0U) << "else the first one";
}

TEST(Tokens, AreLongAndNeverTheSame) {
    std::set<std::string> seen;
    for (int i = 0; i < 1000; ++i) {
        const std::string token = bridge::newToken();
        EXPECT_EQ(token.size(), 43U);
        EXPECT_EQ(token.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"),
                  std::string::npos);
        EXPECT_TRUE(seen.insert(token).second);
    }
}

TEST(Tokens, AreEqualAsAWhole) {
    EXPECT_TRUE(bridge::sameToken("abc", "abc"));
    for (const char* given : {"", "ab", "abcd", "abd", "xbc"})
        EXPECT_FALSE(bridge::sameToken(given, "abc")) << given;
    EXPECT_FALSE(bridge::sameToken("", "")) << "no token is none that fits";
}

} // namespace
