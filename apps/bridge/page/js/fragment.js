/** The part of a link behind `#`: the token (`t`) and a view (`v`). It is never sent to a server. */

/**
 * @param {string} hash with or without `#`
 * @returns {{token: string|null, view: number[]|null}} a view: eye, direction, and the field of view if it is told
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
    return numbers.length === 6 || (numbers[6] > 0 && numbers[6] < 180) ? numbers : null;
}

// As many as floats have; on a national grid, a tenth of a millimetre.
const digits = (number) => String(Number(Math.abs(number) < 1e5 ? number.toPrecision(9) : number.toFixed(4)));

/** A view as it stands in a link, without `#`. @param {number[]} view */
export const viewText = (view) => "v=" + view.map(digits).join(",");
