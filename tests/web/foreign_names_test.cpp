// Names of others in the page - of files, parts, materials, lights, maps, bookmarks and people - stay texts:
// nothing of them runs, loads, turns the direction of what stands around it or moves it out of its place.
#include "web/bridged_server.h"

#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <array>

namespace {

using test::Json;
using test::WebPage;

const std::array<std::string, 7> kNames{
    "<img src=x onerror=owned=1>", "<svg/onload=owned=1>", "\"><script>owned=1</script>", "&amp;&lt;b&gt;",
    "one\u202eowt\u2066\u061c",    "two\nlines\u2028",     std::string(300, 'W')};

/// As a string of TOML.
std::string quoted(const std::string& text) { return Json(text).dump(); }
/// As a part of a model, whose name ends with the word.
std::string inModel(const std::string& text) { return text.substr(0, text.find_first_of(" \n")); }

// Elements that cannot be scrolled to and reach beyond the page, or beyond the image that they are over.
constexpr const char* kOutside =
    R"([...document.querySelectorAll("body *")].filter((element) => element.checkVisibility() && !element.closest(".quiet"))
    .map((element) => [element, element.getBoundingClientRect()])
    .filter(([element, box]) => box.right > innerWidth + 0.5 || box.left < -0.5 ||
        (element.closest("#stage") && (box.bottom > document.getElementById("stage").clientHeight + 0.5 || box.top < -0.5)))
    .map(([element]) => element.outerHTML.slice(0, 90)).join("\n"))";

// Marks of direction and controls in all that is shown or said, and what is laid out from right to left.
constexpr const char* kTurned =
    R"((() => [document.title, ...[...document.querySelectorAll("*")].flatMap((element) => [...element.attributes].map(({ value }) => value)
        .concat(element.children.length ? [] : element.textContent, getComputedStyle(element).direction === "ltr" ? [] : "turned: " + element.outerHTML.slice(0, 90)))]
    .filter((text) => text.startsWith("turned: ") || /[\p{Bidi_Control}\u2028\u2029\0-\x08\x0b-\x1f\x7f-\x9f]/u.test(text)).join("\n"))())";

class ForeignNames : public test::BridgedServer {
  protected:
    void writeScene(const std::string& name) {
        std::string model = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\n", scene;
        int number = 0;
        for (const std::string& each : kNames) {
            const std::string line = inModel(each), z = std::to_string(++number);
            model += "o " + line + "\nusemtl " + line + "\nf 1 2 3\n";
            scene += "[[light]]\nname = " + quoted(each) + "\nkind = \"point\"\nposition = [0, 4, " + z +
                     "]\nintensity = [9, 9, 9]\n[[bookmark]]\nname = " + quoted(each) + "\neye = [0, 2, " +
                     z + "]\nlookAt = [0, 0, -9]\n[[material]]\nname = " + quoted("no " + each) +
                     "\nroughness = 0.5\n[[environment]]\nname = " + quoted(each) +
                     "\nequirectangular = \"sky.ppm\"\n";
        }
        test::writeText(folder() / "m.obj", model);
        test::writeText(folder() / "sky.ppm", "P3 2 1 255 10 20 30 200 210 220\n");
        test::writeText(folder() / name,
                        "version = 2\nmodel = \"m.obj\"\n[camera]\neye = [0, 3, 6]\nlookAt = [0, 0, 0]\n" +
                            scene);
    }
    WebPage openPage(const std::string& link, int width, int height) {
        WebPage page(browser(), "about:blank");
        page.call("Page.setBypassCSP", {{"enabled", true}}); // the policy would hide what runs
        page.call(
            "Emulation.setDeviceMetricsOverride",
            {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < height}});
        page.open(link);
        EXPECT_TRUE(showsFrame(page));
        return page;
    }
    /// All that can be said of a page at any time.
    static void check(const WebPage& page) {
        EXPECT_EQ(page.value("window.owned === undefined"), true);
        EXPECT_EQ(page.value("[...document.querySelectorAll('script, img, iframe, object')].filter((one) => "
                             "!one.src.endsWith('/js/main.js')).length"),
                  0);
        EXPECT_EQ(page.value(kTurned), "");
        EXPECT_EQ(page.value(kOutside), "");
    }
    /// Gathers the texts of notices from now on in `told`, and elements that do not fit in `wide`.
    static void watchNotices(const WebPage& page) {
        page.value(
            "(() => { window.told = window.wide = ''; const place = document.getElementById('notices');"
            "new MutationObserver(() => { told += place.textContent; wide += " +
            std::string(kOutside) + "; }).observe(place, { childList: true }); })()");
    }
    static void calls(const WebPage& page, const std::string& name) {
        page.value("document.getElementById('tab-people').click()");
        page.value("(() => { const box = document.querySelector('#panel-people input'); box.value = " +
                   Json(name).dump() + "; box.dispatchEvent(new Event('change')); })()");
    }
    static std::string texts(const std::string& selector) {
        return "[...document.querySelectorAll('" + selector + "')].map(({ textContent }) => textContent)";
    }
    /// Panels are filled as their answers come.
    static testing::AssertionResult shows(const WebPage& page, const std::string& selector, const Json& all) {
        if (page.becomes("JSON.stringify(" + texts(selector) + ") === " + Json(all.dump()).dump()))
            return testing::AssertionSuccess();
        return testing::AssertionFailure() << page.value(texts(selector)) << " for " << all;
    }
};

