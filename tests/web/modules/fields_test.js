import { equal } from "./expect.js";
import { measured, numeric, steps, vector } from "./fields.js";

// Types into one of a field's boxes: what it showed before.
function type({ element }, text, at = 0) {
    const box = element.querySelectorAll("input")[at];
    const shown = box.value;
    box.value = text;
    box.dispatchEvent(new Event("change"));
    return shown;
}

// Fields in another unit than the bridge's: what is not typed goes back as it came.
export function fieldsShowAnotherUnit() {
    const sent = [], send = (value) => sent.push(value), how = { unit: "m", scale: () => 0.0010000000474974513, min: 0 };
    const size = numeric("Size", send, { ...how, slider: false }), place = vector("Position", send, how);
    const power = measured("Power", [["lm", 1], ["W", 1 / 683]], send);
    size.show(95.23500061035156, true);
    place.show([0.10000000149011612, 1234.5677490234375, -3], true);
    power.show(800, true);
    equal(type(size, "0.3"), "0.095235");
    equal(type(place, "2", 2), "-0.003");
    equal(type(power, "683"), "800");
    const unit = power.element.querySelector("select");
    unit.selectedIndex = 1;
    unit.dispatchEvent(new Event("change"));
    equal(type(power, "2"), "1.1713");
    equal(sent, [300, [0.10000000149011612, 1234.5677490234375, 2000], 683, 1366]);
    const label = ({ element }) => element.querySelector("label, .label").textContent;
    equal([size, place].map(label), ["Size\u00a0m", "Position\u00a0m"]);
}

export function slidersGoByFactorsWhereTheRangeIsWide() {
    const sent = [], send = (value, goesOn) => sent.push([value, goesOn]);
    const slide = ({ element }, fraction) => {
        const slider = element.querySelector("input[type=range]");
        slider.value = Number(slider.min) + fraction * (slider.max - slider.min);
        slider.dispatchEvent(new Event("input"));
        return slider;
    };
    const wide = numeric("Brightness", send, { min: 1e-4, max: 100 }), even = numeric("Depth", send, { min: 0, max: 64, whole: true });
    slide(wide, 0.5);
    slide(wide, 1);
    slide(even, 0.25);
    equal(sent, [[0.1, false], [100, true], [16, false]]);
    const slider = numeric("Brightness", send, { min: 1e-4, max: 100 });
    slider.show(0.1, true);
    equal(slider.element.querySelector("input[type=range]").value, "250");
    for (const without of [{ min: 1e-30, max: 1e30 }, { min: 0, max: 1e6 }, { min: 0 }])
        equal(numeric("Value", send, without).element.querySelector("input[type=range]"), null);
}

export function aLabelLeadsBackByADoubleClick() {
    let times = 0;
    const field = numeric("Depth", () => {}, { min: 0, max: 64, reset: { text: "Reset", run: () => times++ } });
    const click = () => field.element.querySelector("label").dispatchEvent(new Event("dblclick"));
    field.back.hidden = true;
    click();
    equal(times, 0, "nothing to lead back");
    field.back.hidden = false;
    click();
    equal(times, 1);
}

export function oneOfAFewStepsIsPressedOrNone() {
    const chosen = [], bar = steps("Quality", [["a", "A", ""], ["b", "B", ""]], (what) => chosen.push(what), "Custom");
    const state = () => [...bar.element.querySelectorAll("button")].map((each) => each.getAttribute("aria-pressed")).join();
    const custom = bar.element.querySelector(".dim");
    bar.show("b", true);
    equal([state(), custom.hidden], ["false,true", true]);
    bar.element.querySelector("button").click();
    equal([chosen, state()], [["a"], "false,true"], "the server says when it is so");
    bar.show(null, false);
    equal([state(), custom.hidden, bar.element.querySelector("button").disabled], ["false,false", false, true]);
}
