/** Vectors, as lists of three numbers, and turns of the view for a point of the image. */
export const scaled = (a, factor) => a.map((part) => part * factor);
const sum = (a, b) => a.map((part, index) => part + b[index]);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
export const unit = (a) => scaled(a, 1 / Math.hypot(...a));
const DEGREES = 180 / Math.PI;

/**
 * The direction through a point of the image, as the window has it (directionThrough of look_operations.cpp).
 * @param {{forward: number[], up: number[], fov: number}} view
 * @param {number} x -1 to 1, from the left; `y` from below
 */
export function directionThrough({ forward, up, fov }, x, y, aspect) {
    const right = unit(cross(forward, up)), above = unit(cross(right, forward)), side = Math.tan(fov / 2 / DEGREES);
    return unit(sum(unit(forward), sum(scaled(right, x * side), scaled(above, (y * side) / aspect))));
}

/** Degrees to the right about `axis`, which is up, and then up, that turn the view in `direction`. */
export function turnTo({ forward, up }, axis, direction) {
    const upward = unit(axis), from = unit(forward), to = unit(direction);
    const level = (a) => sum(a, scaled(upward, -dot(a, upward)));
    const steep = Math.abs(dot(from, upward)) > 0.9999;
    const ahead = unit(level(steep ? scaled(up, -Math.sign(dot(from, upward))) : from)), right = cross(ahead, upward);
    const pitch = (a) => Math.asin(Math.max(-1, Math.min(1, dot(a, upward))));
    return { right: Math.atan2(dot(to, right), dot(to, ahead)) * DEGREES, up: (pitch(to) - pitch(from)) * DEGREES };
}
