/** This page itself: theme, language, mouse, quality, which server, help. */
import { make } from "./dom.js";
import { choice, numeric, toggle } from "./fields.js";
import { preference, setPreference } from "./storage.js";
import { chooseLanguage, language, languages, t } from "./texts.js";

export function pagePanel(app) {
    let quality, server, statistics;

    const kept = (name, fallback) => ({ value: () => preference(name, fallback),
        set: (value) => setPreference(name, value) });

    function addLook(place) {
        const theme = kept("theme", "");
        const looks = choice(t("theme"), [["", t("themeAuto")], ["light", t("themeLight")], ["dark", t("themeDark")]],
            theme.set);
        looks.show(theme.value(), true);
        const tongue = choice(t("languageOf"), languages.slice(1), chooseLanguage);
        tongue.show(language, true);
        const mouse = kept("mouse", "1"), invert = kept("invert", "false");
        const speed = numeric(t("mouseSpeed"), mouse.set, { min: 0.1, max: 4 });
        speed.show(Number(mouse.value()), true);
        const up = toggle(t("invert"), invert.set);
        up.show(invert.value() === "true", true);
        place.append(looks.element, tongue.element, speed.element, up.element);
    }

    function rungs() {
        const size = ({ divide }) => (divide === 1 ? t("fullSize") : t("part", divide));
        return [["255", t("automatic")], ...(app.welcome?.rungs
            ?? []).map((rung, index) => [String(index), t("rung", size(rung), rung.quality)])];
    }

    return {
        id: "page",
        fill(place) {
            addLook(place);
            quality = choice(t("quality"), rungs(), (rung) => setPreference("rung", rung));
            const save = toggle(t("saveData"), (on) => setPreference("saveData", on), { help: t("saveDataHelp") });
            save.show(preference("saveData", "false") === "true", true);
            statistics = toggle(t("showStatistics"), (on) => app.statistics.toggle(on));
            server = choice(t("instance"), (app.welcome?.instances ?? []).map((one) => [one, one]),
                (one) => app.goTo(one));
            place.append(quality.element, save.element, statistics.element, server.element, make("h3", {}, t("keys")),
                make("p", {}, t("keysHelp")), make("p", {}, t("touchHelp")),
                    make("p", {}, t("version", app.welcome?.version ?? "")));
        },
        show() {
            quality.show(preference("rung", "255"), true);
            statistics.show(app.statistics.isOn, true);
            server.element.hidden = (app.welcome?.instances.length ?? 0) < 2;
            server.show(app.welcome?.instance ?? "", true);
        },
    };
}
