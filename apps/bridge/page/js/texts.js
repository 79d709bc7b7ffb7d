/**
 * The language of the page: its own texts (texts_en, texts_cs), those that it shares with the window (tables_cs), and
 * what server and bridge say (sentences_cs), which is loaded when they first say something.
 */
import english from "./texts_en.js";
import { preference, setPreference } from "./storage.js";

export const languages = [["", "auto"], ["en", "English"], ["cs", "Čeština"]];

const chosen = preference("language", "");
export const language = (chosen || navigator.language || "en").startsWith("cs") ? "cs" : "en";
const [own, shared] = language === "cs"
    ? (await Promise.all([import("./texts_cs.js"), import("./tables_cs.js")])).map((module) => module.default)
        : [english, {}];
document.documentElement.lang = language;

export function chooseLanguage(name) {
    setPreference("language", name);
    location.reload();
}

/** A text of the page, `{0}`, `{1}` replaced. @param {keyof typeof english} key */
export function t(key, ...values) {
    return own[key].replace(/\{(\d)\}/g, (_, index) => values[index]);
}

const plurals = new Intl.PluralRules(language);
/** A text of so many things: `key` with One, Few or Other. */
export function counted(key, count) {
    const form = plurals.select(count);
    return t(key + (form === "one" ? "One" : form === "few" ? "Few" : "Other"), count);
}

/** An English text of the window, in the page's language; as it is where there is no translation. */
export const of = (context, text) => shared[context]?.[text] ?? text;

/** A sentence of server or bridge, [form, ...what stands in its places], by the forms of a table. */
export function inWords(table, part) {
    if (typeof part === "string") return part;
    const [form, ...places] = part;
    const words = Object.hasOwn(table, form) ? table[form] : form;
    return words.replace(/\{(\d)\}/g, (place, index) => (index in places ? inWords(table, places[index]) : place));
}

/** The text of an event, in the page's language. @param {{text: string, sentence?: Array}} event */
export async function said({ text, sentence }) {
    if (!sentence || language !== "cs") return text;
    const loaded = await import("./sentences_cs.js").catch(() => null); // without a connection
    return loaded ? inWords(loaded.default, sentence) : text;
}

const formats = new Map();
/** A number for people, with so many digits after the point. */
export function number(value, digits = 0) {
    if (!formats.has(digits))
        formats.set(digits, new Intl.NumberFormat(language,
            { minimumFractionDigits: digits, maximumFractionDigits: digits }));
    return formats.get(digits).format(value);
}
