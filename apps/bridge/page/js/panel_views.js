/**
 * Views: walk or fly, field of view, bookmarks of the scene and of this browser, measures, a link to what is seen.
 */
import { MAX_BOOKMARKS, checked, load, requestOf, store, viewOf } from "./bookmarks.js";
import { button, make, refill } from "./dom.js";
import { choice, numeric } from "./fields.js";
import { measureText } from "./measures.js";
import { copyView } from "./share.js";
import { counted, t } from "./texts.js";

const SPEED_STEP = 1.5, MEASURED = ["distance", "chain", "angle", "height", "area", "volume", "light"];
/** measureDistance for "distance". */
const kindText = (kind) => t("measure" + kind[0].toUpperCase() + kind.slice(1));
/** The text of a side: sideThreeQuarter for "three-quarter". */
const sideText = (side) => t(("side-" + side).replace(/-(\w)/g, (_, letter) => letter.toUpperCase()));

/** Offers bytes as a file. */
export function download(name, blob) {
    const link = make("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function viewsPanel(app) {
    let motion, angle, speed, middle, own, here, name, plus, copy, reset, sides, measured, taps, last = "";

    const instance = () => app.welcome?.instance ?? "", scene = () => app.state.scene ?? "";
    const stored = () => load(instance(), scene());
    /** False: there is no room. */
    const keep = (list) => {
        const kept = store(instance(), scene(), list);
        if (!kept) app.notices.show("bookmarks", t("bookmarkFull"), { warn: true });
        last = "";
        panel.show();
        return kept;
    };

    const tellFull = () => app.notices.show("bookmarks", t("bookmarkMost", MAX_BOOKMARKS), { warn: true });

    function add() {
        const list = stored();
        if (!app.status.eye) return;
        if (list.length >= MAX_BOOKMARKS) return tellFull();
        list.push({ name: name.value.trim() || t("bookmarkNew", list.length + 1), view: viewOf(app.status),
            image: app.picture.thumbnail(160, 90) });
        name.value = "";
        keep(list);
    }

    async function importFile(event) {
        const [file] = event.target.files;
        event.target.value = "";
        if (!file) return;
        let read = [];
        try {
            read = checked(JSON.parse(await file.text()).bookmarks);
        } catch { /* told below */ }
        if (read.length === 0) return app.notices.show("bookmarks", t("importBad"), { warn: true });
        const before = stored(), taken = read.slice(0, MAX_BOOKMARKS - before.length);
        if (!keep([...before, ...taken])) return;
        if (taken.length < read.length) tellFull();
        else app.notices.show("bookmarks", counted("importGood", taken.length));
    }

    function exportFile() {
        const text = JSON.stringify({ scene: scene(), bookmarks: stored() }, null, 1);
        download((scene().replace(/\.\w+$/, "") || "scene") + "-bookmarks.json",
            new Blob([text], { type: "application/json" }));
    }

    const item = (one, index, list) => make("li", {}, ...(one.image ? [make("img", { src: one.image, alt: "" })] : []),
        make("button", { type: "button", className: "name", title: t("bookmarkGo", one.name), disabled: !app.drives(),
            onclick: () => app.ask(...requestOf(one.view)) }, one.name),
        button(t("bookmarkRemove", one.name), () => keep(list.filter((_, at) => at !== index)), "close"));
    const ownItem = (text, index) => make("li", {}, make("button",
        { type: "button", className: "name", title: t("bookmarkGo", text), disabled: !app.drives(),
        onclick: () => app.ask("bookmark go", index + 1) }, text));

    const measureItem = (one, index) => {
        const text = (one.name ? one.name + " " : "") + kindText(one.kind) + " " + measureText(one, app.measures.unit);
        const remove = button(t("measureRemove", text), () => app.ask("measure remove", index + 1), "close");
        remove.disabled = !app.mayEdit();
        return make("li", {}, make("span", { className: "name" }, text), remove);
    };

    function addMeasures(place) {
        measured = make("ul", { className: "list", id: "measured" });
        taps = MEASURED.map((kind) => button(kindText(kind), () => app.measures.start(kind)));
        place.append(make("h3", {}, t("measures")), measured, make("div", { className: "actions" }, ...taps));
    }

    function showMeasures() {
        const { all } = app.measures, rest = (app.state.measures?.count ?? 0) - all.length;
        for (const tap of taps) tap.disabled = !app.mayEdit();
        const items = all.map(measureItem);
        const word = rest > 0 ? t("measuresMore", rest) : all.length === 0 ? t("bookmarksNone") : "";
        if (word) items.push(make("li", {}, make("span", { className: "dim" }, word)));
        refill(measured, items);
    }

    function addMotion(place) {
        motion = choice(t("motion"), [["walk", t("walk")], ["fly", t("fly")]], (what) => app.ask(what));
        angle = numeric(t("fieldOfView"), (degrees, goesOn) => app.edit("angle", "camera angle", [degrees], goesOn),
            { min: 10, max: 150, unit: "°" });
        speed = numeric(t("flightSpeed"), app.setSpeed, { ...app.argument("speed", 0), slider: false, unit: "×" });
        const step = (text, factor) => button(t(text), () => app.setSpeed(app.speed * factor));
        speed.steps = [step("slower", 1 / SPEED_STEP), step("faster", SPEED_STEP)];
        middle = button(t("focusMiddle"), () => app.focus({ x: 0.5, y: 0.5 }));
        copy = button(t("copyLink"), () => copyView(app));
        reset = button(t("resetView"), () => app.ask("camera reset"));
        sides = (app.argument("camera view", 0).words ?? []).map((side) =>
            button(sideText(side), () => app.ask("camera view", side)));
        place.append(motion.element, angle.element, speed.element,
            make("div", { className: "actions" }, ...speed.steps, middle),
            make("div", { className: "actions" }, copy, reset),
            make("h3", {}, t("seenFrom")), make("div", { className: "actions" }, ...sides));
    }

    const panel = {
        id: "views",
        fill(place) {
            last = "";
            addMotion(place);
            own = make("ul", { className: "list", id: "bookmarked" });
            here = make("ul", { className: "list" });
            name = make("input", { type: "text", maxLength: 40, placeholder: t("bookmarkName"),
                "aria-label": t("bookmarkName"),
                onkeydown: (event) => event.key === "Enter" && add() });
            plus = button(t("bookmarkAdd"), add);
            const file = make("input", { type: "file", accept: "application/json,.json", onchange: importFile,
                "aria-label": t("importAll") });
            place.append(make("h3", {}, t("bookmarksHere")), here,
                make("div", { className: "row wide" }, name, make("div", { className: "field" }, plus)),
                make("div", { className: "actions" }, button(t("exportAll"), exportFile),
                    make("label", { className: "file" }, t("importAll"), file)),
                make("h3", {}, t("bookmarksOwn")), own);
            addMeasures(place);
        },
        show() {
            const { mode, fov } = app.status, drives = app.drives();
            motion.show(mode === "fly" ? "fly" : "walk", drives);
            angle.element.hidden = !fov;
            if (fov && !app.edits.isBusy("angle")) angle.show(fov, drives);
            speed.show(app.speed, drives);
            for (const each of [...speed.steps, ...sides, middle, reset]) each.disabled = !drives;
            copy.disabled = plus.disabled = !app.status.eye;
            const list = stored(), scenes = app.state.bookmarks ?? [];
            const now = JSON.stringify([list, scenes, drives, app.mayEdit(), app.state.measures]);
            if (now === last) return;
            last = now;
            refill(here, list.length ? list.map(item) : [make("li", {},
                make("span", { className: "dim" }, t("bookmarksNone")))]);
            refill(own, scenes.map(ownItem));
            own.previousElementSibling.hidden = scenes.length === 0;
            showMeasures();
        },
    };
    return panel;
}
