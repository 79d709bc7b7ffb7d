/**
 * A phone that is held upright: who drives asks for images of its shape, with as many pixels, and gives the others'
 * shape back.
 */
const upright = matchMedia("(orientation: portrait) and (pointer: coarse)");

/** As many pixels in another shape. */
export function reshaped({ width, height }, aspect) {
    const across = Math.sqrt(width * height * aspect);
    return { width: Math.max(1, Math.round(across)), height: Math.max(1, Math.round(across / aspect)) };
}

export class Upright {
    /** @param {Object} on `drives()`, `size()` of the images, `room()` for them, `resize(width, height)` */
    constructor(on) {
        this.on = on;
        this.before = null; // the size of the others
        upright.addEventListener("change", () => this.follow());
    }

    async follow() {
        if (this.asking || !this.on.drives()) return;
        const size = this.on.size();
        if (!size.width || upright.matches === (this.before !== null)) return;
        const { w, h } = this.on.room(), wanted = upright.matches ? reshaped(size, w / h) : this.before;
        this.before = upright.matches ? size : null;
        this.asking = true;
        await this.on.resize(wanted.width, wanted.height); // where sizes are locked, the image is cut
        this.asking = false;
    }

    /** Another server. */
    forget() {
        this.before = null;
    }
}
