// Several pages at one server: each sees the image, one drives.
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class SecondPage : public test::BridgedServer {
  protected:
    /// Opens the settings, whole.
    static void openSettings(const WebPage& page) {
        ASSERT_TRUE(page.becomes("document.getElementById('pill-text').textContent !== ''"));
        page.value("document.getElementById('menu').click(); document.getElementById('tab-settings').click();"
                   "document.querySelectorAll('#panels details').forEach((one) => one.open = true)");
        ASSERT_TRUE(page.becomes(switchOf("Shadows")));
    }
    /// The switch of a setting, as an expression.
    static std::string switchOf(const std::string& label) {
        return "[...document.querySelectorAll('#panel-settings .row')].find((row) => row.textContent === '" +
               label + "')?.querySelector('input')";
    }
    static bool mayUndo(const WebPage& page) {
        return page.becomes("!document.getElementById('undo').disabled");
    }
    static bool mayNotUndo(const WebPage& page) {
        return page.becomes("document.getElementById('undo').disabled");
    }
    static void click(const WebPage& page, const std::string& element) {
        page.value("document." + element + ".click()");
    }
    /// From the one who drives to the other, who asks.
    static void handOver(const WebPage& driver, const WebPage& other) {
        click(other, "getElementById('tab-people')");
        const std::string ask = "querySelector('#panel-people .actions button')";
        ASSERT_TRUE(other.becomes("document." + ask));
        click(other, ask);
        ASSERT_TRUE(driver.becomes("document.querySelector('#notices button')")) << "the driver is asked";
        click(driver, "querySelector('#notices button')");
        click(other, "getElementById('tab-settings')");
        ASSERT_TRUE(other.becomes("!" + switchOf("Shadows") + ".disabled"));
        ASSERT_TRUE(driver.becomes(switchOf("Shadows") + ".disabled"));
    }
};

// Nothing changes while it joins: no newer frame comes.
TEST_F(SecondPage, THOROUGH_SeesTheRestingImage) {
    const WebPage first = drive();
    ASSERT_TRUE(isExact(first));
    const WebPage second(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(second));
    ASSERT_TRUE(isExact(second));
    const std::string drawn = screenshotPixels();
    for (const WebPage* page : {&first, &second})
        EXPECT_TRUE(test::eventually([&] { return page->pixels() == drawn; }, std::chrono::seconds(20)));
}

// The bridge has let go of the server meanwhile.
TEST_F(SecondPage, THOROUGH_SeesTheRestingImageAfterAllPagesWereClosed) {
    const WebPage first = drive();
    ASSERT_TRUE(isExact(first));
    const std::string drawn = screenshotPixels();
    first.close();
    browser().listen(std::chrono::seconds(1));
    const WebPage second(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(second));
    ASSERT_TRUE(isExact(second));
    EXPECT_TRUE(test::eventually([&] { return second.pixels() == drawn; }, std::chrono::seconds(20)));
}

TEST_F(SecondPage, THOROUGH_DrivesOnceTheFirstOneHandsOver) {
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

// The other page shows the changes of the first one.
TEST_F(SecondPage, THOROUGH_ShowsWhatTheFirstOneSets) {
    const WebPage first = drive();
    const WebPage second(browser(), viewerLink());
    for (const WebPage* page : {&first, &second}) ASSERT_NO_FATAL_FAILURE(openSettings(*page));
    const std::string shadows = switchOf("Shadows");
    ASSERT_TRUE(second.becomes(shadows + ".checked"));
    EXPECT_EQ(second.value(shadows + ".disabled"), true);
    first.value(shadows + ".click()");
    EXPECT_TRUE(second.becomes("!" + shadows + ".checked"));
    EXPECT_EQ(ask("get shadows"), "false");
    first.value("document.getElementById('undo').click()");
    EXPECT_TRUE(second.becomes(shadows + ".checked"));
    EXPECT_EQ(ask("get shadows"), "true");
}

// Two people at one model: each takes back only what is their own, and both see the same values.
TEST_F(SecondPage, THOROUGH_TwoWhoEditInTurnTakeBackTheirOwnOnly) {
    const WebPage first = drive();
    const WebPage second(browser(), driverLink());
    for (const WebPage* page : {&first, &second}) ASSERT_NO_FATAL_FAILURE(openSettings(*page));
    const std::string shadows = switchOf("Shadows"), mirrors = switchOf("Reflections");
    first.value(shadows + ".click()");
    ASSERT_TRUE(second.becomes("!" + shadows + ".checked"));
    EXPECT_TRUE(mayUndo(first));
    EXPECT_TRUE(mayNotUndo(second));
    ASSERT_NO_FATAL_FAILURE(handOver(first, second));
    EXPECT_TRUE(mayNotUndo(second)) << "the other's edit";
    second.value(mirrors + ".click()");
    ASSERT_TRUE(first.becomes("!" + mirrors + ".checked"));
    EXPECT_TRUE(mayUndo(second));
    ASSERT_NO_FATAL_FAILURE(handOver(second, first));
    EXPECT_TRUE(mayNotUndo(first)) << "the other's edit is the last one";
    ASSERT_NO_FATAL_FAILURE(handOver(first, second));
    click(second, "getElementById('undo')");
    ASSERT_TRUE(first.becomes(mirrors + ".checked"));
    EXPECT_TRUE(mayNotUndo(second)) << "what is left is the other's";
    ASSERT_NO_FATAL_FAILURE(handOver(second, first));
    ASSERT_TRUE(mayUndo(first));
    click(first, "getElementById('undo')");
    for (const WebPage* page : {&first, &second})
        EXPECT_TRUE(page->becomes(shadows + ".checked && " + mirrors + ".checked"));
    EXPECT_EQ(ask("get shadows"), "true");
}

} // namespace
