import { checked, requestOf, viewOf } from "./bookmarks.js";
import { equal } from "./expect.js";
import { goTo, readFragment, viewText } from "./fragment.js";
import { shareView, viewLink } from "./share.js";

export function linksAreChecked() {
    const token = "k".repeat(43);
    equal(readFragment(`#t=${token}`).token, token);
    equal(readFragment("#t=short").token, null);
    equal(readFragment("").token, null);
    equal(readFragment("#v=1,2,3,0,0,-1,60").view, [1, 2, 3, 0, 0, -1, 60]);
    equal(readFragment("#v=1,2,3,0,0,-1").view, [1, 2, 3, 0, 0, -1]);
    equal(readFragment("#v=1,2,3,0,0,-1,-20").view, [1, 2, 3, 0, 0, -1, -20], "without perspective, 20 wide");
    for (const bad of ["1,2,3", "1,2,3,0,0,-1,0", "1,2,3,0,0,0,60", "1,2,3,0,0,-1,180", "a,2,3,0,0,-1", "1,,3,0,0,-1", "1,2,1e999,0,0,-1"]) {
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

const status = { eye: [1, 2, 3], forward: [0, 0, -1], fov: 60 }, parallel = { fov: 0, orthographic: 20 };

export function aLinkToAViewHoldsNoToken() {
    equal(viewLink(`https://host:1/#t=${"k".repeat(43)}`, status), "https://host:1/#v=1,2,3,0,0,-1,60");
    equal(viewLink("https://host:1/", { ...status, fov: 0 }), "https://host:1/#v=1,2,3,0,0,-1");
    equal(viewLink("https://host:1/", { ...status, ...parallel }), "https://host:1/#v=1,2,3,0,0,-1,-20");
}

export function aViewIsGoneToWithAndWithoutPerspective() {
    equal(goTo([1, 2, 3, 0, 0, -1]), ["camera set", 1, 2, 3, 0, 0, -1]);
    equal(goTo([1, 2, 3, 0, 0, -1, 60]), ["camera set", 1, 2, 3, 0, 0, -1, 60]);
    equal(goTo([1, 2, 3, 0, 0, -1, -20]), ["camera orthographic", 1, 2, 3, 0, 0, -1, 20]);
    const up = [0, 1, 0];
    equal(requestOf(viewOf({ ...status, up })), ["camera set", 1, 2, 3, 0, 0, -1, 60, 0, 1, 0]);
    equal(requestOf(viewOf({ ...status, up, ...parallel })), ["camera orthographic", 1, 2, 3, 0, 0, -1, 20, 0, 1, 0]);
    equal(requestOf([1, 2, 3, 0, 0, -1, 0, 1, 0, 0]), ["camera set", 1, 2, 3, 0, 0, -1], "of older pages");
}

export async function aViewIsSharedByTheSystemOrCopied() {
    const shown = [], copied = [], app = { status, notices: { show: (key, text) => shown.push([key, text.includes("#v=1,2,3")]) } };
    const put = (name, value) => Object.defineProperty(navigator, name, { value, configurable: true });
    put("clipboard", { writeText: async (text) => copied.push(text.replace(/.*#/, "")) });
    put("share", undefined);
    await shareView(app);
    equal([copied, shown], [["v=1,2,3,0,0,-1,60"], [["copy", false]]], "no system for it");
    const shared = [];
    put("share", async ({ url }) => shared.push(url.replace(/.*#/, "")));
    await shareView(app);
    equal([shared, copied.length], [["v=1,2,3,0,0,-1,60"], 1]);
    put("share", async () => { throw new DOMException("", "AbortError"); });
    await shareView(app);
    equal([copied.length, shown.length], [1, 1], "the user thought better of it");
    put("share", async () => { throw new DOMException("", "NotAllowedError"); });
    await shareView(app);
    equal(copied.length, 2);
    put("clipboard", undefined);
    await shareView(app);
    equal(shown.at(-1), ["copy", true], "to be copied by hand");
    await shareView({ status: {}, notices: null }); // nothing is shown yet
}
