/** Notices over the image: short ones go by themselves, lasting ones when what they tell has passed. Never a dialog. */
import { button, byId, make } from "./dom.js";

const SHORT_MS = 4000;

export class Notices {
    constructor() {
        this.place = byId("notices");
        this.shown = new Map();
    }

    /**
     * @param {string} key one notice of a key is shown: a newer one takes its place
     * @param {{lasting?: boolean, warn?: boolean, actions?: [string, () => void][]}} how
     */
    show(key, text, { lasting = false, warn = false, actions = [] } = {}) {
        this.hide(key);
        const act = (what) => () => {
            this.hide(key);
            what();
        };
        const notice = make("div", { className: warn ? "notice warn" : "notice" }, make("span", {}, text),
            ...actions.map(([label, what]) => button(label, act(what))));
        this.place.append(notice);
        this.shown.set(key, { notice, timer: lasting ? 0 : setTimeout(() => this.hide(key), SHORT_MS) });
    }

    hide(key) {
        const old = this.shown.get(key);
        if (!old) return;
        clearTimeout(old.timer);
        old.notice.remove();
        this.shown.delete(key);
    }
}
