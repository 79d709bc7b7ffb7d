// Many visitors of one address that is another machine's: a proxy's, or a NAT's.
#include "process/bridge/bridge_fixture.h"
#include "process/bridge/own_network.h"

namespace {

using namespace test;

const std::string kAddress = "10.99.0.1", kSite = "https://viz.example";

/// With `--origin`, behind a proxy; without, as a NAT's machines see it.
class SharedAddress : public BridgeTest, public testing::WithParamInterface<bool> {
  protected:
    void SetUp() override {
        network_.emplace(kAddress);
        if (!network_->works()) GTEST_SKIP() << "this process may not make a network of its own";
        startServer();
        std::vector<std::string> options{"--insecure", "--clients=20"};
        if (GetParam()) options.push_back("--origin=" + kSite + "/n/");
        port = 8931;
        startBridge(options, kAddress + ":8931");
        ASSERT_NE(links(), "");
    }
    RawSocket socket() const { return RawSocket::ofDescriptor(connectTo(kAddress, port)); }
    std::string host() const { return GetParam() ? "viz.example" : kAddress + ":8931"; }
    WebClient visitor() const {
        return {socket(), host(), GetParam() ? kSite : "http://" + kAddress + ":8931"};
    }
    int statusOf(const std::string& token) const {
        RawSocket raw = socket();
        raw.write("GET /status HTTP/1.1\r\nHost: " + host() +
                  "\r\nConnection: close\r\nAuthorization: Bearer " + token + "\r\n\r\n");
        const std::string answer = raw.readAll(3s);
        return answer.size() > 12 ? std::stoi(answer.substr(9, 3)) : 0;
    }

  private:
    std::optional<OwnNetwork> network_;
};

TEST_P(SharedAddress, WrongTokensOfOneShutNobodyOut) {
    for (int i = 0; i < 10; ++i) {
        WebClient wrong = visitor();
        wrong.hello("wrong");
        EXPECT_EQ(wrong.closeCode(), 4003) << i;
        EXPECT_EQ(statusOf("wrong"), 401) << i;
    }
    WebClient right = visitor();
    right.hello(kDriver);
    EXPECT_EQ(right.event("welcome")["role"], "driver");
    EXPECT_EQ(statusOf(kViewer), 200);
}

TEST_P(SharedAddress, SilentOnesOfOneKeepNobodyOut) {
    std::vector<WebClient> silent;
    for (int i = 0; i < 60; ++i) silent.push_back(visitor());
    WebClient right = visitor();
    right.hello(kDriver);
    EXPECT_EQ(right.event("welcome")["role"], "driver");
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, SharedAddress, testing::Bool(),
                         [](const auto& behind) { return behind.param ? "Proxy" : "Nat"; });

} // namespace
