// Looks of the page that can be computed: contrast, sizes of targets, names of controls, and that the browser
// has nothing to complain about; in each theme, on a desk and on a phone.
#include "web/bridged_server.h"

#include <ostream>

namespace {

using test::Json;
using test::WebPage;

constexpr const char* kPanels[] = {"views", "lights", "sky", "model", "settings", "people", "page"};

// Texts whose contrast to what is behind them is below 4.5. Over the image, which may be black or white, both
// count.
constexpr const char* kPoorContrast = R"((() => {
    const channels = (text) => text.match(/[\d.]+/g).map(Number);
    const linear = (value) => (value /= 255) <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
    const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
    const over = ([r, g, b, a = 1], back) => [r, g, b].map((value, i) => value * a + back[i] * (1 - a));
    const layers = (element) => {
        const found = [];
        for (let at = element; at; at = at.parentElement) {
            if (at.id === "stage") return [found, [[0, 0, 0], [255, 255, 255]]];
            const colour = channels(getComputedStyle(at).backgroundColor);
            if (colour[3] === 0) continue;
            found.unshift(colour);
            if ((colour[3] ?? 1) === 1) return [found, [[0, 0, 0]]];
        }
        return [found, [[255, 255, 255]]];
    };
    const poor = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const element = node.parentElement, style = getComputedStyle(element);
        const dead = element.closest(":disabled, .quiet, #waiting, option") || element.closest("noscript");
        if (!node.textContent.trim() || !element.checkVisibility() || dead) continue;
        const [above, backs] = layers(element);
        for (const back of backs) {
            const behind = above.reduce((under, layer) => over(layer, under), back);
            const a = luminance(over(channels(style.color), behind)), b = luminance(behind);
            const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
            if (ratio < 4.5) poor.push(node.textContent.trim() + ": " + ratio.toFixed(2));
        }
    }
    return [...new Set(poor)].join("\n");
})())";

// Controls that are too small to be hit by a thumb; a switch counts with its margin.
constexpr const char* kSmallTargets =
    R"((() => [...document.querySelectorAll("button, select, input, summary, .file")]
    .filter((element) => element.checkVisibility() && element.type !== "file")
    .map((element) => [element, element.getBoundingClientRect(), getComputedStyle(element)])
    .filter(([element, box, style]) => box.width < 43.5 || box.height + parseFloat(style.marginTop) + parseFloat(style.marginBottom) < 43.5)
    .map(([element, box]) => `${element.outerHTML.slice(0, 90)}: ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`).join("\n"))())";

constexpr const char* kTooWide =
    R"([...document.querySelectorAll("#drawer *")].filter((element) => element.checkVisibility() &&
    element.getBoundingClientRect().right > innerWidth + 0.5).map((element) => element.outerHTML.slice(0, 90)).join("\n"))";

struct Setting {
    const char* name;
    const char* theme;
    int width, height;
    bool phone;
    friend std::ostream& operator<<(std::ostream& out, const Setting& one) { return out << one.name; }
};

class Look : public test::BridgedServer, public testing::WithParamInterface<Setting> {
  protected:
    /// Roles and descriptions of controls that have no name.
    static std::string nameless(const WebPage& page) {
        std::string all;
        for (const Json& node : page.call("Accessibility.getFullAXTree")["nodes"]) {
            const std::string role = node.value("role", Json::object()).value("value", "");
            const bool control = role == "button" || role == "checkbox" || role == "combobox" ||
                                 role == "slider" || role == "spinbutton" || role == "textbox" ||
                                 role == "searchbox" || role == "tab" || role == "tabpanel" ||
                                 role == "application";
            if (control && !node.value("ignored", false) &&
                node.value("name", Json::object()).value("value", "").empty())
                all += node.dump() + "\n";
        }
        return all;
    }
    static void check(const WebPage& page) {
        EXPECT_EQ(page.value(kPoorContrast), "");
        EXPECT_EQ(page.value(kSmallTargets), "");
        EXPECT_EQ(page.value(kTooWide), "");
        EXPECT_EQ(nameless(page), "");
    }
};

TEST_P(Look, IsReadableAndNamed) {
    const Setting& setting = GetParam();
    startServer();
    startBridge();
    startBrowser();
    const WebPage page(browser(), "about:blank", {{"prefers-color-scheme", setting.theme}});
    page.call("Accessibility.enable");
    page.call("Emulation.setDeviceMetricsOverride", {{"width", setting.width},
                                                     {"height", setting.height},
                                                     {"deviceScaleFactor", 1},
                                                     {"mobile", setting.phone}});
    page.open(driverLink());
    ASSERT_TRUE(showsFrame(page));
    check(page);
    page.value("document.getElementById('menu').click()");
    for (const char* const panel : kPanels) {
        SCOPED_TRACE(panel);
        page.value("document.getElementById('tab-" + std::string(panel) + "').click()");
        page.value("document.querySelectorAll('#panels details').forEach((one) => one.open = true)");
        page.value("document.querySelector('#panel-lights .name')?.click()");
        browser().listen(std::chrono::milliseconds(300));
        check(page);
    }
    EXPECT_EQ(testing::PrintToString(page.complaints()), "{}");
}

INSTANTIATE_TEST_SUITE_P(EachScreen, Look,
                         testing::Values(Setting{"DarkDesk", "dark", 1280, 800, false},
                                         Setting{"Portrait", "light", 390, 844, true},
                                         Setting{"SmallPortrait", "dark", 320, 568, true},
                                         Setting{"SmallLandscape", "light", 568, 320, true}),
                         [](const auto& about) { return about.param.name; });
INSTANTIATE_TEST_SUITE_P(THOROUGH_EachScreen, Look,
                         testing::Values(Setting{"LightDesk", "light", 1280, 800, false},
                                         Setting{"Landscape", "dark", 844, 390, true}),
                         [](const auto& about) { return about.param.name; });

} // namespace
