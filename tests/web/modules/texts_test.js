import { equal, isTrue } from "./expect.js";
import { editLabel, nameSettings, settingLabel } from "./setting_labels.js";
import tables from "./tables_cs.js";
import { counted } from "./texts.js";
import czech from "./texts_cs.js";
import english from "./texts_en.js";

export function eachTextIsInBothLanguages() {
    equal(Object.keys(czech).sort(), Object.keys(english).sort());
    const blanks = (text) => text.split("{").length - 1;
    for (const [key, text] of Object.entries(english)) {
        equal(blanks(czech[key]), blanks(text), key);
        isTrue(czech[key] !== "", key);
    }
    equal(tables.Settings.Shadows, "Stíny");
}

export function pluralsAreRight() {
    equal(counted("importGood", 1), "1 bookmark added");
    equal(counted("importGood", 2), "2 bookmarks added");
}

export function settingsAreCalledAsInTheWindow() {
    nameSettings({ "exposure.brighterSeconds": "Brighter seconds" });
    equal(settingLabel("exposure.brighterSeconds"), "Brighter seconds");
    equal(editLabel({ setting: "exposure.brighterSeconds" }), "Brighter seconds");
    equal(editLabel({ label: "power of light", of: "2" }), "power of light 2");
    equal(editLabel({ label: "sky", of: "" }), "sky");
}
