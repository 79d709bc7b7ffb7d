// Walking in the page moves the eye of the server; whatever takes the keyboard away lets go of the keys.
#include "web/bridged_server.h"

#include "rtcore/math/vec.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using namespace std::chrono_literals;
using test::WebPage;

class PageInput : public test::BridgedServer {
  protected:
    rtcore::Vec3 eye() {
        client().update();
        const ipc::Status now = client().status();
        return {now.eye[0], now.eye[1], now.eye[2]};
    }
    /// How far the eye is from `from` along the view.
    float walked(const rtcore::Vec3& from) {
        const ipc::Status now = client().status();
        return dot(eye() - from, {now.forward[0], now.forward[1], now.forward[2]});
    }
    /// Flying never ends by itself while a key is down: there is nothing to run into.
    bool comesToRest() {
        return test::eventually(
            [&] {
                client().update();
                return client().status().idle == 1;
            },
            20s);
    }
    bool turnsFrom(const rtcore::Vec3& before) {
        return test::eventually([&] { return length(forward() - before) > 0.01F; }, 20s);
    }
    rtcore::Vec3 forward() {
        client().update();
        const ipc::Status now = client().status();
        return {now.forward[0], now.forward[1], now.forward[2]};
    }
    /// "touchStart", "touchMove" with one finger; "touchEnd" with none.
    static void touch(const WebPage& page, const char* type, test::Json points = test::Json::array()) {
        page.call("Input.dispatchTouchEvent", {{"type", type}, {"touchPoints", std::move(points)}});
    }
    /// W is down, and the eye moves.
    void walk(const WebPage& page) {
        ask("fly");
        capture(page);
        const rtcore::Vec3 start = eye();
        page.keyDown("KeyW");
        ASSERT_TRUE(test::eventually([&] { return walked(start) > 0.1F; }, 20s));
    }
};

TEST_F(PageInput, WalksAlongTheViewAndStops) {
    const WebPage page = drive();
    const std::string before = page.pixels();
    walk(page);
    EXPECT_TRUE(test::eventually([&] { return page.pixels() != before; }, 20s));
    page.keyUp("KeyW");
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, TurnsByMouseMovement) {
    const WebPage page = drive();
    capture(page);
    const float before = client().status().forward[0];
    for (int x = 100; x < 200; x += 10)
        page.call("Input.dispatchMouseEvent",
                  {{"type", "mouseMoved"}, {"x", x}, {"y", 300}, {"buttons", 1}, {"button", "left"}});
    EXPECT_TRUE(test::eventually(
        [&] {
            client().update();
            return client().status().forward[0] != before;
        },
        20s));
}

TEST_F(PageInput, AClickLocksTheMouseAndEscapeFreesIt) {
    const WebPage page = drive();
    ask("fly");
    page.click(300, 300);
    ASSERT_TRUE(page.becomes("document.pointerLockElement === document.getElementById('view')"));
    const rtcore::Vec3 before = forward(), start = eye();
    // No button is down: the mouse itself looks around.
    for (int x = 300; x < 400; x += 10)
        page.call("Input.dispatchMouseEvent", {{"type", "mouseMoved"}, {"x", x}, {"y", 300}});
    EXPECT_TRUE(turnsFrom(before));
    page.keyDown("KeyW");
    EXPECT_TRUE(test::eventually([&] { return walked(start) > 0.1F; }, 20s));
    page.keyDown("Escape");
    EXPECT_TRUE(page.becomes("document.pointerLockElement === null"));
    EXPECT_TRUE(comesToRest());
}

