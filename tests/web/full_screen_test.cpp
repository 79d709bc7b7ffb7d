// Control is the page's in full screen alone, where the browser gives it: elsewhere Control+W closes the tab.
#include "web/bridged_server.h"

#include "rtcore/motion/key_codes.h"

namespace {

using test::WebPage;

// Without a lock of the mouse, which takes a headless browser seconds to leave in full screen.
constexpr const char* kNoMouse = "delete Element.prototype.requestPointerLock;";

// The keys that the page reports as held, by the last input that it sent.
constexpr const char* kWatchKeys = R"(
window.heldNow = "";
const post = Worker.prototype.postMessage;
Worker.prototype.postMessage = function (what, ...moved) {
    const [method, message] = what;
    if (method === "send" && message instanceof ArrayBuffer) {
        const bytes = new Uint8Array(message);
        if (bytes[0] === 2) window.heldNow = [...bytes.slice(16, 16 + bytes[1])].sort().join();
    }
    return post.call(this, what, ...moved);
};)";

class FullScreen : public test::BridgedServer {
  protected:
    WebPage open(const std::string& more = "") {
        startServer();
        startBridge();
        startBrowser();
        WebPage page(browser(), "about:blank");
        page.call("Page.addScriptToEvaluateOnNewDocument",
                  {{"source", std::string(kNoMouse) + kWatchKeys + more}});
        page.open(driverLink());
        EXPECT_TRUE(showsFrame(page));
        return page;
    }
    static bool holds(const WebPage& page, const std::string& keys) {
        return page.becomes("window.heldNow === '" + keys + "'");
    }
    static void enter(const WebPage& page) {
        page.value("document.getElementById('full').click()");
        ASSERT_TRUE(page.becomes("document.fullscreenElement !== null"));
        page.value("new Promise((done) => setTimeout(done, 100))"); // the keys are asked for after it
    }
    const std::string crawl_ = std::to_string(rtcore::KeyControl), forward_ = "87";
};

TEST_F(FullScreen, THOROUGH_ControlCrawlsThere) {
    const WebPage page = open();
    ASSERT_NO_FATAL_FAILURE(enter(page));
    capture(page);
    page.keyDown("ControlLeft");
    EXPECT_TRUE(holds(page, crawl_));
    page.keyDown("KeyW");
    EXPECT_TRUE(holds(page, crawl_ + "," + forward_));
    page.value("void document.exitFullscreen()");
    EXPECT_TRUE(holds(page, forward_)) << "Control is the browser's again";
    page.keyUp("KeyW");
    EXPECT_TRUE(holds(page, ""));
}

TEST_F(FullScreen, THOROUGH_ControlIsTheBrowsersOutside) {
    const WebPage page = open();
    capture(page);
    page.keyDown("ControlLeft");
    page.keyDown("KeyX");
    EXPECT_TRUE(holds(page, crawl_)) << "by the page's own key";
    page.keyUp("KeyX");
    EXPECT_TRUE(holds(page, ""));
}

// As over plain http.
TEST_F(FullScreen, THOROUGH_ControlIsTheBrowsersWhereKeysAreNotLocked) {
    const WebPage page = open("Object.defineProperty(navigator, 'keyboard', { value: undefined });");
    ASSERT_NO_FATAL_FAILURE(enter(page));
    capture(page);
    page.keyDown("ControlLeft");
    page.keyDown("KeyW");
    EXPECT_TRUE(holds(page, forward_));
    page.keyUp("KeyW");
    EXPECT_TRUE(holds(page, ""));
}

} // namespace
