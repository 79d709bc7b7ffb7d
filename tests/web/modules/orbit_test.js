import { equal } from "./expect.js";
import { Orbit } from "./orbit.js";

// Motions of the hand while an answer is on its way are told together, and in an order that makes sense.
export async function aModelInTheHandNeverFallsBehind() {
    const asked = [], waiting = [];
    const picture = {
        aspect: 2,
        box: () => ({ width: 360 }),
        at: (x, y) => (x < 0 ? null : { x: x / 360, y: y / 180 }),
    };
    const ask = (...command) => {
        asked.push(command);
        return new Promise((done) => waiting.push(done));
    };
    const orbit = new Orbit(picture, { changed() {}, ask, range: () => ({ min: -360, max: 360 }) });
    const answer = async (ok = true) => {
        waiting.shift()({ ok });
        await new Promise((done) => setTimeout(done));
    };
    orbit.grasp(180, 45);
    orbit.turn(10, 0);
    for (let i = 0; i < 20; ++i) orbit.turn(1, 2);
    orbit.move(36, -18);
    orbit.approach(2);
    orbit.approach(2);
    for (let i = 0; i < 4; ++i) await answer();
    orbit.turn(1, 0);
    orbit.turn(9, 0);
    await answer(false); // nothing is heaped up for who may not drive
    orbit.grasp(-1, 0);
    orbit.turn(2, 0);
    await answer();
    equal(asked, [["camera pivot", 0.5, 0.25], ["camera orbit", 15, -20], ["camera pan", 0.1, 0.05], ["camera approach", 4],
        ["camera orbit", 0.5, 0], ["camera orbit", 1, 0]]);
}
