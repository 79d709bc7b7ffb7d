/**
 * Bytes of a JPEG or PNG to what a canvas can draw. ImageDecoder, which only secure pages of some browsers have, takes the
 * bytes as they are and gives pixels in a third of the time of createImageBitmap, which takes them as a file.
 */

// No conversion of colours: at rest each byte is the server's.
const exactly = { colorSpaceConversion: "none", premultiplyAlpha: "none" };

/** Pixels that were copied out of the decoder. */
class Pixels {
    constructor(image) {
        this.image = image;
    }

    drawOn(context, width, height) {
        const { image } = this;
        if (image.width === width && image.height === height) return context.putImageData(image, 0, 0);
        const own = new OffscreenCanvas(image.width, image.height); // pixels are put as they are, never scaled
        own.getContext("2d", { alpha: false }).putImageData(image, 0, 0);
        context.drawImage(own, 0, 0, width, height);
    }

    close() {
        spare.push(this.image);
        if (spare.length > MOST_SPARE) spare.shift();
    }
}

const MOST_SPARE = 2, spare = []; // memory for the next images of the same size

function roomFor(width, height) {
    const same = spare.findIndex((image) => image.width === width && image.height === height);
    return same < 0 ? new ImageData(width, height) : spare.splice(same, 1)[0];
}

async function decodePixels(bytes, type) {
    const decoder = new ImageDecoder({ data: bytes, type, colorSpaceConversion: "none" });
    try {
        const { image: frame } = await decoder.decode();
        try {
            const image = roomFor(frame.visibleRect.width, frame.visibleRect.height);
            await frame.copyTo(image.data, { format: "RGBA", colorSpace: "srgb" });
            return new Pixels(image);
        } finally {
            frame.close();
        }
    } finally {
        decoder.close();
    }
}

/** What every browser has. */
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
 * @returns {Promise<{drawOn: (context, width: number, height: number) => void, close: () => void}>} rejects for a broken image
 */
export async function decode(bytes, type) {
    if (hasDecoder) {
        try {
            return await decodePixels(bytes, type);
        } catch (error) {
            hasDecoder = error.name !== "NotSupportedError" && error.name !== "TypeError"; // some copy in their own format only
        }
    }
    return new Bitmap(await createImageBitmap(new Blob([bytes], { type }), exactly));
}
