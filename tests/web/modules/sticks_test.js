// Sticks of thumbs and of gamepads.
import { equal } from "./expect.js";
import { Gamepad, axisKeys, turnRate } from "./gamepad.js";
import { stickKeys } from "./touch.js";

const W = 87, A = 65, S = 83, D = 68;

// `shift`: the number of that key.
export function sticksHoldKeys({ shift }) {
    equal(stickKeys(0, -0.2), []);
    equal(stickKeys(0, -1), [W]);
    equal(stickKeys(1, 0), [D]);
    equal(stickKeys(-0.7, 0.7), [S, A]);
    equal(stickKeys(0, -1.3), [W, shift]);

    equal([...axisKeys(0, -0.4, new Set())], []);
    equal([...axisKeys(0, -0.4, new Set([W]))], [W]);
    equal([...axisKeys(0, -0.2, new Set([W]))], []);
    equal(turnRate(0.1), 0);
    equal(turnRate(-1), -120);
}

// Also after something else let all keys go.
export function aGamepadLetsGoOfItsKeysWithTheWindow() {
    const told = [];
    const held = {
        sources: new Map(),
        hold(source, keys) {
            this.sources.set(source, keys);
            told.push([...keys].join());
        },
    };
    const pad = new Gamepad(held, () => true);
    pad.apply(new Set([W]));
    pad.apply(new Set([W]));
    dispatchEvent(new Event("blur"));
    pad.apply(new Set([W]));
    held.sources.clear();
    pad.apply(new Set([W]));
    equal(told, ["87", "", "87", "87"]);
}
