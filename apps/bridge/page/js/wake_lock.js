/** Keeps the screen on during a walk, where the browser allows it. */
let lock = null, wanted = false, asked = false;

export async function keepAwake(on) {
    wanted = on;
    if (!on) {
        lock?.release();
        lock = null;
        return;
    }
    if (asked || (lock && !lock.released)) return;
    asked = true;
    try {
        lock = (await navigator.wakeLock?.request("screen")) ?? null;
    } catch { /* refused: the battery is low, or the page is hidden */ }
    asked = false;
    if (!wanted) keepAwake(false);
}
