import { decode } from "./decoder.js";
import { atMost, equal, isTrue } from "./expect.js";
import { stripsOf } from "./jpeg_strips.js";

// The bytes that the file beside the page lists.
async function listed(file) {
    return new Uint8Array(await new Promise((done) => {
        const asked = new XMLHttpRequest();
        asked.onload = () => done(JSON.parse(asked.responseText));
        asked.open("GET", file);
        asked.send();
    }));
}

// A frame in strips, of the bridge's own encoder, is decoded in parts, to what the browser makes of the whole.
export async function aJpegOfStripsIsDecodedInParts({ file, size }) {
    const bytes = await listed(file);
    const context = new OffscreenCanvas(...size).getContext("2d", { willReadFrequently: true });
    const read = () => context.getImageData(0, 0, ...size).data;
    const whole = await createImageBitmap(new Blob([bytes], { type: "image/jpeg" }));
    context.drawImage(whole, 0, 0);
    const expected = read();
    context.clearRect(0, 0, ...size);
    (await decode(bytes, "image/jpeg")).drawOn(context, ...size);
    equal(typeof ImageDecoder, "function");
    equal(stripsOf(bytes).strips.map(({ top }) => top), [0, 400]);
    atMost(read().reduce((max, value, i) => Math.max(max, Math.abs(value - expected[i])), 0), 8);

    const start = bytes.slice(0, 3000);
    equal(await decode(start, "image/jpeg").then(() => "decoded", () => "refused"), "refused");
    equal([start, bytes.slice(0, 12), new Uint8Array(), new Uint8Array(40)].map(stripsOf), [null, null, null, null]);
}

// Browsers without ImageDecoder, and pages that are not secure, decode otherwise, to the same.
export async function bothWaysOfDecodingKeepEachPixel() {
    const size = [61, 33], count = size[0] * size[1];
    const make = () => new OffscreenCanvas(...size).getContext("2d", { alpha: false, willReadFrequently: true });
    const drawn = new ImageData(...size), source = make();
    for (let i = 0; i < 4 * count; ++i) drawn.data[i] = i % 4 === 3 ? 255 : (i * 7919) >> 3;
    source.putImageData(drawn, 0, 0);
    const bytes = new Uint8Array(await (await source.canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
    const look = async (decoding, kind) => {
        const picture = await decoding(bytes, "image/png"), target = make();
        picture.drawOn(target, ...size);
        equal(picture.constructor.name, kind);
        isTrue(target.getImageData(0, 0, ...size).data.every((value, i) => value === drawn.data[i]), kind);
        picture.drawOn(target, 30, 16); // smaller, too
        picture.close();
    };
    await look(decode, "Pixels");
    await look(decode, "Pixels"); // in memory that was used before
    delete globalThis.ImageDecoder;
    await look((await import("./decoder.js?without")).decode, "Bitmap");
}
