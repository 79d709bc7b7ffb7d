/**
 * The state of all input: which keys are held, whoever holds them (keyboard, thumb, gamepad), and how far the view is
 * to turn. Sent as a whole, so that a lost message cannot leave a key down; repeated while anything is held.
 */
import { inputMessage, MAX_HELD } from "./wire.js";

const MIN_MS = 8, REPEAT_MS = 200;

export class Held {
    /** @param {(message: ArrayBuffer) => boolean} send false: it cannot be sent now */
    constructor(send) {
        this.send = send;
        this.sources = new Map();
        this.sequence = 0;
        this.turned = { right: 0, up: 0 };
        this.taps = [];
        this.lastSent = -Infinity;
        this.timer = 0;
        this.sentAt = new Map(); // of the last inputs, for the delay that statistics show
    }

    /** The keys that `source` holds now. @param {string} source @param {Iterable<number>} keys */
    hold(source, keys) {
        this.sources.set(source, new Set(keys));
        this.wake();
    }

    /** A key that goes down and up at once. */
    tap(key) {
        this.taps.push(key);
        this.wake();
    }

    /** Degrees. */
    turn(right, up) {
        this.turned.right += right;
        this.turned.up += up;
        this.wake();
    }

    get keys() {
        const all = new Set();
        for (const keys of this.sources.values()) for (const key of keys) all.add(key);
        return [...all].slice(0, MAX_HELD);
    }

    /** Everything is let go, and told at once. */
    release() {
        this.sources.clear();
        this.turned = { right: 0, up: 0 };
        this.taps = [];
        this.flush();
    }

    wake() {
        const wait = this.lastSent + MIN_MS - performance.now();
        if (wait <= 0) this.flush();
        else this.flushIn(wait);
    }

    /** Milliseconds; in place of what was to be sent at another time. */
    flushIn(wait) {
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.flush(), wait);
    }

    flush() {
        clearTimeout(this.timer);
        const held = this.keys;
        const right = Math.round(this.turned.right * 1000), up = Math.round(this.turned.up * 1000);
        this.sequence = (this.sequence + 1) >>> 0;
        this.lastSent = performance.now();
        if (this.send(inputMessage(this.sequence, right, up, this.taps.splice(0), held))) this.remember();
        this.turned.right -= right / 1000; // the rest, too small to be sent, stays
        this.turned.up -= up / 1000;
        if (held.length) this.flushIn(REPEAT_MS);
    }

    remember() {
        this.sentAt.set(this.sequence, this.lastSent);
        if (this.sentAt.size > 256) this.sentAt.delete(this.sentAt.keys().next().value);
    }

    /** Milliseconds from when that input was sent until `at`; null where that is not known (any more). */
    until(at, sequence) {
        const sent = this.sentAt.get(sequence);
        if (sent === undefined) return null;
        this.sentAt.delete(sequence);
        return at - performance.timeOrigin - sent;
    }
}
