// The panel of lights in a scene of millimetres: lengths in metres, powers in lumens or watts, each with its
// unit.
#include "web/bridged_server.h"

namespace {

using test::Json;
using test::WebPage;

class PageLights : public test::BridgedServer {
  protected:
    /// The row of a field, as an expression.
    static std::string row(const std::string& label) {
        return "[...document.querySelectorAll('#panel-lights .row')].find((row) => row.checkVisibility() && "
               "row.querySelector('label, .label').textContent === '" +
               label + "')";
    }
    static Json value(const WebPage& page, const std::string& label, int box = 0) {
        return page.value("Number(" + row(label) + "?.querySelectorAll('input')[" + std::to_string(box) +
                          "].value)");
    }
    static bool shows(const WebPage& page, const std::string& label, double value) {
        return page.becomes("Math.abs(" + row(label) + "?.querySelector('input').value / " +
                            std::to_string(value) + " - 1) < 1e-5");
    }
    static void type(const WebPage& page, const std::string& label, const std::string& text, int box = 0) {
        page.value("(() => { const box = " + row(label) + ".querySelectorAll('input')[" +
                   std::to_string(box) + "]; box.value = '" + text +
                   "'; box.dispatchEvent(new Event('change')); })()");
    }
    bool says(const std::string& words) {
        return test::eventually([&] { return ask("light get " + lamp_).find(words) != std::string::npos; },
                                std::chrono::seconds(20));
    }
    std::string lamp_; ///< its number
};

TEST_F(PageLights, AreInMetresAndLumens) {
    startServer("160x120", {"--units=mm"});
    startBridge();
    startBrowser();
    lamp_ = ask("light add sphere at 1234.5 2000.7 0.1");
    ask("light size " + lamp_ + " 60");
    ask("light power " + lamp_ + " 800 lm");
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    page.value("document.getElementById('menu').click(); document.getElementById('tab-lights').click()");
    ASSERT_TRUE(page.becomes("document.querySelector('#panel-lights .name')"));
    page.value("document.querySelector('#panel-lights .name').click()");
    ASSERT_TRUE(shows(page, "Radius\u00a0m", 0.06));
    EXPECT_TRUE(shows(page, "Power", 800));
    EXPECT_EQ(value(page, "Position\u00a0m", 0), 1.2345);
    EXPECT_EQ(value(page, "Position\u00a0m", 2), 0.0001);

    type(page, "Radius\u00a0m", "0.075");
    EXPECT_TRUE(says("radius = 75.0\n"));
    type(page, "Position\u00a0m", "1.5", 1);
    EXPECT_TRUE(says("position = [1234.5, 1500.0, 0.1]\n")) << ask("light get " + lamp_);

    // Watts are the other choice.
    page.value(
        "(() => { const unit = " + row("Power") +
        ".querySelector('select'); unit.selectedIndex = 1; unit.dispatchEvent(new Event('change')); })()");
    EXPECT_TRUE(shows(page, "Power", 800. / 683));
    type(page, "Power", "2");
    EXPECT_TRUE(says("# 2 W, 1366 lm")) << ask("light get " + lamp_);
    EXPECT_TRUE(shows(page, "Power", 2));
    EXPECT_EQ(page.value("[..." + row("Power") + ".querySelectorAll('option')].map(({ text }) => text)"),
              (Json{"lm", "W"}));
    ask("units 1");
    EXPECT_TRUE(shows(page, "Radius\u00a0m", 75));
    ask("light kind " + lamp_ + " directional");
    ASSERT_TRUE(page.becomes("!" + row("Position\u00a0m")));
    EXPECT_EQ(page.value("[..." + row("Power") + ".querySelectorAll('option')].map(({ text }) => text)"),
              (Json{"lx", "W/m²"}));
}

} // namespace
