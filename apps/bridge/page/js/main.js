/** Wires the page: what the bridge says goes to the image, the panels and the notices; what hands do goes to the bridge. */
import { byId, name } from "./dom.js";
import { Edits } from "./edits.js";
import { readFragment } from "./fragment.js";
import { Gamepad } from "./gamepad.js";
import { Held } from "./held.js";
import { Input, toggleFullScreen } from "./input.js";
import { Link } from "./link.js";
import { Notices } from "./notices.js";
import { lightsPanel } from "./panel_lights.js";
import { modelPanel } from "./panel_model.js";
import { pagePanel } from "./panel_page.js";
import { peoplePanel, personName } from "./panel_people.js";
import { settingsPanel } from "./panel_settings.js";
import { skyPanel } from "./panel_sky.js";
import { download, viewsPanel } from "./panel_views.js";
import { Panels } from "./panels.js";
import { Picture } from "./picture.js";
import { editLabel } from "./setting_labels.js";
import { Statistics } from "./statistics.js";
import { followPreference, forThisTab, preference } from "./storage.js";
import { number, t } from "./texts.js";
import { Touch } from "./touch.js";
import { viewMessage } from "./wire.js";

const canvas = byId("view"), stage = byId("stage");

/** Everything that panels share. */
const app = {
    welcome: null,
    state: {},
    status: {},
    roles: { driver: null, asking: [], people: [] },
    notices: new Notices(),
    statistics: new Statistics(),
    drives: () => link.greeted && app.roles.driver === app.welcome?.you,
    mayEdit: () => app.drives() && !app.welcome.locked.includes("edits"),
    /** A request whose failure is told. */
    async ask(what, keys) {
        const answer = await link.request(what, keys);
        if (!answer.ok && answer.text) app.notices.show("failed", answer.text, { warn: true });
        return answer;
    },
    edit: (thing, what, keys, goesOn) => app.edits.edit(thing, what, keys, goesOn),
    async askToDrive() {
        const { ok } = await app.ask("ask");
        if (ok && !app.drives()) app.notices.show("ask", t("asking"));
    },
    goTo(instance) {
        forThisTab.set("rt.instance", instance);
        link.again();
    },
};

// The token leaves the address at once: it stands in no history, and in no picture of the window.
let asked = null;
function takeFragment() {
    const { token, view } = readFragment(location.hash);
    if (token) forThisTab.set("rt.token", token);
    if (view) asked = view;
    if (location.hash) history.replaceState(null, "", location.pathname + location.search);
    return Boolean(token);
}
takeFragment();
addEventListener("hashchange", () => {
    if (takeFragment()) link.again();
    else offerView();
});

const pixels = () => ({ w: Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio)), h: Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio)) });
const link = new Link(() => ({ token: forThisTab.get("rt.token") ?? "", instance: forThisTab.get("rt.instance") ?? "", name: preference("name", ""),
    view: pixels(), codecs: ["jpeg", "png"] }));
app.edits = new Edits((what, keys) => link.request(what, keys), ({ text }) => text && app.notices.show("failed", text, { warn: true }));
const held = new Held((message) => app.drives() && link.send(message));
app.pixels = pixels;
const picture = (app.picture = new Picture(canvas, (ack) => link.send(ack), onDrawn));
const panels = new Panels([viewsPanel, lightsPanel, skyPanel, modelPanel, settingsPanel, peoplePanel, pagePanel].map((make) => make(app)), onResize);
app.statistics.onChange = () => panels.show();

// Hands
let speed = 1, walked = false;
const hands = {
    mayCapture: () => app.drives() || (offerDriving(), false),
    mayDrive: () => app.drives() || (offerDriving(), false),
    captured: onCaptured,
    wheel(steps) {
        if (!app.drives()) return;
        speed = Math.min(1000, Math.max(0.001, speed * 1.15 ** steps));
        app.edit("speed", "speed", { factor: speed });
        app.notices.show("speed", t("speed", number(speed, 2)));
    },
    pointed(clientX, clientY) {
        const at = picture.at(clientX, clientY), { fov } = app.status;
        if (!at || !fov || !app.drives()) return;
        const wide = Math.tan((fov * Math.PI) / 360), degrees = 180 / Math.PI;
        held.turn(Math.atan((2 * at.x - 1) * wide) * degrees, Math.atan(((1 - 2 * at.y) * wide) / picture.aspect) * degrees);
    },
    async focused(clientX, clientY) {
        const at = picture.at(clientX, clientY);
        if (at && app.drives() && (await app.ask("focus", at)).ok) app.notices.show("focus", t("focusSet"));
    },
    used() {
        walked = true;
        byId("pads").hidden = false;
        showHint();
    },
};
const input = new Input(canvas, held, hands);
new Touch(canvas, held, hands);
new Gamepad(held, () => app.drives());

