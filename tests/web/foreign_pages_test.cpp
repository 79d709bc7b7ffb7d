// Pages of other origins cannot reach the bridge, wherever they come from. Requests that the bridge's own
// policy would forbid its page are allowed here: another site has no such policy.
#include "web/bridged_server.h"

namespace {

using test::Json;
using test::WebPage;

class ForeignPage : public test::BridgedServer {
  protected:
    void SetUp() override {
        BridgedServer::SetUp();
        if (IsSkipped()) return;
        startServer();
        startBridge({"--view-only"});
        startBrowser({"--host-resolver-rules=MAP evil.example 127.0.0.1"});
    }
    std::string port() const { return host().substr(host().find(':')); }
    std::string path() const { return "/?" + std::to_string(++visits_); }

    /// "open", or the status of the refusal.
    std::string connect(const WebPage& page, const std::string& target) const {
        const Json said = page.value("new Promise((tell) => { const socket = new WebSocket('ws://" + target +
                                     "/ws', 'rtbridge.1'); socket.onopen = () => tell('open'); "
                                     "socket.onerror = () => tell('refused'); })");
        if (said == "open") return "open";
        browser_().listen(std::chrono::milliseconds(200));
        std::string status = "none";
        for (const Json& event : page.events()) {
            if (event.value("method", "") == "Network.webSocketHandshakeResponseReceived")
                status = std::to_string(event["params"]["response"]["status"].get<int>());
            if (event.value("method", "") == "Network.webSocketFrameError")
                status = event["params"].value("errorMessage", "");
        }
        return status;
    }
    WebPage visit(const std::string& address) {
        WebPage page(browser(), "about:blank");
        page.call("Page.setBypassCSP", {{"enabled", true}});
        page.open(address);
        EXPECT_TRUE(page.becomes("document.readyState === 'complete'"));
        return page;
    }

  private:
    test::Chromium& browser_() const { return const_cast<ForeignPage*>(this)->browser(); }
    mutable int visits_ = 0;
};

TEST_F(ForeignPage, TheBridgesOwnPageIsLetIn) {
    const WebPage page = visit("http://" + host() + path());
    EXPECT_EQ(connect(page, host()), "open");
}

TEST_F(ForeignPage, APageOfAnotherNameOfThisMachineIsRefused) {
    const WebPage page = visit("http://localhost" + port() + path());
    EXPECT_NE(connect(page, host()).find("403"), std::string::npos);
}

TEST_F(ForeignPage, APageOfAnotherPortIsRefused) {
    const std::string first = host();
    startSecondBridge();
    const WebPage page = visit("http://" + host() + path());
    EXPECT_EQ(connect(page, host()), "open");
    EXPECT_NE(connect(page, first).find("403"), std::string::npos);
}

// A frame that is shut off by its page has no origin. One that is not shows that the frame itself works.
TEST_F(ForeignPage, AFrameWithoutOriginIsRefused) {
    const WebPage page = visit("http://" + host() + path());
    const auto connectFrom = [&](const std::string& sandbox) {
        return page.value(
            "new Promise((tell) => { onmessage = ({ data }) => tell(data); const frame = "
            "document.createElement('iframe'); frame.sandbox = '" +
            sandbox + "'; frame.srcdoc = `<script>const socket = new WebSocket('ws://" + host() +
            "/ws', 'rtbridge.1'); const say = (what) => parent.postMessage(origin + ' ' + what, '*');"
            "socket.onopen = () => say('open'); socket.onerror = () => say('refused');</scr` + `ipt>`; "
            "document.body.append(frame); })");
    };
    EXPECT_EQ(connectFrom("allow-scripts"), "null refused");
    EXPECT_EQ(connectFrom("allow-scripts allow-same-origin"), "http://" + host() + " open");
}

// A name of a foreign site that its owner points to this machine.
TEST_F(ForeignPage, AReboundNameIsRefused) {
    const WebPage page = visit("http://evil.example" + port() + path());
    EXPECT_EQ(page.value("document.scripts.length"), 0) << "no page under that name";
    EXPECT_NE(connect(page, "evil.example" + port()), "open");
    EXPECT_NE(connect(page, host()), "open");
}

TEST_F(ForeignPage, THOROUGH_NothingIsKeptInCookies) {
    const WebPage page(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(page));
    EXPECT_TRUE(page.call("Network.getCookies")["cookies"].empty());
    EXPECT_EQ(page.value("location.href").get<std::string>().find("t="), std::string::npos)
        << "the token stands in the address";
}

// Not even the bridge's own page, where the frame's title could be read.
TEST_F(ForeignPage, NoPageCanShowItInAFrame) {
    const WebPage page = visit("http://" + host() + path());
    EXPECT_EQ(
        page.value("new Promise((tell) => { const frame = document.createElement('iframe'); frame.src = '/';"
                   "frame.onload = () => { let seen = ''; try { seen = frame.contentDocument.title; } catch "
                   "{} tell(seen); };"
                   "document.body.append(frame); })"),
        "");
}

} // namespace
