/** Gamepads: the left stick walks, the right one turns, A jumps, B crouches, Y walks or flies, a trigger runs. */
import { KEYS } from "./key_table.js";

const ON = 0.45, OFF = 0.3, DEAD = 0.12, RATE = 120; // parts of the way; degrees per second

/** Keys of a stick; one that is down stays down until the stick is well back. */
export function axisKeys(x, y, before) {
    const over = (value, key) => value > (before.has(key) ? OFF : ON);
    const keys = new Set();
    for (const [value, key] of [[-y, KEYS.forward], [y, KEYS.back], [-x, KEYS.left], [x, KEYS.right]])
        if (over(value, key)) keys.add(key);
    return keys;
}

/** Slow near the middle, with none in the middle itself. */
export const turnRate = (value) => (Math.abs(value) < DEAD ? 0 : Math.sign(value)
    * ((Math.abs(value) - DEAD) / (1 - DEAD)) ** 2 * RATE);

export class Gamepad {
    /** @param {() => boolean} mayDrive */
    constructor(held, mayDrive) {
        this.held = held;
        this.mayDrive = mayDrive;
        this.flew = false;
        const release = () => this.apply(new Set()); // a page that is hidden is asked for no frames
        addEventListener("gamepadconnected", () => this.start());
        for (const type of ["gamepaddisconnected", "blur", "pagehide"]) addEventListener(type, release);
        document.addEventListener("visibilitychange", () => document.hidden && release());
    }

    get keys() {
        return this.held.sources.get("gamepad") ?? new Set();
    }

    start() {
        if (this.running) return;
        this.running = true;
        let last = performance.now();
        const step = (now) => {
            const pad = [...navigator.getGamepads()].find((one) => one?.connected);
            this.running = Boolean(pad);
            if (!pad) return;
            if (document.hasFocus() && this.mayDrive()) this.poll(pad, Math.min(0.1, (now - last) / 1000));
            else this.apply(new Set());
            last = now;
            requestAnimationFrame(step);
        };
        requestAnimationFrame(step);
    }

    poll(pad, seconds) {
        const [x = 0, y = 0, right = 0, down = 0] = pad.axes;
        const pressed = (index) => pad.buttons[index]?.pressed ?? false;
        const keys = axisKeys(x, y, this.keys);
        if (pressed(0)) keys.add(KEYS.jump);
        if (pressed(1)) keys.add(KEYS.crouch);
        if (pressed(7) || pressed(10)) keys.add(KEYS.shift);
        this.apply(keys);
        if (pressed(3) && !this.flew) this.held.tap(KEYS.fly);
        this.flew = pressed(3);
        const turn = turnRate(right) * seconds, up = -turnRate(down) * seconds;
        if (turn !== 0 || up !== 0) this.held.turn(turn, up);
    }

    apply(keys) {
        const { keys: before } = this;
        const same = keys.size === before.size && [...keys].every((key) => before.has(key));
        if (!same) this.held.hold("gamepad", keys);
    }
}
