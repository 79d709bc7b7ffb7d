/**
 * The notes of the scene: numbers over the image, by the camera of the last status, the text of one, and writing one.
 * Their texts are of strangers: they go in as text alone.
 */
import { byId, make } from "./dom.js";
import { imageIn } from "./scene_image.js";
import { t } from "./texts.js";

/** What people typed, without what makes a message longer than it may be. */
export const plainNote = (text) => text.replace(/(?!\n)[\p{Cc}\p{Cs}]/gu, "").trim();

/** Who wrote it, and when. */
export function noteHead({ author, written }) {
    const time = Date.parse(written);
    return [author, time && new Date(time).toLocaleString(document.documentElement.lang,
        { dateStyle: "short", timeStyle: "short" })].filter(Boolean).join(", ");
}

export class Notes {
    constructor(app) {
        this.app = app;
        this.place = byId("notes");
        this.pending = null; // waits for the place that it is about
        this.place.addEventListener("click", (event) => this.tap(event));
        addEventListener("keydown", (event) => event.key === "Escape" && this.pending && this.stop());
        new ResizeObserver(() => this.show()).observe(byId("view"));
    }

    get all() {
        return this.app.state.notes?.all ?? [];
    }

    /** Also by those who only look, where the owner of the bridge allows it. */
    mayWrite() {
        const { app } = this;
        return app.mayEdit() || Boolean(app.link.greeted && app.welcome?.visitorNotes);
    }

    /** The place is tapped next; `done` is called once the note is kept. */
    start(text, author, done) {
        this.app.measures.stop();
        this.pending = { text, author, done };
        this.place.classList.add("measuring");
        this.app.notices.show("note", t("noteTap"), { lasting: true,
            actions: [[t("measureStop"), () => this.stop()]] });
    }

    stop() {
        if (!this.pending) return;
        this.pending = null;
        this.place.classList.remove("measuring");
        this.app.notices.hide("note");
    }

    async tap({ clientX, clientY, target }) {
        const at = this.app.picture.at(clientX, clientY);
        if (!this.pending || !at || target !== this.place) return;
        const { text, author, done } = this.pending;
        this.stop();
        if ((await this.app.ask("note at", at.x, at.y, text, author)).ok) done();
    }

    /** Tells a note; the state has the beginnings of long texts only, where there are very many. */
    async tell(index) {
        this.stop();
        const note = this.all[index];
        const { note: whole } = this.app.state.notes.shortened ? await this.app.ask("note get", index + 1) : {};
        const head = noteHead(note);
        this.app.notices.show("note", index + 1 + (head && "  " + head) + "\n" + (whole ?? note.text),
            { lasting: true, actions: [[t("close"), () => {}]] });
    }

    /** Places their numbers anew. */
    show() {
        const { all, place } = this, marks = place.children;
        if (this.pending && !this.mayWrite()) this.stop();
        while (marks.length > all.length) place.lastChild.remove();
        while (marks.length < all.length) {
            const index = marks.length;
            place.append(make("button", { type: "button", onclick: () => this.tell(index) }, String(index + 1)));
        }
        const shown = all.length > 0 && imageIn(place, this.app);
        all.forEach(({ point, cut, text }, index) => {
            const mark = marks[index], at = shown && !cut && shown.image.at(point), { area } = shown || {};
            const seen = at && at.x >= area.x && at.x <= area.x + area.width && at.y >= area.y
                && at.y <= area.y + area.height;
            mark.hidden = !seen;
            if (seen) mark.style.translate = at.x + "px " + at.y + "px";
            if (mark.title !== text) mark.title = text;
        });
    }
}
