// At rest, what stands in the page is what the server drew, byte by byte, at every quality of moving frames.
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class RestingPage : public test::BridgedServer {
  protected:
    /// Three bytes a pixel.
    std::string serverPixels() {
        const std::string file = (folder() / "frame.ppm").string();
        ask("screenshot " + file);
        const std::string bytes = test::readBytes(file);
        std::size_t at = 0;
        for (int word = 0; word < 4; ++word) at = bytes.find_first_of(" \n", at) + 1; // P6 WIDTH HEIGHT 255
        return bytes.substr(at);
    }
};

TEST_F(RestingPage, ShowsTheServersPixelsAtEachRung) {
    const WebPage page = drive();
    const std::string address = driverLink().substr(0, driverLink().find('#'));
    for (const char rung : std::string("012345")) {
        SCOPED_TRACE(rung);
        page.value(std::string("localStorage.setItem('rt.rung', '") + rung + "')");
        page.open(address + "?" + rung);
        ASSERT_TRUE(page.becomes(std::string("location.search === '?") + rung + "'"));
        ASSERT_TRUE(showsFrame(page));
        ask("camera turn 10 0");
        ask("wait-idle");
        ASSERT_TRUE(page.becomes("document.getElementById('view').width === 160"));
        const std::string drawn = serverPixels();
        EXPECT_TRUE(test::eventually([&] { return page.pixels() == drawn; }, std::chrono::seconds(20)));
    }
}

TEST_F(RestingPage, SavesThatImage) {
    const WebPage page = drive();
    ask("wait-idle");
    ASSERT_TRUE(isExact(page));
    page.call("Page.setDownloadBehavior",
              {{"behavior", "allow"}, {"downloadPath", folder().path().string()}});
    page.value("document.getElementById('save').click()");
    const auto file = folder() / "room.png";
    ASSERT_TRUE(test::eventually(
        [&] { return std::filesystem::exists(file) && test::pngFileSize(file).width == 160; },
        std::chrono::seconds(20)));
    EXPECT_EQ(test::pngFileSize(file), (test::PictureSize{160, 120}));
}

} // namespace
