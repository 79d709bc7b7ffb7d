/**
 * The drawer: a tab and a panel for each subject. A panel is filled when it is first opened and kept up to date while
 * seen.
 */
import { byId, make, symbol } from "./dom.js";
import { forThisTab } from "./storage.js";
import { t } from "./texts.js";

export class Panels {
    /**
     * @param {{id: string, fill: (place: HTMLElement) => void, show: () => void}[]} subjects `id` is the icon and the
     * text, too
     */
    constructor(subjects, onOpen) {
        this.drawer = byId("drawer");
        this.onOpen = onOpen;
        this.subjects = subjects.map((subject) => this.add(subject));
        byId("tabs").addEventListener("keydown", (event) => this.onKey(event));
        byId("menu").addEventListener("click", () => this.toggle());
        byId("close").addEventListener("click", () => this.toggle(false));
        this.drawer.addEventListener("keydown", (event) => event.key === "Escape" && !event.defaultPrevented
            && this.toggle(false));
        this.choose(this.subjects.find(({ id }) => id === forThisTab.get("rt.panel")) ?? this.subjects[0]);
    }

    add(subject) {
        const panel = make("section", { role: "tabpanel", id: "panel-" + subject.id,
            "aria-label": t(subject.id + "Title"), hidden: true, tabIndex: -1 });
        const tab = make("button", { type: "button", role: "tab", id: "tab-" + subject.id,
            title: t(subject.id + "Title"), "aria-controls": panel.id,
            onclick: () => this.choose(one) }, symbol(subject.id), make("span", {}, t(subject.id)));
        const one = { ...subject, panel, tab, filled: false };
        byId("tabs").append(tab);
        byId("panels").append(panel);
        return one;
    }

    onKey(event) {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!step) return;
        event.preventDefault();
        const count = this.subjects.length;
        this.choose(this.subjects[(this.subjects.indexOf(this.chosen) + step + count) % count]);
        this.chosen.tab.focus();
    }

    choose(one) {
        this.chosen = one;
        forThisTab.set("rt.panel", one.id);
        for (const { tab, panel } of this.subjects) {
            tab.setAttribute("aria-selected", String(tab === one.tab));
            tab.tabIndex = tab === one.tab ? 0 : -1;
            panel.hidden = panel !== one.panel;
        }
        this.drawer.setAttribute("aria-label", t(one.id + "Title"));
        byId("panels").scrollTop = 0;
        this.show();
    }

    get isOpen() {
        return !this.drawer.hidden;
    }

    toggle(open = !this.isOpen) {
        if (open === this.isOpen) return;
        this.drawer.hidden = !open;
        byId("menu").setAttribute("aria-expanded", String(open));
        byId("menu").hidden = open;
        if (open) this.chosen.tab.focus();
        else byId("menu").focus();
        this.onOpen(open);
        this.show();
    }

    /** Brings the panel that is seen up to date. */
    show() {
        const { chosen } = this;
        if (!this.isOpen) return;
        if (!chosen.filled) {
            chosen.filled = true;
            chosen.panel.append(make("h3", {}, t(chosen.id + "Title")));
            chosen.fill(chosen.panel);
        }
        chosen.show();
    }

    /** All panels are made anew: another bridge may have other settings. */
    empty() {
        for (const one of this.subjects) {
            one.filled = false;
            one.panel.replaceChildren();
        }
        this.show();
    }
}
