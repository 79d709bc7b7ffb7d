/** Labels of settings, edits and values: in English as the bridge sends them, translated as in the window. */
import { of, number, t } from "./texts.js";

let labels = {};
/** @param {Object<string, string>} english labels of settings, groups and choices, by name */
export const nameSettings = (english) => (labels = english);
const labelText = (name) => labels[name] ?? name;

export const settingLabel = (name) => of("Settings", labelText(name));
export const settingGroup = (group) => of("Settings", labelText(group));
export const settingUnit = (unit) => (unit === "" ? "" : of("Settings", unit));
export const settingHelp = (help) => of("Settings", help);

/** A value as it is shown. */
export function settingValue(row, value) {
    if (row.type === "boolean") return t(value ? "on" : "off");
    if (row.type === "choice") return settingLabel(value);
    if (row.zero && value === 0) return settingLabel(row.zero);
    const shown = String(Number(Number(value).toPrecision(6)));
    return row.unit ? shown + " " + settingUnit(row.unit) : shown;
}

/** The label of `undo` or `redo` of the state: {"label": "power of light", "of": "2"} is "power of light 2". */
export function editLabel({ setting, label, of: thing }) {
    if (setting) return settingLabel(setting);
    return of("Edits", label) + (thing ? " " + (/^\d+$/.test(thing) ? number(Number(thing)) : thing) : "");
}
