import { directionThrough, turnTo } from "./directions.js";
import { equal } from "./expect.js";

// The point that is looked at comes to the middle, however steep the view is.
export function aDoubleClickTurnsThere() {
    const turn = (view, x, y) => {
        const { right, up } = turnTo(view, [0, 1, 0], directionThrough(view, x, y, 2));
        return [Math.round(right * 100), Math.round(up * 100)];
    };
    const level = { forward: [0, 0, -1], up: [0, 1, 0], fov: 90 };
    equal(turn(level, 0, 0), [0, 0]);
    equal(turn(level, 1, 0), [4500, 0]);
    equal(turn(level, 0, 1), [0, 2657]);
    const steep = { forward: [0, -0.8, -0.6], up: [0, 1, 0], fov: 90 };
    equal(turn(steep, 0, 0), [0, 0]);
    equal(turn(steep, 1, 0), [5904, 1868], "farther round than in the image");
    equal(turn({ forward: [0, -1, 0], up: [0, 0, -1], fov: 90 }, 1, 0), [9000, 4500], "straight down");
}
