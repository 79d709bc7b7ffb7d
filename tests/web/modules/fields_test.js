import { equal } from "./expect.js";
import { measured, numeric, vector } from "./fields.js";

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
