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
     * @param {{lasting?: boolean, warn?: boolean, stays?: boolean, actions?: [string, () => void][]}} how `stays`: an
     *     action does not hide it
     */
    show(key, text, { lasting = false, warn = false, stays = false, actions = [] } = {}) {
        this.hide(key);
        const act = (what) => () => {
            if (!stays) this.hide(key);
            what();
        };
        const notice = make("div", { className: warn ? "notice warn" : "notice" }, make("span", {}, text),
            ...actions.map(([label, what]) => button(label, act(what))));
        this.place.append(notice);
        this.shown.set(key, { notice, timer: 0 });
        if (!lasting) this.hideLater(key, actions.length > 0);
    }

    /** `used`: it has buttons, and is not taken from under a hand. */
    hideLater(key, used) {
        const one = this.shown.get(key);
        one.timer = setTimeout(() => {
            if (used && one.notice.matches(":hover, :focus-within")) this.hideLater(key, used);
            else this.hide(key);
        }, SHORT_MS);
    }

    hide(key) {
        const old = this.shown.get(key);
        if (!old) return;
        clearTimeout(old.timer);
        old.notice.remove();
        this.shown.delete(key);
    }
}
