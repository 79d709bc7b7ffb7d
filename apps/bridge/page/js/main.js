/** Wires the page: what the bridge says goes to the image, the panels and the notices; what hands do goes to the bridge. */
import { Around } from "./around.js";
import { directionThrough, turnTo } from "./directions.js";
import { byId } from "./dom.js";
import { Driving } from "./driving.js";
import { Edits } from "./edits.js";
import { showFocusedAgain } from "./fields.js";
import { readFragment } from "./fragment.js";
import { toggleFullScreen } from "./full_screen.js";
import { Gamepad } from "./gamepad.js";
import { Held } from "./held.js";
import { Input } from "./input.js";
import { Link } from "./link.js";
import { Notices } from "./notices.js";
import { Orbit } from "./orbit.js";
import { lightsPanel } from "./panel_lights.js";
import { modelPanel } from "./panel_model.js";
import { pagePanel } from "./panel_page.js";
import { peoplePanel } from "./panel_people.js";
import { settingsPanel } from "./panel_settings.js";
import { nameSettings, settingLabel } from "./setting_labels.js";
import { skyPanel } from "./panel_sky.js";
import { download, viewsPanel } from "./panel_views.js";
import { Panels } from "./panels.js";
import { Picture } from "./picture.js";
import { Statistics } from "./statistics.js";
import { startStream } from "./stream_start.js";
import { Steps } from "./steps.js";
import { followPreference, forThisTab, preference } from "./storage.js";
import { number, t } from "./texts.js";
import { Token } from "./token.js";
import { Touch } from "./touch.js";
import { Upright } from "./upright.js";
import { keepAwake } from "./wake_lock.js";
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
    driver: () => app.roles.people.find(({ id }) => id === app.roles.driver),
    speed: 1, // factor of flying, as long as this page knows the server
    drives: () => link.greeted && app.roles.driver === app.welcome?.you,
    mayEdit: () => app.drives() && !app.welcome.locked.includes("edits"),
    /** A command of the server's table; a failure is told. */
    ask: (what, ...args) => app.request(what, { args }),
    /** A request of the bridge's own, about roles. */
    async request(what, keys) {
        const answer = await link.request(what, keys);
        if (!answer.ok) tellRefusal(answer);
        return answer;
    },
    /** An argument of a command: `min`, `max`, `words`. */
    argument: (command, index) => app.welcome?.commands[command]?.[index] ?? {},
    lightKind: (name) => app.welcome?.lightKinds.find((kind) => kind.name === name) ?? {},
    orbits: () => orbit.is,
    edit: (thing, what, args, goesOn) => app.edits.edit(thing, what, { args }, goesOn),
    askToDrive: () => app.request("ask"), // roles tell the rest
    setSpeed(factor) {
        const { min, max } = app.argument("speed", 0);
        app.speed = Math.min(max, Math.max(min, factor));
        app.edit("speed", "speed", [app.speed]);
        panels.show();
    },
    async focus({ x, y }) {
        if ((await app.ask("focus", x, y)).ok) app.notices.show("focus", t("focusSet"));
    },
    goTo(instance) {
        forThisTab.set("rt.instance", instance);
        link.again();
    },
};

// The token leaves the address at once: it stands in no picture of the window. Browsers keep it nevertheless.
const admission = new Token();
let asked = null, wasOffered = false;
function takeFragment() {
    const { token, view } = readFragment(location.hash);
    if (token) admission.open(token);
    if (view) {
        asked = view;
        wasOffered = false;
    }
    if (location.hash) history.replaceState(null, "", location.pathname + location.search);
    return Boolean(token);
}
takeFragment();
addEventListener("hashchange", () => {
    if (takeFragment()) link.again();
    else offerView();
});

const pixels = () => ({ w: Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio)), h: Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio)) });
const stream = startStream(canvas, (what) => (what.drawn ? onDrawn(what) : link.heard(what)));
const link = new Link(stream, () => ({ token: admission.current, instance: forThisTab.get("rt.instance") ?? "", name: preference("name", ""),
    view: pixels(), codecs: ["jpeg", "png"] }));
link.connect(); // what it says comes after the last line of this module
app.edits = new Edits((what, keys) => link.request(what, keys), tellRefusal);
const held = new Held((message) => app.drives() && link.send(message));
app.pixels = pixels;
const picture = (app.picture = new Picture(canvas));
const upright = new Upright({ drives: () => app.drives(), size: () => ({ width: app.status.width, height: app.status.height }), room: pixels,
    resize: (width, height) => link.request("resolution", { args: [width, height] }) });
const orbit = new Orbit(picture, { ask: app.ask, range: app.argument, changed: () => onOrbit() });
const panels = new Panels([viewsPanel, lightsPanel, skyPanel, modelPanel, settingsPanel, peoplePanel, pagePanel].map((make) => make(app)), () => sendView());
app.statistics.onChange = () => panels.show();
const around = new Around(app), driving = new Driving(app);

/** What was asked for is not so: panels show what is. */
function tellRefusal({ text }) {
    if (text) app.notices.show("failed", text, { warn: true });
    panels.show();
    showFocusedAgain();
}

