/** What settings, edits and values are called: as in the window, whose table the build makes setting_label_table.js of. */
import labels from "./setting_label_table.js";
import { of, number, t } from "./texts.js";

/** "brighterSeconds" is "Brighter seconds". */
function words(name) {
    const text = name.replace(/(?!^)[A-Z]/g, (letter) => " " + letter.toLowerCase());
    return text.charAt(0).toUpperCase() + text.slice(1);
}

const labelText = (name) => labels[name] ?? words(name.slice(name.lastIndexOf(".") + 1));

export const settingLabel = (name) => of("Settings", labelText(name));
export const settingGroup = (group) => of("Settings", group === "" ? "Image" : labelText(group));
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

/** Words that an edit begins with, the longer ones first. */
const edits = [
    ["light add", "add light"], ["light copy", "copy light"], ["light remove", "remove light"], ["light move", "move light"],
    ["light aim", "turn light"], ["light colour", "colour of light"], ["light temperature", "temperature of light"],
    ["light power", "power of light"], ["light kind", "kind of light"], ["light size", "size of light"],
    ["light angles", "angles of light"], ["light mirrored", "light in mirrors"], ["light name", "name of light"], ["light", "light"], ["environment", "environment"],
    ["sky", "sky"], ["look", "light of the scene"], ["material", "material"], ["part", "visible parts"],
    ["camera reset", "reset camera"], ["camera angle", "field of view"], ["camera lens", "field of view"],
    ["camera zoom", "field of view"], ["camera", "look there"], ["focus", "focus there"], ["up", "up axis"], ["units", "unit"],
    ["bookmark", "bookmark"], ["defaults", "defaults"], ["bloom", "bloom"],
];

/** What `undo` or `redo` of the state means: "set bloom.radius" is "Radius". */
export function editLabel(step) {
    if (step.startsWith("set ")) return settingLabel(step.split(" ")[1]);
    const found = edits.find(([words]) => step === words || step.startsWith(words + " "));
    if (!found) return step;
    const rest = step.slice(found[0].length).trim();
    return of("Edits", found[1]) + (/^\d+$/.test(rest) ? " " + number(Number(rest)) : "");
}
