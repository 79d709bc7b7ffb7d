import { equal } from "./expect.js";
import { modelPanel } from "./panel_model.js";

const names = (place) => [...place.querySelectorAll("select option")].map((each) => each.textContent);

export async function variantsAreChosenByTheirNumbers() {
    const asked = [], state = { scene: "a.scn", edits: 0, variants: [], variant: "" };
    const ask = async (...all) => {
        asked.push(all);
        return { ok: false };
    };
    const panel = modelPanel({ state, ask, mayEdit: () => true }), place = document.createElement("div");
    panel.fill(place);
    panel.show();
    equal(names(place), []);
    Object.assign(state, { variants: ["oak", "<b>night</b>"], variant: "oak" });
    panel.show();
    equal(names(place), ["Without a variant", "oak", "<b>night</b>"]);
    const box = place.querySelector("select");
    equal(box.value, "1");
    asked.length = 0;
    const choose = async (value) => {
        box.value = value;
        box.dispatchEvent(new Event("change"));
        await new Promise((done) => setTimeout(done));
    };
    await choose("2");
    equal(box.value, "1"); // it was refused
    await choose("0");
    equal(asked, [["variant go", 2], ["variant leave"]]);
}
