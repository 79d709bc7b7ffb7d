/**
 * Rows of fields for panels: a label, a control, a reset. A row shows what the server says, but not while it is edited.
 */
import { button, freshId, make } from "./dom.js";
import { t } from "./texts.js";

/** The label of a field, and its unit. */
const caption = (label, unit) => [label, ...(unit
    ? ["\u00a0", make("span", { className: unit.length > 2 ? "unit" : "unit short" }, unit)] : [])];

/** @returns {Row} `element`, `show(value, enabled)` */
function row(label, controls, { help, unit, reset } = {}) {
    const id = freshId();
    controls[0].id = id;
    if (help) for (const control of controls) control.title = help;
    const back = reset && button(reset.text, reset.run, "undo");
    back?.classList.add("reset");
    const name = make("label", { for: id, title: help }, ...caption(label, unit));
    if (back) name.ondblclick = () => back.hidden || back.disabled || reset.run();
    const field = make("div", { className: "field" }, ...controls);
    const element = make("div", { className: reset ? "row" : "row wide" }, name, field, ...(back ? [back] : []));
    return { element, back };
}

const isEdited = (control) => control === document.activeElement;

export function toggle(label, onChange, how = {}) {
    const box = make("input", { type: "checkbox", onchange: () => onChange(box.checked) });
    const { element, back } = row(label, [box], how);
    return { element, back, show: (on, enabled) => ((box.checked = on), (box.disabled = !enabled)) };
}

/** @param {[string, string][]} choices value and text */
export function choice(label, choices, onChange, how = {}) {
    const box = make("select", { onchange: () => onChange(box.value) },
        ...choices.map(([value, text]) => make("option", { value }, text)));
    const { element, back } = row(label, [box], how);
    return { element, back, show: (value, enabled) => ((box.value = value), (box.disabled = !enabled)) };
}

export function text(label, onChange, how = {}) {
    const box = make("input", { type: "text", maxLength: 40, onchange: () => onChange(box.value) });
    const { element } = row(label, [box], how);
    return { element, show: (value, enabled) => (isEdited(box) || (box.value = value), (box.disabled = !enabled)) };
}

/** The number that has the focus is the server's again, in place of one that was refused. */
export function showFocusedAgain() {
    const box = document.activeElement;
    if (box?.dataset?.shown !== undefined) box.value = box.dataset.shown;
}

const short = (value, decimals) => (decimals === undefined ? String(Number(Number(value).toPrecision(6)))
    : String(Number(Number(value).toFixed(decimals))));

/** Without the digits of the rounding of floats. */
const unscaled = (shown, scale) => (scale === 1 ? shown : Number((shown / scale).toPrecision(7)));

/**
 * A typed number counts when it is finished; one that the arrows change, at once. The shown number is the value times
 * `scale()`.
 */
function numberBox(onValue, { min, max, whole, label, decimals, scale = () => 1 }) {
    const box = make("input", { type: "number", step: whole ? "1" : "any", inputMode: "decimal", "aria-label": label });
    if (min !== undefined) box.min = min;
    if (max !== undefined) box.max = max;
    box.onchange = () => {
        if (box.value !== "" && box.checkValidity()) onValue(unscaled(Number(box.value), scale()));
        else box.value = box.dataset.shown;
    };
    const show = (value, enabled) => {
        box.dataset.shown = short(value * scale(), decimals);
        if (!isEdited(box)) box.value = box.dataset.shown;
        box.disabled = !enabled;
    };
    return { box, show };
}

const MAX_EVEN = 5000, MANY_ORDERS = 1000, MAX_FACTOR = 1e7, POSITIONS = 500;

/**
 * A slider over a range: even, or by even factors where it is of many orders and not to be `even`; null where its ends
 * are too far apart.
 */
function sliderOver({ min, max, whole, even = false }) {
    if (min === undefined || max === undefined) return null;
    const factors = !even && min > 0 && max / min >= MANY_ORDERS, factor = max / min;
    if (factors ? factor > MAX_FACTOR : max - min > MAX_EVEN) return null;
    const box = make("input", factors ? { type: "range", min: 0, max: POSITIONS, step: 1 }
        : { type: "range", min, max, step: whole ? 1 : (max - min) / POSITIONS });
    const fine = (value) => (whole ? Math.round(value) : Number(value.toPrecision(3)));
    return {
        box,
        value: () => (factors ? fine(min * factor ** (Number(box.value) / POSITIONS)) : Number(box.value)),
        show: (value) => (box.value = factors ? POSITIONS * (Math.log(Math.max(value, min) / min) / Math.log(factor))
            : value),
    };
}

