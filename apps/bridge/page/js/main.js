/**
 * Wires the page: what the bridge says goes to the image, the panels and the notices; what hands do goes to the bridge.
 */
import { App } from "./app.js";
import { Around } from "./around.js";
import { AskedView } from "./asked_view.js";
import { byId, make } from "./dom.js";
import { Driving } from "./driving.js";
import { followBridge } from "./events.js";
import { readFragment } from "./fragment.js";
import { toggleFullScreen } from "./full_screen.js";
import { connectHands } from "./hands.js";
import { Held } from "./held.js";
import { Link } from "./link.js";
import { Measures } from "./measures.js";
import { Notes } from "./notes.js";
import { Orbit } from "./orbit.js";
import { lightsPanel } from "./panel_lights.js";
import { modelPanel } from "./panel_model.js";
import { notesPanel } from "./panel_notes.js";
import { pagePanel } from "./panel_page.js";
import { peoplePanel } from "./panel_people.js";
import { sectionsPanel } from "./panel_sections.js";
import { settingsPanel } from "./panel_settings.js";
import { skyPanel } from "./panel_sky.js";
import { download, viewsPanel } from "./panel_views.js";
import { Panels } from "./panels.js";
import { Picture } from "./picture.js";
import { PlanButton } from "./plan_button.js";
import { shareView } from "./share.js";
import { startStream } from "./stream_start.js";
import { followPreference, forThisTab, preference } from "./storage.js";
import { t } from "./texts.js";
import { Token } from "./token.js";
import { Upright } from "./upright.js";
import { viewMessage } from "./wire.js";

const canvas = byId("view");
const pixels = () => ({
    w: Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio)),
    h: Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio)),
});

const admission = new Token();
const stream = startStream(canvas, (what) => (what.drawn ? onDrawn(what) : link.heard(what)));
const link = new Link(stream, () => ({ token: admission.current, instance: forThisTab.get("rt.instance") ?? "",
    name: preference("name", ""), view: pixels(), codecs: ["jpeg", "png"] }));
const app = new App(link, pixels), asked = new AskedView(app);

// The token leaves the address at once: it stands in no picture of the window. Browsers keep it nevertheless.
function takeFragment() {
    const { token, view } = readFragment(location.hash);
    if (token) admission.open(token);
    if (view) asked.take(view);
    if (location.hash) history.replaceState(null, "", location.pathname + location.search);
    return Boolean(token);
}
takeFragment();
addEventListener("hashchange", () => (takeFragment() ? link.again() : asked.offer()));
link.connect(); // its messages come after the last line of this module

app.held = new Held((message) => app.drives() && link.send(message));
app.picture = new Picture(canvas);
app.upright = new Upright({ drives: () => app.drives(), room: pixels,
    size: () => ({ width: app.status.width, height: app.status.height }),
    resize: (width, height) => link.request("resolution", { args: [width, height] }) });
app.orbit = new Orbit(app.picture, { ask: (...command) => app.ask(...command),
    range: (...which) => app.argument(...which),
    changed: () => onOrbit() });
/** Panels below each other: a phone has room for so many tabs. */
const joined = (...subjects) => (app) => {
    const [upper, ...lower] = subjects.map((subject) => subject(app));
    return {
        id: upper.id,
        fill(place) {
            upper.fill(place);
            for (const each of lower) {
                const part = make("div");
                place.append(make("h3", {}, t(each.id)), part);
                each.fill(part);
            }
        },
        show() {
            for (const each of [upper, ...lower]) each.show();
        },
    };
};
const panels = [viewsPanel, lightsPanel, skyPanel, joined(modelPanel, sectionsPanel, notesPanel), settingsPanel,
    peoplePanel, pagePanel];
app.panels = new Panels(panels.map((panel) => panel(app)), () => sendView());
app.statistics.onChange = () => app.panels.show();
app.measures = new Measures(app);
app.notes = new Notes(app);
app.plan = new PlanButton(app);
app.showMarks = () => [app.measures, app.notes, app.plan].forEach((marks) => marks.show());
app.around = new Around(app);
app.driving = new Driving(app);
connectHands(app, canvas);
followBridge(app, { admission, asked, canvas, sendView });

/** The same view goes on in other hands. */
function onOrbit() {
    app.input.release();
    app.around.showOrbit();
}

function onDrawn({ drawn, still }) {
    app.picture.drew(drawn, still);
    app.around.showFrame(still !== undefined);
    app.showMarks();
    app.statistics.drawn(drawn, drawn.input ? app.held.until(drawn.at, drawn.input) : null);
}

function sendView() {
    const { w, h } = pixels();
    link.send(viewMessage({ visible: !document.hidden, rung: Number(preference("rung", "255")),
        save: preference("saveData", "false") === "true", width: w, height: h }));
}
new ResizeObserver(sendView).observe(canvas);
document.addEventListener("visibilitychange", sendView);
for (const what of ["rung", "saveData"]) followPreference(what, "", sendView);
followPreference("theme", "", (theme) => {
    if (theme) document.documentElement.dataset.theme = theme;
    else delete document.documentElement.dataset.theme;
});

byId("share").addEventListener("click", () => shareView(app));
byId("full").addEventListener("click", toggleFullScreen);
byId("full").hidden = !document.fullscreenEnabled;
byId("save").addEventListener("click", () => {
    if (!app.picture.exact) return;
    const name = app.state.scene?.replace(/\.\w+$/, "") || "image";
    download(name + ".png", new Blob([app.picture.exact], { type: "image/png" }));
});
