import { checked } from "./bookmarks.js";
import { equal } from "./expect.js";
import { readFragment, viewText } from "./fragment.js";

export function linksAreChecked() {
    const token = "k".repeat(43);
    equal(readFragment(`#t=${token}`).token, token);
    equal(readFragment("#t=short").token, null);
    equal(readFragment("").token, null);
    equal(readFragment("#v=1,2,3,0,0,-1,60").view, [1, 2, 3, 0, 0, -1, 60]);
    equal(readFragment("#v=1,2,3,0,0,-1").view, [1, 2, 3, 0, 0, -1]);
    for (const bad of ["1,2,3", "1,2,3,0,0,0,60", "1,2,3,0,0,-1,180", "a,2,3,0,0,-1", "1,,3,0,0,-1", "1,2,1e999,0,0,-1"]) {
        equal(readFragment(`#v=${bad}`).view, null, bad);
    }
    equal(readFragment(viewText([0.1234567894, -2, 1e-7, 0, 0, -1, 60])).view, [0.123456789, -2, 1e-7, 0, 0, -1, 60]);
}

export function bookmarksAreChecked() {
    const good = { name: "a", view: [0, 1, 2, 3, 4, 5, 6, 7, 8, 60], image: "" };
    equal(checked([good]).length, 1);
    const notANumber = { name: "a", view: Array(10).fill(NaN) };
    for (const bad of [null, {}, "text", [null], [{ name: 1, view: [] }], [{ name: "a", view: [1] }], [notANumber]]) {
        equal(checked(bad).length, 0, JSON.stringify(bad));
    }
    const view = Array(10).fill(1);
    equal(checked([{ name: "a", view, image: "https://elsewhere/x.png" }])[0].image, "");
    equal(checked([{ name: "a\u202ab\u200f\u0007\u2066c", view }])[0].name, "abc");
}
