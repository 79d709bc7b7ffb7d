/** Bookmarks of this browser, by instance and scene: name, view, a small picture. */
import { extentOf, goTo } from "./fragment.js";
import { forGood } from "./storage.js";

export const MAX_BOOKMARKS = 200;
const MAX_NAME = 40;
/** Characters that no name needs and that would alter the text around it: controls, line ends, direction marks. */
const CONTROLS = /[\p{Cc}\p{Bidi_Control}\u2028\u2029]/gu;

const key = (instance, scene) => `rt.bookmarks.${instance}.${scene}`;

/** The valid bookmarks of `list`. A file of another program may hold anything. */
export function checked(list) {
    if (!Array.isArray(list)) return [];
    const number = (value) => typeof value === "number" && Number.isFinite(value);
    return list.filter((one) => one && typeof one.name === "string" && Array.isArray(one.view) && one.view.length === 10
        && one.view.every(number))
        .map(({ name, view, image }) => ({ name: name.replace(CONTROLS, "").slice(0, MAX_NAME), view,
            image: typeof image === "string" && /^data:image\/(jpeg|png);base64,[\w+/=]+$/.test(image) ? image
                : "" })).slice(0, MAX_BOOKMARKS);
}

export function load(instance, scene) {
    try {
        return checked(JSON.parse(forGood.get(key(instance, scene)) ?? "[]"));
    } catch {
        return [];
    }
}

/** False: there is no room. */
export const store = (instance, scene, list) => forGood.set(key(instance, scene), JSON.stringify(list));

/** A view as a bookmark has it: eye, direction, up, extent. */
export const viewOf = (status) => [...status.eye, ...status.forward, ...status.up, extentOf(status)];
/** The request that goes there. */
export const requestOf = (view) => goTo([...view.slice(0, 6), view[9]], view.slice(6, 9));
