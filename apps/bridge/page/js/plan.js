/**
 * A small plan of a storey in the corner, with the camera in it; a driver's tap goes there. Loaded when it is first
 * wanted, with its style sheet, so it imports nothing. Positions of the model are in the coordinates of its file,
 * those of the plan in steps to the right and ahead from its lower left corner.
 */
const SVG = "http://www.w3.org/2000/svg", AFTER_EDITS = 1000, UPRIGHT = 0.98, WEDGE = 46, DOT = 4.5; // ms, sine, pixels

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const plus = (a, b, factor) => a.map((part, i) => part + factor * b[i]);

/** The answer to `plan outline`; null: it is none. */
export function readOutline(text) {
    const outline = { solid: [], line: [], light: [], floors: [] };
    for (const row of text.split("\n")) {
        const [name, ...words] = row.split(" "), numbers = words.map(Number);
        if (!numbers.every(Number.isFinite)) return null;
        if (/^(solid|line|light)$/.test(name)) outline[name].push(numbers);
        else outline[name] = /^(storey|top|eye|step)$/.test(name) ? numbers[0] : numbers;
    }
    const whole = ["corner", "right", "ahead", "up"].every((name) => outline[name]?.length === 3);
    return whole && outline.storey >= 0 && outline.step > 0 && outline.size?.length === 2 ? outline : null;
}

/** The number of the storey for an eye at that height, from 1; 0: there are none (outline_text.h of the suite). */
export function storeyAt({ floors, top }, eye) {
    if (floors.length === 0) return 0;
    const below = floors.filter((floor) => floor < eye).length;
    return eye > top ? 1 : Math.max(below, 1);
}

/** Where a position is in the plan. */
export function stepsOf({ corner, right, ahead, step }, position) {
    const off = plus(position, corner, -1);
    return [dot(off, right) / step, dot(off, ahead) / step];
}

/** Where the eye of a person who stands there is; without storeys one at that height along the up axis. */
export function eyeAt({ corner, right, ahead, up, step, storey, eye }, [x, y], height) {
    const floor = plus(plus(corner, right, x * step), ahead, y * step);
    return plus(floor, up, storey > 0 ? eye : height - dot(floor, up));
}

/** Radians from the right, as the plan is turned; null: it looks nowhere in it. */
export function headingOf({ right, ahead, up }, { forward, up: above }) {
    const seen = Math.abs(dot(forward, up)) > UPRIGHT * Math.hypot(...forward) ? above : forward;
    const x = dot(seen, right), y = dot(seen, ahead);
    return Math.hypot(x, y) > 0 ? Math.atan2(y, x) : null;
}

/** Of lines as pairs of numbers. */
export const pathOf = (lines) => lines.map((line) => {
    const count = line.length, closes = line[0] === line[count - 2] && line[1] === line[count - 1];
    return "M" + line.join(" ") + (closes ? "Z" : "");
}).join("");

function shape(tag, attributes) {
    const element = document.createElementNS(SVG, tag);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    return element;
}

export class CornerPlan {
    /** @param {App} app @param {HTMLElement} place @param {(context: string, text: string) => string} of texts.js's */
    constructor(app, place, of) {
        Object.assign(this, { app, place, of, outline: null, wanted: 0, storey: 0, byHand: false, asks: false,
            again: false, seen: "" });
        document.head.append(Object.assign(document.createElement("link"), { rel: "stylesheet", href: "plan.css" }));
        const step = (text, sign, by) => {
            const one = document.createElement("button");
            Object.assign(one, { type: "button", title: text, textContent: sign, onclick: () => this.choose(by) });
            one.setAttribute("aria-label", text);
            return one;
        };
        this.title = document.createElement("span");
        this.below = step(of("CornerPlan", "Show the storey below"), "▼", -1);
        this.above = step(of("CornerPlan", "Show the storey above"), "▲", 1);
        this.picture = shape("svg", { role: "img", "aria-label": of("CornerPlan", "Plan in the corner") });
        this.picture.addEventListener("click", (event) => this.tap(event));
        new ResizeObserver(() => this.follow()).observe(this.picture); // the mark keeps its size
        const head = document.createElement("header");
        head.append(this.title, this.below, this.above);
        place.replaceChildren(head, this.picture);
        this.tell(of("CornerPlanOperations", "The plan is being made…"));
    }

    /** In place of a plan. */
    tell(text) {
        this.outline = null;
        this.title.textContent = text;
        this.picture.replaceChildren();
        this.below.hidden = this.above.hidden = true;
    }