let wake = null;
async function onCaptured(kind) {
    walked ||= kind !== "";
    stage.classList.toggle("captured", kind !== "");
    canvas.classList.toggle("captured", kind === "drag");
    if (kind !== "") app.notices.show("captured", t(kind === "lock" ? "captured" : "capturedDrag"));
    else app.notices.hide("captured");
    showHint();
    if (kind === "" || wake) return void (kind === "" && (wake?.release(), (wake = null)));
    try {
        wake = await navigator.wakeLock?.request("screen");
    } catch { /* not everywhere allowed */ }
}

function offerDriving() {
    if (!link.greeted) return;
    const driver = app.roles.people.find(({ id }) => id === app.roles.driver);
    const text = driver ? t("watching", personName(driver)) : t("watchingFree");
    const actions = app.welcome.mayDrive ? [[t("ask"), () => app.askToDrive()]] : [];
    app.notices.show("driver", app.welcome.mayDrive ? text : text + " · " + t("viewOnly"), { actions });
}

/** A link to a view: the driver goes there, others are offered to ask. */
function offerView() {
    if (!asked || !app.status.eye) return;
    const go = () => {
        const [ex, ey, ez, fx, fy, fz, fov] = asked;
        asked = null;
        app.ask("camera", { eye: [ex, ey, ez], forward: [fx, fy, fz], ...(fov ? { fov } : {}) });
    };
    if (app.drives()) return go();
    const actions = app.welcome?.mayDrive ? [[t("ask"), () => app.askToDrive()]] : [];
    app.notices.show("view", t("viewAsked"), { lasting: true, actions: [...actions, [t("close"), () => (asked = null)]] });
}

// The image
let seen = false, exact = false;
function onDrawn(header) {
    if (!seen) {
        seen = true;
        showWaiting();
        showHint();
    }
    exact = header.exact;
    byId("save").disabled = !exact;
    name(byId("save"), t(exact ? "save" : "saveWait"));
    app.statistics.drawn(header, header.input ? held.since(header.input) : null);
    showPill();
}

function onResize() {
    sendView();
}
function sendView() {
    const { w, h } = pixels();
    link.send(viewMessage({ visible: !document.hidden, rung: Number(preference("rung", "255")), save: preference("saveData", "false") === "true", width: w, height: h }));
}
new ResizeObserver(onResize).observe(canvas);
document.addEventListener("visibilitychange", sendView);
for (const what of ["rung", "saveData"]) followPreference(what, "", sendView);
followPreference("theme", "", (theme) => {
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
});

// What the bridge says
const on = (event, what) => link.addEventListener(event, ({ detail }) => what(detail));

let waitingFor = "connecting";
function showWaiting(what = waitingFor) {
    waitingFor = what;
    byId("waiting").hidden = seen || what === "";
    byId("waiting-text").textContent = what === "" ? "" : t(what);
}

on("binary", (buffer) => picture.take(buffer));
on("welcome", (welcome) => {
    const other = JSON.stringify(app.welcome?.settings) !== JSON.stringify(welcome.settings) || app.welcome?.instance !== welcome.instance;
    if (app.lost) app.notices.show("link", t("back"));
    app.lost = false;
    app.welcome = welcome;
    canvas.classList.remove("stale");
    if (other) panels.empty();
    showWaiting("firstFrame");
    sendView();
});
on("roles", (roles) => {
    const drove = app.drives();
    app.roles = roles;
    if (drove && !app.drives()) letGo();
    if (!drove && app.drives()) app.notices.hide("driver");
    canvas.classList.toggle("drives", app.drives());
    showHint();
    showPill();
    offerView();
    panels.show();
});
on("state", ({ event: _, values, ...rest }) => {
    app.state = { ...app.state, ...rest, values: { ...app.state.values, ...values } };
    showHeader();
    panels.show();
});
on("status", ({ event: _, ...status }) => {
    const first = !app.status.eye;
    app.status = app.statistics.status = status;
    if (first) offerView();
    showPill();
    panels.show();
});
on("link", (facts) => {
    if (app.statistics.link && facts.divide > app.statistics.link.divide) app.notices.show("slow", t("slow", facts.divide));
    app.statistics.link = facts;
});
on("server", ({ state, text }) => {
    const key = "server";
    canvas.classList.toggle("stale", state === "gone" || state === "refused");
    if (state === "there") {
        app.notices.hide(key);
        if (!seen) showWaiting("firstFrame");
        return;
    }
    if (state !== "busy") letGo();
    if (state === "gone" && !seen) return showWaiting("noServer");
    app.notices.show(key, state === "refused" ? t("refused", text) : t(state), { lasting: true, warn: true });
});
on("message", ({ kind, text }) => app.notices.show("message", text, { warn: kind === "warning" }));
on("notice", ({ code, text, by }) => {
    const person = (id) => personName(app.roles.people.find((one) => one.id === id) ?? { id });
    const told = {
        asked: () => app.notices.show("asked", t("asksYou", person(by)), { lasting: true, actions: [[t("giveTo"), () => app.ask("give", { to: by })], [t("keep"), () => app.ask("keep")]] }),
        handed: () => app.notices.show("role", t("handed")),
        taken: () => (app.notices.hide("asked"), app.notices.show("role", t("taken", person(app.roles.driver)))),
        elsewhere: () => app.notices.show("elsewhere", t("elsewhere")),
        released: () => app.notices.show("released", t("released")),
    }[code];
    if (told) told();
    else app.notices.show("notice", text, { warn: true });
});
on("lost", ({ code, reason, final }) => {
    letGo();
    canvas.classList.add("stale");
    const wasGreeted = Boolean(app.welcome);
    app.lost = wasGreeted;
    app.roles = { driver: null, asking: [], people: [] };
    panels.show();
    showHint();
    if (!final) return wasGreeted ? app.notices.show("link", t("lost"), { lasting: true, warn: true, actions: [[t("tryAgain"), () => link.hurry()]] }) : showWaiting("connecting");
    showWaiting("");
    const reload = [t("reload"), () => location.reload()];
    if (code === 4004) {
        const names = reason.split(" ").filter(Boolean);
        return app.notices.show("link", t("noInstance"), { lasting: true, warn: true, actions: names.map((one) => [one, () => app.goTo(one)]) });
    }
    const texts = { 4002: "malformed", 4003: forThisTab.get("rt.token") ? "tokenOld" : "noToken", 4010: "versionOld" };
    app.notices.show("link", t(texts[code]), { lasting: true, warn: true, actions: code === 4003 ? [] : [reload] });
});

