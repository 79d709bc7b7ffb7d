// A narrow link: frames stay young, and the quality comes back.
#include "support/quantile.h"
#include "web/bridged_server.h"
#include "web/narrow_link.h"

#include <atomic>
#include <map>
#include <mutex>
#include <thread>

namespace {

using namespace std::chrono_literals;
using test::Json;
using test::WebPage;

class SlowLink : public test::BridgedServer {
  protected:
    /// The printed links lead to the narrow link.
    void startBridge() {
        BridgedServer::startBridge({"--listen=127.0.0.1:" + std::to_string(link_.target()),
                                    "--origin=http://127.0.0.1:" + std::to_string(link_.port())});
    }

    // As a tunnel to a far node may be: 2 Mbit/s.
    static constexpr double kBytesPerSecond = 250'000, kRoundTrip = 0.1;
    test::NarrowLink link_{kBytesPerSecond, kRoundTrip};
};

TEST_F(SlowLink, TheLastFrameIsShownAfterAWalk) {
    startServer();
    ask("fly");
    startBridge();
    startBrowser();
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    capture(page);
    page.keyDown("KeyE");
    browser().listen(2s);
    page.keyUp("KeyE");
    ask("wait-idle");
    EXPECT_TRUE(isExact(page)) << "nothing is queued for minutes";
    const std::string drawn = screenshotPixels();
    EXPECT_TRUE(test::eventually([&] { return page.pixels() == drawn; }, 20s));
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

/// The frames that the page drew, and when, by the system's clock in ms.
constexpr const char* kWatchDrawn = R"(
window.drawn = [];
window.Worker = class extends Worker {
    constructor(...words) {
        super(...words);
        this.addEventListener("message", ({ data }) => data.drawn && drawn.push([Number(data.drawn.number), data.drawn.at, data.drawn.type]));
    }
};)";

/// When the server published each of its frames, by the same clock.
class Publications {
  public:
    explicit Publications(const std::string& instance)
        : thread_([this, instance] {
              ipc::Client client(instance, 20s);
              const double between =
                  sinceEpoch<std::chrono::system_clock>() - sinceEpoch<std::chrono::steady_clock>();
              for (ipc::Frame frame; !stopping_;) {
                  if (!client.waitForFrame(frame, 50ms)) continue;
                  const std::lock_guard lock(mutex_);
                  times_[frame.info.number] = between + 1e-6 * static_cast<double>(frame.info.nanoseconds);
              }
          }) {}
    ~Publications() {
        stopping_ = true;
        thread_.join();
    }
    /// Nothing for a frame that was missed.
    std::optional<double> of(std::uint64_t number) const {
        const std::lock_guard lock(mutex_);
        const auto found = times_.find(number);
        return found == times_.end() ? std::nullopt : std::optional(found->second);
    }
    template <class Clock>
    static double sinceEpoch() {
        return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
    }

  private:
    mutable std::mutex mutex_;
    std::map<std::uint64_t, double> times_;
    std::atomic<bool> stopping_ = false;
    std::thread thread_;
};

struct Walk {
    double rate = 0;          ///< pictures a second, from the first one on
    double fewest = 0;        ///< in any second but the first
    double first = 0;         ///< seconds from the key to its picture
    std::vector<double> ages; ///< seconds from a frame's publication to its picture
};

/// The page turns while the key is held.
Walk walk(const WebPage& page, const Publications& published, std::size_t seconds) {
    const auto now = [] { return Publications::sinceEpoch<std::chrono::system_clock>(); };
    page.value("drawn.length = 0");
    const double pressed = now();
    page.keyDown("KeyE");
    std::this_thread::sleep_for(std::chrono::seconds(seconds));
    const Json drawn = page.value("drawn");
    const double held = 1e-3 * (now() - pressed);
    page.keyUp("KeyE");
    Walk all;
    std::vector<double> counts(seconds);
    for (const Json& one : drawn) {
        const double time = one[1];
        if (const auto began = published.of(one[0])) all.ages.push_back(1e-3 * (time - *began));
        const auto second = static_cast<std::size_t>(std::max(0.0, 1e-3 * (time - pressed)));
        if (second < seconds) ++counts[second];
    }
    if (drawn.empty() || seconds < 2) return all;
    all.first = 1e-3 * (drawn[0][1].get<double>() - pressed);
    all.rate = static_cast<double>(drawn.size()) / (held - all.first);
    all.fewest = *std::min_element(counts.begin() + 1, counts.end());
    return all;
}

TEST_F(SlowLink, THOROUGH_WalksFluently) {
    startServer("1280x720", {"--frame-time=33"});
    ask("load scene " RT_SOURCE_FOLDER "/data/nave/nave.scn");
    ask("fly");
    startBridge();
    startBrowser();
    const Publications published(instance());
    const WebPage page(browser(), "about:blank");
    page.call("Page.addScriptToEvaluateOnNewDocument", {{"source", kWatchDrawn}});
    page.open(driverLink());
    ASSERT_TRUE(showsFrame(page));
    capture(page);
    ask("wait-idle");
    walk(page, published, 1); // the server's first movement in a scene takes it longer
    for (int i = 0; i < 3; ++i) {
        ask("wait-idle");
        EXPECT_TRUE(isExact(page));
        const Walk all = walk(page, published, 6);
        std::printf(
            "%.1f pictures/s, %.0f in the worst second, %.0f to %.0f ms old, the first after %.0f ms\n",
            all.rate, all.fewest, 1e3 * test::quantile(all.ages, 0.5), 1e3 * test::quantile(all.ages, 1),
            1e3 * all.first);
        EXPECT_GE(all.ages.size(), 40U) << "frames whose publication was seen";
        EXPECT_GE(all.fewest, 8);
        EXPECT_LT(test::quantile(all.ages, 1), kRoundTrip + 3 / all.fewest);
        EXPECT_LT(all.first, 0.5);
    }
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

// The page comes back by itself, to the same place.
TEST_F(SlowLink, ALostLinkComesBack) {
    startServer();
    startBridge();
    startBrowser();
    const WebPage page(browser(), driverLink());
    ASSERT_TRUE(showsFrame(page));
    ASSERT_TRUE(isExact(page));
    const std::string before = screenshotPixels();
    ASSERT_TRUE(test::eventually([&] { return page.pixels() == before; }, 20s)); // the worker draws later
    page.value("window.mark = 1");
    link_.cut();
    EXPECT_TRUE(page.becomes("document.getElementById('notices').textContent.includes('Connection lost')"));
    EXPECT_EQ(page.pixels(), before) << "what is left of it";
    browser().listen(1s);
    link_.mend();
    EXPECT_TRUE(page.becomes("document.getElementById('notices').textContent.includes('Connected again')"));
    ask("fly");
    capture(page);
    page.keyDown("KeyE");
    EXPECT_TRUE(test::eventually([&] { return page.pixels() != before; }, 20s))
        << page.value("document.getElementById('notices').textContent + '; ' + "
                      "document.getElementById('stage').className");
    page.keyUp("KeyE");
    ask("wait-idle");
    EXPECT_TRUE(isExact(page));
    EXPECT_EQ(page.value("window.mark"), 1) << "without being loaded again";
}

} // namespace
