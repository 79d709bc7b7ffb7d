// From the address to the first image: how much comes over the wire, and when what happens.
#include "web/bridged_server.h"

#include <iostream>

namespace {

using test::Json;
using test::WebPage;

// Notes the first time of each step.
constexpr const char* kWatchSteps = R"(
window.steps = {};
const note = (step) => (window.steps[step] ??= Math.round(performance.now()));
window.Worker = class extends Worker {
    constructor(...words) {
        super(...words);
        note("worker made");
        this.addEventListener("message", ({ data }) => note(data.said ? JSON.parse(data.said).event : data.drawn ? "drawn" : "closed"));
    }
};)";

class FirstPage : public test::BridgedServer, public testing::WithParamInterface<const char*> {
  protected:
    void SetUp() override {
        BridgedServer::SetUp();
        if (IsSkipped()) return;
        startServer();
        startBridge();
        startBrowser();
    }
    /// Bytes and answers over HTTP since the event so many.
    static std::pair<double, int> loaded(const WebPage& page, std::size_t from) {
        double bytes = 0;
        int answers = 0;
        const std::vector<Json> events = page.events();
        for (std::size_t i = from; i < events.size(); ++i) {
            if (events[i].value("method", "") != "Network.loadingFinished") continue;
            bytes += events[i]["params"].value("encodedDataLength", 0.0);
            ++answers;
        }
        return {bytes, answers};
    }
};

TEST_P(FirstPage, IsLight) {
    const WebPage page(browser(), "about:blank");
    page.call("Page.addScriptToEvaluateOnNewDocument",
              {{"source", std::string("Object.defineProperty(navigator, 'language', { value: '") +
                              GetParam() + "' });" + kWatchSteps}});
    const std::size_t before = page.events().size();
    page.open(driverLink());
    ASSERT_TRUE(showsFrame(page));
    browser().listen(std::chrono::milliseconds(200));
    const auto [bytes, answers] = loaded(page, before);
    EXPECT_GT(bytes, 10'000);
    EXPECT_LT(bytes, 100'000);
    EXPECT_LE(answers, 10) << "each is a trip over the link";
    std::cout << "time line, ms: " << page.value("window.steps").dump() << ", " << bytes << " bytes in "
              << answers << " answers\n";

    // The second time next to nothing comes.
    const std::size_t again = page.events().size();
    page.open(address());
    ASSERT_TRUE(page.becomes("location.hash === '' && performance.now() > 0"));
    ASSERT_TRUE(showsFrame(page));
    browser().listen(std::chrono::milliseconds(200));
    EXPECT_LT(loaded(page, again).first, 10'000);
}

INSTANTIATE_TEST_SUITE_P(English, FirstPage, testing::Values("en"),
                         [](const auto& about) { return std::string(about.param); });
INSTANTIATE_TEST_SUITE_P(THOROUGH_Czech, FirstPage, testing::Values("cs"),
                         [](const auto& about) { return std::string(about.param); });

} // namespace
