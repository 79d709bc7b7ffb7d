import { Measuring, caughtPoint, lightText } from "./measuring.js";
import { equal } from "./expect.js";

/** A server that catches the place that was tapped, on the floor. */
function tool(asked) {
    const app = {
        ask: async (what, ...args) => {
            asked.push([what, ...args].join(" "));
            return what === "seen" ? { ok: true, part: { number: 3, name: "lid" } }
                : { ok: true, text: what === "measure point" ? `face ${args[0]} 0 ${args[1]}` : "" };
        },
        notices: { show() {}, hide() {} },
    };
    return new Measuring(app, () => {}, { t: (key) => key, of: (_, text) => text, number: String });
}

export function answersAreRead() {
    equal(caughtPoint("corner 1 0 2.5"), [1, 0, 2.5]);
    equal(caughtPoint("corner 1 nothing 2"), null);
    equal(caughtPoint(""), null);
    const text = "illuminance 512.3 lx, standard error 3.1\nluminance 120 cd/m2, standard error 1\nat 1 2 3";
    equal(lightText(text, (value, digits) => value.toFixed(digits)), "512.3 lx ± 3.1, 120 cd/m² ± 1");
    equal(lightText("luminance 7 cd/m2, standard error 0", String), "7 cd/m² ± 0");
}

export async function tapsBecomeMeasures() {
    const asked = [], measuring = tool(asked), last = () => asked.at(-1);
    measuring.start("angle");
    for (const at of [{ x: 0.1, y: 0.2 }, { x: 0.3, y: 0.4 }, { x: 0.5, y: 0.6 }]) await measuring.tap(at);
    equal(last(), "measure keep angle 0.1 0 0.2 0.3 0 0.4 0.5 0 0.6");
    equal(measuring.kind, "", "it ends by itself");
    measuring.start("height");
    await measuring.tap({ x: 0.1, y: 0.2 });
    equal(last(), "measure keep height 0.1 0 0.2");
    measuring.start("chain");
    for (const x of [1, 2]) await measuring.tap({ x, y: 0 });
    measuring.keepPoints();
    equal(last(), "measure keep distance 1 0 0 2 0 0", "two points are no chain");
    measuring.start("volume");
    await measuring.tap({ x: 0.1, y: 0.2 });
    equal(last(), "measure keep volume 3");
}

export async function aTapThatIsAnsweredAfterTheEndIsNone() {
    const asked = [], measuring = tool(asked);
    measuring.start("distance");
    const late = measuring.tap({ x: 0.1, y: 0.2 });
    measuring.stop();
    measuring.start("distance");
    await late;
    equal(measuring.points, []);
}
