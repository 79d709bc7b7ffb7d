// How soon the bridge reacts: keys, the exact image at rest, and a real page in a browser.
#include "bench/bridge/bench_parts.h"
#include "bench/bridge/goals.h"

#include "support/quantile.h"
#include "web/chromium.h"
#include "web/web_page.h"

namespace bridgebench {

namespace {

struct Reactions {
    std::vector<double> toKey, toFrame, toStill; ///< ms
};

/// Until all parts of an exact image are there.
void takeStill(WebClient& client) {
    for (auto part = client.binary(2); part; part = client.binary(2)) {
        client.acknowledge(*part);
        if ((headerOf(part->payload).flags & 4) != 0) return;
    }
    throw std::runtime_error("no exact image at rest");
}

void press(WebClient& client, const InstantServer& server, bool rests, Reactions& times) {
    const auto start = Clock::now();
    client.input({}, 0, 0, {'W'});
    const auto frame = client.binary(1);
    if (!frame) throw std::runtime_error("no frame after a key");
    const auto came = Clock::now();
    times.toFrame.push_back(kMs * std::chrono::duration<double>(came - start).count());
    times.toKey.push_back(1e-6 * static_cast<double>(server.pressedNs - start.time_since_epoch().count()));
    client.acknowledge(*frame);
    if (!rests) return;
    takeStill(client);
    times.toStill.push_back(kMs * secondsFrom(came));
}

/// Processor time, and bytes, of an instance that rests.
void measureRest(WebClient& client, const Bridge& bridge) {
    takeStill(client);
    sleepFor(2);
    while (client.next(100ms)) { // messages on the last frames
    }
    constexpr double kRest = 5;
    const double cpu = bridge.cpu();
    double bytes = 0;
    for (const auto start = Clock::now(); secondsFrom(start) < kRest;)
        if (const auto message = client.next(100ms)) bytes += static_cast<double>(message->payload.size());
    tell("bridge's processor time at rest, 1 viewer", 100 * (bridge.cpu() - cpu) / kRest, "%");
    tell("sent at rest", bytes / kRest, "byte/s", Goal{atMost(10)});
}

/// The medians that the page's own statistics tell: from a key, and from a frame's arrival, to its image.
enum class Shown : char { Delay = 3, Decoding = 4 };
double shown(const WebPage& page, Shown row) {
    const auto text =
        page.value(fmt::format("document.querySelectorAll('#statistics dd')[{}]?.textContent ?? ''",
                               static_cast<int>(row)))
            .get<std::string>();
    return text.empty() ? 0 : std::atof(text.c_str());
}

void pressKeys(const WebPage& page) {
    page.value("document.getElementById('view').focus()");
    page.keyDown("Enter");
    page.keyUp("Enter");
    if (!page.becomes("document.getElementById('stage').classList.contains('captured')"))
        throw std::runtime_error("the page does not take keys");
    page.value("dispatchEvent(new KeyboardEvent('keydown', {code: 'F3'}))");
    for (int i = 0; i < 100; ++i) {
        page.keyDown("KeyW");
        page.keyUp("KeyW");
        std::this_thread::sleep_for(std::chrono::milliseconds(40 + 7 * i % 31));
    }
    sleepFor(1); // the figures are shown twice a second
}

} // namespace

void measureInput(const PixelBytes& pixels) {
    fmt::print("=== a server that publishes at once\n");
    const IpcInstance instance;
    const InstantServer server(instance.name(), pixels, 0);
    const Bridge bridge(instance);
    WebClient client(bridge.port());
    client.hello(kToken);
    if (client.event("welcome").is_null()) throw std::runtime_error("no welcome");
    sleepFor(1);
    while (const auto rest = client.next(300ms))
        if (rest->opcode == 2) client.acknowledge(*rest);
    Reactions times;
    constexpr int kPresses = 100, kBetweenRests = 10;
    for (int i = 0; i < kPresses; ++i) {
        press(client, server, i % kBetweenRests == 0, times);
        // The bridge takes 60 frames per second.
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + 7 * i % 31));
    }
    tell("input message to key bit, median", quantile(times.toKey, 0.5), "ms", Goal{atMost(0.3)});
    tell("input message to key bit, 99 %", quantile(times.toKey, 0.99), "ms", Goal{atMost(2)});
    tell("input message to whole frame at a client, median", quantile(times.toFrame, 0.5), "ms");
    tell("last movement to exact image, median", quantile(times.toStill, 0.5), "ms", Goal{atMost(250)});
    measureRest(client, bridge);
}

void measureBrowser(const PixelBytes& pixels) {
    fmt::print("=== a page in Chromium, on the same cores\n");
    constexpr const char *kDrawn = "key to drawn canvas beyond the frame, median",
                         *kFirst = "start of the page to first picture";
    if (!chromiumProgram()) {
        tellMissing(kDrawn, "there is no Chromium");
        return tellMissing(kFirst, "there is no Chromium");
    }
    const IpcInstance instance;
    const InstantServer server(instance.name(), pixels, 0);
    const Bridge bridge(instance);
    Chromium browser;
    const auto open = [&](const WebPage& page) {
        page.open("about:blank");
        const auto start = Clock::now();
        page.open(bridge.link());
        if (!page.becomes("document.getElementById('waiting')?.hidden"))
            throw std::runtime_error("the page shows no picture");
        return kMs * secondsFrom(start);
    };
    const WebPage driver(browser, "about:blank"), another(browser, "about:blank");
    open(driver); // the first page drives
    pressKeys(driver);
    const double delay = shown(driver, Shown::Delay), decoding = shown(driver, Shown::Decoding);
    driver.close(); // it asks before it is left while it has the keys
    if (delay > 0) tell(kDrawn, delay, "ms", Goal{atMost(10), atMost(15)});
    if (delay > 0) tell("of it, from a frame's arrival to drawn canvas, median", decoding, "ms");
    if (delay <= 0) tellMissing(kDrawn, "the page tells no figure");
    std::vector<double> firsts;
    for (int i = 0; i < 5; ++i) firsts.push_back(open(another));
    tell(kFirst, quantile(firsts, 0.5), "ms", Goal{atMost(400)});
}

} // namespace bridgebench
