/**
 * The talk with the bridge: identifies, comes back by itself after a loss, and knows which requests are under way.
 */
const FIRST_WAIT = 250, MAX_WAIT = 5000, REQUEST_MS = 30000;
/** Close codes after which another try would end the same way. */
const FINAL = new Set([4002, 4003, 4004, 4005, 4010]);

export class Link extends EventTarget {
    /**
     * @param {{open: Function, send: Function, check: Function, close: Function}} stream where the connection is
     * @param {() => Object} hello what the first message says, without `do` and `v`
     */
    constructor(stream, hello) {
        super();
        this.stream = stream;
        this.hello = hello;
        this.serial = 0; // of the connection
        this.wait = FIRST_WAIT;
        this.open = new Map(); // requests under way
        this.queue = [];
        this.lastId = 0;
        this.limit = 4;
        this.greeted = false;
        this.ended = false;
        addEventListener("online", () => this.hurry());
        document.addEventListener("visibilitychange", () => document.visibilityState === "visible" && this.hurry());
        // A page that is left may be kept, with its connection, and be shown again: the bridge is told.
        addEventListener("pagehide", () => this.stream.close());
        addEventListener("pageshow", ({ persisted }) => persisted && this.again());
    }

    connect() {
        clearTimeout(this.timer);
        this.timer = 0;
        this.ended = false;
        const address = new URL("ws", location.href.replace(/[?#].*$/, ""));
        address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
        this.stream.open(++this.serial, address.href, JSON.stringify({ do: "hello", v: 2, ...this.hello() }));
    }

    /** Handles a message or the end of a connection, as the stream reports it. */
    heard({ serial, said, closed }) {
        if (serial !== this.serial) return;
        if (closed) this.onClose(closed.code, closed.reason);
        else this.onMessage(JSON.parse(said));
    }

    /** Another token, instance or a press of the user: at once. */
    again() {
        this.drop();
        this.wait = FIRST_WAIT;
        this.connect();
    }

    /** The next try at once; or a look whether the link still is one. */
    hurry() {
        if (this.greeted || this.ended) return this.stream.check();
        this.wait = FIRST_WAIT;
        this.connect();
    }

    onMessage(said) {
        if (said.event === "answer") return this.onAnswer(said);
        if (said.event === "welcome") {
            this.greeted = true;
            this.wait = FIRST_WAIT;
            this.limit = said.limits?.requests ?? 4;
        }
        this.tell(said.event, said);
    }

    tell(type, detail) {
        this.dispatchEvent(new CustomEvent(type, { detail }));
    }

    onClose(code, reason) {
        this.drop();
        this.ended = FINAL.has(code);
        if (!this.ended) {
            // Many pages that lose one bridge shall not come back in one moment.
            const wait = Math.max(code === 4008 ? 1000 : 0, this.wait * (0.5 + Math.random() / 2));
            this.timer = setTimeout(() => this.connect(), wait);
            this.wait = Math.min(MAX_WAIT, this.wait * 2);
        }
        this.tell("lost", { code, reason, final: this.ended });
    }

    drop() {
        this.greeted = false;
        for (const { resolve, timer } of this.open.values()) {
            clearTimeout(timer);
            resolve({ ok: false, lost: true, text: "" });
        }
        for (const { resolve } of this.queue.splice(0)) resolve({ ok: false, lost: true, text: "" });
        this.open.clear();
    }

    /** Binary. False: there is no connection now. */
    send(message) {
        if (this.greeted) this.stream.send(message);
        return this.greeted;
    }

    /**
     * Asks for something; more than the bridge takes at once waits here.
     * @returns {Promise<{ok: boolean, text: string, lost?: boolean}>} never rejects
     */
    request(what, keys = {}) {
        return new Promise((resolve) => {
            if (!this.greeted) return resolve({ ok: false, lost: true, text: "" });
            this.queue.push({ what, keys, resolve });
            this.pump();
        });
    }

    pump() {
        while (this.queue.length && this.open.size < this.limit) {
            const { what, keys, resolve } = this.queue.shift();
            const id = (this.lastId = (this.lastId + 1) >>> 0);
            const timer = setTimeout(() => this.onAnswer({ id, ok: false, lost: true, text: "" }), REQUEST_MS);
            this.open.set(id, { resolve, timer });
            this.stream.send(JSON.stringify({ id, do: what, ...keys }));
        }
    }

    onAnswer(answer) {
        const waiting = this.open.get(answer.id);
        if (!waiting) return;
        clearTimeout(waiting.timer);
        this.open.delete(answer.id);
        waiting.resolve(answer);
        this.pump();
    }
}
