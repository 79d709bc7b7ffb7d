// Modules of the page that know no document: tables of keys, links, sticks, texts.
#include "web/web_page.h"

#include "bridge/stream/motion_encoder.h"

#include "rtcore/motion/key_codes.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace {

using test::Json;
using test::WebPage;

/// A page of files: the modules as they are, and those that the build makes.
class PageModules : public testing::Test {
  protected:
    void SetUp() override {
        if (!test::chromiumProgram()) GTEST_SKIP() << "there is no Chromium";
        namespace fs = std::filesystem;
        for (const char* const from : {RT_PAGE_MODULES, RT_PAGE_MADE, RT_PAGE_PARTS})
            for (const fs::directory_entry& file : fs::directory_iterator(from))
                fs::copy_file(file.path(), folder_.path() / file.path().filename(),
                              fs::copy_options::skip_existing);
        std::ofstream(folder_ / "page.html") << "<!doctype html>";
        page_.emplace(test::sharedChromium({"--allow-file-access-from-files"}),
                      "file://" + (folder_ / "page.html").string());
        ASSERT_TRUE(page_->becomes("location.protocol === 'file:' && document.readyState === 'complete'"));
    }
    /// An expression that has the module as `m`.
    Json with(const std::string& module, const std::string& expression) const {
        return page_->value("import('./" + module + "').then((m) => " + expression + ")");
    }
    std::filesystem::path folder() const { return folder_.path(); }

  private:
    test::TemporaryFolder folder_;
    std::optional<WebPage> page_;
};

TEST_F(PageModules, KeysHaveTheNumbersOfTheServer) {
    const auto code = [&](const std::string& place) {
        return with("key_table.js", "m.keyCode('" + place + "', false)").get<int>();
    };
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        if (letter == 'Q' || letter == 'E' || letter == 'X') continue; // the page's own
        EXPECT_EQ(code(std::string("Key") + letter), letter);
    }
    for (char digit = '0'; digit <= '9'; ++digit) EXPECT_EQ(code(std::string("Digit") + digit), digit);
    const std::pair<const char*, int> named[] = {
        {"ArrowLeft", rtcore::KeyLeft},      {"ArrowRight", rtcore::KeyRight},
        {"ArrowUp", rtcore::KeyUp},          {"ArrowDown", rtcore::KeyDown},
        {"ShiftLeft", rtcore::KeyShift},     {"ShiftRight", rtcore::KeyShift},
        {"Space", rtcore::KeySpace},         {"Enter", rtcore::KeyReturn},
        {"PageUp", rtcore::KeyPageUp},       {"PageDown", rtcore::KeyPageDown},
        {"Home", rtcore::KeyHome},           {"End", rtcore::KeyEnd},
        {"Insert", rtcore::KeyInsert},       {"Delete", rtcore::KeyDelete},
        {"Backspace", rtcore::KeyBackspace}, {"KeyX", rtcore::KeyControl}};
    for (const auto& [place, number] : named) EXPECT_EQ(code(place), number) << place;
    for (const char* const place : {"KeyQ", "KeyE", "F5", "F12", "Tab", "MetaLeft", "ControlLeft", ""})
        EXPECT_EQ(code(place), 0) << place;
    EXPECT_EQ(with("key_table.js", "m.keyCode('ControlLeft', true)"), rtcore::KeyControl)
        << "where it is the page's";
}

