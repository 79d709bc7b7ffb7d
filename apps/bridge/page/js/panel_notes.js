/** The notes of the scene, and a new one: a driver's, or, where that is allowed, of who only looks, with a name. */
import { button, make, refill } from "./dom.js";
import { plainNote } from "./notes.js";
import { preference, setPreference } from "./storage.js";
import { t } from "./texts.js";

const MAX_NAME = 40, SHOWN = 80; // letters

export function notesPanel(app) {
    let list, form, words, name, last = "";

    const item = ({ text, author }, index) => {
        const remove = button(t("measureRemove", index + 1), () => app.ask("note remove", index + 1), "close");
        remove.disabled = !app.mayEdit();
        return make("li", {}, make("button", { type: "button", className: "name", onclick: () => go(index) },
            index + 1 + "  " + (author && author + ": ") + text.slice(0, SHOWN)), remove);
    };

    /** Drivers look from where it was written. */
    function go(index) {
        if (app.drives()) app.ask("note go", index + 1);
        app.notes.tell(index);
    }

    function write() {
        const text = plainNote(words.value), author = plainNote(name.value);
        const missing = text ? !author && !app.mayEdit() && name : words;
        if (missing) return missing.focus();
        if (author) setPreference("name", author);
        app.panels.toggle(false);
        app.notes.start(text, author, () => (words.value = ""));
    }

    return {
        id: "notes",
        fill(place) {
            last = "";
            list = make("ul", { className: "list", id: "noted" });
            words = make("textarea", { name: "note", rows: 3, placeholder: t("noteText"),
                "aria-label": t("noteText") });
            name = make("input", { type: "text", name: "author", maxLength: MAX_NAME, placeholder: t("yourName"),
                "aria-label": t("yourName"), value: preference("name", "") });
            form = make("div", { id: "note" }, words, name, make("div", { className: "actions" },
                button(t("notePlace"), write)));
            place.append(list, form);
        },
        show() {
            form.hidden = !app.notes.mayWrite();
            if (app.welcome) words.maxLength = app.welcome.limits.note;
            const { all } = app.notes, rest = (app.state.notes?.count ?? 0) - all.length;
            const now = JSON.stringify([app.state.notes, app.mayEdit()]);
            if (now === last) return;
            last = now;
            const word = rest > 0 ? t("measuresMore", rest) : all.length === 0 ? t("bookmarksNone") : "";
            refill(list, [...all.map(item),
                ...(word ? [make("li", {}, make("span", { className: "dim" }, word))] : [])]);
        },
    };
}
