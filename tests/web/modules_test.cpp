// Modules of the page that know no document: tables of keys, links, sticks, texts.
#include "web/module_page.h"

#include "bridge/stream/motion_encoder.h"

#include "rtcore/motion/key_codes.h"

#include <filesystem>
#include <fstream>

namespace {

using test::Json;

class PageModules : public test::ModulePage {};

TEST_F(PageModules, KeysHaveTheNumbersOfTheServer) {
    const auto code = [&](const std::string& place) {
        return with("key_table.js", "m.keyCode('" + place + "', false)").get<int>();
    };
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
        if (std::string("QERVX").find(letter) != std::string::npos) continue; // the page's own
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
    for (const char* const place :
         {"KeyQ", "KeyE", "KeyR", "KeyV", "F5", "F12", "Tab", "MetaLeft", "ControlLeft", ""})
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
    EXPECT_EQ(with("bookmarks.js", "m.checked([{name: 'a\\u202ab\\u200f\\u0007\\u2066c', "
                                   "view: Array(10).fill(1)}])[0].name"),
              "abc");
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
        held.hold("keys", [87]);
        held.turn(2, 0);
        await new Promise((done) => setTimeout(done, 60));
        told.push(last);
        return told;
    })())");
    EXPECT_EQ(told, (Json{{0, 1, 0}, {1000, 1, 0}, {0, 2, 0}, {0, 2, 1}, {0, 0, 0}, {2000, 1, 0}}))
        << "turn, keys, taps; the last one came at once after another, and waits no longer than that asks "
           "for";
}

// Also after something else let all keys go.
TEST_F(PageModules, AGamepadLetsGoOfItsKeysWithTheWindow) {
    EXPECT_EQ(with("gamepad.js", R"((() => {
        const told = [];
        const held = { sources: new Map(), hold(source, keys) { this.sources.set(source, keys); told.push([...keys].join()); } };
        const pad = new m.Gamepad(held, () => true);
        pad.apply(new Set([87]));
        pad.apply(new Set([87]));
        dispatchEvent(new Event("blur"));
        pad.apply(new Set([87]));
        held.sources.clear();
        pad.apply(new Set([87]));
        return told.join("|");
    })())"),
              "87||87|87");
}

// What the keyboard holds, and what the wheel turns.
TEST_F(PageModules, CommandLetsGoOfKeysAndTheWheelHasSteps) {
    const Json told = with("input.js", R"((() => {
        const canvas = document.createElement("canvas");
        const keys = [], steps = [];
        const held = { hold: (_, codes) => keys.push(codes.join()), turn() {}, release() {} };
        const input = new m.Input(canvas, held, { captured() {}, wheel: (count) => steps.push(count) });
        input.down.add("KeyW").add("KeyA");
        input.tell();
        dispatchEvent(new KeyboardEvent("keyup", { code: "MetaLeft" }));
        for (const [deltaY, deltaMode] of [[40, 0], [40, 0], [40, 0], [80, 0], [-100, 0], [3, 1], [250, 0], [-99, 0]])
            canvas.dispatchEvent(new WheelEvent("wheel", { deltaY, deltaMode }));
        return { keys: keys.join("|"), steps: steps.join() };
    })())");
    EXPECT_EQ(told["keys"], "87,65|");
    EXPECT_EQ(told["steps"], "-1,-1,1,-1,-2");
}

// What hands do while an answer is on its way is told together, and in the order in which it makes sense.
TEST_F(PageModules, AModelInTheHandNeverFallsBehind) {
    const Json told = with("orbit.js", R"((async () => {
        const asked = [], waiting = [];
        const picture = { aspect: 2, box: () => ({ width: 360 }), at: (x, y) => (x < 0 ? null : { x: x / 360, y: y / 180 }) };
        const orbit = new m.Orbit(picture, { changed() {}, ask(what, keys) {
            asked.push([what, ...Object.values(keys)]);
            return new Promise((done) => waiting.push(done));
        } });
        const answer = async (ok = true) => { waiting.shift()({ ok }); await new Promise((done) => setTimeout(done)); };
        orbit.grasp(180, 45);
        orbit.turn(10, 0);
        for (let i = 0; i < 20; ++i) orbit.turn(1, 2);
        orbit.move(36, -18);
        orbit.approach(2);
        orbit.approach(2);
        for (let i = 0; i < 4; ++i) await answer();
        orbit.turn(1, 0);
        orbit.turn(9, 0);
        await answer(false); // nothing is heaped up for who may not drive
        orbit.grasp(-1, 0);
        orbit.turn(2, 0);
        await answer();
        return asked;
    })())");
    EXPECT_EQ(told, (Json{{"pivot", 0.5, 0.25},
                          {"orbit", 15, -20},
                          {"pan", 0.1, 0.05},
                          {"approach", 4},
                          {"orbit", 0.5, 0},
                          {"orbit", 1, 0}}));
}

