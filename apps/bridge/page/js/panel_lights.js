/** Lights: a switch for each, and the fields of the chosen one, as its kind has them. */
import { button, make, refill } from "./dom.js";
import { choice, colour, measured, numeric, toggle, vector } from "./fields.js";
import { of, t } from "./texts.js";

const kindText = (app, kind) => of("LightKinds", app.lightKind(kind).label ?? kind);

const LUMENS_PER_WATT = 683;

export const lightName = (light) => light.name || of("LightFields", "Light %1").replace("%1", light.id);

export function lightsPanel(app) {
    let chosen = 0, list, fields, rows = [], empty, addKind, plus;

    const light = () => app.state.lights?.find(({ id }) => id === chosen);
    const edit = (what, args, goesOn) => app.edit(what + " " + chosen, what, [chosen, ...[args].flat()], goesOn);
    const kinds = () => (app.welcome?.lightKinds ?? []).map(({ name }) => [name, kindText(app, name)]);
    /** Whether lights of a kind have it: a place, a direction, a radius, sides, a cone, a disc, an area. */
    const has = (trait) => ({ kind }) => app.lightKind(kind)[trait];
    const not = (when) => (one) => !when(one);

    /** Unit and scale of lengths, which the bridge sends and takes in scene units. */
    const metres = { unit: "m", scale: () => app.state.metresPerUnit ?? 1 };

    /** A row of fields: when it is shown, and what it shows of a light. */
    const add = (made, when, show) => {
        fields.append(made.element);
        rows.push({ element: made.element, when, show: (one, enabled) => made.show(show(one), enabled) });
    };
    const buttons = (when, ...all) => {
        const element = make("div", { className: "actions" }, ...all);
        fields.append(element);
        rows.push({ element, when, show: (_, enabled) => all.forEach((each) => (each.disabled = !enabled)) });
    };
    const tipped = (text, help, run) => {
        const made = button(text, run);
        made.title = help;
        return made;
    };

    function addFields() {
        const always = () => true;
        add(choice(of("LightFields", "Kind"), kinds(), (kind) => edit("light kind", kind)), always, ({ kind }) => kind);
        const power = { min: 0, unitName: of("PowerField", "Unit of the power"),
            unitHelp: of("PowerField", "Lumens, or radiant watts of 683 lumens each") };
        for (const [unit, watts, when] of [["lm", "W", has("position")], ["lx", "W/m²", not(has("position"))]])
            add(measured(of("LightFields", "Power"), [[unit, 1], [watts, 1 / LUMENS_PER_WATT]],
                (much) => edit("light power", [much, unit]), power),
                when, ({ lumens }) => lumens);
        add(colour(of("LightFields", "Colour"), (value, goesOn) => edit("light colour", value, goesOn),
            { scaled: true, help: of("LightFields", "Choose a colour; the power stays") }),
                ({ temperature }) => !temperature, (one) => one.colour);
        add(toggle(of("LightFields", "Colour by temperature"), (on) => edit("light temperature", on ? 4000 : "none")),
            always,
            ({ temperature }) => temperature > 0);
        add(numeric(of("LightFields", "Temperature"), (kelvin, goesOn) => edit("light temperature", kelvin, goesOn),
            { ...app.argument("light temperature", 1), until: 6500, whole: true, unit: "K",
                help: of("LightFields", "Of a black body: candle 1900 K, bulb 2700 K, sun 5800 K") }),
        ({ temperature }) => temperature > 0, ({ temperature }) => temperature);
        addPlaces();
        addShape();
    }

    function addPlaces() {
        add(vector(of("LightFields", "Position"), (to) => edit("light move", ["at", ...to]), metres), has("position"),
            ({ position }) => position);
        buttons(has("position"),
            tipped(of("LightFields", "Here"), of("LightFields", "Put the light at the camera"),
                () => edit("light move", "here")),
            tipped(of("LightFields", "At view centre"),
                of("LightFields", "Put it before the surface in the middle of the image"),
                () => edit("light move", "seen")));
        add(vector(of("LightFields", "Direction"), (along) => along.some((part) => part !== 0)
            && edit("light aim", ["along", ...along])),
            has("direction"), ({ direction }) => direction);
        buttons(has("direction"),
            tipped(of("LightFields", "Along view"), of("LightFields", "Let it shine as the camera looks"),
                () => edit("light aim", "ahead")),
            tipped(of("LightFields", "Aim at view centre"),
                of("LightFields", "Let it shine to what is in the middle of the image"),
                () => edit("light aim", "seen")));
        const turn = of("LightFields", "Turn it by 15° about its direction");
        buttons(has("turns"),
            tipped(of("LightFields", "Turn left"), turn, () => edit("light turn", 15)),
            tipped(of("LightFields", "Turn right"), turn, () => edit("light turn", -15)));
    }

    function addShape() {
        const sizes = { min: 0, slider: false, ...metres }, angles = app.argument("light angles", 1);
        add(numeric(of("LightFields", "Radius"), (radius) => edit("light size", radius), sizes), has("radius"),
            ({ radius }) => radius);
        add(numeric(of("LightFields", "Angle under which it is seen"),
            (angle, goesOn) => edit("light size", angle, goesOn),
            { min: 0, max: 180, until: 5, unit: "°",
                help: of("LightFields", "The sun has 0.53°; 0: shadows are sharp") }), has("disc"),
        ({ angle }) => angle);
        add(numeric(of("LightFields", "Width"), (width) => edit("light size", [width, light().height]), sizes),
            has("sides"), ({ width }) => width);
        add(numeric(of("LightFields", "Height"), (height) => edit("light size", [light().width, height]), sizes),
            has("sides"), ({ height }) => height);
        add(numeric(of("LightFields", "Angle of full brightness"),
            (inner, goesOn) => edit("light angles", [inner, Math.max(inner, light().outer)], goesOn),
                { ...angles, unit: "°" }), has("cone"), ({ inner }) => inner);
        add(numeric(of("LightFields", "Angle where it ends"),
            (outer, goesOn) => edit("light angles", [Math.min(light().inner, outer), outer], goesOn),
                { ...angles, unit: "°" }), has("cone"), ({ outer }) => outer);
        const mirrors =
            of("LightFields", "Mirrors, lacquer and glass that bends show the light itself; the camera does not");
        add(toggle(of("LightFields", "Seen in mirrors"), (on) => edit("light mirrored", on ? "on" : "off"),
            { help: mirrors }),
        has("area"), ({ mirrored }) => mirrored);
    }

    const item = (one) => {
        const name = lightName(one);
        const box = make("input", { type: "checkbox", checked: one.on, disabled: !app.mayEdit(), "aria-label": name,
            onchange: async () => {
                const { ok } = await app.ask("light", one.id, box.checked ? "on" : "off");
                if (!ok) box.checked = one.on;
            } });
        const choose = make("button", { type: "button", className: "name", "aria-current": String(one.id === chosen),
            onclick: () => {
                chosen = one.id === chosen ? 0 : one.id;
                panel.show();
                list.querySelector("[aria-current=true]")?.focus();
            } }, name);
        return make("li", {}, box, choose, ...(one.kind ? [make("span", { className: "dim" }, kindText(app, one.kind))]
            : []));
    };

    let last = "";
    const panel = {
        id: "lights",
        fill(place) {
            rows = [];
            last = "";
            list = make("ul", { className: "list" });
            empty = make("p", {}, t("lightsNone"));
            fields = make("div", { role: "group", "aria-label": t("lights") });
            addKind = make("select", { "aria-label": of("LightFields", "Kind of the light") },
                ...kinds().map(([value, text]) => make("option", { value }, text)));
            plus = tipped(of("LightsPanel", "Add"), of("LightsPanel", "Add a light where you look"), async () => {
                const { ok, light: id } = await app.ask("light add", addKind.value);
                if (ok) chosen = id ?? 0;
                panel.show();
            });
            const copy =
                tipped(of("LightsPanel", "Copy"), of("LightsPanel", "Add a light like the selected one, in its place"),
                () => app.ask("light copy", chosen));
            const remove = tipped(of("LightsPanel", "Remove"), of("LightsPanel", "Remove the selected light"),
                () => app.ask("light remove", chosen));
            place.append(list, empty, make("div", { className: "actions" }, addKind, plus),
                make("div", { className: "actions" }, copy, remove), fields);
            addFields();
            rows.push({ element: copy.parentElement, when: () => true,
                show: (_, enabled) => ((copy.disabled = !enabled), (remove.disabled = !enabled)) });
        },
        show() {
            const lights = app.state.lights ?? [], one = light(), may = app.mayEdit();
            const now = JSON.stringify([lights.map(({ id, on, name, kind }) => [id, on, name, kind]), chosen, may]);
            if (now !== last) refill(list, lights.map(item));
            last = now;
            empty.hidden = lights.length > 0;
            fields.hidden = !one?.kind;
            for (const each of [plus, addKind]) each.disabled = !may;
            for (const { element, when, show } of rows) {
                element.hidden = !one?.kind || !when(one);
                if (!element.hidden) show(one, may);
            }
        },
    };
    return panel;
}
