/** The panel of the scene's environment: the sky with its sun, the environment map, lighting presets. */
import { button, make } from "./dom.js";
import { choice, numeric, text, toggle, vector } from "./fields.js";
import { of, t } from "./texts.js";

const lookText = (name) => t("look" + name.charAt(0).toUpperCase() + name.slice(1));
const SKY = "sky"; // among the numbers of maps
const two = (value) => String(value).padStart(2, "0");

export function skyPanel(app) {
    let rows, environments, looks, map;

    const add = (place, made, when, value) => {
        place.append(made.element);
        rows.push({ made, when, value });
    };
    /** An edit that follows a hand: `edit(command)(value, goesOn)`. */
    const edit = (command) => (value, goesOn) => app.edit(command, command, [value].flat(), goesOn);
    const ask = (command) => (value) => app.ask(command, value);
    const onOff = (command) => (on) => app.ask(command, on ? "on" : "off");
    const hasSky = () => Boolean(app.state.sky?.on && !app.state.sky.studio);
    const range = (command) => app.argument(command, 0);

    function addMap(place) {
        const has = () => Boolean(app.state.map);
        environments = choice(t("environment"), [], (what) => {
            if (what === "") app.ask("environment none");
            else if (what !== SKY) app.ask("environment", Number(what));
            else if (hasSky()) app.ask("environment", app.state.environments.length); // the sky's own is the last one
            else app.ask("sky", "on");
        });
        place.append(environments.element);
        add(place, numeric(of("SkyFields", "Turned by"), edit("environment rotation"),
            { ...range("environment rotation"), unit: "°", help:
                of("SkyFields", "Turns the environment map, to the right about the up axis") }), has,
                () => app.state.map.rotation);
        add(place, numeric(of("SkyFields", "Brightness"), edit("environment strength"),
            { ...range("environment strength"), slider: false,
                help: of("SkyFields", "How bright the environment map is; 1 is as its file says") }), has,
                () => app.state.map.strength);
    }

    function addDate(place) {
        const dated = () => hasSky() && Boolean(app.state.sky.date), sky = () => app.state.sky;
        add(place, numeric(of("SkyFields", "Time of day"), edit("sky hour"), { ...range("sky hour"), unit: "h" }),
            dated, () => sky().hour);
        const date = text(of("SkyFields", "Date"), (value) => value && edit("sky date")(value));
        date.element.querySelector("input").type = "date";
        add(place, date, dated, () => sky().date.year.toString().padStart(4, "0") + "-" + two(sky().date.month) + "-"
            + two(sky().date.day));
        const put = (change) => (value) => {
            const { latitude, longitude, zone } = { ...sky(), [change]: value };
            edit("sky place")([latitude, longitude, zone]);
        };
        const placeRange = (index) => ({ ...app.argument("sky place", index), slider: false });
        add(place, numeric(of("SkyFields", "Latitude"), put("latitude"),
            { ...placeRange(0), unit: "°", help: of("SkyFields", "Degrees north; negative in the south") }), dated,
            () => sky().latitude);
        add(place, numeric(of("SkyFields", "Longitude"), put("longitude"),
            { ...placeRange(1), unit: "°", help: of("SkyFields", "Degrees east; negative in the west") }), dated,
            () => sky().longitude);
        add(place, numeric(of("SkyFields", "Time zone"), put("zone"),
            { ...placeRange(2), unit: "h", help: of("SkyFields", "What the clock is ahead of universal time") }), dated,
            () => sky().zone);
        add(place, numeric(of("SkyFields", "North"), edit("sky north"),
            { ...range("sky north"), unit: "°",
                help: of("SkyFields", "Where north is in the scene: from straight ahead to the right") }), dated,
                () => sky().north);
    }

    function addSun(place) {
        const any = () => Boolean(app.state.sky?.on), on = hasSky, byDirection = () => on() && !app.state.sky.date;
        add(place, { element: make("h3", {}, of("SkyFields", "Sun")), show: () => {} }, on, () => null);
        add(place, choice(of("SkyFields", "Sun"), [["date", of("SkyFields", "By date and place")],
            ["direction", of("SkyFields", "By direction")]],
            (by) => (by === "date" ? app.ask("sky hour", app.state.sky.hour ?? 12)
                : app.ask("sky direction", ...app.state.sky.direction))),
        on, () => (app.state.sky.date ? "date" : "direction"));
        addDate(place);
        add(place, vector(of("SkyFields", "Sun direction"),
            (direction) => direction.some((part) => part !== 0) && edit("sky direction")(direction)),
            byDirection, () => app.state.sky.direction);
        const ahead = button(of("SkyFields", "Along view"),
            () => app.status.forward && app.ask("sky direction", ...app.status.forward));
        ahead.title = of("SkyFields", "Put the sun where the camera looks");
        add(place, { element: make("div", { className: "actions" }, ahead),
            show: (_, enabled) => (ahead.disabled = !enabled) }, byDirection, () => null);
        add(place, numeric(of("SkyFields", "Haze"), edit("sky turbidity"),
            { ...range("sky turbidity"), help: of("SkyFields", "2 very clear, 3 clear, 6 hazy, 10 thick") }), on,
                () => app.state.sky.turbidity);
        add(place, numeric(of("SkyFields", "Strength"), edit("sky strength"),
            { ...range("sky strength"), slider: false,
                help: of("SkyFields", "How bright sun and sky are; 1 is as in nature") }), any,
                () => app.state.sky.strength);
        add(place, toggle(of("SkyFields", "Ground plane"), onOff("sky ground"),
            { help: of("SkyFields", "A wide ground below the model") }), any, () => app.state.sky.ground);
        add(place, toggle(of("SkyFields", "White horizon"), onOff("sky haze"),
            { help: of("SkyFields", "Haze at the horizon, into which a light ground fades") }), on,
                () => app.state.sky.haze);
    }

    return {
        id: "sky",
        fill(place) {
            rows = [];
            map = "";
            addMap(place);
            addSun(place);
            looks = (range("look").words ?? []).map((name) => button(lookText(name), () => app.ask("look", name)));
            place.append(make("h3", {}, t("look")), make("div",
                { className: "actions", role: "group", "aria-label": t("lookNow") }, ...looks));
        },
        show() {
            const may = app.mayEdit(), all = app.state.environments ?? [], maps = hasSky() ? all.slice(0, -1) : all;
            const names = JSON.stringify(maps.map(({ name }) => name));
            if (names !== map) {
                const box = environments.element.querySelector("select");
                const option = (value, text) => make("option", { value }, text);
                const mapName = ({ number, name }) => name || of("LightsPanel", "Map %1").replace("%1", number);
                box.replaceChildren(option("", t("none")), ...maps.map((one) =>
                    option(String(one.number), mapName(one))),
                    option(SKY, of("LightsPanel", "Computed sky with a sun")));
                map = names;
            }
            const shown = all.find(({ on }) => on);
            environments.show(hasSky() && shown === all.at(-1) ? SKY : String(shown?.number ?? ""), may);
            for (const { made, when, value } of rows) {
                made.element.hidden = !when();
                if (!made.element.hidden) made.show(value(), may);
            }
            for (const each of looks) each.disabled = !may;
        },
    };
}
