// Measures of the scene in the page: labels over the image, a list, and measuring by taps.
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class PageMeasures : public test::BridgedServer {
  protected:
    static constexpr const char* kLabels =
        "[...document.querySelectorAll('#measures text')].map(({ textContent }) => textContent).join('|')";
    const std::string kMarks = "document.querySelectorAll('#measures circle').length";
    const std::string kListed = "document.getElementById('measured').textContent";
    /// Presses the button of that kind; taps follow.
    static void begin(const WebPage& page, const std::string& kind) {
        page.value("[...document.querySelectorAll('#panel-views button')].find(({ textContent }) => "
                   "textContent === '" +
                   kind + "').click()");
        EXPECT_TRUE(page.becomes("document.getElementById('measures').classList.contains('measuring')"));
    }
    static void tapAt(const WebPage& page, double right, double down) {
        page.value(
            "(() => { const place = document.getElementById('measures'), box = "
            "place.getBoundingClientRect(); place.dispatchEvent(new MouseEvent('click', { bubbles: true, "
            "clientX: box.x + " +
            std::to_string(right) + " * box.width, clientY: box.y + " + std::to_string(down) +
            " * box.height })); })()");
    }
};

TEST_F(PageMeasures, AreShownListedMadeAndRemoved) {
    startServer("160x120", {"--units=m"});
    startBridge();
    startBrowser();
    ask("camera set 0 1 3 0 0 -1 90");
    ask("measure keep distance -1 1 0 1 1 0");
    ask("measure name 1 <b>");
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    ASSERT_TRUE(page.becomes(std::string(kLabels) + " === '<b> 2.000 m'")) << page.value(kLabels);
    ask("measure unit cm 0");
    ASSERT_TRUE(page.becomes(std::string(kLabels) + " === '<b> 200 cm'")) << page.value(kLabels);
    ask("section add 0 0 -1 0 0 1");
    EXPECT_TRUE(page.becomes(std::string(kLabels) + " === ''")) << "it is cut away";
    ask("section clear");
    page.value("document.getElementById('menu').click(); document.getElementById('tab-views').click()");
    ASSERT_TRUE(
        page.becomes("document.querySelector('#measured .name')?.textContent === '<b> Distance 200 cm'"));
    begin(page, "Distance");
    tapAt(page, 0.4, 0.7);
    ASSERT_TRUE(page.becomes(kMarks + " === 1"));
    tapAt(page, 0.6, 0.7);
    ASSERT_TRUE(page.becomes("document.querySelectorAll('#measured li').length === 2"));
    EXPECT_NE(ask("measure list").find("2 distance "), std::string::npos);
    page.value("document.querySelector('#measured button').click()");
    EXPECT_TRUE(page.becomes("document.querySelectorAll('#measured li').length === 1"));
    EXPECT_EQ(ask("measure list").find("2 distance "), std::string::npos);
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

TEST_F(PageMeasures, OfEachKindAreMadeByTaps) {
    startServer("160x120", {"--units=m"});
    startBridge();
    startBrowser();
    ask("camera set 0 1 3 0 0 -1 90");
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    page.value("document.getElementById('menu').click(); document.getElementById('tab-views').click()");
    begin(page, "Angle");
    tapAt(page, 0.4, 0.7);
    ASSERT_TRUE(page.becomes(kMarks + " === 1"));
    ask("camera set 0 1.2 3 0 0 -1 90"); // what was caught stays where it is in the model
    tapAt(page, 0.6, 0.7);
    ASSERT_TRUE(page.becomes(kMarks + " === 2"));
    tapAt(page, 0.5, 0.75);
    ASSERT_TRUE(page.becomes(kListed + ".startsWith('Angle')")) << page.value(kListed);
    EXPECT_NE(ask("measure list").find("1 angle "), std::string::npos);
    begin(page, "Area");
    tapAt(page, 0.5, 0.75);
    ASSERT_TRUE(page.becomes(kListed + ".includes('Area')")) << page.value(kListed);
    EXPECT_NE(ask("measure list").find("2 area "), std::string::npos);
    begin(page, "Chain");
    tapAt(page, 0.4, 0.7);
    ASSERT_TRUE(page.becomes(kMarks + " === 1"));
    tapAt(page, 0.6, 0.7);
    ASSERT_TRUE(page.becomes(kMarks + " === 2"));
    page.value("document.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }))");
    ASSERT_TRUE(page.becomes(kMarks + " === 0"));
    begin(page, "Light");
    tapAt(page, 0.5, 0.75);
    EXPECT_TRUE(page.becomes("/ lx ± .* cd\\/m² ± /.test(document.getElementById('notices').textContent)"))
        << page.value("document.getElementById('notices').textContent");
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

} // namespace
