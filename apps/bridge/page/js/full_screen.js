/** Full screen, where the page has Control and the keys that would close its tab, as far as the browser gives them. */
import { lockedPlaces } from "./key_table.js";

let locked = false;

/** Whether Control is the page's: elsewhere Control+W closes the tab in the middle of a walk. */
export const hasControl = () => locked && document.fullscreenElement !== null;

export async function toggleFullScreen() {
    if (document.fullscreenElement) return void document.exitFullscreen();
    try {
        await document.documentElement.requestFullscreen({ navigationUI: "hide" });
        if (!navigator.keyboard?.lock) return; // plain http
        await navigator.keyboard.lock(lockedPlaces);
        locked = true;
    } catch { /* iPhones have no full screen, some browsers lock no keys */ }
}

/** Calls `tell` when the full screen has ended. */
export function onFullScreenEnd(tell) {
    document.addEventListener("fullscreenchange", () => {
        if (document.fullscreenElement) return;
        locked = false;
        navigator.keyboard?.unlock?.();
        tell();
    });
}
