// The settings of the page: the quality as one choice, and what is folded up.
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class PageSettings : public test::BridgedServer {
  protected:
    static std::string step(const std::string& name) {
        return "[...document.querySelectorAll('#panel-settings .steps button')].find((one) => "
               "one.textContent === '" +
               name + "')";
    }
    static bool isAt(const WebPage& page, const std::string& name) {
        return page.becomes(step(name) + "?.getAttribute('aria-pressed') === 'true'");
    }
    static std::string row(const std::string& label) {
        return "[...document.querySelectorAll('#panel-settings .row')].find((row) => "
               "row.querySelector('label')?.textContent.startsWith('" +
               label + "'))";
    }
};

TEST_F(PageSettings, AQualityIsOneStepOfUndo) {
    const WebPage page = drive();
    page.value("document.getElementById('menu').click(); document.getElementById('tab-settings').click()");
    ASSERT_TRUE(isAt(page, "Good"));
    EXPECT_EQ(page.value(row("Brightness") + ".checkVisibility()"), true);
    EXPECT_EQ(page.value(row("Max. bounces") + ".checkVisibility()"), false) << "folded up";
    page.value(step("Final") + ".click()");
    ASSERT_TRUE(isAt(page, "Final"));
    EXPECT_EQ(ask("get antialiasing"), "3");
    EXPECT_EQ(ask("quality"), "final");
    ask("set antialiasing 2");
    EXPECT_TRUE(page.becomes("!document.querySelector('#panel-settings .steps + .dim').hidden"));
    ask("undo");
    ASSERT_TRUE(isAt(page, "Final"));
    page.value("document.getElementById('undo').click()");
    EXPECT_TRUE(isAt(page, "Good"));
    EXPECT_EQ(ask("get antialiasing"), "1");
}

TEST_F(PageSettings, AViewIsSharedByAButton) {
    const WebPage page = drive();
    EXPECT_TRUE(page.becomes("!document.getElementById('share').hidden"));
    page.value("Object.defineProperty(navigator, 'share', {value: async ({url}) => window.shared = url})");
    page.value("document.getElementById('share').click()");
    EXPECT_TRUE(page.becomes("/^http:.*#v=[-0-9.,e]+$/.test(window.shared)"));
}

} // namespace
