/** The state that panels and hands share: the last messages of the bridge, and requests to it. */
import { Edits } from "./edits.js";
import { showFocusedAgain } from "./fields.js";
import { Notices } from "./notices.js";
import { Statistics } from "./statistics.js";
import { forThisTab } from "./storage.js";
import { said, t } from "./texts.js";

export class App {
    /** @param {Link} link @param {() => {w: number, h: number}} pixels that the page has for the image */
    constructor(link, pixels) {
        this.link = link;
        this.pixels = pixels;
        this.notices = new Notices();
        this.statistics = new Statistics();
        this.edits = new Edits((what, keys) => link.request(what, keys), (answer) => this.tellRefusal(answer));
        this.welcome = null;
        this.roles = { driver: null, asking: [], people: [] };
        this.lost = false; // the connection, after it was there
        this.forgetServer();
    }

    /** Another instance: nothing of what was shown is its. */
    forgetServer() {
        this.state = {};
        this.follow({});
        this.image = this.statistics.image = { paths: false };
        this.speed = 1; // factor of flying, as long as this page knows the server
    }

    follow(status) {
        this.status = this.statistics.status = status;
    }

    driver() {
        return this.roles.people.find(({ id }) => id === this.roles.driver);
    }

    drives() {
        return this.link.greeted && this.roles.driver === this.welcome?.you;
    }

    mayEdit() {
        return this.drives() && !this.welcome.locked.includes("edits");
    }

    /** An argument of a command: `min`, `max`, `words`. */
    argument(command, index) {
        return this.welcome?.commands[command]?.[index] ?? {};
    }

    lightKind(name) {
        return this.welcome?.lightKinds.find((kind) => kind.name === name) ?? {};
    }

    /** A command of the server's table; a refusal is told. */
    ask(what, ...args) {
        return this.request(what, { args });
    }

    /** A request with keys of its own, about roles. */
    async request(what, keys) {
        const answer = await this.link.request(what, keys);
        if (!answer.ok) this.tellRefusal(answer);
        return answer;
    }

    /** An edit that follows a hand: see Edits. */
    edit(thing, what, args, goesOn) {
        return this.edits.edit(thing, what, { args }, goesOn);
    }

    /** Tells why a request was refused; panels show the actual state again. */
    tellRefusal(answer) {
        if (answer.text) said(answer).then((text) => this.notices.show("failed", text, { warn: true }));
        this.panels.show();
        showFocusedAgain();
    }

    askToDrive() {
        return this.request("ask"); // roles tell the rest
    }

    orbits() {
        return this.orbit.is;
    }

    setSpeed(factor) {
        const { min, max } = this.argument("speed", 0);
        this.speed = Math.min(max, Math.max(min, factor));
        this.edit("speed", "speed", [this.speed]);
        this.panels.show();
    }

    async focus({ x, y }) {
        if ((await this.ask("focus", x, y)).ok) this.notices.show("focus", t("focusSet"));
    }

    goTo(instance) {
        forThisTab.set("rt.instance", instance);
        this.link.again();
    }

    /** Hands let go of all that they hold. */
    letGo() {
        this.input.release();
        this.orbit.forget();
        this.held.release();
    }
}
