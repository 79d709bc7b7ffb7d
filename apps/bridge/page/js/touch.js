/**
 * Thumbs: on the left half a stick that walks, on the right half the view turns. Two fingers there change the speed.
 * Where the model is in the hand, one finger turns it, two move it and bring it nearer.
 */
import { byId } from "./dom.js";
import { KEYS } from "./key_table.js";

const RADIUS = 56, DEAD = 0.25, RUN = 1.15; // pixels; parts of the radius
const DEGREES_PER_PIXEL = 0.25, TAP_MS = 300, TAP_MOVE = 12, PINCH_STEP = 24;

/** The keys of a thumb that is so far from its start, in radii, to the right and down. */
export function stickKeys(x, y) {
    const far = Math.hypot(x, y);
    if (far < DEAD) return [];
    const keys = [];
    // Eight directions, each of 45 degrees.
    if (Math.abs(y) > far * 0.38) keys.push(y < 0 ? KEYS.forward : KEYS.back);
    if (Math.abs(x) > far * 0.38) keys.push(x < 0 ? KEYS.left : KEYS.right);
    if (far > RUN) keys.push(KEYS.shift);
    return keys;
}

export class Touch {
    /** @param {Object} on `mayDrive()`, `wheel(steps)`, `pointed(x, y)`, `used()` at the first touch; `orbit` */
    constructor(canvas, held, on) {
        this.canvas = canvas;
        this.held = held;
        this.on = on;
        this.fingers = new Map();
        this.stick = byId("stick");
        for (const [type, what] of [["pointerdown", "onDown"], ["pointermove", "onMove"], ["pointerup", "onUp"],
            ["pointercancel", "onUp"]])
            canvas.addEventListener(type, (event) => event.pointerType === "touch" && this[what](event));
        addEventListener("blur", () => this.release());
        document.addEventListener("visibilitychange", () => document.hidden && this.release());
        this.pad("pad-jump", KEYS.jump);
        this.pad("pad-crouch", KEYS.crouch);
        byId("pad-fly").addEventListener("click", () => this.held.tap(KEYS.fly));
    }

    pad(id, key) {
        const element = byId(id);
        element.addEventListener("pointerdown", (event) => {
            element.setPointerCapture(event.pointerId);
            this.held.hold(id, [key]);
        });
        for (const type of ["pointerup", "pointercancel", "lostpointercapture"])
            element.addEventListener(type, () => this.held.hold(id, []));
        element.addEventListener("click", (event) => event.detail === 0 && this.held.tap(key)); // by keyboard
    }

    onDown(event) {
        event.preventDefault();
        if (!this.on.mayDrive()) return;
        this.on.used();
        this.canvas.setPointerCapture(event.pointerId);
        const room = this.canvas.getBoundingClientRect(), orbits = this.on.orbit.is;
        const walks = !orbits && event.clientX < room.x + room.width / 2
            && ![...this.fingers.values()].some((f) => f.walks);
        this.fingers.set(event.pointerId, { walks, x: event.clientX, y: event.clientY, startX: event.clientX,
            startY: event.clientY,
            at: performance.now() });
        if (walks) this.showStick(event.clientX - room.x, event.clientY - room.y);
        this.apart = this.distance();
        if (orbits) this.grasp();
    }

    /** About what is under the finger, or between two. */
    grasp() {
        const all = [...this.fingers.values()];
        const middle = (key) => all.reduce((sum, finger) => sum + finger[key], 0) / all.length;
        if (all.length > 0) this.on.orbit.grasp(middle("x"), middle("y"));
    }

    onMove(event) {
        const finger = this.fingers.get(event.pointerId);
        if (!finger) return;
        const dx = event.clientX - finger.x, dy = event.clientY - finger.y;
        finger.x = event.clientX;
        finger.y = event.clientY;
        if (finger.walks) return this.walk(finger);
        if (this.on.orbit.is) return this.handle(dx, dy);
        const apart = this.distance();
        if (apart === null) return this.held.turn(dx * DEGREES_PER_PIXEL, -dy * DEGREES_PER_PIXEL);
        const steps = Math.trunc((apart - this.apart) / PINCH_STEP);
        if (steps === 0) return;
        this.apart += steps * PINCH_STEP;
        this.on.wheel(steps);
    }

    handle(dx, dy) {
        const { orbit } = this.on, apart = this.distance();
        if (apart === null) return this.fingers.size === 1 && orbit.turn(dx, dy);
        orbit.move(dx / 2, dy / 2); // each finger moves the middle by half its way
        if (this.apart > 0 && apart > 0) orbit.approach(apart / this.apart);
        this.apart = apart;
    }

    onUp(event) {
        const finger = this.fingers.get(event.pointerId);
        if (!finger) return;
        this.fingers.delete(event.pointerId);
        this.apart = this.distance();
        if (this.on.orbit.is) this.grasp();
        if (finger.walks) {
            this.stick.hidden = true;
            this.held.hold("stick", []);
        }
        const short = performance.now() - finger.at < TAP_MS && event.type === "pointerup" &&
            Math.hypot(finger.x - finger.startX, finger.y - finger.startY) < TAP_MOVE;
        if (short) this.onTap(finger);
    }

    onTap({ x, y }) {
        const now = performance.now(), first = this.tap;
        this.tap = { at: now, x, y };
        if (!first || now - first.at > 2 * TAP_MS || Math.hypot(x - first.x, y - first.y) > 3 * TAP_MOVE) return;
        this.tap = null;
        if (this.on.orbit.is) this.on.orbit.centre(x, y);
        else this.on.pointed(x, y);
    }

    walk({ x, y, startX, startY }) {
        const right = (x - startX) / RADIUS, down = (y - startY) / RADIUS;
        const far = Math.max(1, Math.hypot(right, down));
        this.stick.firstElementChild.style.translate = `${(right / far) * RADIUS}px ${(down / far) * RADIUS}px`;
        this.held.hold("stick", stickKeys(right, down));
    }

    /** Between two fingers that look; null: there are not two. */
    distance() {
        const looking = [...this.fingers.values()].filter((finger) => !finger.walks);
        return looking.length === 2 ? Math.hypot(looking[0].x - looking[1].x, looking[0].y - looking[1].y) : null;
    }

    showStick(x, y) {
        this.stick.style.left = x + "px";
        this.stick.style.top = y + "px";
        this.stick.firstElementChild.style.translate = "";
        this.stick.hidden = false;
    }

    release() {
        this.fingers.clear();
        this.stick.hidden = true;
        for (const source of ["stick", "pad-jump", "pad-crouch"]) this.held.hold(source, []);
    }
}
