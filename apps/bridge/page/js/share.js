/** A link to what is seen: given to the system to be passed on, or copied. */
import { extentOf, viewText } from "./fragment.js";
import { t } from "./texts.js";

/**
 * The address of a view, without a token: it opens for those who were let in before.
 * @param {string} address of the page
 * @param {{eye: number[], forward: number[], fov: number, orthographic?: number}} status
 */
export function viewLink(address, status) {
    const extent = extentOf(status);
    return address.replace(/#.*/, "") + "#" +
        viewText([...status.eye, ...status.forward, ...(extent === 0 ? [] : [extent])]);
}

async function copy(app, link) {
    try {
        await navigator.clipboard.writeText(link);
        app.notices.show("copy", t("copied"));
    } catch {
        app.notices.show("copy", t("copyByHand") + " " + link, { lasting: true, actions: [[t("close"), () => {}]] });
    }
}

/** By what the system has for it; where it has nothing, or that fails, by the clipboard. */
export async function shareView(app) {
    if (!app.status.eye) return;
    const link = viewLink(location.href, app.status);
    if (!navigator.share) return copy(app, link);
    try {
        await navigator.share({ title: document.title, url: link });
    } catch (error) {
        if (error.name !== "AbortError") await copy(app, link); // else the user thought better of it
    }
}

export const copyView = (app) => copy(app, viewLink(location.href, app.status));
