/** Gamepads: the left stick walks, the right one turns, A jumps, B crouches, Y walks or flies, a trigger runs. */
const ON = 0.45, OFF = 0.3, DEAD = 0.12, RATE = 120; // parts of the way; degrees per second
const KEYS = { forward: 87, back: 83, left: 65, right: 68, shift: 132, jump: 32, crouch: 67, fly: 70 };

/** Keys of a stick; one that is down stays down until the stick is well back. */
export function axisKeys(x, y, before) {
    const over = (value, key) => value > (before.has(key) ? OFF : ON);
    const keys = new Set();
    for (const [value, key] of [[-y, KEYS.forward], [y, KEYS.back], [-x, KEYS.left], [x, KEYS.right]])
        if (over(value, key)) keys.add(key);
    return keys;
}

/** Slow near the middle, with none in the middle itself. */
export const turnRate = (value) => (Math.abs(value) < DEAD ? 0 : Math.sign(value) * ((Math.abs(value) - DEAD) / (1 - DEAD)) ** 2 * RATE);

export class Gamepad {
    /** @param {() => boolean} mayDrive */
    constructor(held, mayDrive) {
        this.held = held;
        this.mayDrive = mayDrive;
        this.keys = new Set();
        this.flew = false;
        addEventListener("gamepadconnected", () => this.start());
        addEventListener("gamepaddisconnected", () => this.apply(new Set()));
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
        const same = keys.size === this.keys.size && [...keys].every((key) => this.keys.has(key));
        this.keys = keys;
        if (!same) this.held.hold("gamepad", keys);
    }
}
