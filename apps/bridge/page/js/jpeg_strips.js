/** Takes a JPEG apart at its restart markers (ITU-T T.81, E.1.4): strips that can be decoded at the same time. */
const FRAME = 0xc0, FIRST_RESTART = 0xd0, END = 0xd9, SCAN = 0xda, INTERVAL = 0xdd;

/** Offsets of frame header and content, rows of a strip, size; null where the image is not one of strips. */
function layoutOf(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    let frame = 0, interval = 0, at = 2;
    for (; at + 4 <= bytes.length && bytes[at] === 0xff && bytes[at + 1] !== SCAN; at += 2 + view.getUint16(at + 2)) {
        if (bytes[at + 1] === FRAME) frame = at;
        if (bytes[at + 1] === INTERVAL) interval = view.getUint16(at + 4);
    }
    if (!frame || !interval || at + 4 > bytes.length) return null;
    const width = view.getUint16(frame + 7), first = bytes[frame + 11]; // the first component has the most samples
    const rows = (interval / Math.ceil(width / (8 * (first >> 4)))) * 8 * (first & 15);
    return Number.isInteger(rows) ? { frame, content: at + 2 + view.getUint16(at + 2), rows, width,
        height: view.getUint16(frame + 5) } : null;
}

/** The image of one strip. */
function imageOf(bytes, { frame, content }, from, until, height) {
    const image = new Uint8Array(content + until - from + 2);
    image.set(bytes.subarray(0, content));
    image.set([height >> 8, height & 255], frame + 5);
    image.set(bytes.subarray(from, until), content);
    image.set([0xff, END], content + until - from);
    return image;
}

/**
 * @param {Uint8Array} bytes of a JPEG
 * @returns {{width: number, height: number, strips: {top: number, bytes: Uint8Array}[]}|null} null where it is to be
 *     decoded as a whole
 */
export function stripsOf(bytes) {
    const layout = layoutOf(bytes);
    if (!layout) return null;
    const { width, height, rows } = layout, strips = [];
    const { length } = bytes;
    let from = layout.content;
    for (let at = from, top = 0; at < length - 1; ++at) {
        if (bytes[at] !== 0xff) continue;
        const marker = bytes[at + 1];
        if ((marker & 0xf8) !== FIRST_RESTART && marker !== END) continue;
        if (top >= height) return null;
        strips.push({ top, bytes: imageOf(bytes, layout, from, at, Math.min(rows, height - top)) });
        top += rows;
        from = at + 2;
    }
    return strips.length === Math.ceil(height / rows) ? { width, height, strips } : null;
}
