/** The image in the page: its place, and the exact bytes of an image at rest. The stream draws it. */
export class Picture {
    /** @param {HTMLCanvasElement} canvas */
    constructor(canvas) {
        this.canvas = canvas;
        this.exact = null; // the bytes of the PNG that is shown
        this.aspect = 16 / 9;
    }

    /** An image was drawn; `still`: the bytes of an exact one. */
    drew({ shownWidth, shownHeight }, still) {
        this.exact = still ?? null;
        this.aspect = shownWidth / shownHeight;
    }

    /** Where the image lies in the canvas, CSS pixels of the window. */
    box() {
        const room = this.canvas.getBoundingClientRect(), cut = getComputedStyle(this.canvas).objectFit === "cover";
        const width = Math[cut ? "max" : "min"](room.width, room.height * this.aspect), height = width / this.aspect;
        return { x: room.x + (room.width - width) / 2, y: room.y + (room.height - height) / 2, width, height };
    }

    /** A point of the window as 0..1 from the left and the top of the image; null beside it. */
    at(clientX, clientY) {
        const box = this.box();
        const x = (clientX - box.x) / box.width, y = (clientY - box.y) / box.height;
        return x >= 0 && x <= 1 && y >= 0 && y <= 1 ? { x, y } : null;
    }

    /** A small JPEG of what is shown, as a data URL. */
    thumbnail(width, height) {
        const small = document.createElement("canvas");
        small.width = width;
        small.height = height;
        const cut = Math.min(this.canvas.width / width, this.canvas.height / height);
        const w = width * cut, h = height * cut;
        small.getContext("2d").drawImage(this.canvas, (this.canvas.width - w) / 2, (this.canvas.height - h) / 2, w, h,
            0, 0, width, height);
        return small.toDataURL("image/jpeg", 0.7);
    }
}
