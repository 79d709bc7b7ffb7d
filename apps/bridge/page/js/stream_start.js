/** Starts the stream: in a worker where the canvas can go there. */
import { Stream } from "./stream.js";

const VERSION_OLD = 4010; // a page without all its files is to be loaded anew

/**
 * @param {HTMLCanvasElement} canvas
 * @param {(what: Object) => void} tell as the stream has it
 * @returns {{open: Function, send: Function, check: Function, close: Function}} as the stream has them; a message that
 *     is sent is no longer the sender's
 */
export function startStream(canvas, tell) {
    const canLeave = typeof canvas.transferControlToOffscreen === "function" && typeof OffscreenCanvas === "function";
    if (!canLeave) return new Stream(canvas, tell);
    let serial = 0;
    const worker = new Worker(new URL("stream_worker.js", import.meta.url));
    worker.onmessage = ({ data }) => tell(data);
    worker.onerror = ({ message }) => message === undefined
        && tell({ serial, closed: { code: VERSION_OLD, reason: "" } });
    const surface = canvas.transferControlToOffscreen();
    worker.postMessage(["start", surface], [surface]);
    return {
        open: (...words) => {
            serial = words[0];
            worker.postMessage(["open", ...words]);
        },
        check: () => worker.postMessage(["check"]),
        close: () => worker.postMessage(["close"]),
        send: (message) => worker.postMessage(["send", message], typeof message === "string" ? [] : [message]),
    };
}
