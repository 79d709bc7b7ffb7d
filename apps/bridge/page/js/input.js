/**
 * Keyboard and mouse. Keys are the server's only while captured, by click or Enter; with the mouse locked where the
 * browser allows it, else by dragging. Whatever ends the capture lets all keys go. Where the model is turned in the
 * hand, a drag needs no capture.
 */
import { hasControl, onFullScreenEnd } from "./full_screen.js";
import { keyCode, pageKeys } from "./key_table.js";
import { preference } from "./storage.js";

const DEGREES_PER_PIXEL = 0.12; // as in the window
const TURN_RATE = 90;           // degrees per second, of Q and E, R and V
const RETRY_MS = 1300;          // Chromium refuses the lock for a while after Esc
const STEP = 100, LINE = STEP / 3; // pixels of the wheel for one step of the speed; of a line
const NEARER = 1.2;             // by a step of the wheel
const STRAY = 400;              // pixels: no hand moves so far between two events

export class Input {
    /**
     * @param {HTMLCanvasElement} canvas
     * @param {Held} held
     * @param {Object} on `mayCapture()`, `captured(kind)` ("lock", "drag", "retry", ""), `wheel(steps)`, `pointed(x,
     *     y)`, `focused(x, y)` with places in the window; `orbit`, `fit()`
     */
    constructor(canvas, held, on) {
        this.canvas = canvas;
        this.held = held;
        this.on = on;
        this.kind = "";
        this.down = new Set(); // places of keys
        this.turning = 0;
        this.rolled = 0; // pixels of the wheel that are no whole step yet
        this.listen();
    }

    listen() {
        const { canvas } = this;
        addEventListener("keydown", (event) => this.onKey(event, true), true);
        addEventListener("keyup", (event) => this.onKey(event, false), true);
        canvas.addEventListener("pointerdown", (event) => this.onDown(event));
        canvas.addEventListener("pointermove", (event) => this.onMove(event));
        canvas.addEventListener("pointerup", () => (this.dragging = this.holding = false));
        canvas.addEventListener("wheel", (event) => this.onWheel(event), { passive: false });
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        canvas.addEventListener("blur", () => this.release());
        addEventListener("blur", () => this.release());
        addEventListener("pagehide", () => this.release());
        document.addEventListener("visibilitychange", () => document.hidden && this.release());
        document.addEventListener("pointerlockchange", () => this.onLockChange());
        onFullScreenEnd(() => this.captured && this.tell()); // without Control
        addEventListener("beforeunload", (event) => this.kind && event.preventDefault());
    }

    get captured() {
        return this.kind !== "";
    }

    async capture() {
        if (this.captured || !this.on.mayCapture()) return;
        this.canvas.focus({ preventScroll: true });
        this.set("drag");
        await this.lock();
    }

    async lock(again = true) {
        const ask = async (how) => this.canvas.requestPointerLock(how);
        try {
            await ask({ unadjustedMovement: true }).catch((error) => {
                if (error.name !== "NotSupportedError") throw error;
                return ask();
            });
        } catch {
            // The keyboard is captured in any case, and dragging looks around.
            if (again && this.captured && "requestPointerLock" in this.canvas) {
                this.retry = setTimeout(() => this.captured && this.kind === "drag" && this.lock(false), RETRY_MS);
            }
        }
    }

    onLockChange() {
        if (document.pointerLockElement === this.canvas) {
            if (this.captured) this.set("lock");
            else document.exitPointerLock();
        } else if (this.kind === "lock") this.release();
    }

    set(kind) {
        this.kind = kind;
        this.on.captured(kind);
    }

    /** Lets keyboard, mouse and all keys go. */
    release() {
        clearTimeout(this.retry);
        this.down.clear();
        this.stopTurning();
        this.dragging = false;
        const was = this.captured;
        this.kind = "";
        if (document.pointerLockElement === this.canvas) document.exitPointerLock();
        if (!was) return;
        this.held.release();
        this.on.captured("");
    }

    onKey(event, isDown) {
        const place = event.code;
        if (/^Meta(Left|Right)$/.test(place) && this.down.size) { // a Mac tells of no other key that comes up meanwhile
            this.down.clear();
            return void this.tell();
        }
        if (!isDown && this.down.delete(place)) return void this.tell();
        if (!isDown || event.target !== this.canvas) return;
        if (!this.captured) {
            const fits = place === "Home" && this.orbits;
            if ((place !== "Enter" && !fits) || event.ctrlKey || event.metaKey || event.altKey) return;
            event.preventDefault();
            if (!fits) return void this.capture();
            return void (this.on.mayDrive() && this.on.fit());
        }
        if (place === "Escape") {
            event.preventDefault();
            return this.release();
        }
        const control = hasControl();
        const known = keyCode(place, control) !== 0 || place in pageKeys;
        // A keydown can come after the blur that should have let it go.
        if (!known || event.metaKey || event.altKey || (event.ctrlKey && !control) || !document.hasFocus()) return;
        event.preventDefault();
        if (event.repeat || this.down.has(place)) return;
        this.down.add(place);
        this.tell();
    }

