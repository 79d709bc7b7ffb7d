// Servers that die and come again: the page lives on, and shows nothing that is not so any more.
#include "web/bridged_server.h"

#include <csignal>

namespace {

using test::WebPage;

class LostServer : public test::BridgedServer {
  protected:
    static bool isStale(const WebPage& page) {
        return page.becomes("document.getElementById('view').classList.contains('stale')");
    }
    static bool isLive(const WebPage& page) {
        return page.becomes("!document.getElementById('view').classList.contains('stale')");
    }
    static std::string widthField() { return "document.querySelector('#panel-settings .actions input')"; }
};

TEST_F(LostServer, THOROUGH_AnotherServerIsShownAsSoonAsItRuns) {
    const WebPage page = drive();
    ask("wait-idle");
    ASSERT_TRUE(isExact(page));
    page.value(
        "document.getElementById('menu').click(); document.getElementById('tab-settings').click();"
        "document.querySelectorAll('#panels details').forEach((one) => one.open = true); window.mark = 1");
    ASSERT_TRUE(page.becomes(widthField() + "?.value === '160'"));
    const std::string before = screenshotPixels();
    ASSERT_TRUE(test::eventually([&] { return page.pixels() == before; }, std::chrono::seconds(20)));
    killServer();
    ASSERT_TRUE(isStale(page));
    EXPECT_TRUE(page.becomes("document.querySelector('#notices .warn')"));
    EXPECT_EQ(page.pixels(), before) << "what is left of it";
    EXPECT_TRUE(page.becomes("document.getElementById('pill-text').textContent === ''"));

    startServer("200x150", {"--setting=shadows=false"});
    ask("wait-idle");
    ASSERT_TRUE(isLive(page));
    EXPECT_TRUE(page.becomes("!document.querySelector('#notices .warn')"));
    const std::string drawn = screenshotPixels();
    EXPECT_TRUE(test::eventually([&] { return page.pixels() == drawn; }, std::chrono::seconds(20)));
    EXPECT_TRUE(isExact(page));
    EXPECT_TRUE(page.becomes(widthField() + ".value === '200'"));
    EXPECT_TRUE(page.becomes("![...document.querySelectorAll('#panel-settings .row')].find((row) => "
                             "row.textContent === 'Shadows').querySelector('input').checked"));
    EXPECT_EQ(page.value("window.mark"), 1) << "without being loaded again";

    // And the new one is driven.
    capture(page);
    page.keyDown("KeyE");
    EXPECT_TRUE(test::eventually([&] { return page.pixels() != drawn; }, std::chrono::seconds(20)));
    page.keyUp("KeyE");
}

/// As after a sleep of the computer, or in another network.
TEST_F(LostServer, THOROUGH_ALinkThatBreaksWithoutAWordIsNoticed) {
    const WebPage page = drive();
    const auto lost = [&](std::chrono::seconds within) {
        return page.becomes("document.querySelector('#notices .warn') !== null", within);
    };
    kill(bridge().process(), SIGSTOP);
    page.value("dispatchEvent(new Event('online'))");
    EXPECT_TRUE(lost(std::chrono::seconds(10)));
    kill(bridge().process(), SIGCONT);
    EXPECT_TRUE(page.becomes("!document.querySelector('#notices .warn')"));
    page.value("window.mark = 1; dispatchEvent(new Event('online'))");
    EXPECT_FALSE(lost(std::chrono::seconds(6))) << "one that is whole answers";
}

TEST_F(LostServer, THOROUGH_ThePageWaitsForTheFirstOne) {
    startBridge();
    startBrowser();
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(page.becomes("document.getElementById('waiting-text').textContent.includes('RTServer')"));
    startServer();
    EXPECT_TRUE(showsFrame(page));
}

} // namespace
