/**
 * Measuring by taps. Loaded when it is first wanted, so it imports nothing. The server catches corners and edges, and
 * what is caught is a point of the model: the view may change between two taps.
 */
const MAX_CHAIN = 64, MIN_CHAIN = 3, LIGHT_PATHS = 10000;

/** How many points a kind is measured by; the others are asked for by where the image was tapped. */
const POINTS = { distance: 2, chain: MAX_CHAIN, angle: 3, height: 1 };

/** The position that `measure point` answers with; null: none. */
export function caughtPoint(answer) {
    const numbers = answer.split("\n")[0].split(" ").slice(1).map(Number);
    return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : null;
}

/** What `measure light` answers, for people: "512.3 lx ± 3.1, 120.1 cd/m² ± 1.0". */
export function lightText(answer, number) {
    const texts = [];
    for (const [name, unit] of [["illuminance", "lx"], ["luminance", "cd/m2"]]) {
        const line = new RegExp(`^${name} ([0-9.]+) ${unit}, standard error ([0-9.]+)$`, "m").exec(answer);
        if (!line) continue;
        const [, value, error] = line, digits = (value.split(".")[1] ?? "").length;
        texts.push(`${number(Number(value), digits)} ${unit.replace("2", "²")} ± ${number(Number(error), digits)}`);
    }
    return texts.join(", ");
}

export class Measuring {
    /**
     * @param {App} app
     * @param {() => void} changed the marks are to be painted anew
     * @param {{t: Function, of: Function, number: Function}} words of texts.js
     */
    constructor(app, changed, words) {
        Object.assign(this, { app, changed, words, kind: "", points: [] });
    }

    /** @param {"distance"|"chain"|"angle"|"height"|"area"|"volume"|"light"} kind */
    start(kind) {
        this.kind = kind;
        this.points = [];
        this.hint();
        this.changed();
    }

    stop() {
        if (!this.kind) return;
        this.kind = "";
        this.points = [];
        this.app.notices.hide("measure");
        this.changed();
    }

    hint() {
        const { t } = this.words, { kind } = this;
        const key = { distance: "measureTaps", chain: "measureTapsChain", angle: "measureTapsAngle" }[kind];
        const actions = [[t("measureStop"), () => this.stop()]];
        if (kind === "chain" && this.points.length > 1) actions.unshift([t("measureKeep"), () => this.keepPoints()]);
        this.app.notices.show("measure", t(key ?? "measureTap"), { lasting: true, actions });
    }

    /** Of the kinds that are measured where the image was tapped. */
    async tap({ x, y }) {
        const { kind } = this;
        if (kind in POINTS) return this.tapPoint(x, y);
        this.stop();
        if (kind === "area") return this.app.ask("measure keep face", x, y);
        if (kind === "volume") return this.keepVolume(x, y);
        if (kind === "light") return this.tellLight(x, y);
    }

    async tapPoint(x, y) {
        const { points, kind } = this, answer = await this.app.ask("measure point", x, y);
        const point = answer.ok && caughtPoint(answer.text);
        if (!point || this.points !== points || this.kind !== kind) return; // stopped, or begun anew
        points.push(point);
        if (points.length === POINTS[kind]) return this.keepPoints();
        this.hint();
        this.changed();
    }

    keepPoints() {
        const { points } = this;
        const kind = this.kind === "chain" && points.length < MIN_CHAIN ? "distance" : this.kind;
        this.stop();
        return this.app.ask("measure keep " + kind, ...points.flat());
    }

    async keepVolume(x, y) {
        const answer = await this.app.ask("seen", x, y);
        if (answer.part) return this.app.ask("measure keep volume", String(answer.part.number));
        if (answer.ok) this.tellNothing();
    }

    async tellLight(x, y) {
        const { notices } = this.app, { t, of, number } = this.words;
        notices.show("measured", t("measureRuns"), { lasting: true });
        const answer = await this.app.ask("measure light", x, y, LIGHT_PATHS);
        notices.hide("measured");
        if (!answer.ok) return;
        const unitless = answer.text.includes("no absolute unit");
        const text = lightText(answer.text, number)
            + (unitless ? "; " + of("gui", "some light has no absolute unit") : "");
        notices.show("measured", text, { lasting: true, actions: [[t("close"), () => {}]] });
    }

    tellNothing() {
        const text = this.words.of("MeasureOperations", "Nothing of the model is seen there.");
        this.app.notices.show("failed", text, { warn: true });
    }

    /** Marks for the points so far. @param {(tag: string, attributes: object) => SVGElement} shape */
    marks(image, shape) {
        const marks = [];
        for (let i = 1; i < this.points.length; ++i) {
            const ends = image.line(this.points[i - 1], this.points[i]);
            if (ends) marks.push(shape("line", { x1: ends[0].x, y1: ends[0].y, x2: ends[1].x, y2: ends[1].y }));
        }
        for (const at of this.points.map((point) => image.at(point)).filter(Boolean))
            marks.push(shape("circle", { r: 5, cx: at.x, cy: at.y }));
        return marks;
    }
}
