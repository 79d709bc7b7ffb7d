/** Who is here, who drives, and how another comes to drive. */
import { button, make, refill } from "./dom.js";
import { text } from "./fields.js";
import { preference, setPreference } from "./storage.js";
import { t } from "./texts.js";

export const personName = ({ id, name } = { id: 0 }) => name || t("someone", id);

export function peoplePanel(app) {
    let list, name, actions, last = "";

    const item = (one) => {
        const { driver, asking } = app.roles, mine = one.id === app.welcome.you;
        const facts = [mine && t("you"), one.id === driver && t("drives"), asking.includes(one.id) && t("asks"),
            !one.mayDrive && t("viewOnly")].filter(Boolean);
        const give = app.drives() && !mine && one.mayDrive
            ? [button(t("giveTo"), () => app.request("give", { to: one.id }))] : [];
        return make("li", {}, make("span", { className: "name" }, personName(one)),
            make("span", { className: "dim" }, facts.join(", ")), ...give);
    };

    return {
        id: "people",
        fill(place) {
            last = "";
            list = make("ul", { className: "list" });
            name = text(t("yourName"), (value) => {
                setPreference("name", value.trim());
                app.request("name", { name: value.trim() });
            });
            actions = make("div", { className: "actions" });
            place.append(name.element, list, actions);
        },
        show() {
            name.show(preference("name", ""), true);
            const now = JSON.stringify([app.roles, app.welcome?.you, app.welcome?.mayDrive]);
            if (now === last) return;
            last = now;
            refill(list, app.roles.people.map(item));
            refill(actions, [app.drives() ? button(t("stop"), () => app.request("release"))
                : app.welcome?.mayDrive ? button(t("ask"), () => app.askToDrive()) : make("p", {}, t("viewOnly"))]);
        },
    };
}
