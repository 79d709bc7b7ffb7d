// Keys that are held and turns of the wheel, and how they are told.
import { equal } from "./expect.js";
import { Held } from "./held.js";
import { Input } from "./input.js";

const after = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

// Actions of the hands are told at once, also while a key that is held waits to be told again.
export async function aHeldKeyDelaysNothing() {
    let last = null;
    const held = new Held((message) => {
        const view = new DataView(message);
        last = [view.getInt32(8, true), view.getUint8(1), view.getUint8(2)]; // turn, keys, taps
        return true;
    });
    const told = [];
    for (const act of [() => held.hold("keys", [87]), () => held.turn(1, 0), () => held.hold("keys", [87, 65]),
        () => held.tap(32), () => held.hold("keys", [])]) {
        last = null;
        act();
        told.push(last);
        await after(12);
    }
    equal(told, [[0, 1, 0], [1000, 1, 0], [0, 2, 0], [0, 2, 1], [0, 0, 0]]);

    held.hold("keys", [87]);
    held.turn(2, 0);
    await after(60);
    equal(last, [2000, 1, 0], "at once after another, and waits no longer than that asks for");
}

export function commandLetsGoOfKeysAndTheWheelHasSteps() {
    const canvas = document.createElement("canvas");
    const keys = [], steps = [];
    const held = { hold: (_, codes) => keys.push(codes.join()), turn() {}, release() {} };
    const input = new Input(canvas, held, { captured() {}, wheel: (count) => steps.push(count) });
    input.down.add("KeyW").add("KeyA");
    input.tell();
    dispatchEvent(new KeyboardEvent("keyup", { code: "MetaLeft" }));
    for (const [deltaY, deltaMode] of [[40, 0], [40, 0], [40, 0], [80, 0], [-100, 0], [3, 1], [250, 0], [-99, 0]]) {
        canvas.dispatchEvent(new WheelEvent("wheel", { deltaY, deltaMode }));
    }
    equal(keys, ["87,65", ""]);
    equal(steps, [-1, -1, 1, -1, -2]);
}
