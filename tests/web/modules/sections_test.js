import { equal } from "./expect.js";
import { axisName, sideOf, sidesOf, trackOf } from "./panel_sections.js";

// As the window has them, whichever axis is up.
export function sectionsHaveASideAndATrack() {
    equal(axisName(sidesOf([0, 1, 0]).front), "z");
    equal(axisName(sidesOf([0, 0, 1]).front), "-y");
    equal(axisName(sidesOf([0, 0, 1]).above), "z");
    equal(axisName(sidesOf([0, 1, 0]).right), "x");
    const below = sideOf([0, -3, 0], [0, 1, 0]);
    equal([below.away, below.axis, below.along], ["below %1", "y", [0, 1, 0]]);
    equal(sideOf([1, 1, 0], [0, 1, 0]).axis, "");
    equal(trackOf([0, 1, 0], { lo: [-1, 2, 0], hi: [1, 5, 3] }), { min: 2, max: 5 });
}
