/** Values that the browser keeps. Where it keeps none (private windows, sandboxed frames), the page works without. */

function store(kind) {
    try {
        return window[kind];
    } catch {
        return null;
    }
}

/** @param {"localStorage"|"sessionStorage"} kind */
function room(kind) {
    const kept = new Map();
    return {
        get(key) {
            try {
                return store(kind).getItem(key);
            } catch {
                return kept.get(key) ?? null;
            }
        },
        /** False: there is no room for it. */
        set(key, value) {
            kept.set(key, value);
            try {
                store(kind).setItem(key, value);
                return true;
            } catch {
                return false;
            }
        },
        remove(key) {
            kept.delete(key);
            try {
                store(kind).removeItem(key);
            } catch {} // it keeps nothing
        },
    };
}

export const forGood = room("localStorage");
export const forThisTab = room("sessionStorage");

const listeners = new Map();
/** A preference of this browser; `fallback` until it is chosen. */
export const preference = (name, fallback) => forGood.get("rt." + name) ?? fallback;
export function setPreference(name, value) {
    forGood.set("rt." + name, String(value));
    for (const tell of listeners.get(name) ?? []) tell(String(value));
}
/** Calls `tell` at once and after each change in this page. */
export function followPreference(name, fallback, tell) {
    listeners.set(name, [...(listeners.get(name) ?? []), tell]);
    tell(preference(name, fallback));
}
