import { labelsOf, measureText } from "./measures.js";
import { SceneImage } from "./scene_image.js";
import { equal, isTrue } from "./expect.js";

const VIEW = { eye: [0, 0, 0], forward: [0, 0, -1], up: [0, 1, 0], fov: 90 };
const BOX = { x: 10, y: 0, width: 200, height: 100 };

const rounded = (at) => at && [at.x, at.y].map((part) => Math.round(part * 1e6) / 1e6);

export function pointsAreShownWithPerspectiveAndWithout() {
    const image = new SceneImage(VIEW, 0, BOX);
    equal(rounded(image.at([0, 0, -1])), [110, 50]);
    equal(rounded(image.at([1, 0.5, -2])), [160, 25]);
    equal(image.at([0, 0, 1]), null, "behind the eye");
    const parallel = new SceneImage({ ...VIEW, fov: 0 }, 4, BOX);
    equal(rounded(parallel.at([1, 0.5, -1000])), [160, 25]);
}

export function linesAreClippedBeforeTheEye() {
    const image = new SceneImage(VIEW, 0, BOX);
    equal(image.line([0, 0, -1], [0.5, 0, -1]).map(rounded), [[110, 50], [160, 50]]);
    const ends = image.line([0.5, 0, 9], [0.5, 0, -1]);
    isTrue(ends !== null && ends.every(({ x, y }) => Number.isFinite(x) && Number.isFinite(y)));
    equal(image.line([0, 0, 1], [0, 0, 9]), null);
}

export function measuresHaveLabels() {
    const value = (of, power = 1) => ({ value: of, power, decimals: 2 });
    equal(measureText(value(2.5), "cm"), "2.50 cm");
    equal(measureText(value(2.5, 2), "m"), "2.50 m²");
    equal(measureText(value(45, 0), "m"), "45.00°");
    const distance = { ...value(2), kind: "distance", name: "door", points: [[0, 0, 0], [2, 0, 0]], legs: [] };
    equal(labelsOf(distance, "m"), [{ point: [1, 0, 0], text: "door 2.00 m", below: false }]);
    const chain = { ...value(3), kind: "chain", name: "", points: [[0, 0, 0], [2, 0, 0], [2, 1, 0]],
        legs: [value(2), value(1)] };
    equal(labelsOf(chain, "m").map(({ text }) => text), ["Σ 3.00 m", "2.00 m", "1.00 m"]);
    equal(labelsOf(chain, "m")[0].point, [2, 1, 0]);
}
