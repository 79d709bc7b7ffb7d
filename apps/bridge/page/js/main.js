/** Wires the page: what the bridge says goes to the image, the panels and the notices; what hands do goes to the bridge. */
import { Around } from "./around.js";
import { byId } from "./dom.js";
import { Edits } from "./edits.js";
import { readFragment } from "./fragment.js";
import { toggleFullScreen } from "./full_screen.js";
import { Gamepad } from "./gamepad.js";
import { Held } from "./held.js";
import { Input } from "./input.js";
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
import { Statistics } from "./statistics.js";
import { startStream } from "./stream_start.js";
import { followPreference, forThisTab, preference } from "./storage.js";
import { number, t } from "./texts.js";
import { Touch } from "./touch.js";
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
const stream = startStream(canvas, (what) => (what.drawn ? onDrawn(what) : link.heard(what)));
const link = new Link(stream, () => ({ token: forThisTab.get("rt.token") ?? "", instance: forThisTab.get("rt.instance") ?? "", name: preference("name", ""),
    view: pixels(), codecs: ["jpeg", "png"] }));
link.connect(); // what it says comes after the last line of this module
app.edits = new Edits((what, keys) => link.request(what, keys), ({ text }) => text && app.notices.show("failed", text, { warn: true }));
const held = new Held((message) => app.drives() && link.send(message));
app.pixels = pixels;
const picture = (app.picture = new Picture(canvas));
const panels = new Panels([viewsPanel, lightsPanel, skyPanel, modelPanel, settingsPanel, peoplePanel, pagePanel].map((make) => make(app)), () => sendView());
app.statistics.onChange = () => panels.show();
const around = new Around(app);

// Hands
let speed = 1;
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
        around.walked = true;
        keepAwakeForNow();
        byId("pads").hidden = false;
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
        const [ex, ey, ez, fx, fy, fz, fov] = asked;
        asked = null;
        app.ask("camera", { eye: [ex, ey, ez], forward: [fx, fy, fz], ...(fov ? { fov } : {}) });
    };
    if (app.drives()) return go();
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
    app.lost = false;
    app.welcome = welcome;
    around.setLive(true);
    if (other) panels.empty();
    around.showWaiting("firstFrame");
    sendView();
});
on("roles", (roles) => {
    const drove = app.drives();
    app.roles = roles;
    if (drove && !app.drives()) letGo();
    if (!drove && app.drives()) app.notices.hide("driver");
    canvas.classList.toggle("drives", app.drives());
    around.showHint();
    around.showStatus();
    offerView();
    panels.show();
});
on("state", ({ event: _, values, ...rest }) => {
    app.state = { ...app.state, ...rest, values: { ...app.state.values, ...values } };
    around.showHeader();
    panels.show();
});
on("status", ({ event: _, ...status }) => {
    const first = !app.status.eye;
    app.status = app.statistics.status = status;
    if (first) offerView();
    around.showStatus();
    panels.show();
});
on("link", (facts) => {
    if (app.statistics.link && facts.divide > app.statistics.link.divide) app.notices.show("slow", t("slow", facts.divide));
    app.statistics.link = facts;
});
on("server", ({ state, text }) => {
    const key = "server";
    around.setLive(state === "there" || state === "busy");
    if (state === "there") {
        app.notices.hide(key);
        if (!around.seen) around.showWaiting("firstFrame");
        return;
    }
    if (state !== "busy") letGo();
    if (state === "gone" && !around.seen) return around.showWaiting("noServer");
    app.notices.show(key, state === "refused" ? t("refused", text) : t(state), { lasting: true, warn: true });
});
on("message", ({ kind, text }) => app.notices.show("message", text, { warn: kind === "warning" }));
on("notice", ({ code, text, by }) => {
    const person = (id) => personName(app.roles.people.find((one) => one.id === id) ?? { id });
    const told = {
        asked: () => app.notices.show("asked", t("asksYou", person(by)), { lasting: true, actions: [[t("giveTo"), () => app.ask("give", { to: by })], [t("keep"), () => app.ask("keep")]] }),
        handed: () => app.roles.people.length > 1 && app.notices.show("role", t("handed")), // alone, that is no news
        taken: () => (app.notices.hide("asked"), app.notices.show("role", t("taken", person(app.roles.driver)))),
        elsewhere: () => app.notices.show("elsewhere", t("elsewhere")),
        released: () => app.notices.show("released", t("released")),
    }[code];
    if (told) told();
    else app.notices.show("notice", text, { warn: true });
});
on("lost", ({ code, reason, final }) => {
    letGo();
    around.setLive(false);
    app.notices.hide("server");
    const wasGreeted = Boolean(app.welcome);
    app.lost = wasGreeted;
    app.roles = { driver: null, asking: [], people: [] };
    panels.show();
    around.showHint();
    if (!final) return wasGreeted ? app.notices.show("link", t("lost"), { lasting: true, warn: true, actions: [[t("tryAgain"), () => link.hurry()]] }) : around.showWaiting("connecting");
    around.showWaiting("");
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

// Buttons and keys of the page
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
