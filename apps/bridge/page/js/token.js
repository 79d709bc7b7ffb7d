/**
 * The token that lets this tab in: that of the link that was opened, or the page's own. The driver's link is good once,
 * and the bridge gives the page a token in its place, since browsers keep addresses. The browser keeps that one on its
 * disk only while the tab is hidden or loaded again.
 */
import { forThisTab } from "./storage.js";

const LINK = "rt.token", OWN = "rt.own";

export class Token {
    constructor() {
        this.link = forThisTab.get(LINK);
        this.own = forThisTab.get(OWN);
        this.before = null; // the page's own until another link was opened
        this.store();
        document.addEventListener("visibilitychange", () => this.store());
        addEventListener("pagehide", () => this.store(true));
        addEventListener("pageshow", () => this.store());
    }

    store(leaves = document.hidden) {
        if (leaves && this.own) forThisTab.set(OWN, this.own);
        else forThisTab.remove(OWN);
    }

    /** "": there is none. */
    get current() {
        return this.own ?? this.link ?? "";
    }

    /** A link was opened; the same one again changes nothing. */
    open(link) {
        if (link === this.link) return;
        this.link = link;
        forThisTab.set(LINK, link);
        if (this.own) this.before = this.own;
        this.own = null;
        this.store();
    }

    /** The bridge has let the page in. @param {string|undefined} own */
    welcome(own) {
        this.own = own ?? null;
        this.before = null;
        this.store();
    }

    /** The link was used before: what let this tab in until then does again. False: nothing did. */
    goBack() {
        this.own = this.before;
        this.before = null;
        return this.own !== null;
    }
}