// A drag without capture turns it about what is under the pointer, two fingers bring it nearer.
TEST_F(PageInput, TheModelIsTurnedInTheHand) {
    const WebPage page = drive();
    ask("fly");
    if (page.value("document.getElementById('orbit').getAttribute('aria-pressed')") != "true")
        page.value("document.getElementById('orbit').click()");
    ASSERT_TRUE(comesToRest());
    const rtcore::Vec3 start = eye(), before = forward();
    const auto mouse = [&](const char* type, int x, int buttons) {
        page.call("Input.dispatchMouseEvent",
                  {{"type", type}, {"x", x}, {"y", 300}, {"buttons", buttons}, {"button", "left"}});
    };
    mouse("mousePressed", 300, 1);
    for (int x = 310; x <= 400; x += 10) mouse("mouseMoved", x, 1);
    mouse("mouseReleased", 400, 0);
    EXPECT_TRUE(turnsFrom(before));
    EXPECT_GT(length(eye() - start), 0.01F) << "the eye goes around it";
    EXPECT_EQ(page.value("document.pointerLockElement"), nullptr);
    EXPECT_TRUE(comesToRest());

    page.call("Emulation.setTouchEmulationEnabled", {{"enabled", true}, {"maxTouchPoints", 2}});
    const rtcore::Vec3 turned = forward();
    touch(page, "touchStart", {{{"x", 300}, {"y", 300}}});
    touch(page, "touchMove", {{{"x", 240}, {"y", 300}}});
    EXPECT_TRUE(turnsFrom(turned));
    touch(page, "touchEnd");
    EXPECT_TRUE(comesToRest());
    const rtcore::Vec3 far = eye();
    touch(page, "touchStart", {{{"x", 300}, {"y", 300}, {"id", 1}}, {{"x", 340}, {"y", 300}, {"id", 2}}});
    touch(page, "touchMove", {{{"x", 270}, {"y", 300}, {"id", 1}}, {{"x", 370}, {"y", 300}, {"id", 2}}});
    EXPECT_TRUE(test::eventually([&] { return walked(far) > 0.05F; }, 20s)) << "nearer";
    touch(page, "touchEnd");
    EXPECT_TRUE(comesToRest());
}

// Knows which requests of the page have no answer yet.
constexpr const char* kWatchRequests = R"(
window.underWay = new Set();
window.Worker = class extends Worker {
    constructor(...words) {
        super(...words);
        this.addEventListener("message", ({ data }) => {
            const said = data.said ? JSON.parse(data.said) : {};
            if (said.event === "answer") underWay.delete(said.id);
        });
    }
    postMessage(message, ...rest) {
        const [method, text] = message;
        if (method === "send" && typeof text === "string") underWay.add(JSON.parse(text).id);
        super.postMessage(message, ...rest);
    }
};)";

