/** The painter in a thread of its own: drawing goes on while the page is busy. */
import { Painter } from "./painter.js";

let painter = null;

onmessage = ({ data }) => {
    if (data.canvas) painter = new Painter(data.canvas, (told) => postMessage(told));
    else painter?.take(data.header, data.buffer);
};
