/** Parts and materials of the model. Lists are long and seldom needed: they are asked for when the panel is opened. */
import { button, make } from "./dom.js";
import { colour, group, numeric, toggle } from "./fields.js";
import { number, of, t } from "./texts.js";

const MOST_SHOWN = 300; // rows of a list; the field above it finds the others

/** Fields of a material: key, label, range of a number or "colour" or "switch". */
const fieldsOf = () => [
    ["diffuse", of("MaterialFields", "Colour"), "colour"],
    ["roughness", of("MaterialFields", "Roughness"), [0, 1]],
    ["shininess", of("MaterialFields", "Shininess"), [0, 1000]],
    ["metallic", of("MaterialFields", "Metal"), [0, 1]],
    ["reflectivity", of("MaterialFields", "Mirror"), [0, 1]],
    ["opacity", of("MaterialFields", "Opacity"), [0, 1]],
    ["transmission", of("MaterialFields", "Glass colour"), "colour"],
    ["indexOfRefraction", of("MaterialFields", "Refraction"), [1, 3]],
    ["textures", of("MaterialFields", "Textures"), "switch"],
    ["flipTextures", of("MaterialFields", "Upside down"), "switch"],
];

export function modelPanel(app) {
    const lists = { parts: [], materials: [] };
    let chosen = 0, material = null, places, fields, find, all, scene = null;

    /** All rows, asked for piece by piece. */
    async function load(what) {
        const rows = [];
        for (let from = 1; from; ) {
            const answer = await app.ask(what, { from });
            if (!answer.ok) break;
            rows.push(...answer[what]);
            from = answer.next;
        }
        lists[what] = rows;
    }

    const nameOf = (row) => row.name || of("ModelPanel", "Without a name (%1)").replace("%1", row.number);

    const partItem = (row) => {
        const box = make("input", { type: "checkbox", checked: row.shown, disabled: !app.mayEdit(), "aria-label": nameOf(row),
            onchange: () => app.ask(box.checked ? "partShow" : "partHide", { parts: [row.number] }) });
        const alone = button(t("isolate", nameOf(row)), () => app.ask("partIsolate", { parts: [row.number] }), "model");
        alone.disabled = !app.mayEdit();
        return make("li", {}, box, make("span", { className: "name", title: t("triangles", number(row.triangles)) }, nameOf(row)),
            make("span", { className: "dim" }, number(row.triangles)), alone);
    };

    const materialItem = (row) => make("li", {}, make("button", { type: "button", className: "name", "aria-current": String(row.number === chosen),
        onclick: () => choose(row.number) }, nameOf(row)), ...(row.edited ? [make("span", { className: "dim" }, t("edited"))] : []));

    async function choose(which) {
        chosen = which;
        await showMaterial();
        list();
    }

    async function showMaterial() {
        const answer = chosen ? await app.ask("material", { number: chosen }) : { ok: false };
        material = answer.ok ? answer.material : null;
        fields.hidden = !material;
        if (!material) return;
        for (const { key, made } of fields.made) {
            made.element.hidden = !(key in material);
            if (key in material) made.show(material[key], app.mayEdit());
        }
        fields.back.disabled = !app.mayEdit();
    }

    function addFields(place) {
        fields = make("div", { role: "group", "aria-label": t("model"), hidden: true });
        const set = (key) => (value, goesOn) => app.edit("materialSet " + chosen + key, "materialSet", { number: chosen, key, value }, goesOn === true);
        fields.made = fieldsOf().map(([key, label, kind]) => {
            const made = kind === "colour" ? colour(label, set(key)) : kind === "switch" ? toggle(label, set(key))
                : numeric(label, set(key), { min: kind[0], max: kind[1] });
            fields.append(made.element);
            return { key, made };
        });
        fields.back = button(of("MaterialFields", "As in the file"), () => app.ask("materialReset", { number: chosen }));
        fields.back.title = of("MaterialFields", "Take all changes of this material back");
        fields.append(make("div", { className: "actions" }, fields.back));
        place.append(fields);
    }

    function list() {
        const wanted = find.value.trim().toLowerCase();
        const fits = (row) => wanted === "" || nameOf(row).toLowerCase().includes(wanted);
        for (const [what, item] of [["parts", partItem], ["materials", materialItem]]) {
            const rows = lists[what].filter(fits);
            places[what].replaceChildren(...rows.slice(0, MOST_SHOWN).map(item),
                ...(rows.length > MOST_SHOWN ? [make("li", {}, make("span", { className: "dim" }, t("more")))] : []));
        }
    }

    /** The part and the material in the middle of the image. */
    async function pick() {
        const answer = await app.ask("seen", { x: 0.5, y: 0.5 });
        if (!answer.ok) return;
        find.value = "";
        if (answer.material) await choose(answer.material.number);
        if (answer.part) find.value = answer.part.name ?? "";
        list();
    }

    async function refresh() {
        await Promise.all([load("parts"), load("materials")]);
        await showMaterial();
        list();
    }

    return {
        id: "model",
        fill(place) {
            scene = null;
            find = make("input", { type: "search", placeholder: t("findPart"), "aria-label": t("findPart"), oninput: list });
            places = { parts: make("ul", { className: "list" }), materials: make("ul", { className: "list" }) };
            all = button(of("ModelPanel", "Show all"), () => app.ask("partShowAll"));
            const parts = group(of("ModelPanel", "Parts"), make("div", { className: "actions" }, all), places.parts);
            const materials = group(of("ModelPanel", "Materials"), places.materials);
            parts.open = true;
            materials.open = true;
            place.append(find, make("div", { className: "actions" }, button(t("seen"), pick)));
            addFields(place);
            place.append(materials, parts);
        },
        show() {
            all.disabled = !app.mayEdit();
            const now = [app.state.scene, app.state.edits, app.state.redo, app.mayEdit()].join("|");
            if (now === scene) return;
            scene = now;
            refresh();
        },
    };
}
