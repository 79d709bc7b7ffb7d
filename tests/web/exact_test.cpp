// At rest, what stands in the page is what the server drew, byte by byte, at every quality of moving frames.
#include "web/bridged_server.h"

#include <csignal>

namespace {

using test::WebPage;

class RestingPage : public test::BridgedServer {
  protected:
    /// At each of these rungs of moving frames the page shows the server's pixels at rest.
    void showsTheServersPixelsAt(const std::string& rungs) {
        const WebPage page = drive();
        for (const char rung : rungs) {
            SCOPED_TRACE(rung);
            page.value(std::string("localStorage.setItem('rt.rung', '") + rung + "')");
            page.open(address() + "?" + rung);
            ASSERT_TRUE(page.becomes(std::string("location.search === '?") + rung + "'"));
            ASSERT_TRUE(showsFrame(page));
            ask("camera turn 10 0");
            ask("wait-idle");
            ASSERT_TRUE(page.becomes("document.getElementById('view').width === 160"));
            const std::string drawn = screenshotPixels();
            EXPECT_TRUE(test::eventually([&] { return page.pixels() == drawn; }, std::chrono::seconds(20)));
        }
    }
};

TEST_F(RestingPage, ShowsTheServersPixelsAtTheFinestAndTheCoarsestRung) { showsTheServersPixelsAt("05"); }
TEST_F(RestingPage, THOROUGH_ShowsTheServersPixelsAtTheRungsBetween) { showsTheServersPixelsAt("1234"); }

// *Save picture* writes what the server has, not what the screen made of it.
TEST_F(RestingPage, SavesTheServersPixels) {
    const WebPage page = drive();
    ask("camera turn 25 5");
    ask("wait-idle");
    const std::string drawn = screenshotPixels();
    ASSERT_EQ(drawn.size(), 160U * 120 * 3);
    ASSERT_TRUE(test::eventually([&] { return page.pixels() == drawn; }, std::chrono::seconds(20)));
    ASSERT_TRUE(isExact(page));
    page.call("Page.setDownloadBehavior",
              {{"behavior", "allow"}, {"downloadPath", folder().path().string()}});
    page.value("document.getElementById('save').click()");
    const auto file = folder() / "room.png";
    EXPECT_TRUE(test::eventually([&] { return pngPixels(file) == drawn; }, std::chrono::seconds(20)));
}

// By paths there is more light than in the server's frame; the page says how the image was made.
TEST_F(RestingPage, ShowsTheViewByPaths) {
    const WebPage page = drive({"--rest=paths"});
    ask("set path.samples 16");
    ask("camera turn 25 5");
    ask("wait-idle");
    const std::string drawn = screenshotPixels();
    page.keyDown("F3");
    page.keyUp("F3");
    EXPECT_TRUE(page.becomes("document.getElementById('statistics').textContent.includes('samples: 16')"));
    EXPECT_TRUE(isExact(page));
    EXPECT_TRUE(page.becomes("document.getElementById('pill-text').textContent.includes('full quality')"));
    const std::string shown = page.pixels();
    ASSERT_EQ(shown.size(), drawn.size());
    EXPECT_NE(shown, drawn);
    ask("fly");
    capture(page);
    page.keyDown("KeyW");
    EXPECT_TRUE(page.becomes("!document.getElementById('statistics').textContent.includes('samples')"));
    page.keyUp("KeyW");
    bridge().send(SIGTERM); // it ends its Renderer
    EXPECT_EQ(bridge().wait().exitCode, 143);
}

} // namespace
