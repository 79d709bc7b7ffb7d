/** The part of a link behind `#`: the token (`t`) and a view (`v`). It is never sent to a server. */

/**
 * @param {string} hash with or without `#`
 * @returns {{token: string|null, view: number[]|null}} a view: eye, direction, and its extent if it is told
 */
export function readFragment(hash) {
    const fields = new URLSearchParams(hash.replace(/^#/, ""));
    const token = fields.get("t");
    return { token: /^[\w-]{16,200}$/.test(token ?? "") ? token : null, view: readView(fields.get("v")) };
}

function readView(text) {
    const numbers = (text ?? "").split(",").map((word) => (word.trim() === "" ? NaN : Number(word)));
    const right = numbers.length === 6 || numbers.length === 7;
    if (!right || !numbers.every(Number.isFinite)) return null;
    if (Math.hypot(numbers[3], numbers[4], numbers[5]) === 0) return null;
    return numbers.length === 6 || (numbers[6] !== 0 && numbers[6] < 180) ? numbers : null;
}

/**
 * The extent of a view: its field of view in degrees, or, without perspective, minus its width; 0: not known.
 * @param {{fov: number, orthographic?: number}} status
 */
export const extentOf = ({ fov, orthographic = 0 }) => fov || -orthographic || 0;

/** The request that goes there, as app.ask() takes it. @param {number[]} view eye, direction, extent or none */
export function goTo(view, up = []) {
    const eyeAndDirection = view.slice(0, 6), extent = view[6] ?? 0;
    if (extent < 0) return ["camera orthographic", ...eyeAndDirection, -extent, ...up];
    return ["camera set", ...eyeAndDirection, ...(extent > 0 ? [extent, ...up] : [])];
}

// As many as floats have; on a national grid, a tenth of a millimetre.
const digits = (number) => String(Number(Math.abs(number) < 1e5 ? number.toPrecision(9) : number.toFixed(4)));

/** A view as it stands in a link, without `#`. @param {number[]} view */
export const viewText = (view) => "v=" + view.map(digits).join(",");
