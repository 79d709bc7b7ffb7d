import { equal } from "./expect.js";
import { keepAwake } from "./wake_lock.js";

export async function theScreenIsKeptOnOnce() {
    const locks = [];
    const make = () => ({
        released: false,
        async release() {
            this.released = true;
        },
    });
    const request = async () => (locks.push(make()), locks.at(-1));
    Object.defineProperty(navigator, "wakeLock", { value: { request }, configurable: true });
    const held = () => locks.map(({ released }) => !released);
    await Promise.all([keepAwake(true), keepAwake(true)]);
    equal(held(), [true]);
    locks[0].released = true; // by the browser
    await keepAwake(true);
    equal(held(), [false, true]);
    keepAwake(false);
    equal(held(), [false, false]);
    const late = keepAwake(true);
    keepAwake(false);
    await late;
    equal(held(), [false, false, false]);
}