TEST_F(ForeignNames, StayTexts) {
    const std::string name = kNames[0] + kNames[3] + kNames[4] + kNames[5] + ".scn";
    writeScene(name);
    startServer();
    startBridge();
    startBrowser();
    const WebPage desk = openPage(driverLink(), 1280, 800), phone = openPage(driverLink(), 390, 844);
    for (const WebPage* page : {&desk, &phone}) watchNotices(*page);
    ask("load scene \"" + (folder() / name).string() + "\"");
    std::vector<std::string> shown;
    for (const std::string& each : kNames) shown.push_back(rtcore::printable(each));
    for (const WebPage* page : {&desk, &phone}) {
        page->value("document.getElementById('menu').click()");
        ASSERT_TRUE(page->becomes("document.getElementById('scene').textContent === " +
                                  Json(rtcore::printable(name)).dump()));
        EXPECT_TRUE(
            page->becomes("document.title === " + Json(rtcore::printable(name) + " – ray tracing").dump()));
        EXPECT_TRUE(page->becomes("told.includes('no <img src=x') && told.includes('WWW')")) << "warnings";
        EXPECT_EQ(page->value("wide"), "");
        for (const char* const panel : {"views", "lights", "sky", "model", "people"}) {
            SCOPED_TRACE(panel);
            page->value("document.getElementById('tab-" + std::string(panel) + "').click()");
            if (panel == std::string("model")) {
                ASSERT_TRUE(page->becomes("document.querySelectorAll('#panel-model .list li').length >= 14"));
            }
            check(*page);
        }
        EXPECT_TRUE(shows(*page, "#panel-lights .name", shown));
        const Json model = page->value(texts("#panel-model .list .name"));
        for (const std::string& each : kNames) {
            const std::string line = rtcore::printable(inModel(each));
            EXPECT_EQ(std::count(model.begin(), model.end(), Json(line)), 2) << line << " in " << model;
        }
        EXPECT_TRUE(shows(*page, "#bookmarked .name", shown));
        EXPECT_TRUE(page->becomes(texts("#panel-sky .row:first-of-type option") +
                                  ".length === " + std::to_string(shown.size() + 2)))
            << "none, and the computed sky";
    }
    // People, by what they tell of themselves.
    for (const std::string& each : {kNames[0], kNames[4], kNames[6]}) {
        SCOPED_TRACE(each.substr(0, 40));
        const std::string called = rtcore::withoutControls(each, 40);
        for (const WebPage* page : {&desk, &phone}) calls(*page, each);
        for (const WebPage* page : {&desk, &phone})
            EXPECT_TRUE(shows(*page, "#panel-people .name", {called, called}));
        ASSERT_TRUE(phone.becomes("document.getElementById('pill-text').textContent.includes(" +
                                  Json(called).dump() + ")"));
        phone.value("document.querySelector('#panel-people .actions button').click()");
        ASSERT_TRUE(phone.becomes("document.getElementById('notices').textContent.includes('Waiting')"));
        ASSERT_TRUE(desk.becomes("document.getElementById('notices').textContent.includes(" +
                                 Json(called).dump() + ")"));
        for (const WebPage* page : {&desk, &phone}) check(*page);
        desk.value("[...document.querySelectorAll('#notices button')].at(-1).click()");
        ASSERT_TRUE(phone.becomes("document.getElementById('notices').textContent.includes('not handed')"));
    }
    for (const WebPage* page : {&desk, &phone}) EXPECT_EQ(testing::PrintToString(page->complaints()), "{}");
}

} // namespace
