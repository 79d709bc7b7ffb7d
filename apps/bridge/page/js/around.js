/** Elements around the image: the scene's name, undo and redo, the status line, the hint, the text while waiting. */
import { byId, name } from "./dom.js";
import { personName } from "./panel_people.js";
import { editLabel } from "./setting_labels.js";
import { number, t } from "./texts.js";

const byTouch = matchMedia("(pointer: coarse)").matches;

export class Around {
    constructor(app) {
        this.app = app;
        this.seen = false;   // a frame was shown
        this.exact = false;  // the exact image is shown
        this.walked = false; // the hint has done its work
        this.said = "";
        this.live = true;    // the shown image comes from a server that is there
        this.waitingFor = "connecting";
        this.nameAll();
        this.showHeader();
        this.showWaiting();
    }

    nameAll() {
        const buttons = { menu: "menu", close: "close", full: "full", share: "shareView", orbit: "orbit",
            fit: "fitView", "pad-fly": "padFly", "pad-jump": "padJump", "pad-crouch": "padCrouch", save: "saveWait" };
        for (const [id, text] of Object.entries(buttons)) name(byId(id), t(text));
        const places = { view: "view", corner: "corner", pads: "pads", tabs: "tabs" };
        for (const [id, text] of Object.entries(places)) byId(id).setAttribute("aria-label", t(text));
        byId("save").disabled = true;
    }

    showHeader() {
        const { scene = "", undo, redo, mayUndo, mayRedo } = this.app.state;
        byId("scene").textContent = scene;
        document.title = scene ? t("titleOf", scene) : t("title");
        byId("title").textContent = document.title;
        byId("undo").disabled = !mayUndo || !this.app.mayEdit();
        byId("redo").disabled = !mayRedo || !this.app.mayEdit();
        name(byId("undo"), undo ? t("undoOf", editLabel(undo)) : t("undo"));
        name(byId("redo"), redo ? t("redoOf", editLabel(redo)) : t("redo"));
    }

    /** Text of what is waited for, as long as no frame was shown; "": nothing. */
    showWaiting(what = this.waitingFor) {
        this.waitingFor = what;
        byId("waiting").hidden = this.seen || what === "";
        byId("waiting-text").textContent = what === "" ? "" : t(what);
    }

    showFrame(exact) {
        const first = !this.seen;
        this.seen = true;
        if (first) {
            byId("view").classList.remove("unseen");
            this.showWaiting();
            this.showHint();
        }
        if (exact !== this.exact) name(byId("save"), t(exact ? "save" : "saveWait"));
        this.exact = exact;
        byId("save").disabled = !exact;
        this.showStatus();
    }

    /** Another server is to be shown. */
    forget() {
        this.seen = false;
        this.exact = false;
        byId("view").classList.add("unseen");
        byId("save").disabled = true;
        name(byId("save"), t("saveWait"));
        this.showHeader();
        this.showStatus();
    }

    /** False: what is shown is all that is left of a server. */
    setLive(live) {
        this.live = live;
        byId("view").classList.toggle("stale", !live);
        this.showHint();
        this.showStatus();
    }

    showHint() {
        const hint = byId("hint");
        hint.hidden = this.walked || !this.seen || !this.live || !this.app.drives();
        const hints = this.app.orbits() ? ["hintOrbit", "hintOrbitTouch"] : ["hint", "hintTouch"];
        hint.textContent = hint.hidden ? "" : t(hints[byTouch ? 1 : 0]);
    }

    /** Whether hands turn the model. */
    showOrbit() {
        const button = byId("orbit");
        button.hidden = !this.app.drives();
        button.setAttribute("aria-pressed", this.app.orbits());
        byId("fit").hidden = button.hidden || !this.app.orbits();
        if (this.app.orbits()) byId("pads").hidden = true;
        this.showHint();
    }

    driverText() {
        const driver = this.app.driver();
        return driver ? t("watching", personName(driver)) : t("watchingFree");
    }

    showStatus() {
        const { mode, fps = 0, idle, paused, eye = [] } = this.app.status;
        byId("share").hidden = !this.seen || eye.length === 0; // the view is known from the first status on
        if (!mode || !this.live) return void (byId("pill-text").textContent = "");
        const { paths, part } = this.app.image;
        const motion = paused ? t("paused") : paths && part < 1 ? t("rendering", number(100 * part))
            : this.exact ? t("refined") : idle ? t("idle") : t("fps", number(fps));
        const role = this.app.drives() ? "" : " · " + this.driverText();
        byId("pill-text").textContent = t(mode) + " · " + motion + role;
        // Screen readers hear what changed, not each rate, and the place once it is reached.
        const quiet = t(mode) + ", " + (idle ? t("idleAt", eye.map((part) => number(part, 1)).join("; ")) : t("moving"))
            + role;
        if (quiet !== this.said) byId("live").textContent = this.said = quiet;
    }
}
