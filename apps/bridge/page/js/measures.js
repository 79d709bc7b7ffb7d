/**
 * The measures of the scene over the image: lines and labels, by the camera of the last status. A driver may measure
 * by taps.
 */
import { byId } from "./dom.js";
import { imageIn } from "./scene_image.js";
import { number, of, t } from "./texts.js";

const SVG = "http://www.w3.org/2000/svg", POWERS = ["", "", "²", "³"];

function shape(tag, attributes, text) {
    const element = document.createElementNS(SVG, tag);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (text) element.textContent = text;
    return element;
}

/** "2.350 m", "90.0°". @param {{value: number, power: number, decimals: number}} measure */
export function measureText({ value, power, decimals }, unit) {
    return number(value, decimals) + (power === 0 ? "°" : " " + unit + POWERS[power]);
}

const middle = (a, b) => a.map((part, index) => (part + b[index]) / 2);

/** Texts and where they are: that of the whole, and those of the legs of a chain. */
export function labelsOf({ name, kind, points, legs, ...whole }, unit) {
    const sum = kind === "chain" ? "Σ " : "", text = (name ? name + " " : "") + sum + measureText(whole, unit);
    const place = kind === "chain" ? points.at(-1) : kind === "angle" ? points[1]
        : points.length === 2 ? middle(points[0], points[1]) : points[0];
    return [{ point: place, text, below: kind === "chain" },
        ...legs.map((leg, index) => ({ point: middle(points[index], points[index + 1]),
            text: measureText(leg, unit) }))];
}

export class Measures {
    constructor(app) {
        this.app = app;
        this.place = byId("measures");
        this.tool = null; // measures by taps, once it was wanted
        this.place.addEventListener("click", (event) => this.tap(event));
        addEventListener("keydown", (event) => event.key === "Escape" && this.stop());
        new ResizeObserver(() => this.show()).observe(byId("view"));
    }

    get all() {
        return this.app.state.measures?.all ?? [];
    }

    get unit() {
        return this.app.state.measures?.unit ?? "m";
    }

    /** Taps of that kind follow. */
    async start(kind) {
        this.app.notes.stop();
        const loaded = await import("./measuring.js").catch(() => null); // without a connection
        if (loaded) this.tool ??= new loaded.Measuring(this.app, () => this.show(), { t, of, number });
        this.tool?.start(kind);
    }

    stop() {
        this.tool?.stop();
    }

    tap({ clientX, clientY }) {
        const at = this.app.picture.at(clientX, clientY);
        if (at) this.tool?.tap(at);
    }

    /** Paints them anew. */
    show() {
        const measuring = Boolean(this.tool?.kind);
        if (measuring && !this.app.mayEdit()) return this.stop();
        this.place.classList.toggle("measuring", measuring);
        const shown = (this.all.length > 0 || measuring) && imageIn(this.place, this.app);
        if (!shown) return this.place.replaceChildren();
        const { image } = shown;
        const all = this.all.filter(({ cut }) => !cut); // no line over a label
        const marks = [...all.flatMap((one) => this.linesOf(one, image)),
            ...all.flatMap((one) => this.textsOf(one, image))];
        if (measuring) marks.push(...this.tool.marks(image, shape));
        this.place.replaceChildren(...marks);
    }

    linesOf({ points }, image) {
        const lines = [];
        for (let i = 1; i < points.length; ++i) {
            const ends = image.line(points[i - 1], points[i]);
            if (!ends) continue;
            const [{ x: x1, y: y1 }, { x: x2, y: y2 }] = ends;
            lines.push(shape("line", { x1, y1, x2, y2, class: "under" }), shape("line", { x1, y1, x2, y2 }));
        }
        return lines;
    }

    textsOf(measure, image) {
        return labelsOf(measure, this.unit).map(({ point, text, below }) => {
            const at = image.at(point);
            return at && shape("text", { x: at.x, y: at.y + (below ? 18 : 0) }, text);
        }).filter(Boolean);
    }
}
