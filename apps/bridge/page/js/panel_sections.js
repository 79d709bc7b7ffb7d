/** The panel of the planes that cut the model open, and of what closes the solids that they cut. */
import { cross, dot, scaled, unit as unitOf } from "./directions.js";
import { button, make } from "./dom.js";
import { choice, colour, numeric, toggle } from "./fields.js";
import { of, t } from "./texts.js";

const text = (english) => of("SectionsPanel", english);
const AXES = ["x", "y", "z"], ON_AXIS = 0.9999;

/** Unit vectors above, in front and to the right of the model. */
export function sidesOf(up) {
    const right = up[0] === 0 ? [1, 0, 0] : [0, 1, 0];
    return { above: up, front: cross(right, up), right };
}

/** "-z" of [0, 0, -1]. */
export function axisName(unit) {
    const at = unit.findIndex((part) => Math.abs(part) > ON_AXIS);
    return (unit[at] < 0 ? "-" : "") + AXES[at];
}

/** The side that a section takes away, "above %1", and the line along which its position is told. */
export function sideOf(normal, up) {
    const unit = unitOf(normal), { above, front, right } = sidesOf(up);
    const sides = [[above, "above %1", "below %1"], [front, "in front of %1", "behind %1"],
        [right, "right of %1", "left of %1"]];
    for (const [axis, there, opposite] of sides) {
        const along = dot(axis, unit);
        if (Math.abs(along) < ON_AXIS) continue;
        const line = axis.map(Math.abs);
        return { away: text(along > 0 ? there : opposite), axis: axisName(line), along: line };
    }
    return { away: text("beyond %1"), axis: "", along: unit };
}

/** From where to where a plane along `along` meets the box. */
export function trackOf(along, { lo, hi }) {
    const middle = dot(along, scaled(lo.map((low, i) => low + hi[i]), 0.5));
    const reach = dot(along.map(Math.abs), scaled(hi.map((high, i) => high - lo[i]), 0.5));
    return { min: middle - reach, max: middle + reach };
}

export function sectionsPanel(app) {
    let cuts, list, rows, all, style, shape;

    const sections = () => app.state.sections;
    const unit = () => app.state.metresPerUnit;
    const ask = (command) => (value) => app.ask(command, value);

    function addCuts(place) {
        const cut = (english, tip, side) => {
            const one = button(text(english), () => app.ask("section through", axisName(sidesOf(app.state.up)[side])));
            one.title = text(tip);
            return one;
        };
        const here = button(text("Here"), () => app.ask("section here", 0.5, 0.5));
        here.title = text("Cut along the face in the middle of the image: what lies before it is taken away");
        cuts = [cut("From above", "Take the upper half of the model away", "above"),
            cut("From the front", "Take the front half of the model away", "front"),
            cut("From the right", "Take the right half of the model away", "right"), here];
        place.append(make("div", { className: "actions", role: "group", "aria-label": text("Cut the model open") },
            ...cuts));
    }

    /** A plane: a slider through the model, the other side, none of it. */
    function addRow({ point, normal }, number) {
        const { away, axis, along } = sideOf(normal, app.state.up), track = trackOf(along, sections().bounds);
        const name = away.replace("%1", axis ? axis + " =" : "").trim();
        const metres = (value) => value * unit();
        const move = (value, goesOn) => {
            const by = value / unit() - dot(along, sections().planes[number - 1].point);
            const now = sections().planes[number - 1].point.map((part, i) => part + along[i] * by);
            app.edit("section at " + number, "section at", [number, ...now], goesOn);
        };
        const position = numeric(number + "  " + name, move,
            { min: metres(track.min), max: metres(track.max), unit: "m", even: true, decimals: 4,
                help: text("In the coordinates of the model's file") });
        const turn = button(text("Turn"), () => app.ask("section turn", number));
        turn.title = text("Take the other side away");
        const remove = button(text("Remove"), () => app.ask("section remove", number));
        list.append(position.element, make("div", { className: "actions" }, turn, remove));
        rows.push({ show(may) {
            position.show(metres(dot(along, sections().planes[number - 1].point)), may);
            turn.disabled = remove.disabled = !may;
        } });
    }

    /** Rows are made anew where their planes are others, not where one moves. */
    function makeRows() {
        const now = JSON.stringify([sections().planes.map(({ normal }) => normal), sections().bounds, app.state.up,
            unit()]);
        if (now === shape) return;
        shape = now;
        rows = [];
        list.replaceChildren();
        sections().planes.forEach((plane, i) => addRow(plane, i + 1));
    }

    function addStyle(place) {
        const light = choice(text("Light"), [["whole", text("Rooms keep their light")],
            ["cut", text("Light falls in")]], ask("section light"),
            { help: text("Whether light, too, passes where the model is taken away") });
        const caps = choice(text("Caps"), [["own", text("Colours of materials")], ["one", text("One colour")],
            ["none", text("None")]], ask("section caps"), { help: text("Areas that close the solids that are cut") });
        const paint = colour(text("Colour"), (linear, goesOn) =>
            app.edit("section colour", "section colour", linear, goesOn));
        const hatching = toggle(text("Hatching"), (on) => app.ask("section hatching", on ? "on" : "off"),
            { help: text("Lines across caps") });
        style = { light, caps, paint, hatching };
        place.append(make("h3", {}, text("Light and caps")), ...Object.values(style).map(({ element }) => element));
    }

    return {
        id: "sections",
        fill(place) {
            shape = null;
            addCuts(place);
            list = make("div", { role: "group", "aria-label": t("sections") });
            all = button(text("Remove all"), () => app.ask("section clear"));
            all.title = text("The model is whole again");
            place.append(list, make("div", { className: "actions" }, all));
            addStyle(place);
        },
        show() {
            if (!sections()) return;
            const may = app.mayEdit(), { planes, light, caps, colour: paint, hatching, max } = sections();
            makeRows();
            for (const one of rows) one.show(may);
            for (const one of cuts) one.disabled = !may || planes.length >= max;
            all.disabled = !may || planes.length === 0;
            style.light.show(light, may);
            style.caps.show(caps, may);
            style.paint.show(paint, may && caps === "one");
            style.hatching.show(hatching, may && caps !== "none");
        },
    };
}
