/** Figures over the image (F3): what the server draws, what is shown here, and how the link does. */
import { byId, make } from "./dom.js";
import { number, t } from "./texts.js";

const KEPT = 120; // delays of inputs that figures are made of

export class Statistics {
    constructor() {
        this.place = byId("statistics");
        this.times = [];  // when images were drawn
        this.delays = [];
        this.decodes = [];
        this.link = null;
        this.image = { paths: false };
        this.onChange = () => {};
    }

    get isOn() {
        return !this.place.hidden;
    }

    toggle(on = !this.isOn) {
        this.place.hidden = !on;
        clearInterval(this.timer);
        if (on) this.timer = setInterval(() => this.show(), 500);
        this.show();
        this.onChange();
    }

    /** An image was drawn. `delay`: since its input was sent, ms; null: of none. */
    drawn(header, delay) {
        const now = performance.now();
        this.times.push(now);
        while (this.times[0] < now - 2000) this.times.shift();
        this.header = header;
        this.keep(this.decodes, header.decodeMs);
        if (delay !== null) this.keep(this.delays, delay);
    }

    keep(list, value) {
        list.push(value);
        if (list.length > KEPT) list.shift();
    }

    quantile(list, part) {
        const sorted = [...list].sort((a, b) => a - b);
        return sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * part))] ?? 0;
    }

    pair(list) {
        return list.length ? t("ms2", number(this.quantile(list, 0.5), 1), number(this.quantile(list, 0.95), 1)) : "–";
    }

    imageText() {
        const { samples, error } = this.image;
        const parts = [t("byPaths", number(samples))];
        if (error !== undefined) parts.push(t("imageError", number(error, error < 1 ? 2 : 1)));
        return parts.join(" · ");
    }

    rows() {
        const { status = {}, link, header } = this;
        const now = performance.now(), recent = this.times.filter((time) => time > now - 2000).length / 2;
        const rows = [[t("statServer"), status.idle ? t("idle") : t("perSecond", number(status.fps ?? 0, 1))],
            [t("statShown"), t("perSecond", number(recent, 1))],
            [t("statFrame"), t("ms", number(status.frameMs ?? 0, 1))], [t("statDelay"), this.pair(this.delays)],
                [t("statDecode"), this.pair(this.decodes)]];
        if (this.image.paths) rows.push([t("statImage"), this.imageText()]);
        if (header) rows.push([t("statSize"),
            `${header.width} × ${header.height} / ${header.shownWidth} × ${header.shownHeight}`]);
        if (link) {
            const size = link.divide === 1 ? t("fullSize") : t("part", link.divide);
            rows.push([t("statLink"), t("mbit", number(link.mbit, 1)) + ", " + t("rung", size, link.quality)],
                [t("statTrip"), t("ms", number(link.rttMs, 1))],
                [t("statDropped"), number(link.skipped)]);
        }
        if (status.eye) rows.push([t("statPlace"), status.eye.map((part) => number(part, 2)).join("  ")]);
        return rows;
    }

    show() {
        if (!this.isOn) return;
        this.place.replaceChildren(make("dl", {}, ...this.rows().flatMap(([what, value]) =>
            [make("dt", {}, what), make("dd", {}, value)])));
    }
}