    tell() {
        const control = hasControl();
        this.held.hold("keys", [...this.down].map((place) => keyCode(place, control)).filter((code) => code !== 0));
        const right = this.down.has("KeyE") - this.down.has("KeyQ"), up = this.down.has("KeyR") - this.down.has("KeyV");
        if (right === 0 && up === 0) this.stopTurning();
        else this.startTurning(right, up);
    }

    /** Each: 1, 0 or -1. */
    startTurning(right, up) {
        this.direction = { right, up };
        if (this.turning) return;
        let last = performance.now();
        this.turning = setInterval(() => {
            const now = performance.now(), degrees = TURN_RATE * Math.min(0.1, (now - last) / 1000);
            this.held.turn(this.direction.right * degrees, this.direction.up * degrees);
            last = now;
        }, 16);
    }

    stopTurning() {
        clearInterval(this.turning);
        this.turning = 0;
    }

    onDown(event) {
        if (event.pointerType === "touch") return;
        if (this.orbits && (event.button === 0 || event.button === 1) && !event.ctrlKey) return this.grasp(event);
        if (event.button !== 0) return;
        const now = performance.now(), first = this.first;
        this.first = { at: now, x: event.clientX, y: event.clientY };
        if (event.ctrlKey) return this.on.focused(event.clientX, event.clientY);
        if (this.captured) {
            this.dragging = true;
            if (this.kind === "drag") this.canvas.setPointerCapture(event.pointerId);
            // The second click of a pair, the first of which captured.
            if (this.byClick && first && now - first.at < 400 && !this.moved) {
                this.release();
                this.on.pointed(first.x, first.y);
            }
            return;
        }
        this.byClick = true;
        this.moved = false;
        this.dragging = true;
        this.capture();
    }

    /** A drag does not turn the model while the keyboard and the mouse are captured. */
    get orbits() {
        return Boolean(this.on.orbit?.is) && !this.captured;
    }

    grasp(event) {
        event.preventDefault();
        if (!this.on.mayDrive()) return;
        this.on.used();
        this.canvas.focus({ preventScroll: true });
        const now = performance.now(), first = this.first;
        this.first = { at: now, x: event.clientX, y: event.clientY };
        if (first && now - first.at < 400 && event.button === 0
            && Math.hypot(event.clientX - first.x, event.clientY - first.y) < 8) {
            this.first = null;
            return this.on.orbit.centre(event.clientX, event.clientY);
        }
        this.canvas.setPointerCapture(event.pointerId);
        this.holding = true;
        this.on.orbit.grasp(event.clientX, event.clientY);
    }

    onMove(event) {
        if (event.pointerType === "touch") return;
        if (this.holding && event.buttons & 5) {
            const pushes = event.shiftKey || event.buttons & 4;
            return this.on.orbit[pushes ? "move" : "turn"](event.movementX, event.movementY);
        }
        if (!this.captured) return;
        if (this.kind === "drag" && !(this.dragging && event.buttons & 1)) return;
        const { movementX: x, movementY: y } = event;
        if (Math.abs(x) > STRAY || Math.abs(y) > STRAY) return; // jumps that some browsers make when they lock
        if (Math.abs(x) + Math.abs(y) > 1) this.moved = true;
        const scale = DEGREES_PER_PIXEL * Number(preference("mouse", "1"));
        const up = preference("invert", "false") === "true" ? 1 : -1;
        this.held.turn(x * scale, up * y * scale);
    }

    onWheel(event) {
        if (event.ctrlKey) return; // the page's size
        event.preventDefault();
        const moved = (event.deltaMode === 1 ? LINE : 1) * event.deltaY;
        if (moved * this.rolled < 0) this.rolled = 0;
        this.rolled += moved;
        const steps = Math.trunc(this.rolled / STEP);
        this.rolled -= steps * STEP;
        if (steps === 0) return;
        if (!this.orbits) return this.on.wheel(-steps);
        if (!this.on.mayDrive()) return;
        this.on.orbit.grasp(event.clientX, event.clientY);
        this.on.orbit.approach(NEARER ** -steps);
    }
}