TEST_F(PageModules, LinksAndBookmarksAreChecked) {
    const auto read = [&](const std::string& hash) {
        return with("fragment.js", "m.readFragment('" + hash + "')");
    };
    const std::string token(43, 'k');
    EXPECT_EQ(read("#t=" + token)["token"], token);
    EXPECT_TRUE(read("#t=short")["token"].is_null());
    EXPECT_TRUE(read("")["token"].is_null());
    EXPECT_EQ(read("#v=1,2,3,0,0,-1,60")["view"], (Json{1, 2, 3, 0, 0, -1, 60}));
    EXPECT_EQ(read("#v=1,2,3,0,0,-1")["view"], (Json{1, 2, 3, 0, 0, -1}));
    for (const char* const bad : {"#v=1,2,3", "#v=1,2,3,0,0,0,60", "#v=1,2,3,0,0,-1,180", "#v=a,2,3,0,0,-1",
                                  "#v=1,,3,0,0,-1", "#v=1,2,1e999,0,0,-1"})
        EXPECT_TRUE(read(bad)["view"].is_null()) << bad;
    EXPECT_EQ(with("fragment.js", "m.readFragment(m.viewText([0.1234567894, -2, 1e-7, 0, 0, -1, 60])).view"),
              (Json{0.123456789, -2, 1e-7, 0, 0, -1, 60}));

    const std::string good = "{name: 'a', view: [0,1,2,3,4,5,6,7,8,60], image: ''}";
    EXPECT_EQ(with("bookmarks.js", "m.checked([" + good + "]).length"), 1);
    for (const char* const bad : {"null", "{}", "'text'", "[null]", "[{name: 1, view: []}]",
                                  "[{name: 'a', view: [1]}]", "[{name: 'a', view: Array(10).fill(NaN)}]"})
        EXPECT_EQ(with("bookmarks.js", "m.checked(" + std::string(bad) + ").length"), 0) << bad;
    EXPECT_EQ(
        with("bookmarks.js",
             "m.checked([{name: 'a', view: Array(10).fill(1), image: 'https://elsewhere/x.png'}])[0].image"),
        "");
}

// Sticks of thumbs and of gamepads.
TEST_F(PageModules, SticksHoldKeys) {
    EXPECT_EQ(with("touch.js", "m.stickKeys(0, -0.2)"), Json::array());
    EXPECT_EQ(with("touch.js", "m.stickKeys(0, -1)"), Json{'W'});
    EXPECT_EQ(with("touch.js", "m.stickKeys(1, 0)"), Json{'D'});
    EXPECT_EQ(with("touch.js", "m.stickKeys(-0.7, 0.7)"), (Json{'S', 'A'}));
    EXPECT_EQ(with("touch.js", "m.stickKeys(0, -1.3)"), (Json{'W', static_cast<int>(rtcore::KeyShift)}));

    EXPECT_EQ(with("gamepad.js", "[...m.axisKeys(0, -0.4, new Set())]"), Json::array());
    EXPECT_EQ(with("gamepad.js", "[...m.axisKeys(0, -0.4, new Set([87]))]"), Json{'W'});
    EXPECT_EQ(with("gamepad.js", "[...m.axisKeys(0, -0.2, new Set([87]))]"), Json::array());
    EXPECT_EQ(with("gamepad.js", "m.turnRate(0.1)"), 0);
    EXPECT_EQ(with("gamepad.js", "m.turnRate(-1)"), -120);
}

// What hands do is told at once, also while a key that is held waits to be told again.
TEST_F(PageModules, AHeldKeyDelaysNothing) {
    const Json told = with("held.js", R"((async () => {
        let last = null;
        const held = new m.Held((message) => {
            const view = new DataView(message);
            last = [view.getInt32(8, true), view.getUint8(1), view.getUint8(2)];
            return true;
        });
        const told = [];
        for (const what of [() => held.hold("keys", [87]), () => held.turn(1, 0), () => held.hold("keys", [87, 65]),
            () => held.tap(32), () => held.hold("keys", [])]) {
            last = null;
            what();
            told.push(last);
            await new Promise((done) => setTimeout(done, 12));
        }
        return told;
    })())");
    EXPECT_EQ(told, (Json{{0, 1, 0}, {1000, 1, 0}, {0, 2, 0}, {0, 2, 1}, {0, 0, 0}})) << "turn, keys, taps";
}

