/** Small helpers over the document. Texts always go in as text, never as markup. */

/** @param {string} id @returns {HTMLElement} */
export const byId = (id) => document.getElementById(id);

/**
 * An element with properties, `data-`, `aria-` and `role` attributes, and children.
 * @param {string} tag @param {Object} [with_] @param {...(Node|string)} children
 */
export function make(tag, with_ = {}, ...children) {
    const element = document.createElement(tag);
    for (const [key, value] of Object.entries(with_)) {
        if (value === undefined) continue;
        if (key.includes("-") || key === "role" || key === "for") element.setAttribute(key, value);
        else if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
        else element[key] = value;
    }
    if (/^(input|select)$/.test(tag) && !element.id) element.id = freshId(); // browsers complain about fields without
    element.append(...children);
    return element;
}

/** A button. One with an icon says `text` to screen readers and as its tip. */
export function button(text, onclick, icon) {
    if (!icon) return make("button", { type: "button", onclick }, text);
    return make("button", { type: "button", className: "icon", title: text, "aria-label": text, onclick },
        symbol(icon));
}

/** One of the icons of index.html. */
export function symbol(name) {
    const space = "http://www.w3.org/2000/svg";
    const svg = document.createElementNS(space, "svg"), use = document.createElementNS(space, "use");
    svg.setAttribute("aria-hidden", "true");
    use.setAttribute("href", "#i-" + name);
    svg.append(use);
    return svg;
}

/** Other rows in a list. Where a control of it has the focus, the one in its place gets it. */
export function refill(list, items) {
    const controls = () => [...list.querySelectorAll("input, button")];
    const at = controls().indexOf(document.activeElement);
    list.replaceChildren(...items);
    if (at < 0) return;
    const now = controls();
    list.tabIndex = -1;
    ([...now.slice(at), ...now.slice(0, at).reverse()].find((one) => !one.disabled) ?? list).focus();
}

/** Names a control for screen readers and by its tip. */
export function name(element, text) {
    element.title = text;
    element.setAttribute("aria-label", text);
}

let ids = 0;
/** An id that no other element has. */
export const freshId = () => "c" + ++ids;
