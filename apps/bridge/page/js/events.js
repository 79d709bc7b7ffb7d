/** Passes messages of the bridge to the image, the panels and the notices. */
import { byId } from "./dom.js";
import { nameSettings, settingLabel } from "./setting_labels.js";
import { said, t } from "./texts.js";

const BUSY_MS = 500; // shorter ones are not worth a word

/** A setting, the size or an edit that was undone. */
const heavyName = (name) => (name === "size" || name === "lastEdit" ? t(name) : settingLabel(name));

/**
 * @param {App} app with `around`, `driving`, `orbit`, `panels`, `picture`, `upright`
 * @param {{admission: Token, asked: AskedView, canvas: HTMLCanvasElement, sendView: () => void}} page
 */
export function followBridge(app, { admission, asked, canvas, sendView }) {
    const { around, driving, link, notices, panels } = app;
    const on = (event, what) => link.addEventListener(event, ({ detail }) => what(detail));

    on("welcome", (welcome) => {
        const before = app.welcome, another = before && before.instance !== welcome.instance;
        if (app.lost) notices.show("link", t("back"));
        else notices.hide("link");
        app.lost = false;
        driving.forget();
        if (another) forgetServer();
        app.welcome = welcome;
        nameSettings(welcome.labels);
        admission.welcome(welcome.token);
        around.setLive(true);
        if (another || JSON.stringify(before?.settings) !== JSON.stringify(welcome.settings)) panels.empty();
        around.showWaiting("firstFrame");
        sendView();
    });

    function forgetServer() {
        app.forgetServer();
        app.upright.forget();
        app.picture.exact = null;
        around.forget();
    }

    on("roles", (roles) => {
        const drove = app.drives();
        app.roles = roles;
        if (drove && !app.drives()) app.letGo();
        if (!drove && app.drives()) notices.hide("driver");
        if (!app.drives()) byId("pads").hidden = true;
        driving.follow(drove);
        canvas.classList.toggle("drives", app.drives());
        around.showHeader();
        around.showOrbit();
        around.showStatus();
        asked.offer();
        app.showMarks();
        panels.show();
    });

    on("state", ({ event: _, values, ...rest }) => {
        const { scene, indoors } = app.state;
        app.state = { ...app.state, ...rest, values: { ...app.state.values, ...values } };
        // A whole state comes after each loss of the link, too: hands go on as they were.
        const another = scene !== app.state.scene || indoors !== app.state.indoors;
        if (another) app.orbit.begin(app.state.indoors);
        app.showMarks();
        around.showHeader();
        panels.show();
    });

    on("status", ({ event: _, ...status }) => {
        const first = !app.status.eye;
        app.follow(status);
        if (first) asked.offer();
        app.upright.follow();
        app.showMarks();
        around.showStatus();
        panels.show();
    });

    on("link", (facts) => {
        const { statistics } = app;
        if (statistics.link && facts.divide > statistics.link.divide) notices.show("slow", t("slow", facts.divide));
        statistics.link = facts;
    });

    on("image", ({ event: _, ...image }) => {
        app.image = app.statistics.image = image;
        around.showStatus();
        app.statistics.show();
    });

    let busyTimer = 0;
    function showBusy(on) {
        clearTimeout(busyTimer);
        if (on) busyTimer = setTimeout(tellBusy, BUSY_MS);
        else byId("busy").hidden = true;
    }
    function tellBusy() {
        byId("busy").hidden = !around.seen; // before the first frame another one turns
        notices.show("server", t("busy"), { lasting: true, warn: true });
    }

    let server = null; // the last of these events
    on("server", async (event) => {
        server = event;
        const { state } = event;
        const key = "server";
        showBusy(state === "busy");
        around.setLive(state === "there" || state === "busy");
        if (state === "there") {
            notices.hide(key);
            if (!around.seen) around.showWaiting("firstFrame");
            return;
        }
        if (state === "busy") return;
        app.letGo();
        app.speed = 1;
        if (state === "gone" && !around.seen) return around.showWaiting("noServer");
        const text = state === "refused" ? t("refused", await said(event)) : t(state);
        if (event === server) notices.show(key, text, { lasting: true, warn: true });
    });

    on("message", async (message) => notices.show("message", await said(message),
        { warn: message.kind === "warning" }));

    on("notice", (notice) => {
        const { code, back } = notice;
        const told = {
            asked: () => {}, // the roles that follow tell it, as what `taken` says
            handed: () => app.roles.people.length > 1 && notices.show("role", t("handed")), // alone, that is no news
            taken: () => notices.hide("asked"),
            heavy: () => notices.show("notice", t("heavy", back.map(heavyName).join(", ")), { warn: true }),
            elsewhere: () => notices.show("elsewhere", t("elsewhere")),
            released: () => notices.show("released", t("released")),
        }[code];
        if (told) told();
        else said(notice).then((text) => notices.show("notice", text, { warn: true }));
    });

    on("lost", ({ code, reason, final }) => {
        app.letGo();
        app.measures.stop();
        app.notes.stop();
        showBusy(false);
        around.setLive(false);
        notices.hide("server");
        const wasGreeted = Boolean(app.welcome);
        app.lost = wasGreeted;
        app.roles = { driver: null, asking: [], people: [] };
        driving.forget();
        byId("pads").hidden = true;
        panels.show();
        around.showHeader();
        around.showHint();
        if (final) return tellEnd(code, reason);
        if (!wasGreeted) return around.showWaiting("connecting");
        const actions = [[t("tryAgain"), () => link.hurry()]];
        notices.show("link", t("lost"), { lasting: true, warn: true, stays: true, actions });
    });

    /** Another try would end the same way. */
    function tellEnd(code, reason) {
        around.showWaiting("");
        if (code === 4005 && admission.goBack()) {
            notices.show("used", t("linkUsed"), { warn: true });
            return link.again();
        }
        const lasting = { lasting: true, warn: true };
        if (code === 4004) {
            const actions = reason.split(" ").filter(Boolean).map((one) => [one, () => app.goTo(one)]);
            return notices.show("link", t("noInstance"), { ...lasting, actions });
        }
        const texts = { 4002: "malformed", 4003: admission.current ? "tokenOld" : "noToken", 4005: "linkUsed",
            4010: "versionOld" };
        const actions = code === 4003 || code === 4005 ? [] : [[t("reload"), () => location.reload()]];
        notices.show("link", t(texts[code]), { ...lasting, actions });
    }
}