// RT_DRAGS: how many (check-long.sh: 1,000).
TEST_F(PageInput, HomeShowsTheModelAfterAnyTouches) {
    const char* const wanted = std::getenv("RT_DRAGS");
    const int count = wanted != nullptr ? std::atoi(wanted) : 10, atOnce = 5;
    startServer();
    startBridge();
    startBrowser();
    const WebPage page(browser(), "about:blank");
    page.call("Page.addScriptToEvaluateOnNewDocument", {{"source", kWatchRequests}});
    page.open(driverLink());
    ASSERT_TRUE(showsFrame(page));
    ask("fly");
    // Idle is the server also while a request is still on its way to it.
    const auto settles = [&] {
        ASSERT_TRUE(page.becomes("underWay.size === 0"));
        ask("wait-idle");
    };
    page.value("document.querySelector('#orbit[aria-pressed=\"false\"]')?.click()");
    page.call("Emulation.setTouchEmulationEnabled", {{"enabled", true}, {"maxTouchPoints", 2}});
    ASSERT_TRUE(page.becomes("!document.getElementById('fit').hidden"));
    bool byKey = false;
    const auto fit = [&] {
        page.value(byKey ? "document.getElementById('view').focus()"
                         : "document.getElementById('fit').click()");
        if (byKey) {
            page.keyDown("Home");
            page.keyUp("Home");
        }
        byKey = !byKey;
        ASSERT_NO_FATAL_FAILURE(settles());
    };
    // Where the ways of two views of the whole meet is its middle.
    ask("camera view front");
    ASSERT_NO_FATAL_FAILURE(fit());
    const rtcore::Vec3 front = eye(), ahead = forward();
    ask("camera view right");
    ASSERT_NO_FATAL_FAILURE(fit());
    const rtcore::Vec3 middle = front + ahead * dot(eye() - front, ahead);
    ask("camera view three-quarter");
    ASSERT_NO_FATAL_FAILURE(fit());
    const rtcore::Vec3 fitted = eye();
    const float far = length(fitted - middle);
    std::mt19937 random(5);
    const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    float furthest = 0;
    for (int i = 1; i <= count; ++i) {
        const int fingers = number(1, 2);
        test::Json down = test::Json::array(), moved = test::Json::array();
        for (int id = 0; id < fingers; ++id) {
            const int x = number(100, 600), y = number(100, 500);
            down.push_back({{"x", x}, {"y", y}, {"id", id}});
            moved.push_back({{"x", x + number(-90, 90)}, {"y", y + number(-90, 90)}, {"id", id}});
        }
        touch(page, "touchStart", down);
        touch(page, "touchMove", moved);
        touch(page, "touchEnd");
        if (i % atOnce != 0) continue;
        ASSERT_NO_FATAL_FAILURE(settles());
        furthest = std::max(furthest, length(eye() - fitted) / far);
        ASSERT_NO_FATAL_FAILURE(fit());
        EXPECT_TRUE(test::eventually(
            [&] {
                const rtcore::Vec3 way = middle - eye();
                return dot(normalize(way), normalize(forward())) > 0.95F &&
                       std::fabs(length(way) / far - 1) < 0.6F; // it depends on the direction
            },
            20s))
            << i << ": " << length(eye() - middle) / far;
        // From beside the model the page shows it as the server fits it, to the width of a line.
        ask("camera fit");
        ask("wait-idle");
        const rtcore::Vec3 whole = eye();
        ask("camera pan 3 2");
        ask("wait-idle");
        ASSERT_GT(length(eye() - whole), far);
        ASSERT_NO_FATAL_FAILURE(fit());
        EXPECT_TRUE(test::eventually([&] { return length(eye() - whole) < 0.005F * far; }, 20s))
            << i << ": " << length(eye() - whole) / far;
    }
    EXPECT_GT(furthest, 0.1F) << "the touches moved it";
}

// Held upright, a phone that drives gets images of its shape; put down again, it gives the old one back.
TEST_F(PageInput, APhoneThatIsHeldUprightIsFilled) {
    const WebPage page = drive();
    ask("fly");
    ASSERT_TRUE(comesToRest());
    const ipc::Status before = client().status();
    const auto hold = [&](int width, int height) {
        page.call("Emulation.setTouchEmulationEnabled", {{"enabled", true}, {"maxTouchPoints", 2}});
        page.call("Emulation.setDeviceMetricsOverride",
                  {{"width", width}, {"height", height}, {"deviceScaleFactor", 2}, {"mobile", true}});
    };
    const auto becomes = [&](double aspect) {
        return test::eventually(
            [&] {
                client().update();
                const ipc::Status now = client().status();
                return std::abs(static_cast<double>(now.width) / now.height - aspect) < 0.02;
            },
            20s);
    };
    hold(390, 844);
    EXPECT_TRUE(becomes(390.0 / 844));
    EXPECT_EQ(page.value("getComputedStyle(document.getElementById('view')).objectFit"), "cover");
    hold(844, 390);
    EXPECT_TRUE(becomes(static_cast<double>(before.width) / before.height));
}

