import { equal } from "./expect.js";
import { keyCode } from "./key_table.js";

// `server`: the numbers of the server by the names of keys.
export function keysHaveTheNumbersOfTheServer(server) {
    const code = (place) => keyCode(place, false);
    for (const letter of "ABCDFGHIJKLMNOPSTUWYZ") equal(code(`Key${letter}`), letter.charCodeAt(0), letter); // QERVX: the page's own
    for (const digit of "0123456789") equal(code(`Digit${digit}`), digit.charCodeAt(0), digit);
    for (const [place, number] of Object.entries(server)) equal(code(place), number, place);
    for (const place of ["KeyQ", "KeyE", "KeyR", "KeyV", "F5", "F12", "Tab", "MetaLeft", "ControlLeft", ""]) {
        equal(code(place), 0, place);
    }
    equal(keyCode("ControlLeft", true), server.KeyX, "where it is the page's");
}
