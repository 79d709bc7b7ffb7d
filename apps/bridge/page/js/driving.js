/** Notices about driving: requests of others to this page, the state of its own, the driver that follows it. */
import { personName } from "./panel_people.js";
import { t } from "./texts.js";

export class Driving {
    constructor(app) {
        this.app = app;
        this.asks = false; // this page asks
        this.by = null;    // the one who asks this page
    }

    nameOf(id) {
        return personName(this.app.roles.people.find((one) => one.id === id) ?? { id });
    }

    /** After each change of roles. `drove`: whether this page drove before. */
    follow(drove) {
        const { app } = this;
        if (drove && !app.drives() && app.welcome) this.tellNext();
        this.tellOwnRequest();
        this.tellRequestOfOthers();
    }

    /** The connection is lost, and all requests with it. */
    forget() {
        this.asks = false;
        this.by = null;
        for (const key of ["ask", "asked"]) this.app.notices.hide(key);
    }

    tellNext() {
        const { driver } = this.app.roles;
        this.app.notices.show("role", driver === null ? t("drivesNoMore") : t("taken", this.nameOf(driver)));
    }

    tellOwnRequest() {
        const { app } = this, asks = app.roles.asking.includes(app.welcome?.you);
        if (asks === this.asks) return;
        this.asks = asks;
        if (asks) app.notices.show("ask", t("asking"), { lasting: true });
        else if (app.drives()) app.notices.hide("ask");
        else app.notices.show("ask", t("askRefused"));
    }

    tellRequestOfOthers() {
        const { app } = this, [by = null] = app.drives() ? app.roles.asking : [];
        if (by === this.by) return;
        this.by = by;
        if (by === null) return app.notices.hide("asked");
        app.notices.show("asked", t("asksYou", this.nameOf(by)), { lasting: true,
            actions: [[t("giveTo"), () => app.request("give", { to: by })], [t("keep"), () => app.request("keep")]] });
    }
}