TEST_F(PageModules, TheScreenIsKeptOnOnce) {
    const Json told = with("wake_lock.js", R"((async () => {
        const locks = [];
        const make = () => ({ released: false, async release() { this.released = true; } });
        const request = async () => (locks.push(make()), locks.at(-1));
        Object.defineProperty(navigator, "wakeLock", { value: { request }, configurable: true });
        const states = [], note = () => states.push(locks.map(({ released }) => (released ? 0 : 1)).join(""));
        await Promise.all([m.keepAwake(true), m.keepAwake(true)]);
        note();
        locks[0].released = true; // by the browser
        await m.keepAwake(true);
        note();
        m.keepAwake(false);
        note();
        const late = m.keepAwake(true);
        m.keepAwake(false);
        await late;
        note();
        return states.join();
    })())");
    EXPECT_EQ(told, "1,01,00,000");
}

// The point that is looked at comes to the middle, however steep the view is.
TEST_F(PageModules, ADoubleClickTurnsThere) {
    const auto turn = [&](const std::string& view, const std::string& point) {
        return with("directions.js",
                    "(() => { const view = " + view + "; const { right, up } = m.turnTo(view, [0, 1, 0], " +
                        "m.directionThrough(view, " + point +
                        ", 2)); return [Math.round(right * 100), Math.round(up * 100)]; })()");
    };
    const std::string level = "{ forward: [0, 0, -1], up: [0, 1, 0], fov: 90 }";
    EXPECT_EQ(turn(level, "0, 0"), (Json{0, 0}));
    EXPECT_EQ(turn(level, "1, 0"), (Json{4500, 0}));
    EXPECT_EQ(turn(level, "0, 1"), (Json{0, 2657}));
    const std::string steep = "{ forward: [0, -0.8, -0.6], up: [0, 1, 0], fov: 90 }";
    EXPECT_EQ(turn(steep, "0, 0"), (Json{0, 0}));
    EXPECT_EQ(turn(steep, "1, 0"), (Json{5904, 1868})) << "farther round than in the image";
    EXPECT_EQ(turn("{ forward: [0, -1, 0], up: [0, 0, -1], fov: 90 }", "1, 0"), (Json{9000, 4500}))
        << "straight down";
}

// The bridge takes one step at a time.
TEST_F(PageModules, UndoWaitsForTheLastOne) {
    EXPECT_EQ(with("steps.js", R"((async () => {
        const told = [], link = new EventTarget();
        const steps = new m.Steps(async (what) => {
            told.push(what);
            setTimeout(() => (told.push("state"), link.dispatchEvent(new Event("state"))), 20);
            return { ok: true };
        }, link);
        steps.take("undo");
        await steps.take("redo");
        return told.join();
    })())"),
              "undo,state,redo,state");
}

TEST_F(PageModules, ARefusedEditIsToldOnceItIsOver) {
    EXPECT_EQ(with("edits.js", R"((async () => {
        const told = [], edits = new m.Edits(async () => ({ ok: false }), () => told.push(edits.isBusy("a")));
        return [await edits.edit("a", "set", {}), ...told].join();
    })())"),
              "false,false");
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

// Fields in another unit than the bridge's: what is not typed goes back as it came.
TEST_F(PageModules, FieldsShowAnotherUnit) {
    const Json told = with("fields.js", R"((() => {
        const sent = [], send = (value) => sent.push(value), how = { unit: "m", scale: () => 0.0010000000474974513, min: 0 };
        const type = (made, text, at = 0) => {
            const box = made.element.querySelectorAll("input")[at];
            const shown = box.value;
            box.value = text;
            box.dispatchEvent(new Event("change"));
            return shown;
        };
        const size = m.numeric("Size", send, { ...how, slider: false }), place = m.vector("Position", send, how);
        const power = m.measured("Power", [["lm", 1], ["W", 1 / 683]], send);
        size.show(95.23500061035156, true);
        place.show([0.10000000149011612, 1234.5677490234375, -3], true);
        power.show(800, true);
        const unit = power.element.querySelector("select"), shown = [type(size, "0.3"), type(place, "2", 2), type(power, "683")];
        unit.selectedIndex = 1;
        unit.dispatchEvent(new Event("change"));
        shown.push(type(power, "2"));
        return { shown, sent, labels: [size, place].map(({ element }) => element.querySelector("label, .label").textContent) };
    })())");
    EXPECT_EQ(told["shown"], (Json{"0.095235", "-0.003", "800", "1.1713"}));
    EXPECT_EQ(told["sent"], (Json{300, {0.10000000149011612, 1234.5677490234375, 2000}, 683, 1366}));
    EXPECT_EQ(told["labels"], (Json{"Size\u00a0m", "Position\u00a0m"}));
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

TEST_F(PageModules, PluralsAreRight) {
    EXPECT_EQ(with("texts.js", "m.counted('importGood', 1) + ', ' + m.counted('importGood', 2)"),
              "1 bookmark added, 2 bookmarks added");
}

TEST_F(PageModules, SettingsAreCalledAsInTheWindow) {
    EXPECT_EQ(with("setting_labels.js", "m.settingLabel('path.rouletteFrom')"), "Roulette from bounce");
    EXPECT_EQ(with("setting_labels.js", "m.settingLabel('exposure.brighterSeconds')"), "Brighter seconds");
    EXPECT_EQ(with("setting_labels.js", "m.editLabel('light power 2')"), "power of light 2");
}

} // namespace
