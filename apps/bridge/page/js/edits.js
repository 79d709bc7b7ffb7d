/**
 * Edits that follow a hand: of each thing one request is under way, and of what was wanted meanwhile the newest is sent
 * next. All values of one drag are one step of undo.
 */
export class Edits {
    /**
     * @param {(what: string, keys: Object) => Promise<{ok: boolean}>} request
     * @param {(answer: Object) => void} onFailed once nothing of that thing is under way
     */
    constructor(request, onFailed) {
        this.request = request;
        this.onFailed = onFailed;
        this.things = new Map();
    }

    /**
     * @param {string} thing what is edited: one of a name is under way
     * @param {boolean} goesOn this value belongs to the same drag as the one before
     * @returns {Promise<boolean>} false: the last value was refused
     */
    async edit(thing, what, keys, goesOn = false) {
        const busy = this.things.get(thing);
        if (busy) {
            busy.next = { what, keys, goesOn: goesOn && (busy.next?.goesOn ?? true) };
            return true;
        }
        let answer = null;
        const state = { next: { what, keys, goesOn } };
        this.things.set(thing, state);
        while (state.next) {
            const { what: now, keys: with_, goesOn: also } = state.next;
            state.next = null;
            answer = await this.request(now, also ? { ...with_, also: true } : with_);
        }
        this.things.delete(thing);
        if (!answer.ok) this.onFailed(answer);
        return answer.ok;
    }

    /** Whether this page is changing it, so that what the server says of it is already old. */
    isBusy(thing) {
        return this.things.has(thing);
    }
}
