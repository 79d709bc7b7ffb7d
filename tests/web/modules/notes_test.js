import { equal, isTrue } from "./expect.js";
import { noteHead, plainNote } from "./notes.js";

export function notesAreTextWithoutControlCharacters() {
    equal(plainNote(" <b>a</b>\nb\u0000\u001b\u007f\ud800 "), "<b>a</b>\nb");
    equal(plainNote("\ud83d\ude00 \u200d"), "\ud83d\ude00 \u200d".trim());
    equal(plainNote("\u0007 \n"), "");
    const bytes = new TextEncoder().encode(JSON.stringify(plainNote("\u0001".repeat(1000) + "x"))).length;
    equal(bytes, 3, "it has room in a message");
}

export function notesHaveAHead() {
    equal(noteHead({ author: "Ada", written: "" }), "Ada");
    equal(noteHead({ author: "", written: "" }), "");
    isTrue(noteHead({ author: "<b>", written: "2026-11-30T18:40:00Z" }).startsWith("<b>, "));
    equal(noteHead({ author: "Ada", written: "0000" }).split(",")[0], "Ada");
}