// A frame in strips is decoded in parts, to what the browser makes of the whole.
TEST_F(PageModules, AJpegOfStripsIsDecodedInParts) {
    constexpr int kWidth = 1280, kHeight = 720;
    std::vector<std::byte> pixels(std::size_t(4) * kWidth * kHeight);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t x = i / 4 % kWidth, y = i / 4 / kWidth;
        pixels[i] = static_cast<std::byte>(i % 4 == 0 ? x / 5 : i % 4 == 1 ? y / 3 : (x + y) / 8);
    }
    const bridge::SharedFrame frame =
        bridge::MotionEncoder().encode({pixels, kWidth, kHeight}, bridge::kRungs[0], {});
    std::ofstream(folder() / "strips.txt") << Json(frame->bytes).dump();
    const Json told = with("decoder.js", R"((async () => {
        const bytes = new Uint8Array(await new Promise((done) => {
            const asked = new XMLHttpRequest();
            asked.onload = () => done(JSON.parse(asked.responseText));
            asked.open("GET", "strips.txt");
            asked.send();
        }));
        const { stripsOf } = await import("./jpeg_strips.js");
        const size = [1280, 720], context = new OffscreenCanvas(...size).getContext("2d", { willReadFrequently: true });
        const read = () => context.getImageData(0, 0, ...size).data;
        const whole = await createImageBitmap(new Blob([bytes], { type: "image/jpeg" }));
        context.drawImage(whole, 0, 0);
        const expected = read();
        context.clearRect(0, 0, ...size);
        (await m.decode(bytes, "image/jpeg")).drawOn(context, ...size);
        const most = read().reduce((most, value, i) => Math.max(most, Math.abs(value - expected[i])), 0);
        const cut = await m.decode(bytes.slice(0, 3000), "image/jpeg").then(() => "decoded", () => "refused");
        return { decoder: typeof ImageDecoder, tops: stripsOf(bytes).strips.map(({ top }) => top), most, cut,
            of: [bytes.slice(0, 3000), bytes.slice(0, 12), new Uint8Array(), new Uint8Array(40)].map(stripsOf) };
    })())");
    EXPECT_EQ(told["decoder"], "function");
    EXPECT_EQ(told["tops"], (Json{0, 400}));
    EXPECT_LE(told["most"], 8);
    EXPECT_EQ(told["cut"], "refused");
    EXPECT_EQ(told["of"], (Json{nullptr, nullptr, nullptr, nullptr}));
}

// Browsers without ImageDecoder, and pages that are not secure, decode otherwise, to the same.
TEST_F(PageModules, BothWaysOfDecodingKeepEachPixel) {
    const Json told = with("decoder.js", R"((async () => {
        const size = [61, 33], count = size[0] * size[1];
        const make = () => new OffscreenCanvas(...size).getContext("2d", { alpha: false, willReadFrequently: true });
        const drawn = new ImageData(...size), source = make();
        for (let i = 0; i < 4 * count; ++i) drawn.data[i] = i % 4 === 3 ? 255 : (i * 7919) >> 3;
        source.putImageData(drawn, 0, 0);
        const bytes = new Uint8Array(await (await source.canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
        const kinds = [], equal = [];
        const look = async ({ decode }) => {
            const picture = await decode(bytes, "image/png"), target = make();
            picture.drawOn(target, ...size);
            kinds.push(picture.constructor.name);
            equal.push(target.getImageData(0, 0, ...size).data.every((value, i) => value === drawn.data[i]));
            picture.drawOn(target, 30, 16); // smaller, too
            picture.close();
        };
        await look(m);
        await look(m); // in memory that was used before
        delete globalThis.ImageDecoder;
        await look(await import("./decoder.js?without"));
        return { kinds, equal };
    })())");
    EXPECT_EQ(told["kinds"], (Json{"Pixels", "Pixels", "Bitmap"}));
    EXPECT_EQ(told["equal"], (Json{true, true, true}));
}

TEST_F(PageModules, EachTextIsInBothLanguages) {
    const Json english = with("texts_en.js", "m.default"), czech = with("texts_cs.js", "m.default");
    for (const auto& [key, text] : english.items()) {
        ASSERT_TRUE(czech.contains(key)) << key;
        const auto places = [](const std::string& of) { return std::count(of.begin(), of.end(), '{'); };
        EXPECT_EQ(places(text), places(czech[key])) << key;
        EXPECT_NE(czech[key], "") << key;
    }
    EXPECT_EQ(english.size(), czech.size());
    EXPECT_EQ(with("tables_cs.js", "m.default.Settings.Shadows"), "Stíny");
}

TEST_F(PageModules, SettingsAreCalledAsInTheWindow) {
    EXPECT_EQ(with("setting_labels.js", "m.settingLabel('path.rouletteFrom')"), "Roulette from bounce");
    EXPECT_EQ(with("setting_labels.js", "m.settingLabel('exposure.brighterSeconds')"), "Brighter seconds");
    EXPECT_EQ(with("setting_labels.js", "m.editLabel('light power 2')"), "power of light 2");
}

} // namespace
