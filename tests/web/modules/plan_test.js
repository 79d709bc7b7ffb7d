import { eyeAt, headingOf, pathOf, readOutline, stepsOf, storeyAt } from "./plan.js";
import { equal, isTrue } from "./expect.js";

const TEXT = "storey 2\nfloors 0 3\ntop 6\neye 1.6\ncorner 10 3 -5\nright 1 0 0\nahead 0 0 -1\nup 0 1 0\nstep 0.5\nsize 8 4\n"
    + "solid 0 0 8 0 8 4 0 0\nline 1 1 2 2\nlight 3 3 4 4\nlight 0 0 1 1";

export function plansAreRead() {
    const outline = readOutline(TEXT);
    equal([outline.storey, outline.floors, outline.top, outline.size], [2, [0, 3], 6, [8, 4]]);
    equal(outline.solid, [[0, 0, 8, 0, 8, 4, 0, 0]]);
    equal(outline.light.length, 2);
    equal(pathOf(outline.solid), "M0 0 8 0 8 4 0 0Z");
    equal(pathOf(outline.line), "M1 1 2 2", "it does not close");
    for (const bad of ["", "no storeys", TEXT.replace("step 0.5", "step 0"), TEXT.replace("corner 10", "corner x"),
        TEXT.replace("up 0 1 0\n", "")])
        equal(readOutline(bad), null, bad);
    equal(readOutline(TEXT.replace("floors 0 3", "floors").replace("storey 2", "storey 0")).floors, []);
}

export function storeysOfPlansAreThoseOfTheSuite() {
    const house = { floors: [0, 3], top: 6 };
    equal([-1, 1.6, 4.6, 7].map((eye) => storeyAt(house, eye)), [1, 1, 2, 1]);
    equal(storeyAt({ floors: [], top: 6 }, 1), 0);
}

export function aTapOnAPlanLeadsThere() {
    const outline = readOutline(TEXT);
    equal(stepsOf(outline, [12, 4.6, -6]), [4, 2]);
    equal(eyeAt(outline, [4, 2], 100), [12, 4.6, -6], "as high as a person's eyes");
    equal(eyeAt({ ...outline, storey: 0 }, [4, 2], 100), [12, 100, -6], "as high as before");
}

export function plansShowWhereOneLooks() {
    const outline = readOutline(TEXT), up = [0, 1, 0];
    equal(headingOf(outline, { forward: [1, 0, 0], up }), 0);
    isTrue(Math.abs(headingOf(outline, { forward: [0, 0, -1], up }) - Math.PI / 2) < 1e-9, "ahead");
    equal(headingOf(outline, { forward: [0, -1, 0], up: [1, 0, 0] }), 0, "by the upper edge of the image");
    equal(headingOf(outline, { forward: [0, -1, 0], up: [0, 1, 0] }), null);
}
