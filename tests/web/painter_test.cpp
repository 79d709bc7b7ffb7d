// What is drawn of what comes, and what is acknowledged: the painter of the page, by itself.
#include "web/module_page.h"

namespace {

using test::Json;

// `take(type, number, colour, [from, until])` hands it an image of that colour, or bytes of it, `hand` what
// `encode` gave; `quiet()` waits for all decodes; `colour()` is what is shown, `draws()` how often something
// was.
const char* const kStage = R"(
import('./painter.js').then(({ Painter }) => {
    const surface = new OffscreenCanvas(4, 4);
    const told = [];
    const painter = new Painter(surface, (what) => told.push(what));
    const encode = async (colour, type) => {
        const canvas = new OffscreenCanvas(4, 4), context = canvas.getContext("2d");
        context.fillStyle = colour;
        context.fillRect(0, 0, 4, 4);
        return new Uint8Array(await (await canvas.convertToBlob({ type, quality: 1 })).arrayBuffer());
    };
    const hand = (type, number, bytes, cut = []) => {
        const [from = 0, until = bytes.length] = cut;
        const part = bytes.subarray(from, until);
        const message = new Uint8Array(40 + part.length);
        message.set(part, 40);
        painter.take({ type, codec: type - 1, stream: 1, number: BigInt(number), atRest: type === 2, last: true,
            width: 4, height: 4, shownWidth: 4, shownHeight: 4, offset: from, total: bytes.length }, message.buffer);
    };
    const take = async (type, number, colour, cut) =>
        hand(type, number, await encode(colour, type === 1 ? "image/jpeg" : "image/png"), cut);
    const quiet = async () => {
        while (painter.decodes > 0 || painter.waiting) await new Promise((done) => setTimeout(done, 5));
    };
    const colour = () => {
        const [red, green, blue] = surface.getContext("2d").getImageData(1, 1, 1, 1).data;
        return red > 200 && green < 60 ? "red" : green > 200 && red < 60 ? "lime" : blue > 200 && red < 60 ? "blue" : "";
    };
    const acknowledged = () => told.flatMap((what) => what.acks).map(([type, , number]) => type + ":" + number);
    const draws = () => told.filter((what) => what.drawn).length;
    globalThis.stage = { encode, hand, take, quiet, colour, acknowledged, draws };
    return true;
}))";

class Painter : public test::ModulePage {
  protected:
    void SetUp() override {
        ModulePage::SetUp();
        if (!IsSkipped() && !HasFatalFailure()) page().value(kStage);
    }
    /// The value at the end of these steps.
    Json after(const std::string& steps, const std::string& value) const {
        return page().value(
            "(async () => { const { encode, hand, take, quiet, colour, acknowledged, draws } = stage; " +
            steps + "; await quiet(); return " + value + "; })()");
    }
};

TEST_F(Painter, DrawsNewerFramesOnly) {
    EXPECT_EQ(after("await take(1, 5, 'red')", "colour()"), "red");
    EXPECT_EQ(after("await take(1, 6, 'lime')", "colour()"), "lime");
    EXPECT_EQ(after("await take(1, 4, 'blue')", "colour()"), "lime");
    EXPECT_EQ(after("", "acknowledged()"), (Json{"1:5", "1:6", "1:4"})) << "also what is not drawn";
}

TEST_F(Painter, DrawsAStillOverItsOwnFrameOnly) {
    EXPECT_EQ(after("await take(1, 5, 'red'); await quiet(); await take(2, 5, 'lime')", "colour()"), "lime");
    EXPECT_EQ(after("await take(1, 6, 'red'); await quiet(); await take(2, 5, 'blue')", "colour()"), "red");
    EXPECT_EQ(after("await take(1, 6, 'blue')", "colour()"), "red") << "the same frame again";
}

TEST_F(Painter, DrawsNoStillOfMissingParts) {
    EXPECT_EQ(after("await take(1, 5, 'red'); await quiet(); await take(2, 5, 'lime', [0, 20]);"
                    "await take(2, 5, 'lime', [20])",
                    "colour()"),
              "lime");
    EXPECT_EQ(after("await take(1, 6, 'red'); await quiet(); await take(2, 6, 'blue', [0, 40]);"
                    "await take(2, 6, 'blue', [20]); await take(2, 6, 'blue', [40])",
                    "colour()"),
              "red");
}

TEST_F(Painter, AcknowledgesWhatItSkips) {
    const Json told =
        after("const red = await encode('red', 'image/jpeg'); for (let i = 1; i <= 30; ++i) hand(1, i, red)",
              "[draws(), ...acknowledged()]");
    EXPECT_LE(told[0], 4) << "two are decoded at a time, and of the others the newest";
    EXPECT_EQ(told.size(), 1U + 30) << told;
}

} // namespace
