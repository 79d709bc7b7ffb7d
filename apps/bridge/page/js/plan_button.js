/** The button that shows and hides the plan in the corner, whose module is loaded when it is first wanted. */
import { byId, name } from "./dom.js";
import { preference, setPreference } from "./storage.js";
import { of } from "./texts.js";

export class PlanButton {
    constructor(app) {
        this.app = app;
        this.button = byId("plan-button");
        this.place = byId("plan");
        this.plan = null;
        name(this.button, of("CornerPlan", "Plan in the corner"));
        this.button.addEventListener("click", () => {
            setPreference("plan", String(this.place.hidden));
            this.toggle(this.place.hidden);
        });
    }

    async toggle(on) {
        this.place.hidden = !on;
        this.button.setAttribute("aria-pressed", on);
        if (on && !this.plan) {
            const loaded = await import("./plan.js").catch(() => null); // without a connection
            if (!loaded) return this.toggle(false);
            this.plan ??= new loaded.CornerPlan(this.app, this.place, of);
        }
        this.plan?.show();
    }

    /** With the first frame comes what was shown when this browser was last here. */
    show() {
        const first = this.button.hidden && this.app.status.eye;
        if (first) this.button.hidden = false;
        if (first && preference("plan", "false") === "true") this.toggle(true);
        else this.plan?.show();
    }
}
