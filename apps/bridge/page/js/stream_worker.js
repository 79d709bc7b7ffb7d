/** The stream in a thread of its own. Messages are the names of its methods, and what those take. */
import { Stream } from "./stream.js";

let stream = null;

onmessage = ({ data: [method, ...words] }) => {
    if (stream) stream[method](...words);
    else stream = new Stream(words[0], (what) => postMessage(what, what.still ? [what.still.buffer] : []));
};
