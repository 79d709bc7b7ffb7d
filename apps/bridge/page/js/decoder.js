/**
 * Bytes of a JPEG or PNG to what a canvas can draw. ImageDecoder, which only secure pages of some browsers have, takes
 * the bytes as they are and gives pixels in a third of the time of createImageBitmap, which takes them as a file.
 */
import { stripsOf } from "./jpeg_strips.js";

// No conversion of colours: at rest each byte is the server's.
const exactly = { colorSpaceConversion: "none", premultiplyAlpha: "none" };

let canvas = null; // the last one, of smaller images

/** A canvas with these pixels, until the next one is asked for: they are put as they are, never scaled. */
function canvasOf(image) {
    const fits = canvas?.width === image.width && canvas.height === image.height;
    if (!fits) canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext("2d", { alpha: false }).putImageData(image, 0, 0);
    return canvas;
}

/** Pixels that were copied out of the decoder. */
class Pixels {
    constructor(image) {
        this.image = image;
    }

    drawOn(context, width, height) {
        const { image } = this;
        if (image.width === width && image.height === height) return context.putImageData(image, 0, 0);
        context.drawImage(canvasOf(image), 0, 0, width, height);
    }

    close() {
        spare.push(this.image);
        if (spare.length > MAX_SPARE) spare.shift();
    }
}

const MAX_SPARE = 2, spare = []; // memory for the next images of the same size

function roomOf({ width, height }) {
    const same = spare.findIndex((image) => image.width === width && image.height === height);
    return same < 0 ? new ImageData(width, height) : spare.splice(same, 1)[0];
}

/**
 * `roomFor` gets width and height of what was decoded, and gives where its pixels go; `transfer`: buffers that go to
 * the decoder.
 */
async function decodeInto(roomFor, bytes, type, transfer = []) {
    const decoder = new ImageDecoder({ data: bytes, type, transfer, colorSpaceConversion: "none" });
    try {
        const { image: frame } = await decoder.decode();
        try {
            await frame.copyTo(roomFor(frame.visibleRect), { format: "RGBA", colorSpace: "srgb" });
        } finally {
            frame.close();
        }
    } finally {
        decoder.close();
    }
}

async function decodePixels(bytes, type) {
    const parts = type === "image/jpeg" ? stripsOf(bytes) : null;
    let image = parts && roomOf(parts);
    const whole = (size) => (image = roomOf(size)).data;
    const strip = (top) => () => image.data.subarray(4 * image.width * top);
    if (parts) await Promise.all(parts.strips.map((part) =>
        decodeInto(strip(part.top), part.bytes, type, [part.bytes.buffer])));
    else await decodeInto(whole, bytes, type);
    return new Pixels(image);
}

/** An image as an ImageBitmap, which every browser has. */
class Bitmap {
    constructor(image) {
        this.image = image;
    }

    drawOn(context, width, height) {
        context.drawImage(this.image, 0, 0, width, height);
    }

    close() {
        this.image.close();
    }
}

let hasDecoder = typeof ImageDecoder === "function" && typeof OffscreenCanvas === "function";

/**
 * @param {Uint8Array} bytes
 * @param {string} type its media type
 * @returns {Promise<{drawOn: (context, width: number, height: number) => void, close: () => void}>} rejects for a
 *     broken image
 */
export async function decode(bytes, type) {
    if (hasDecoder) {
        try {
            return await decodePixels(bytes, type);
        } catch (error) {
            // some copy in their own format only
            hasDecoder = error.name !== "NotSupportedError" && error.name !== "TypeError";
        }
    }
    return new Bitmap(await createImageBitmap(new Blob([bytes], { type }), exactly));
}
