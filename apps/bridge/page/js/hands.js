/** Sends input by mouse, touch, keys and gamepad to the bridge, or offers to drive first. */
import { directionThrough, turnTo } from "./directions.js";
import { byId } from "./dom.js";
import { Gamepad } from "./gamepad.js";
import { Input } from "./input.js";
import { Steps } from "./steps.js";
import { number, t } from "./texts.js";
import { Touch } from "./touch.js";
import { keepAwake } from "./wake_lock.js";

const AWAKE_MS = 60000, SPEED_STEP = 1.15;

/** Whether an element takes its own typing back. */
const holdsText = (element) => element instanceof HTMLTextAreaElement
    || (element instanceof HTMLInputElement && !/^(range|checkbox|color|file)$/.test(element.type));

/** `app` has `around`, `held`, `orbit`, `picture` and gets `input`. */
export function connectHands(app, canvas) {
    const { around, held, orbit } = app, stage = byId("stage");

    function offerDriving() {
        if (!app.link.greeted) return;
        const text = around.driverText(), { mayDrive } = app.welcome;
        const actions = mayDrive ? [[t("ask"), () => app.askToDrive()]] : [];
        app.notices.show("driver", mayDrive ? text : text + " · " + t("viewOnly"), { actions });
    }
    const mayDrive = () => app.drives() || (offerDriving(), false);

    /** Hands that capture nothing tell of no end. */
    let awakeUntil = 0;
    function keepAwakeForNow() {
        clearTimeout(awakeUntil);
        awakeUntil = setTimeout(() => stage.classList.contains("captured") || keepAwake(false), AWAKE_MS);
        keepAwake(true);
    }

    const hands = {
        orbit,
        mayCapture: mayDrive,
        mayDrive,
        fit() {
            orbit.forget();
            app.ask("camera fit");
        },
        captured(kind) {
            around.walked ||= kind !== "";
            stage.classList.toggle("captured", kind !== "");
            canvas.classList.toggle("captured", kind === "drag");
            if (kind === "") app.notices.hide("captured");
            else app.notices.show("captured", t(kind === "lock" ? "captured" : "capturedDrag"));
            around.showHint();
            keepAwake(kind !== "");
        },
        wheel(steps) {
            if (!app.drives()) return;
            app.setSpeed(app.speed * SPEED_STEP ** steps);
            app.notices.show("speed", t(app.status.mode === "fly" ? "speed" : "speedLater", number(app.speed, 2)));
        },
        pointed(clientX, clientY) {
            const at = app.picture.at(clientX, clientY), { status } = app;
            if (!at || !status.fov || !app.drives()) return;
            const direction = directionThrough(status, 2 * at.x - 1, 1 - 2 * at.y, app.picture.aspect);
            const { right, up } = turnTo(status, app.state.up ?? status.up, direction);
            held.turn(right, up);
        },
        focused(clientX, clientY) {
            const at = app.picture.at(clientX, clientY);
            if (at && app.drives()) app.focus(at);
        },
        used() {
            around.walked = true;
            keepAwakeForNow();
            byId("pads").hidden = orbit.is;
            around.showHint();
        },
    };
    app.input = new Input(canvas, held, hands);
    new Touch(canvas, held, hands);
    new Gamepad(held, () => app.drives());
    connectButtons(app, hands);
}

function connectButtons(app, hands) {
    byId("fit").addEventListener("click", () => hands.fit());
    byId("orbit").addEventListener("click", () => app.orbit.choose(!app.orbit.is));
    const steps = new Steps((what) => app.ask(what), app.link);
    for (const what of ["undo", "redo"]) byId(what).addEventListener("click", () => steps.take(what));
    addEventListener("keydown", (event) => {
        if (event.defaultPrevented || event.altKey) return;
        const command = event.ctrlKey || event.metaKey;
        if (event.code === "F3" && !command) {
            event.preventDefault();
            app.statistics.toggle();
        } else if (event.key?.toLowerCase() === "z" && command && !holdsText(event.target)) {
            event.preventDefault();
            steps.take(event.shiftKey ? "redo" : "undo");
        }
    });
}
