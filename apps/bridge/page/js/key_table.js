/**
 * Keys by their place on the keyboard (`KeyboardEvent.code`), as the numbers that servers know
 * (libs/rtcore/motion/key_codes.h): ASCII of the unshifted key on an American keyboard, letters as capitals.
 */

const named = {
    Enter: 13, NumpadEnter: 13, Space: 32, ArrowLeft: 128, ArrowRight: 129, ArrowUp: 130, ArrowDown: 131,
    ShiftLeft: 132, ShiftRight: 132, PageUp: 136, PageDown: 137, Home: 138, End: 139, Insert: 140, Delete: 141,
    Backspace: 142, Minus: 45, Equal: 61, BracketLeft: 91, BracketRight: 93, Backslash: 92, Semicolon: 59, Quote: 39,
    Comma: 44, Period: 46, Slash: 47, Backquote: 96,
};

export const CRAWL = 133; // Control on the server

/** Keys of the server's default bindings. */
export const KEYS = { forward: 87, back: 83, left: 65, right: 68, shift: 132, jump: 32, crouch: 67, fly: 70 };

/** Keys of this page, which no server sees as such: X crawls (Ctrl+W would close the tab), Q E R V turn. */
export const pageKeys = { KeyX: "crawl", KeyQ: "left", KeyE: "right", KeyR: "up", KeyV: "down" };

/**
 * @param {string} place as in KeyboardEvent.code
 * @param {boolean} control whether Control is the page's
 * @returns {number} 0: no key of the server
 */
export function keyCode(place, control) {
    if (place === "KeyX") return CRAWL;
    if (place in pageKeys) return 0;
    if (/^Key[A-Z]$/.test(place)) return place.charCodeAt(3);
    if (/^Digit[0-9]$/.test(place)) return place.charCodeAt(5);
    if (/^Numpad[0-9]$/.test(place)) return place.charCodeAt(6);
    if (control && /^Control(Left|Right)$/.test(place)) return CRAWL;
    return named[place] ?? 0;
}

/** The places that a captured page asks the browser for in full screen. */
export const lockedPlaces = ["KeyW", "KeyA", "KeyS", "KeyD", "KeyF", "KeyN", "KeyT", "ControlLeft", "ControlRight",
    "Space"];