/** The same view goes on in other hands. */
function onOrbit() {
    input.release();
    around.showOrbit();
}

// Hands
const hands = {
    orbit,
    fit() {
        orbit.forget();
        app.ask("camera fit");
    },
    mayCapture: () => app.drives() || (offerDriving(), false),
    mayDrive: () => app.drives() || (offerDriving(), false),
    captured: onCaptured,
    wheel(steps) {
        if (!app.drives()) return;
        app.setSpeed(app.speed * 1.15 ** steps);
        app.notices.show("speed", t(app.status.mode === "fly" ? "speed" : "speedLater", number(app.speed, 2)));
    },
    pointed(clientX, clientY) {
        const at = picture.at(clientX, clientY), { status } = app;
        if (!at || !status.fov || !app.drives()) return;
        const direction = directionThrough(status, 2 * at.x - 1, 1 - 2 * at.y, picture.aspect);
        const { right, up } = turnTo(status, app.state.up ?? status.up, direction);
        held.turn(right, up);
    },
    focused(clientX, clientY) {
        const at = picture.at(clientX, clientY);
        if (at && app.drives()) app.focus(at);
    },
    used() {
        around.walked = true;
        keepAwakeForNow();
        byId("pads").hidden = orbit.is;
        around.showHint();
    },
};
const input = new Input(canvas, held, hands);
new Touch(canvas, held, hands);
new Gamepad(held, () => app.drives());

/** Hands that capture nothing tell of no end. */
let awakeUntil = 0;
function keepAwakeForNow() {
    clearTimeout(awakeUntil);
    awakeUntil = setTimeout(() => stage.classList.contains("captured") || keepAwake(false), 60000);
    keepAwake(true);
}

function onCaptured(kind) {
    around.walked ||= kind !== "";
    stage.classList.toggle("captured", kind !== "");
    canvas.classList.toggle("captured", kind === "drag");
    if (kind === "") app.notices.hide("captured");
    else app.notices.show("captured", t(kind === "lock" ? "captured" : "capturedDrag"));
    around.showHint();
    keepAwake(kind !== "");
}

function offerDriving() {
    if (!link.greeted) return;
    const text = around.driverText();
    const actions = app.welcome.mayDrive ? [[t("ask"), () => app.askToDrive()]] : [];
    app.notices.show("driver", app.welcome.mayDrive ? text : text + " · " + t("viewOnly"), { actions });
}

/** A link to a view: the driver goes there, others are offered to ask. */
function offerView() {
    if (!asked || !app.status.eye) return;
    const go = () => {
        const view = asked; // eye, direction, field of view
        asked = null;
        app.notices.hide("view");
        app.ask("camera set", ...view);
    };
    if (app.drives()) return go();
    if (wasOffered) return;
    wasOffered = true;
    const actions = app.welcome?.mayDrive ? [[t("ask"), () => app.askToDrive()]] : [];
    app.notices.show("view", t("viewAsked"), { lasting: true, actions: [...actions, [t("close"), () => (asked = null)]] });
}

// The image
function onDrawn({ drawn, still }) {
    picture.drew(drawn, still);
    around.showFrame(still !== undefined);
    app.statistics.drawn(drawn, drawn.input ? held.until(drawn.at, drawn.input) : null);
}

function sendView() {
    const { w, h } = pixels();
    link.send(viewMessage({ visible: !document.hidden, rung: Number(preference("rung", "255")), save: preference("saveData", "false") === "true", width: w, height: h }));
}
new ResizeObserver(sendView).observe(canvas);
document.addEventListener("visibilitychange", sendView);
for (const what of ["rung", "saveData"]) followPreference(what, "", sendView);
followPreference("theme", "", (theme) => {
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
});

// What the bridge says
const on = (event, what) => link.addEventListener(event, ({ detail }) => what(detail));

