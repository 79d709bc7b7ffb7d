// A narrow link: frames stay young, and the quality comes back.
#include "web/bridged_server.h"

namespace {

using namespace std::chrono_literals;
using test::Json;
using test::WebPage;

class SlowLink : public test::BridgedServer {};

TEST_F(SlowLink, TheLastFrameIsShownAfterAWalk) {
    const WebPage page = drive();
    page.call("Network.emulateNetworkConditions", {{"offline", false},
                                                   {"latency", 100},
                                                   {"downloadThroughput", 250'000},
                                                   {"uploadThroughput", 250'000}});
    ask("fly");
    capture(page);
    page.keyDown("KeyE");
    browser().listen(2s);
    page.keyUp("KeyE");
    ask("wait-idle");
    EXPECT_TRUE(isExact(page)) << "nothing is queued for minutes";
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

// The page comes back by itself, with the token that its tab keeps.
TEST_F(SlowLink, ALostLinkComesBack) {
    const WebPage page = drive();
    page.call("Network.emulateNetworkConditions",
              {{"offline", true}, {"latency", 0}, {"downloadThroughput", -1}, {"uploadThroughput", -1}});
    page.open("about:blank");
    page.call("Network.emulateNetworkConditions",
              {{"offline", false}, {"latency", 0}, {"downloadThroughput", -1}, {"uploadThroughput", -1}});
    page.open(driverLink().substr(0, driverLink().find('#')));
    EXPECT_TRUE(showsFrame(page));
    EXPECT_TRUE(isExact(page));
}

} // namespace
