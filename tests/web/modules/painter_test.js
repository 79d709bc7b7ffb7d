// The painter of the page by itself: the frames that it draws, and those that it acknowledges.
import { atMost, equal } from "./expect.js";
import { Painter } from "./painter.js";

const surface = new OffscreenCanvas(4, 4);
const told = [];
const painter = new Painter(surface, (what) => told.push(what));

async function encode(colour, type) {
    const canvas = new OffscreenCanvas(4, 4), context = canvas.getContext("2d");
    context.fillStyle = colour;
    context.fillRect(0, 0, 4, 4);
    return new Uint8Array(await (await canvas.convertToBlob({ type, quality: 1 })).arrayBuffer());
}

// Hands the painter such bytes, or a part of them.
function hand(type, number, bytes, [from = 0, until = bytes.length] = []) {
    const part = bytes.subarray(from, until);
    const message = new Uint8Array(40 + part.length);
    message.set(part, 40);
    painter.take({ type, codec: type - 1, stream: 1, number: BigInt(number), atRest: type === 2, last: true,
        width: 4, height: 4, shownWidth: 4, shownHeight: 4, offset: from, total: bytes.length }, message.buffer);
}

// Hands it an image of one colour: type 1 is a frame in motion, 2 a still.
async function take(type, number, colour, cut) {
    hand(type, number, await encode(colour, type === 1 ? "image/jpeg" : "image/png"), cut);
}

// Waits for all decodes.
async function quiet() {
    while (painter.decodes > 0 || painter.waiting) await new Promise((done) => setTimeout(done, 5));
}

// The colour that is shown.
async function shown() {
    await quiet();
    const [red, green, blue] = surface.getContext("2d").getImageData(1, 1, 1, 1).data;
    return red > 200 && green < 60 ? "red" : green > 200 && red < 60 ? "lime" : blue > 200 && red < 60 ? "blue" : "";
}

const acknowledged = () => told.flatMap((what) => what.acks).map(([type, , number]) => `${type}:${number}`);

export async function drawsNewerFramesOnly() {
    await take(1, 5, "red");
    equal(await shown(), "red");
    await take(1, 6, "lime");
    equal(await shown(), "lime");
    await take(1, 4, "blue");
    equal(await shown(), "lime");
    equal(acknowledged(), ["1:5", "1:6", "1:4"], "also what is not drawn");
}

export async function drawsAStillOverItsOwnFrameOnly() {
    await take(1, 5, "red");
    await quiet();
    await take(2, 5, "lime");
    equal(await shown(), "lime");
    await take(1, 6, "red");
    await quiet();
    await take(2, 5, "blue");
    equal(await shown(), "red");
    await take(1, 6, "blue");
    equal(await shown(), "red", "the same frame again");
}

export async function drawsNoStillOfMissingParts() {
    await take(1, 5, "red");
    await quiet();
    await take(2, 5, "lime", [0, 20]);
    await take(2, 5, "lime", [20]);
    equal(await shown(), "lime");
    await take(1, 6, "red");
    await quiet();
    await take(2, 6, "blue", [0, 40]);
    await take(2, 6, "blue", [20]);
    await take(2, 6, "blue", [40]);
    equal(await shown(), "red");
}

export async function acknowledgesWhatItSkips() {
    const red = await encode("red", "image/jpeg");
    for (let i = 1; i <= 30; ++i) hand(1, i, red);
    await quiet();
    atMost(told.filter((what) => what.drawn).length, 4, "two are decoded at a time, and of the others the newest");
    equal(acknowledged().length, 30, acknowledged().join());
}