on("welcome", (welcome) => {
    const other = JSON.stringify(app.welcome?.settings) !== JSON.stringify(welcome.settings) || app.welcome?.instance !== welcome.instance;
    if (app.lost) app.notices.show("link", t("back"));
    else app.notices.hide("link");
    app.lost = false;
    driving.forget();
    if (app.welcome && app.welcome.instance !== welcome.instance) forgetServer();
    app.welcome = welcome;
    nameSettings(welcome.labels);
    admission.welcome(welcome.token);
    around.setLive(true);
    if (other) panels.empty();
    around.showWaiting("firstFrame");
    sendView();
});
/** Another instance: nothing of what was shown is its. */
function forgetServer() {
    app.state = {};
    app.status = app.statistics.status = {};
    app.speed = 1;
    upright.forget();
    picture.exact = null;
    around.forget();
}
on("roles", (roles) => {
    const drove = app.drives();
    app.roles = roles;
    if (drove && !app.drives()) letGo();
    if (!drove && app.drives()) app.notices.hide("driver");
    if (!app.drives()) byId("pads").hidden = true;
    driving.follow(drove);
    canvas.classList.toggle("drives", app.drives());
    around.showHeader();
    around.showOrbit();
    around.showStatus();
    offerView();
    panels.show();
});
on("state", ({ event: _, values, ...rest }) => {
    app.state = { ...app.state, ...rest, values: { ...app.state.values, ...values } };
    if ("scene" in rest || "indoors" in rest) orbit.begin(app.state.indoors);
    around.showHeader();
    panels.show();
});
on("status", ({ event: _, ...status }) => {
    const first = !app.status.eye;
    app.status = app.statistics.status = status;
    if (first) offerView();
    upright.follow();
    around.showStatus();
    panels.show();
});
on("link", (facts) => {
    if (app.statistics.link && facts.divide > app.statistics.link.divide) app.notices.show("slow", t("slow", facts.divide));
    app.statistics.link = facts;
});
/** Shorter ones are not worth a word. */
const BUSY_MS = 500;
let busyTimer = 0;
function tellBusy() {
    byId("busy").hidden = !around.seen; // before the first frame another one turns
    app.notices.show("server", t("busy"), { lasting: true, warn: true });
}
on("server", ({ state, text }) => {
    const key = "server";
    clearTimeout(busyTimer);
    if (state === "busy") busyTimer = setTimeout(tellBusy, BUSY_MS);
    else byId("busy").hidden = true;
    around.setLive(state === "there" || state === "busy");
    if (state === "there") {
        app.notices.hide(key);
        if (!around.seen) around.showWaiting("firstFrame");
        return;
    }
    if (state === "busy") return;
    letGo();
    app.speed = 1;
    if (state === "gone" && !around.seen) return around.showWaiting("noServer");
    app.notices.show(key, state === "refused" ? t("refused", text) : t(state), { lasting: true, warn: true });
});
on("message", ({ kind, text }) => app.notices.show("message", text, { warn: kind === "warning" }));
on("notice", ({ code, text, back }) => {
    const told = {
        asked: () => {}, // the roles that follow tell it, as what `taken` says
        handed: () => app.roles.people.length > 1 && app.notices.show("role", t("handed")), // alone, that is no news
        taken: () => app.notices.hide("asked"),
        heavy: () => app.notices.show("notice", t("heavy", back.map(heavyName).join(", ")), { warn: true }),
        elsewhere: () => app.notices.show("elsewhere", t("elsewhere")),
        released: () => app.notices.show("released", t("released")),
    }[code];
    if (told) told();
    else app.notices.show("notice", text, { warn: true });
});
/** A setting, the size or an edit that was undone. */
const heavyName = (name) => (name === "size" || name === "lastEdit" ? t(name) : settingLabel(name));

on("lost", ({ code, reason, final }) => {
    letGo();
    clearTimeout(busyTimer);
    byId("busy").hidden = true;
    around.setLive(false);
    app.notices.hide("server");
    const wasGreeted = Boolean(app.welcome);
    app.lost = wasGreeted;
    app.roles = { driver: null, asking: [], people: [] };
    driving.forget();
    byId("pads").hidden = true;
    panels.show();
    around.showHeader();
    around.showHint();
    if (!final) return wasGreeted ? app.notices.show("link", t("lost"), { lasting: true, warn: true, stays: true, actions: [[t("tryAgain"), () => link.hurry()]] }) : around.showWaiting("connecting");
    around.showWaiting("");
    const reload = [t("reload"), () => location.reload()];
    if (code === 4005 && admission.goBack()) {
        app.notices.show("used", t("linkUsed"), { warn: true });
        return link.again();
    }
    if (code === 4004) {
        const names = reason.split(" ").filter(Boolean);
        return app.notices.show("link", t("noInstance"), { lasting: true, warn: true, actions: names.map((one) => [one, () => app.goTo(one)]) });
    }
    const texts = { 4002: "malformed", 4003: admission.current ? "tokenOld" : "noToken", 4005: "linkUsed", 4010: "versionOld" };
    app.notices.show("link", t(texts[code]), { lasting: true, warn: true, actions: code === 4003 || code === 4005 ? [] : [reload] });
});

function letGo() {
    input.release();
    orbit.forget();
    held.release();
}

// Buttons and keys of the page
byId("full").addEventListener("click", toggleFullScreen);
byId("full").hidden = !document.fullscreenEnabled;
byId("fit").addEventListener("click", () => hands.fit());
byId("orbit").addEventListener("click", () => orbit.choose(!orbit.is));
const steps = new Steps(app.ask, link);
for (const what of ["undo", "redo"]) byId(what).addEventListener("click", () => steps.take(what));
byId("save").addEventListener("click", () => {
    if (!picture.exact) return;
    download((app.state.scene?.replace(/\.\w+$/, "") || "image") + ".png", new Blob([picture.exact], { type: "image/png" }));
});
/** Whether an element takes its own typing back. */
const holdsText = (element) => element instanceof HTMLInputElement && !/^(range|checkbox|color|file)$/.test(element.type);

addEventListener("keydown", (event) => {
    if (event.defaultPrevented) return;
    if (event.code === "F3" && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        app.statistics.toggle();
    } else if (event.key?.toLowerCase() === "z" && (event.ctrlKey || event.metaKey) && !event.altKey && !holdsText(event.target)) {
        event.preventDefault();
        steps.take(event.shiftKey ? "redo" : "undo");
    }
});