TEST_F(PageInput, OneThumbWalksAndTheOtherTurns) {
    const WebPage page = drive();
    ask("fly");
    page.call("Emulation.setTouchEmulationEnabled", {{"enabled", true}, {"maxTouchPoints", 2}});
    const rtcore::Vec3 start = eye(), before = forward();
    touch(page, "touchStart", {{{"x", 150}, {"y", 400}}});
    touch(page, "touchMove", {{{"x", 150}, {"y", 340}}});
    EXPECT_TRUE(test::eventually([&] { return walked(start) > 0.1F; }, 20s)) << "forward";
    touch(page, "touchEnd");
    EXPECT_TRUE(comesToRest());
    const double right = page.value("innerWidth - 150").get<double>();
    touch(page, "touchStart", {{{"x", right}, {"y", 300}}});
    touch(page, "touchMove", {{{"x", right - 60}, {"y", 300}}});
    EXPECT_TRUE(turnsFrom(before));
    touch(page, "touchEnd");
    EXPECT_TRUE(comesToRest());
}

// A browser without a hand has no gamepad: what the page asks for tells of one.
TEST_F(PageInput, AGamepadWalksAndTurns) {
    const WebPage page = drive();
    ask("fly");
    page.value("(globalThis.pad = { connected: true, mapping: 'standard', axes: [0, -1, 0, 0],"
               " buttons: Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })) },"
               " navigator.getGamepads = () => [pad], dispatchEvent(new Event('gamepadconnected')))");
    const rtcore::Vec3 start = eye(), before = forward();
    EXPECT_TRUE(test::eventually([&] { return walked(start) > 0.1F; }, 20s)) << "forward";
    page.value("pad.axes = [0, 0, 1, 0]");
    EXPECT_TRUE(turnsFrom(before));
    page.value("pad.axes = [0, 0, 0, 0]");
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, ReleasesKeysWhenTheWindowLosesTheFocus) {
    const WebPage page = drive();
    walk(page);
    page.value("dispatchEvent(new Event('blur'))");
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, ReleasesKeysWhenTheTabIsHidden) {
    WebPage page = drive();
    walk(page);
    page.hide();
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, THOROUGH_ReleasesKeysWhenTheFocusGoesToAnotherElement) {
    const WebPage page = drive();
    walk(page);
    page.value("document.getElementById('menu').focus()");
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, THOROUGH_ReleasesKeysWhenTheBrowserIsKilled) {
    const WebPage page = drive();
    walk(page);
    browser().kill();
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, THOROUGH_ReleasesKeysWhenTheBridgeIsKilled) {
    const WebPage page = drive();
    walk(page);
    bridge().send(SIGKILL);
    EXPECT_TRUE(comesToRest());
}

// The page is alive, but its scripts stand still, as in a debugger.
TEST_F(PageInput, THOROUGH_ReleasesKeysWhenThePageIsFrozen) {
    const WebPage page = drive();
    walk(page);
    page.call("Debugger.enable");
    page.call("Debugger.pause");
    EXPECT_TRUE(comesToRest());
}

TEST_F(PageInput, THOROUGH_IgnoresKeysThatComeWithoutCapture) {
    const WebPage page = drive();
    ask("fly");
    ASSERT_TRUE(comesToRest());
    const rtcore::Vec3 start = eye();
    page.value("document.getElementById('view').focus()");
    page.keyDown("KeyW");
    // A later key that is taken shows that the first one had its chance.
    capture(page);
    page.keyDown("KeyE");
    page.keyUp("KeyE");
    EXPECT_TRUE(comesToRest());
    EXPECT_EQ(eye(), start);
}

TEST_F(PageInput, AViewerMovesNothing) {
    startServer();
    startBridge();
    startBrowser();
    const WebPage page(browser(), viewerLink());
    ASSERT_TRUE(showsFrame(page));
    ASSERT_TRUE(comesToRest());
    const rtcore::Vec3 start = eye();
    page.value("document.getElementById('view').focus()");
    page.keyDown("Enter");
    page.keyUp("Enter");
    page.keyDown("KeyW");
    EXPECT_TRUE(page.becomes("document.getElementById('notices').textContent !== ''"))
        << "it should say who drives";
    EXPECT_EQ(eye(), start);
}

} // namespace
