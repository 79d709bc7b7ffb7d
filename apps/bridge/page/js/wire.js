/** Binary messages, as docs/bridge.md ("Binary") lays them out; all little-endian. */

export const FRAME = 1, STILL = 2;
export const MAX_HELD = 16, MAX_TAPS = 8;
const HEADER = 40, MAX_TURN = 360000, MAX_DECODE = 65535;

/**
 * @param {ArrayBuffer} buffer
 * @returns {Object|null} the header; null for what is none
 */
export function readHeader(buffer) {
    if (buffer.byteLength < HEADER) return null;
    const view = new DataView(buffer);
    const flags = view.getUint16(2, true);
    return {
        type: view.getUint8(0),
        codec: view.getUint8(1),
        atRest: (flags & 2) !== 0,
        stream: view.getUint32(4, true),
        number: view.getBigUint64(8, true),
        width: view.getUint16(16, true),
        height: view.getUint16(18, true),
        shownWidth: view.getUint16(20, true),
        shownHeight: view.getUint16(22, true),
        input: view.getUint32(24, true),
        offset: view.getUint32(32, true),
        total: view.getUint32(36, true),
    };
}

export const payloadOf = (buffer) => new Uint8Array(buffer, HEADER);

const clamp = (value, max) => Math.max(-max, Math.min(max, value));

/** After a frame (`type` FRAME) or a part of a still was drawn or taken. `ms`: from receipt to then. */
export function ackMessage(type, stream, number, ms) {
    const view = new DataView(new ArrayBuffer(16));
    view.setUint8(0, type === FRAME ? 1 : 4);
    view.setUint16(2, Math.min(MAX_DECODE, Math.round(ms * 10)), true);
    view.setUint32(4, stream, true);
    view.setBigUint64(8, number, true);
    return view.buffer;
}

/** `right`, `up`: 1/1000 degree; `taps`, `held`: key codes. */
export function inputMessage(sequence, right, up, taps, held) {
    const keys = held.slice(0, MAX_HELD), pressed = taps.slice(0, MAX_TAPS);
    const bytes = new Uint8Array(16 + keys.length + pressed.length);
    const view = new DataView(bytes.buffer);
    bytes.set([2, keys.length, pressed.length]);
    view.setUint32(4, sequence, true);
    view.setInt32(8, clamp(right, MAX_TURN), true);
    view.setInt32(12, clamp(up, MAX_TURN), true);
    bytes.set(keys, 16);
    bytes.set(pressed, 16 + keys.length);
    return bytes.buffer;
}

/** Its echo comes at once. */
export function pingMessage() {
    const message = new DataView(new ArrayBuffer(16));
    message.setUint8(0, 5);
    return message.buffer;
}

/** @param {{visible: boolean, rung: number, save: boolean, width: number, height: number}} view */
export function viewMessage({ visible, rung, save, width, height }) {
    const message = new DataView(new ArrayBuffer(8));
    message.setUint8(0, 3);
    message.setUint8(1, visible ? 1 : 0);
    message.setUint8(2, rung);
    message.setUint8(3, save ? 1 : 0);
    message.setUint16(4, Math.max(1, Math.min(32767, width)), true);
    message.setUint16(6, Math.max(1, Math.min(32767, height)), true);
    return message.buffer;
}
