// Notes of the scene in the page: numbers over the image, their texts, a list, and writing by drivers and,
// where that is allowed, by those who only look.
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class PageNotes : public test::BridgedServer {
  protected:
    void SetUp() override {
        BridgedServer::SetUp();
        if (IsSkipped()) return;
        startServer("160x120", {"--units=m"});
        ask("camera set 0 1 3 0 0 -1 90");
    }
    static void openList(const WebPage& page) {
        page.value("document.getElementById('menu').click(); document.getElementById('tab-model').click()");
    }
    static void type(const WebPage& page, const std::string& text, const std::string& name) {
        page.value("document.querySelector('#note textarea').value = '" + text +
                   "'; document.querySelector('#note input').value = '" + name +
                   "'; document.querySelector('#note button').click()");
    }
    static void tapAt(const WebPage& page, double right, double down) {
        page.value(
            "(() => { const place = document.getElementById('notes'), box = "
            "place.getBoundingClientRect(); place.dispatchEvent(new MouseEvent('click', { bubbles: true, "
            "clientX: box.x + " +
            std::to_string(right) + " * box.width, clientY: box.y + " + std::to_string(down) +
            " * box.height })); })()");
    }
    static bool isWaiting(const WebPage& page) {
        return page.becomes("document.getElementById('notes').className === 'measuring'");
    }
    static constexpr const char* kShown =
        "[...document.querySelectorAll('#notes button')].filter((one) => !one.hidden).length";
};

TEST_F(PageNotes, AreAsLongAsTheServerTakesThem) {
    startBridge();
    startBrowser();
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    openList(page);
    ASSERT_TRUE(page.becomes("document.querySelector('#note textarea')?.maxLength === 2000"));
    type(page, "' + '\\u20AC'.repeat(2000) + '", "Ada");
    ASSERT_TRUE(isWaiting(page));
    tapAt(page, 0.5, 0.8);
    ASSERT_TRUE(page.becomes(std::string(kShown) + " === 1"));
    EXPECT_EQ(ask("note get 1").size(), 6000U);
}

TEST_F(PageNotes, AreShownListedWrittenAndRemoved) {
    startBridge();
    startBrowser();
    ask("note add 0 1 0 \"<b>dark</b>\nhere\" <i>Ada</i>");
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    ASSERT_TRUE(page.becomes(std::string(kShown) + " === 1"));
    page.value("document.querySelector('#notes button').click()");
    EXPECT_TRUE(
        page.becomes("document.querySelector('#notices').textContent.includes('<b>dark</b>\\nhere') && "
                     "document.querySelector('#notices').textContent.includes('<i>Ada</i>')"));
    EXPECT_TRUE(page.becomes("document.querySelectorAll('#notices b, #notices i').length === 0"));
    ask("section add 0 0 -1 0 0 1");
    EXPECT_TRUE(page.becomes(std::string(kShown) + " === 0")) << "it is cut away";
    ask("section clear");
    openList(page);
    ASSERT_TRUE(page.becomes("document.querySelector('#noted .name')?.textContent.startsWith('1  <i>Ada')"));
    type(page, "brighter", "");
    ASSERT_TRUE(isWaiting(page));
    tapAt(page, 0.5, 0.8);
    ASSERT_TRUE(page.becomes(std::string(kShown) + " === 2"));
    EXPECT_EQ(ask("note get 2"), "brighter");
    ask("camera set 5 5 5 1 0 0 90");
    openList(page);
    page.value("document.querySelectorAll('#noted .name')[1].click()");
    EXPECT_TRUE(page.becomes(std::string(kShown) + " === 2")) << "where it was written";
    page.value("document.querySelector('#noted li button:last-child').click()");
    EXPECT_TRUE(page.becomes("document.querySelectorAll('#noted li').length === 1"));
    EXPECT_EQ(ask("note get 1"), "brighter");
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

TEST_F(PageNotes, AreWrittenByThoseWhoOnlyLookWhereThatIsAllowed) {
    startBridge({"--visitor-notes"});
    startBrowser();
    const WebPage page(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(page));
    openList(page);
    ASSERT_TRUE(page.becomes("document.getElementById('note')?.hidden === false"));
    type(page, "dark", "");
    EXPECT_FALSE(page.value("document.getElementById('notes').className === 'measuring'").get<bool>())
        << "without a name";
    type(page, "dark", "Ben");
    ASSERT_TRUE(isWaiting(page));
    tapAt(page, 0.5, 0.8);
    ASSERT_TRUE(page.becomes("document.querySelectorAll('#notes button').length === 1"));
    EXPECT_NE(ask("note list").find(" Ben: dark"), std::string::npos);
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

TEST_F(PageNotes, AreOnlyReadByThoseWhoLookElsewhere) {
    startBridge();
    startBrowser();
    ask("note add 0 1 0 dark");
    const std::string camera = ask("camera get");
    const WebPage page(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(page));
    openList(page);
    ASSERT_TRUE(page.becomes("document.querySelectorAll('#noted .name').length === 1"));
    EXPECT_TRUE(page.value("document.getElementById('note').hidden").get<bool>());
    page.value("document.querySelector('#noted .name').click()");
    EXPECT_TRUE(page.becomes("document.querySelector('#notices').textContent.includes('dark')"));
    EXPECT_EQ(ask("camera get"), camera) << "who looks moves nothing";
}

} // namespace
