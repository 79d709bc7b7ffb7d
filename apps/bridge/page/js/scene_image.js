/** Where the image shows points and lines of the scene, by the camera of its frame (scene_image.h of the window). */
import { cross, dot, unit } from "./directions.js";

const difference = (a, b) => a.map((part, index) => part - b[index]);
const between = (a, b, part) => a.map((from, index) => from + part * (b[index] - from));

/** The image that is shown, in pixels of `place`, and where it is there; null: its camera is not known. */
export function imageIn(place, { status, picture }) {
    const width = status.orthographic ?? 0;
    if (!status.eye || !(status.fov > 0 || width > 0)) return null;
    const origin = place.getBoundingClientRect(), box = picture.box();
    const area = { ...box, x: box.x - origin.x, y: box.y - origin.y };
    return { area, image: new SceneImage(status, width, area) };
}

export class SceneImage {
    /**
     * @param {{eye: number[], forward: number[], up: number[], fov: number}} view
     * @param {number} parallelWidth of a view without perspective, whose `fov` is 0: scene units from edge to edge
     * @param {{x: number, y: number, width: number, height: number}} box where the whole image is
     */
    constructor({ eye, forward, up, fov }, parallelWidth, box) {
        this.eye = eye;
        this.forward = unit(forward);
        this.right = unit(cross(this.forward, up));
        this.up = cross(this.right, this.forward);
        this.parallel = !(fov > 0);
        this.perPixel = (this.parallel ? parallelWidth : 2 * Math.tan((fov * Math.PI) / 360)) / box.width;
        this.centre = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }

    depth(point) {
        return dot(difference(point, this.eye), this.forward);
    }

    /** Null: it is not in front of the eye. */
    at(point) {
        const off = difference(point, this.eye), depth = this.depth(point);
        const scale = this.perPixel * (this.parallel ? 1 : depth);
        if (!(depth > 0) || !(scale > 0)) return null;
        return { x: this.centre.x + dot(off, this.right) / scale, y: this.centre.y - dot(off, this.up) / scale };
    }

    /** The ends of a line, clipped before the eye; null: none of it is in front. */
    line(from, to) {
        const NEAR = 1e-3; // of the depth of the farther end
        const [near, far] = this.depth(from) <= this.depth(to) ? [from, to] : [to, from];
        const a = this.depth(near), b = this.depth(far), min = NEAR * b;
        if (!(b > 0)) return null;
        const start = a < min ? between(near, far, (min - a) / (b - a)) : near;
        const ends = [this.at(start), this.at(far)];
        return ends.every(Boolean) ? ends : null;
    }
}
