/** Undo and redo, one after the other: the bridge takes none while it does not know what the last one left. */
const STATE_MS = 300; // one that changed nothing brings no state

export class Steps {
    /**
     * @param {(what: string) => Promise<{ok: boolean}>} ask
     * @param {EventTarget} link tells `state`
     */
    constructor(ask, link) {
        this.ask = ask;
        this.link = link;
        this.last = Promise.resolve();
    }

    /** @param {"undo"|"redo"} what @returns {Promise<void>} until the next one may begin */
    take(what) {
        this.last = this.last.then(() => this.step(what));
        return this.last;
    }

    async step(what) {
        const { ok } = await this.ask(what);
        if (!ok) return;
        await new Promise((resolve) => {
            this.link.addEventListener("state", resolve, { once: true });
            setTimeout(resolve, STATE_MS);
        });
    }
}
