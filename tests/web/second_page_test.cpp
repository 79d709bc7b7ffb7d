// Several pages at one server: each sees the image, one drives.
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class SecondPage : public test::BridgedServer {};

// Nothing changes while it joins: no newer frame comes.
TEST_F(SecondPage, SeesTheRestingImage) {
    const WebPage first = drive();
    ASSERT_TRUE(isExact(first));
    const WebPage second(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(second));
    ASSERT_TRUE(isExact(second));
    EXPECT_EQ(first.pixels(), second.pixels());
}

// The bridge has let go of the server meanwhile.
TEST_F(SecondPage, SeesTheRestingImageAfterAllPagesWereClosed) {
    const WebPage first = drive();
    ASSERT_TRUE(isExact(first));
    const std::string drawn = first.pixels();
    first.close();
    browser().listen(std::chrono::seconds(1));
    const WebPage second(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(second));
    ASSERT_TRUE(isExact(second));
    EXPECT_EQ(second.pixels(), drawn);
}

TEST_F(SecondPage, DrivesOnceTheFirstOneHandsOver) {
    const WebPage first = drive();
    const WebPage second(browser(), driverLink());
    ASSERT_TRUE(second.becomes("document.getElementById('pill-text').textContent.includes('drives')"));
    const std::string open =
        "document.getElementById('menu').click(); document.getElementById('tab-people').click()";
    second.value(open);
    ASSERT_TRUE(second.becomes("document.querySelector('#panel-people .actions button')"));
    second.value("document.querySelector('#panel-people .actions button').click()");
    ASSERT_TRUE(first.becomes("document.querySelector('#notices button')")) << "the driver is asked";
    first.value("document.querySelector('#notices button').click()");
    EXPECT_TRUE(second.becomes("!document.getElementById('pill-text').textContent.includes('drives')"));
    EXPECT_TRUE(first.becomes("document.getElementById('pill-text').textContent.includes('drives')"));
}

// What one page changes, the other one shows.
TEST_F(SecondPage, ShowsWhatTheFirstOneSets) {
    const WebPage first = drive();
    const WebPage second(browser(), viewerLink());
    const std::string open =
        "document.getElementById('menu').click(); document.getElementById('tab-settings').click();"
        "document.querySelectorAll('#panels details').forEach((one) => one.open = true)";
    const std::string shadows = "[...document.querySelectorAll('#panel-settings .row')].find((row) => "
                                "row.textContent === 'Shadows').querySelector('input')";
    for (const WebPage* page : {&first, &second}) {
        ASSERT_TRUE(page->becomes("document.getElementById('pill-text').textContent !== ''"));
        page->value(open);
        ASSERT_TRUE(page->becomes(shadows + ".checked"));
    }
    EXPECT_EQ(second.value(shadows + ".disabled"), true);
    first.value(shadows + ".click()");
    EXPECT_TRUE(second.becomes("!" + shadows + ".checked"));
    EXPECT_EQ(ask("get shadows"), "false");
    first.value("document.getElementById('undo').click()");
    EXPECT_TRUE(second.becomes(shadows + ".checked"));
    EXPECT_EQ(ask("get shadows"), "true");
}

} // namespace