    /** The scene or the camera is another one, or it is shown again. */
    show() {
        const { app } = this, { scene, edits, redo, up } = app.state;
        if (this.place.hidden || !app.status.eye) return;
        const now = JSON.stringify([app.welcome?.instance, scene, edits, redo, up]);
        if (now !== this.seen) {
            clearTimeout(this.timer);
            this.timer = setTimeout(() => this.ask(), this.seen ? AFTER_EDITS : 0);
            this.seen = now;
        }
        this.follow();
    }

    /** A camera that comes to another storey shows that. */
    follow() {
        const { outline, app } = this;
        if (!outline) return;
        const storey = storeyAt(outline, dot(app.status.eye, outline.up));
        if (storey !== this.storey) this.byHand = false;
        this.storey = storey;
        if (!this.byHand && storey > 0) this.want(storey);
        this.showCamera();
    }

    want(storey) {
        if (storey === this.wanted) return;
        this.wanted = storey;
        if (this.asks || storey !== this.outline?.storey) this.ask();
    }

    choose(by) {
        this.byHand = true;
        this.want(this.outline.storey + by);
    }

    /** One question at a time; what is shown stays until the answer is there. */
    async ask() {
        this.again = this.asks;
        if (this.asks || this.place.hidden) return;
        this.asks = true;
        const answer = await this.app.link.request("plan outline", { args: this.wanted ? [this.wanted] : [] });
        this.asks = false;
        if (answer.ok) this.take(readOutline(answer.text));
        else this.refuse(answer);
        if (this.again) this.ask();
    }

    /** A storey that is there no more gives way to that of the camera. */
    refuse({ text, lost }) {
        if (lost) this.seen = ""; // asked again when the server is there
        else if (!this.wanted) this.tell(text);
        this.again ||= this.wanted > 0 && !lost;
        this.wanted = 0;
        this.byHand = false;
    }

    take(outline) {
        if (!outline) return this.tell(this.of("CornerPlanOperations", "The plan cannot be read."));
        this.outline = outline;
        const { storey, floors, size } = outline;
        const nothing = this.of("CornerPlan", "Nothing is cut there.");
        const name = this.of("CornerPlan", "Storey %1 of %2").replace("%1", storey).replace("%2", floors.length);
        this.title.textContent = size[0] + size[1] === 0 ? nothing
            : floors.length > 0 ? name : this.of("CornerPlan", "No storeys: contour lines");
        this.below.hidden = this.above.hidden = floors.length < 2;
        this.below.disabled = storey <= 1;
        this.above.disabled = storey >= floors.length;
        this.paint();
        this.follow();
    }

    paint() {
        const { solid, line, light, size } = this.outline, [wide, high] = size.map((part) => Math.max(part, 1));
        this.picture.setAttribute("viewBox", `0 0 ${wide} ${high}`);
        this.turned = shape("g", { transform: `matrix(1 0 0 -1 0 ${high})` });
        const lines = (all, name) => shape("path", { d: pathOf(all), class: name });
        this.camera = [shape("path", { class: "wedge" }), shape("circle", {})];
        this.turned.append(lines(light, "light"), lines(solid, "solid"), lines(line, "line"), ...this.camera);
        this.picture.replaceChildren(this.turned);
    }

    /** Hollow where it is not on this storey, at the edge where it is beside the plan. */
    showCamera() {
        const { outline, app: { status } } = this, [wedge, circle] = this.camera;
        const pixels = this.turned.getScreenCTM()?.a || 1;
        const [x, y] = stepsOf(outline, status.eye).map((part, i) => Math.min(Math.max(part, 0), outline.size[i]));
        const heading = headingOf(outline, status), half = (Math.min(status.fov || 8, 300) * Math.PI) / 360;
        const end = (angle) => [x + (Math.cos(angle) * WEDGE) / pixels, y + (Math.sin(angle) * WEDGE) / pixels];
        const radius = WEDGE / pixels, wide = half > Math.PI / 2 ? 1 : 0;
        const arc = () => ["M", x, y, "L", ...end(heading - half), "A", radius, radius, 0, wide, 1,
            ...end(heading + half), "Z"];
        wedge.setAttribute("d", heading === null ? "" : arc().join(" "));
        for (const [key, value] of Object.entries({ cx: x, cy: y, r: DOT / pixels })) circle.setAttribute(key, value);
        circle.classList.toggle("elsewhere", outline.storey !== this.storey);
        this.picture.classList.toggle("drives", this.app.drives());
    }

    /** An edit, which can be undone; the direction of the view stays. */
    tap({ clientX, clientY }) {
        const { outline, app } = this, matrix = this.turned?.getScreenCTM()?.inverse();
        if (!outline || !matrix || !app.drives()) return;
        const at = new DOMPoint(clientX, clientY).matrixTransform(matrix);
        const eye = eyeAt(outline, [at.x, at.y], dot(app.status.eye, outline.up));
        app.ask("camera set", ...eye, ...app.status.forward);
    }
}