function letGo() {
    input.release();
    held.release();
}

// What stands around the image
function showHeader() {
    const { scene = "", undo = "", redo = "", mayUndo, mayRedo } = app.state;
    byId("scene").textContent = scene;
    document.title = scene ? t("titleOf", scene) : t("title");
    byId("title").textContent = document.title;
    byId("undo").disabled = !mayUndo;
    byId("redo").disabled = !mayRedo;
    name(byId("undo"), undo ? t("undoOf", editLabel(undo)) : t("undo"));
    name(byId("redo"), redo ? t("redoOf", editLabel(redo)) : t("redo"));
}

let said = "";
function showPill() {
    const { mode, fps = 0, idle, paused } = app.status;
    if (!mode) return;
    const motion = paused ? t("paused") : exact ? t("refined") : idle ? t("idle") : t("fps", number(fps));
    const driver = app.roles.people.find(({ id }) => id === app.roles.driver);
    const role = app.drives() ? "" : " · " + (driver ? t("watching", personName(driver)) : t("watchingFree"));
    byId("pill-text").textContent = t(mode) + " · " + motion + role;
    // Screen readers hear what changed, not each rate.
    const quiet = t(mode) + (idle ? ", " + t("idle") : "") + role;
    if (quiet !== said) byId("live").textContent = said = quiet;
}

const byTouch = matchMedia("(pointer: coarse)").matches;
function showHint() {
    const hint = byId("hint");
    hint.hidden = walked || !seen || !app.drives();
    hint.textContent = hint.hidden ? "" : t(byTouch ? "hintTouch" : "hint");
}

byId("full").addEventListener("click", toggleFullScreen);
byId("full").hidden = !document.fullscreenEnabled;
byId("undo").addEventListener("click", () => app.ask("undo"));
byId("redo").addEventListener("click", () => app.ask("redo"));
byId("save").addEventListener("click", () => {
    if (!picture.exact) return;
    download((app.state.scene?.replace(/\.\w+$/, "") || "image") + ".png", new Blob([picture.exact], { type: "image/png" }));
});
addEventListener("keydown", (event) => {
    if (event.code === "F3" && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        app.statistics.toggle();
    } else if (event.code === "KeyZ" && (event.ctrlKey || event.metaKey) && !event.altKey && !(event.target instanceof HTMLInputElement)) {
        event.preventDefault();
        app.ask(event.shiftKey ? "redo" : "undo");
    }
});

for (const [id, text] of [["menu", "menu"], ["close", "close"], ["full", "full"], ["pad-fly", "padFly"], ["pad-jump", "padJump"], ["pad-crouch", "padCrouch"], ["save", "saveWait"]])
    name(byId(id), t(text));
byId("save").disabled = true;
canvas.setAttribute("aria-label", t("view"));
byId("corner").setAttribute("aria-label", t("menu"));
byId("pads").setAttribute("aria-label", t("pads"));
byId("tabs").setAttribute("aria-label", t("menu"));
byId("drawer").setAttribute("aria-label", t("menu"));
showHeader();
showWaiting();
link.connect();
