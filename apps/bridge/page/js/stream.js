/**
 * The connection and what draws its images. Lives in a worker, where nothing that the page does delays either; in the
 * page where a canvas cannot leave it.
 */
import { Painter } from "./painter.js";
import { FRAME, STILL, ackMessage, pingMessage, readHeader } from "./wire.js";

const SILENCE_MS = 15000, ANSWER_MS = 4000;
const BROKEN = 1006; // as browsers call it

export class Stream {
    /**
     * @param {HTMLCanvasElement|OffscreenCanvas} canvas
     * @param {(what: Object) => void} tell of a connection `{serial, said: string}`,
     *     `{serial, closed: {code, reason}}`; of an image `{drawn: header, still?: Uint8Array}`
     */
    constructor(canvas, tell) {
        this.tell = tell;
        this.painter = new Painter(canvas, (told) => this.onPainted(told));
        this.socket = null;
        this.received = 0; // messages
        let before = 0;
        setInterval(() => {
            if (this.received === before) this.check();
            before = this.received;
        }, SILENCE_MS);
    }

    /** Connects in place of the last connection, and says `hello`. */
    open(serial, address, hello) {
        this.close();
        const socket = (this.socket = new WebSocket(address, "rtbridge.1"));
        const mine = (what) => (event) => socket === this.socket && what(event);
        socket.binaryType = "arraybuffer";
        socket.onopen = mine(() => socket.send(hello));
        socket.onmessage = mine(({ data }) => {
            ++this.received;
            if (typeof data === "string") this.tell({ serial, said: data });
            else this.take(data);
        });
        socket.onclose = mine(({ code, reason }) => this.tell({ serial, closed: { code, reason } }));
        this.lose = mine(() => {
            this.close();
            this.tell({ serial, closed: { code: BROKEN, reason: "" } });
        });
    }

    /** Text or binary; lost where there is no connection now. */
    send(message) {
        if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(message);
    }

    /**
     * After a sleep, or in another network, a connection may be gone without a word: then nothing answers a ping.
     */
    check() {
        if (this.socket?.readyState !== WebSocket.OPEN) return;
        const { lose, received } = this;
        this.send(pingMessage());
        setTimeout(() => this.received === received && lose(), ANSWER_MS);
    }

    /** Ends the connection, if there is one, and tells nothing of it. */
    close() {
        const { socket } = this;
        this.socket = null;
        socket?.close(1000);
    }

    take(buffer) {
        const header = readHeader(buffer);
        if (header && (header.type === FRAME || header.type === STILL)) this.painter.take(header, buffer);
    }

    onPainted({ acks, drawn, still }) {
        for (const [type, stream, number, ms] of acks) this.send(ackMessage(type, stream, number, ms));
        if (drawn) this.tell({ drawn, still });
    }
}
