// Edits and steps of undo, of which the bridge takes one at a time.
import { Edits } from "./edits.js";
import { equal } from "./expect.js";
import { Steps } from "./steps.js";

export async function undoWaitsForTheLastOne() {
    const told = [], link = new EventTarget();
    const steps = new Steps(async (what) => {
        told.push(what);
        setTimeout(() => (told.push("state"), link.dispatchEvent(new Event("state"))), 20);
        return { ok: true };
    }, link);
    steps.take("undo");
    await steps.take("redo");
    equal(told, ["undo", "state", "redo", "state"]);
}

export async function aRefusedEditIsToldOnceItIsOver() {
    const busy = [], edits = new Edits(async () => ({ ok: false }), () => busy.push(edits.isBusy("a")));
    equal(await edits.edit("a", "set", {}), false);
    equal(busy, [false]);
}
