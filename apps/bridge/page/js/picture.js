/** The image: hands what comes to the painter, acknowledges what it drew, and keeps the exact bytes of an image at rest. */
import { Painter } from "./painter.js";
import { FRAME, STILL, ackMessage, readHeader } from "./wire.js";

export class Picture {
    /**
     * @param {HTMLCanvasElement} canvas
     * @param {(ack: ArrayBuffer) => void} send
     * @param {(header: Object) => void} onDrawn after each image that was drawn; `decodeMs`, and `exact`
     */
    constructor(canvas, send, onDrawn) {
        this.canvas = canvas;
        this.send = send;
        this.onDrawn = onDrawn;
        this.exact = null; // the bytes of the PNG that is shown
        this.aspect = 16 / 9;
        this.start();
    }

    start() {
        const told = (what) => this.told(what);
        const offscreen = typeof this.canvas.transferControlToOffscreen === "function" && typeof OffscreenCanvas === "function";
        if (!offscreen) return void (this.painter = new Painter(this.canvas, told));
        this.worker = new Worker(new URL("picture_worker.js", import.meta.url), { type: "module" });
        this.worker.onmessage = ({ data }) => told(data);
        const canvas = this.canvas.transferControlToOffscreen();
        this.worker.postMessage({ canvas }, [canvas]);
    }

    /** A binary message of the bridge. */
    take(buffer) {
        const header = readHeader(buffer);
        if (!header || (header.type !== FRAME && header.type !== STILL)) return header;
        if (this.worker) this.worker.postMessage({ header, buffer }, [buffer]);
        else this.painter.take(header, buffer);
        return header;
    }

    told({ acks, drawn, still }) {
        for (const [type, stream, number, ms] of acks) this.send(ackMessage(type, stream, number, ms));
        if (!drawn) return;
        this.exact = still ?? null;
        this.aspect = drawn.shownWidth / drawn.shownHeight;
        this.onDrawn({ ...drawn, exact: still !== undefined });
    }

    /** Where the image lies in the canvas, CSS pixels of the window. */
    box() {
        const room = this.canvas.getBoundingClientRect();
        const width = Math.min(room.width, room.height * this.aspect), height = width / this.aspect;
        return { x: room.x + (room.width - width) / 2, y: room.y + (room.height - height) / 2, width, height };
    }

    /** A point of the window as 0..1 from the left and the top of the image; null beside it. */
    at(clientX, clientY) {
        const box = this.box();
        const x = (clientX - box.x) / box.width, y = (clientY - box.y) / box.height;
        return x >= 0 && x <= 1 && y >= 0 && y <= 1 ? { x, y } : null;
    }

    /** A small JPEG of what is shown, as a data URL. */
    thumbnail(width, height) {
        const small = document.createElement("canvas");
        small.width = width;
        small.height = height;
        const cut = Math.min(this.canvas.width / width, this.canvas.height / height);
        const w = width * cut, h = height * cut;
        small.getContext("2d").drawImage(this.canvas, (this.canvas.width - w) / 2, (this.canvas.height - h) / 2, w, h, 0, 0, width, height);
        return small.toDataURL("image/jpeg", 0.7);
    }
}
