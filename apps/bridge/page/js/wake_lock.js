/** Keeps the screen on during a walk, where the browser allows it. */
let lock = null, wanted = false;

export async function keepAwake(on) {
    wanted = on;
    if (!on) {
        lock?.release();
        lock = null;
        return;
    }
    if (lock) return;
    try {
        const got = await navigator.wakeLock?.request("screen");
        if (wanted) lock = got ?? null;
        else got?.release();
    } catch { /* refused: the battery is low, or the page is hidden */ }
}
