/**
 * Decodes what comes and draws it, newest first; two decodes at a time; of what waits meanwhile only the newest is
 * decoded. A still is put together of its parts and drawn only over what it is the still of.
 */
import { decode } from "./decoder.js";
import { FRAME, STILL, payloadOf } from "./wire.js";

const MAX_DECODES = 2, MAX_STILL = 1 << 28;
const media = ["image/jpeg", "image/png"];

export class Painter {
    /**
     * @param {HTMLCanvasElement|OffscreenCanvas} canvas
     * @param {(told: Object) => void} tell `{acks: [[type, stream, number, ms]], drawn?: header, still?: Uint8Array}`
     */
    constructor(canvas, tell) {
        this.canvas = canvas;
        this.context = canvas.getContext("2d", { alpha: false });
        this.tell = tell;
        this.shown = { stream: -1, number: -1n, exact: false };
        this.decodes = 0;
        this.waiting = null;
        this.skipped = []; // acknowledged with the next one that is drawn
        this.still = null;
    }

    /** `header` of readHeader, and the whole message. */
    take(header, buffer) {
        const received = performance.now();
        if (header.type === FRAME) {
            this.still = null;
            this.queue({ header, received, bytes: payloadOf(buffer) });
        } else if (header.type === STILL) {
            this.tell({ acks: [[STILL, header.stream, header.number, performance.now() - received]] });
            this.collect(header, payloadOf(buffer), received);
        }
    }

    collect(header, part, received) {
        if (header.offset === 0) {
            if (header.total > MAX_STILL) return;
            this.still = { header, bytes: new Uint8Array(header.total), filled: 0 };
        }
        const still = this.still;
        const fits = still && still.header.number === header.number && still.header.stream === header.stream &&
            header.offset === still.filled && still.filled + part.length <= still.bytes.length;
        if (!fits) {
            this.still = null;
            return;
        }
        still.bytes.set(part, still.filled);
        still.filled += part.length;
        if (still.filled < still.bytes.length) return;
        this.still = null;
        this.queue({ header: { ...header, offset: 0 }, received, bytes: still.bytes });
    }

    queue(image) {
        if (this.decodes < MAX_DECODES) return void this.begin(image);
        if (this.waiting) this.skip(this.waiting);
        this.waiting = image;
    }

    skip({ header, received }) {
        if (header.type === FRAME) this.skipped.push([FRAME, header.stream, header.number,
            performance.now() - received]);
    }

    async begin(image) {
        ++this.decodes;
        let picture = null;
        try {
            picture = await decode(image.bytes, media[image.header.codec]);
        } catch { /* a broken image is acknowledged and not drawn */ }
        --this.decodes;
        this.draw(image, picture);
        const next = this.waiting;
        this.waiting = null;
        if (next) this.begin(next);
    }

    isNewer({ type, stream, number }) {
        if (stream !== this.shown.stream) return true;
        return number > this.shown.number || (type === STILL && number === this.shown.number && !this.shown.exact);
    }

    draw({ header, received, bytes }, picture) {
        const drawn = picture !== null && this.isNewer(header);
        if (drawn) this.put(header, picture);
        picture?.close();
        const acks = header.type === FRAME ? [[FRAME, header.stream, header.number, performance.now() - received]] : [];
        if (acks.length) acks.unshift(...this.skipped.splice(0));
        const exact = drawn && header.type === STILL && header.atRest && header.codec === 1;
        if (drawn) this.shown.exact = exact;
        this.tell({ acks, drawn: drawn ? { ...header, decodeMs: performance.now() - received,
            at: performance.timeOrigin + performance.now() } : undefined,
            still: exact ? bytes : undefined });
    }

    put({ stream, number, shownWidth, shownHeight }, picture) {
        this.shown = { stream, number, exact: false };
        const { canvas, context } = this;
        if (canvas.width !== shownWidth || canvas.height !== shownHeight) {
            canvas.width = shownWidth;
            canvas.height = shownHeight;
        }
        context.imageSmoothingQuality = "low"; // of an image that is smaller than shown
        picture.drawOn(context, shownWidth, shownHeight);
    }
}
