/**
 * A model in the hand: a drag turns it about the point under the pointer, and moves it. Movements while an answer
 * is on its way go with the next request, so that a slow line never falls behind.
 */
const HALF_TURN = 180; // degrees, of a drag over the width of the image

export class Orbit {
    /**
     * @param {Picture} picture @param {Object} on `ask(command, ...args)`, `range(command, index)` of an argument,
     * `changed()`
     */
    constructor(picture, on) {
        this.picture = picture;
        this.on = on;
        this.indoors = true; // the scene's own view
        this.chosen = null;  // by this page's user, for this scene
        this.forget();
    }

    get is() {
        return this.chosen ?? !this.indoors;
    }

    /** Another scene begins as suits it. */
    begin(indoors) {
        this.indoors = indoors;
        this.chosen = null;
        this.on.changed();
    }

    choose(orbits) {
        this.chosen = orbits;
        this.on.changed();
    }

    forget() {
        this.pending = { right: 0, up: 0, x: 0, y: 0, factor: 1 };
        this.pivot = null; // where a hand took hold, not yet told
    }

    /** Places in the window. */
    grasp(clientX, clientY) {
        this.pivot = this.picture.at(clientX, clientY);
    }

    turn(dx, dy) {
        const degrees = HALF_TURN / this.width;
        this.pending.right += dx * degrees;
        this.pending.up -= dy * degrees;
        this.go();
    }

    move(dx, dy) {
        this.pending.x += dx / this.width;
        this.pending.y -= dy / this.width;
        this.go();
    }

    approach(factor) {
        this.pending.factor *= factor;
        this.go();
    }

    /** Moves the point of the image there to the middle. */
    centre(clientX, clientY) {
        const at = this.picture.at(clientX, clientY);
        if (!at) return;
        this.pivot = at;
        this.pending.x += 0.5 - at.x;
        this.pending.y -= (0.5 - at.y) / this.picture.aspect;
        this.go();
    }

    get width() {
        return Math.max(1, this.picture.box().width);
    }

    async go() {
        if (this.going) return;
        this.going = true;
        try {
            for (let next = this.next(); next; next = this.next()) if (!(await this.on.ask(...next)).ok) this.forget();
        } finally {
            this.going = false;
        }
    }

    /** The request that comes next; null: there is none. */
    next() {
        const { pivot, pending } = this;
        if (pivot) {
            this.pivot = null;
            return this.command("camera pivot", pivot.x, pivot.y);
        }
        const { right, up, x, y, factor } = pending;
        if (right || up) {
            pending.right = pending.up = 0;
            return this.command("camera orbit", right, up);
        }
        if (x || y) {
            pending.x = pending.y = 0;
            return this.command("camera pan", x, y);
        }
        if (factor === 1) return null;
        pending.factor = 1;
        return this.command("camera approach", factor);
    }

    /** With arguments as large as it takes. */
    command(name, ...args) {
        return [name, ...args.map((value, index) => {
            const { min, max } = this.on.range(name, index);
            return Math.min(max, Math.max(min, value));
        })];
    }
}
