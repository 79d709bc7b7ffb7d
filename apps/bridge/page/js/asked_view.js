/** A link to a view: the driver goes there, others are offered to ask. */
import { goTo } from "./fragment.js";
import { t } from "./texts.js";

export class AskedView {
    constructor(app) {
        this.app = app;
        this.view = null; // eye, direction, extent
        this.wasOffered = false;
    }

    /** Takes the view of the address; it is offered once there is a view to leave. */
    take(view) {
        this.view = view;
        this.wasOffered = false;
    }

    offer() {
        const { app, view } = this;
        if (!view || !app.status.eye) return;
        if (app.drives()) {
            this.view = null;
            app.notices.hide("view");
            app.ask(...goTo(view));
            return;
        }
        if (this.wasOffered) return;
        this.wasOffered = true;
        const actions = app.welcome?.mayDrive ? [[t("ask"), () => app.askToDrive()]] : [];
        app.notices.show("view", t("viewAsked"), { lasting: true,
            actions: [...actions, [t("close"), () => (this.view = null)]] });
    }
}
