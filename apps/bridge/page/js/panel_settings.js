/**
 * Settings, made from the table that the bridge sends: first the quality as a whole, then those that most people
 * change, and the rest under a fold, in groups; fields by type, a reset for each value.
 */
import { button, make, freshId } from "./dom.js";
import { choice, group, numeric, resetOf, steps, toggle } from "./fields.js";
import { settingGroup, settingHelp, settingLabel, settingUnit, settingValue } from "./setting_labels.js";
import { forThisTab } from "./storage.js";
import { of, t } from "./texts.js";

export function settingsPanel(app) {
    let rows = [], groups = new Map(), size = null, defaults, quality, advanced;

    const set = (row) => (value, goesOn = false) => app.edit("set " + row.name, "set", [row.name, value], goesOn);

    function field(row, onChange) {
        const own = settingLabel(row.name), grouped = row.name.includes("."),
            label = row.main ? of("Settings", row.main.label) : own;
        const name = grouped ? t("group", settingGroup(row.group), own) : own;
        let help = settingHelp(row.help);
        help = help.charAt(0).toUpperCase() + help.slice(1) + (row.locked ? ". " + t("locked") : "");
        const reset = resetOf(name, settingValue(row, row.default), () => onChange(row.default));
        const how = { help, reset, name, unit: row.zero ? "0: " + settingLabel(row.zero) : settingUnit(row.unit) };
        if (row.type === "boolean") return toggle(label, onChange, { help, reset });
        if (row.type === "choice") return choice(label, row.choices.map((one) => [one, settingLabel(one)]), onChange,
            { help, reset });
        return numeric(label, onChange, { ...how, min: row.min, max: row.max, whole: row.type === "integer" });
    }

    function folded(name, title) {
        const place = group(title), dot = make("span", { className: "changed", hidden: true, role: "img",
            "aria-label": t("changed") });
        place.firstChild.append(dot);
        place.open = forThisTab.get("rt.open." + name) === "true";
        place.addEventListener("toggle", () => forThisTab.set("rt.open." + name, String(place.open)));
        return { place, dot };
    }

    /** The fold of its group, which is made with its first row. */
    function groupOf(row) {
        if (!groups.has(row.group)) {
            groups.set(row.group, folded(row.group, settingGroup(row.group)));
            advanced.place.append(groups.get(row.group).place);
        }
        return groups.get(row.group).place;
    }

    /** Shows the settings that match, and opens their groups. */
    function find(words) {
        const wanted = words.trim().toLowerCase();
        for (const { place } of groups.values()) place.hidden = wanted !== "";
        for (const { row, made } of rows) {
            const said = [row.name, settingLabel(row.name), settingGroup(row.group),
                settingHelp(row.help)].join(" ").toLowerCase();
            made.element.hidden = wanted !== "" && !said.includes(wanted);
            if (wanted === "" || made.element.hidden) continue;
            if (row.main) continue;
            const { place } = groups.get(row.group);
            place.hidden = false;
            place.open = true;
            advanced.place.open = true;
        }
    }

    /** Name and settings of each, as its command orders them. */
    const qualities = () => (app.argument("quality", 0).words ?? []).map((name) => [name, app.welcome.qualities[name]]);
    /** The settings of a quality, a line each. */
    function qualityTip(settings) {
        const table = app.welcome.settings;
        return Object.entries(settings).map(([name, value]) => {
            const row = table.find((one) => one.name === name);
            return t("group", (name.includes(".") ? settingGroup(row.group) + " " : "") + settingLabel(name),
                settingValue(row, value));
        }).join("\n");
    }
    const makeQuality = () => steps(t("imageQuality"),
        qualities().map(([name, settings]) => [name, settingLabel(name), qualityTip(settings)]),
        (name) => app.ask("quality", name), of("QualityBar", "Custom"));
    /** The name of the one that the settings are as in; null: of none. */
    function qualityOf(values) {
        const found = qualities().find(([, settings]) => Object.entries(settings).every(([name, value]) =>
            values[name] === value));
        return found ? found[0] : null;
    }
    const mayChooseQuality = () => !rows.some(({ row }) => row.locked
        && qualities().some(([, settings]) => row.name in settings));

    /** The pixels of this screen's part for the frame, or as many as the bridge allows. */
    function fitted() {
        const { w, h } = app.pixels(), scale = Math.min(1,
            Math.sqrt((app.welcome.limits.maxPixels ?? w * h) / (w * h)));
        return [Math.max(1, Math.floor(w * scale)), Math.max(1, Math.floor(h * scale))];
    }

    function addSize(place) {
        const side = (name, index) => {
            const { min, max } = app.argument("resolution", index);
            return make("input", { type: "number", min, max, id: freshId(), "aria-label": settingLabel(name) });
        };
        const width = side("width", 0), height = side("height", 1);
        const apply = button(t("apply"), () => {
            if (width.checkValidity() && height.checkValidity())
                app.ask("resolution", Number(width.value), Number(height.value));
        });
        const fit = button(t("fit"), () => app.ask("resolution", ...fitted()));
        place.append(make("div", { className: "actions", role: "group", "aria-label": t("size") },
            make("label", { for: width.id }, t("size")),
            width, "×", height, apply, fit));
        size = { width, height, apply, fit };
    }

    return {
        id: "settings",
        fill(place) {
            rows = [];
            groups = new Map();
            place.append(make("input", { type: "search", placeholder: t("find"), "aria-label": t("find"),
                oninput: (event) => find(event.target.value) }));
            quality = makeQuality();
            const main = make("div", {});
            advanced = folded("advanced", of("SettingsPanel", "Advanced"));
            place.append(quality.element, main, advanced.place);
            addSize(advanced.place);
            const order = (row) => row.main?.place ?? 1e9;
            for (const row of [...(app.welcome?.settings ?? [])].sort((one, other) => order(one) - order(other))) {
                const made = field(row, set(row));
                rows.push({ row, made });
                if (row.main) main.append(made.element);
                else groupOf(row).append(made.element);
            }
            defaults = button(t("defaults"), () => app.ask("defaults"));
            place.append(make("div", { className: "actions" }, defaults));
        },
        show() {
            const values = app.state.values ?? {}, changed = new Set(), may = app.mayEdit();
            for (const { row, made } of rows) {
                const value = values[row.name] ?? row.default, enabled = may && !row.locked;
                if (value !== row.default && !row.main) changed.add(row.group);
                made.back.disabled = !enabled;
                if (app.edits.isBusy("set " + row.name)) continue;
                made.show(value, enabled);
                const focused = made.back === document.activeElement;
                made.back.hidden = value === row.default;
                if (focused && made.back.hidden) made.element.querySelector("input, select").focus();
            }
            for (const [name, { dot }] of groups) dot.hidden = !changed.has(name);
            advanced.dot.hidden = changed.size === 0;
            quality.show(qualityOf(values), may && mayChooseQuality());
            for (const side of ["width", "height"]) {
                if (size[side] !== document.activeElement) size[side].value = values[side] ?? "";
                size[side].disabled = !may;
            }
            size.apply.disabled = size.fit.disabled = !may;
            defaults.disabled = !may || app.welcome.locked.length > 0;
        },
    };
}