/**
 * A number, of so many `decimals` where that is said, with a slider where both ends are known; it ends at `until` where
 * few want more. `onValue(value, goesOn)`:
 * later values of one drag go on. Without a slider `scale` may tell how many of the unit that is shown make one of the
 * value's.
 */
export function numeric(label, onValue, how = {}) {
    const { min, max, whole, name = label, until = max } = how;
    const { box, show } = numberBox((value) => onValue(value, false),
        { min, max, whole, decimals: how.decimals, scale: how.scale,
            label: how.slider === false ? undefined : name });
    const slider = how.slider === false ? null : sliderOver({ min, max: until, whole, even: how.even });
    if (!slider) {
        box.removeAttribute("aria-label");
        const { element, back } = row(label, [box], how);
        return { element, back, show };
    }
    let dragging = false;
    slider.box.oninput = () => {
        const value = slider.value();
        box.value = value;
        onValue(value, dragging);
        dragging = true;
    };
    slider.box.onchange = () => (dragging = false);
    const { element, back } = row(label, [slider.box, box], how);
    return { element, back, show(value, enabled) {
        show(value, enabled);
        if (!dragging) slider.show(value);
        slider.box.disabled = !enabled;
    } };
}

/** A number in the one of `units` that is chosen: for each its name, and how many of it make one of the value's. */
export function measured(label, units, onValue, how = {}) {
    let value = 0, may = false;
    const { box, show } = numberBox(onValue, { ...how, scale: () => units[unit.selectedIndex][1] });
    const unit = make("select", { className: "units", title: how.unitHelp, "aria-label": how.unitName,
        onchange: () => show(value, may) },
        ...units.map(([text]) => make("option", {}, text)));
    const { element } = row(label, [box, unit], how);
    return { element, show: (now, enabled) => show((value = now), (may = enabled)) };
}

/** Three numbers. Those that are not typed go as they came, to the last digit. */
export function vector(label, onValue, how = {}) {
    let now = [0, 0, 0];
    const boxes = ["x", "y", "z"].map((axis, index) => numberBox((value) => {
        now = now.map((old, at) => (at === index ? value : old));
        onValue(now);
    }, { ...how, label: label + " " + axis }));
    const field = make("div", { className: "field" }, ...boxes.map(({ box }) => box));
    const element = make("div", { className: "row vector", role: "group", "aria-label": label },
        make("span", { className: "label" }, ...caption(label, how.unit)), field);
    return { element, show(value, enabled) {
        now = value;
        boxes.forEach(({ show }, index) => show(value[index], enabled));
    } };
}

const encode = (linear) => (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055);
const decode = (code) => (code <= 0.04045 ? code / 12.92 : ((code + 0.055) / 1.055) ** 2.4);
/** A linear colour as a screen shows it, as bright as it can be where `scaled`. */
export function screenColour(linear, scaled = false) {
    const largest = scaled ? Math.max(...linear, 1e-30) : 1;
    const code = (part) => Math.round(255 * encode(Math.min(1, Math.max(0, part / largest))));
    return "#" + linear.map((part) => code(part).toString(16).padStart(2, "0")).join("");
}
export const linearColour = (screen) => [1, 3, 5].map((at) => decode(parseInt(screen.slice(at, at + 2), 16) / 255));

/** A linear colour. */
export function colour(label, onValue, how = {}) {
    let dragging = false;
    const box = make("input", { type: "color" });
    box.oninput = () => {
        onValue(linearColour(box.value), dragging);
        dragging = true;
    };
    box.onchange = () => (dragging = false);
    const { element } = row(label, [box], how);
    return { element, show(linear, enabled) {
        if (!dragging) box.value = screenColour(linear, how.scaled);
        box.disabled = !enabled;
    } };
}

/** One of a few steps, side by side, or none of them. @param {[string, string, string][]} steps value, text and tip */
export function steps(label, all, onChoice, none) {
    const buttons = all.map(([value, text, title]) =>
        make("button", { type: "button", title, "aria-pressed": "false", onclick: () => onChoice(value) }, text));
    const other = make("span", { className: "dim", hidden: true }, none);
    const element = make("div", { className: "row wide", role: "group", "aria-label": label },
        make("span", { className: "label" }, label),
        make("div", { className: "field" }, make("div", { className: "steps" }, ...buttons), other));
    return { element, show(value, enabled) {
        buttons.forEach((button, index) => {
            button.setAttribute("aria-pressed", String(all[index][0] === value));
            button.disabled = !enabled;
        });
        other.hidden = value !== null;
    } };
}

/** A folding group; `fill` is called when it is first open. */
export function group(title, ...children) {
    return make("details", {}, make("summary", {}, title), ...children);
}

/** A reset to a value that is told. */
export const resetOf = (label, value, run) => ({ text: t("reset", label, value), run });
