// The plan in the corner of the page: loaded when it is asked for, storeys up and down, and a driver's tap
// that goes there.
#include "web/bridged_server.h"

#include <array>
#include <fstream>
#include <sstream>

namespace {

using test::WebPage;

/// Two storeys of 20 x 10 m at 0 and 3 m with walls of 0.5 m, up along y.
std::string houseWithStoreys() {
    std::ostringstream text;
    text << "# units = metres\n";
    int first = 1;
    const auto box = [&](std::array<double, 3> lo, std::array<double, 3> hi) {
        for (int i = 0; i < 8; ++i)
            text << "v " << ((i & 1) != 0 ? hi : lo)[0] << ' ' << ((i & 2) != 0 ? hi : lo)[1] << ' '
                 << ((i & 4) != 0 ? hi : lo)[2] << '\n';
        constexpr int kFaces[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (const auto& face : kFaces) {
            text << 'f';
            for (const int corner : face) text << ' ' << first + corner;
            text << '\n';
        }
        first += 8;
    };
    for (const double floor : {0.0, 3.0, 6.0}) box({0, floor - 0.25, 0}, {20, floor, 10});
    for (const double floor : {0.0, 3.0}) {
        box({0, floor, 0}, {20, floor + 2.75, 0.5});
        box({0, floor, 9.5}, {20, floor + 2.75, 10});
        box({0, floor, 0.5}, {0.5, floor + 2.75, 9.5});
        box({19.5, floor, 0.5}, {20, floor + 2.75, 9.5});
    }
    return text.str();
}

class PagePlan : public test::BridgedServer {
  protected:
    void SetUp() override {
        BridgedServer::SetUp();
        if (IsSkipped()) return;
        startServer();
        std::ofstream(folder() / "house.obj") << houseWithStoreys();
        ask("load scene \"" + (folder() / "house.obj").string() + "\"");
        ask("camera set 5 1.6 5 1 0 0");
        startBridge();
        startBrowser();
    }
    static bool isTitled(const WebPage& page, const std::string& title) {
        return page.becomes("document.querySelector('#plan header span')?.textContent === '" + title + "'");
    }
    static void press(const WebPage& page, const std::string& what) {
        page.value("document.querySelector('" + what + "').click()");
    }
    /// At a part of the plan from its left and from its top.
    static void tapPlan(const WebPage& page, double right, double down) {
        page.value("(() => { const plan = document.querySelector('#plan svg'), box = "
                   "document.querySelector('#plan .solid').getBoundingClientRect(); "
                   "plan.dispatchEvent(new MouseEvent('click', { bubbles: true, clientX: box.x + " +
                   std::to_string(right) + " * box.width, clientY: box.y + " + std::to_string(down) +
                   " * box.height })); })()");
    }
    static constexpr const char* kLoaded =
        "performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/plan.js'))";
};

TEST_F(PagePlan, IsLoadedWhenAskedForShowsStoreysAndLeadsThere) {
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    ASSERT_TRUE(page.becomes("document.getElementById('plan-button').hidden === false"));
    EXPECT_EQ(page.value(kLoaded), false);
    press(page, "#plan-button");
    ASSERT_TRUE(isTitled(page, "Storey 1 of 2")) << page.value("document.getElementById('plan').textContent");
    EXPECT_EQ(page.value(kLoaded), true);
    EXPECT_EQ(page.value("document.getElementById('plan-button').getAttribute('aria-pressed')"), "true");
    EXPECT_TRUE(page.becomes("document.querySelector('#plan .wedge').getAttribute('d').startsWith('M')"));
    EXPECT_EQ(page.value("document.querySelector('#plan circle').classList.contains('elsewhere')"), false);
    // Where the camera is in the plan: a quarter from the left, in the middle.
    EXPECT_TRUE(page.becomes(
        "(() => { const box = document.querySelector('#plan .solid').getBoundingClientRect(), dot = "
        "document.querySelector('#plan circle').getBoundingClientRect(); return Math.abs((dot.x + dot.width "
        "/ "
        "2 - box.x) / box.width - 0.25) < 0.03 && Math.abs((dot.y + dot.height / 2 - box.y) / box.height - "
        "0.5) < 0.06; })()"));
    press(page, "#plan button:last-child");
    ASSERT_TRUE(isTitled(page, "Storey 2 of 2"));
    EXPECT_TRUE(page.becomes("document.querySelector('#plan circle').classList.contains('elsewhere')"));
    EXPECT_EQ(page.value("document.querySelector('#plan button:last-child').disabled"), true);
    tapPlan(page, 0.75, 0.5);
    EXPECT_TRUE(page.becomes("!document.querySelector('#plan circle').classList.contains('elsewhere')"));
    const std::string camera = ask("camera get");
    EXPECT_NE(camera.find("eye = [15."), std::string::npos) << camera;
    EXPECT_NE(camera.find("forward = [1.0, 0.0, 0.0]"), std::string::npos) << camera;
    ask("storey go 1");
    EXPECT_TRUE(isTitled(page, "Storey 1 of 2")) << "it comes with the camera";
    press(page, "#plan-button");
    EXPECT_TRUE(page.becomes("document.getElementById('plan').hidden"));
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

TEST_F(PagePlan, OfWhoOnlyLooksLeadsNowhereAndShowsOtherModels) {
    const WebPage page(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(page));
    ASSERT_TRUE(page.becomes("document.getElementById('plan-button').hidden === false"));
    press(page, "#plan-button");
    ASSERT_TRUE(isTitled(page, "Storey 1 of 2"));
    const std::string before = ask("camera get");
    tapPlan(page, 0.75, 0.5);
    press(page, "#plan button:last-child");
    ASSERT_TRUE(isTitled(page, "Storey 2 of 2")) << "asked for behind what a tap would ask for";
    EXPECT_EQ(ask("camera get"), before);
    ask("load scene \"" + (folder() / "room.obj").string() + "\"");
    EXPECT_TRUE(isTitled(page, "No storeys: contour lines"));
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

} // namespace
