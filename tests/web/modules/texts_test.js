import { equal, isTrue } from "./expect.js";
import { editLabel, nameSettings, settingLabel } from "./setting_labels.js";
import sentences from "./sentences_cs.js";
import tables from "./tables_cs.js";
import { counted, inWords, said } from "./texts.js";
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

export async function whatTheServerSaysIsTranslatedByItsForm() {
    const words = (sentence) => inWords(sentences, sentence);
    equal(words(["there is no light {0}; the scene has {1}", "7", ["only number {0}", "3"]]), "světlo 7 tu není; scéna má jen číslo 3");
    equal(words(["{0}: {1}", "a {1} <b>.scn", ["the file is empty"]]), "a {1} <b>.scn: soubor je prázdný");
    equal(words(["a new thing {0} {1}", "x"]), "a new thing x {1}");
    equal(await said({ text: "there is no light 7", sentence: ["there is no light {0}", "7"] }), "there is no light 7");
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
