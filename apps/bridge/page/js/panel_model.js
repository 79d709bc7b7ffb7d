/**
 * Variants, parts and materials of the model. Lists are long and seldom needed: they are asked for when the panel is
 * opened.
 */
import { button, make, refill } from "./dom.js";
import { choice, colour, group, numeric, toggle } from "./fields.js";
import { number, of, t } from "./texts.js";

const MAX_SHOWN = 300; // rows of a list; the field above it finds the others

/** Fields of a material: key, label, range of a number or "colour" or "switch". */
const fieldsOf = () => [
    ["diffuse", of("MaterialFields", "Colour"), "colour"],
    ["roughness", of("MaterialFields", "Roughness"), [0, 1]],
    ["metallic", of("MaterialFields", "Metal"), [0, 1]],
    ["coat", of("MaterialFields", "Varnish"), [0, 1]],
    ["coatRoughness", of("MaterialFields", "Its roughness"), [0, 1]],
    ["reflectivity", of("MaterialFields", "Mirror"), [0, 1]],
    ["opacity", of("MaterialFields", "Opacity"), [0, 1]],
    ["transmission", of("MaterialFields", "Glass colour"), "colour"],
    ["indexOfRefraction", of("MaterialFields", "Refraction"), [1, 3]],
    ["priority", of("MaterialFields", "Priority"), [0, 100]],
    ["textures", of("MaterialFields", "Textures"), "switch"],
    ["flipTextures", of("MaterialFields", "Upside down"), "switch"],
];

export function modelPanel(app) {
    const lists = { parts: [], materials: [] };
    // `picked`: what is looked for is the name of a part that was picked in the image, no material's.
    const variants = { names: "", place: null, made: null };
    let chosen = 0, material = null, places, fields, find, picked = false, showAll, scene = null;

    /** All rows, asked for piece by piece; null where one was refused. */
    async function load(what) {
        const rows = [];
        for (let from = 1; from; ) {
            const answer = await app.ask(what, from);
            if (!answer.ok) return null;
            rows.push(...answer[what]);
            from = answer.next;
        }
        return rows;
    }

    const nameOf = (row) => row.name || of("ModelPanel", "Without a name (%1)").replace("%1", row.number);

    const partItem = (row) => {
        const box = make("input", { type: "checkbox", checked: row.shown, disabled: !app.mayEdit(),
            "aria-label": nameOf(row),
            onchange: async () => {
                const { ok } = await app.ask(box.checked ? "part show" : "part hide", row.number);
                if (!ok) box.checked = row.shown;
            } });
        const alone = button(t("isolate", nameOf(row)), () => app.ask("part isolate", row.number), "model");
        alone.disabled = !app.mayEdit();
        return make("li", {}, box, make("span", { className: "name", title: t("triangles", number(row.triangles)) },
            nameOf(row)),
            make("span", { className: "dim" }, number(row.triangles)), alone);
    };

    const materialItem = (row) => make("li", {}, make("button",
        { type: "button", className: "name", "aria-current": String(row.number === chosen),
        onclick: () => choose(row.number) }, nameOf(row)),
            ...(row.edited ? [make("span", { className: "dim" }, t("edited"))] : []));

    async function choose(which) {
        chosen = which;
        await showMaterial();
        list();
    }

    async function showMaterial() {
        const answer = chosen ? await app.ask("material get", chosen) : { ok: false };
        material = answer.ok ? answer.material : null;
        fields.hidden = !material;
        if (!material) return;
        for (const { key, made } of fields.made) {
            made.element.hidden = !(key in material);
            if (key in material) made.show(key === "reflectivity" ? Math.max(...material[key]) : material[key],
                app.mayEdit());
        }
        fields.back.disabled = !app.mayEdit();
    }

    function addFields(place) {
        fields = make("div", { role: "group", "aria-label": t("model"), hidden: true });
        const set = (key) => async (value, goesOn) => {
            const which = chosen;
            const ok = await app.edit("material set " + which + key, "material set", [which, key, ...[value].flat()],
                goesOn === true);
            if (!ok) showMaterial();
        };
        fields.made = fieldsOf().map(([key, label, kind]) => {
            const made = kind === "colour" ? colour(label, set(key)) : kind === "switch" ? toggle(label, set(key))
                : numeric(label, set(key), { min: kind[0], max: kind[1] });
            fields.append(made.element);
            return { key, made };
        });
        fields.back = button(of("MaterialFields", "As in the file"), () => app.ask("material reset", chosen));
        fields.back.title = of("MaterialFields", "Reset this material");
        fields.append(make("div", { className: "actions" }, fields.back));
        place.append(fields);
    }

    function list() {
        const wanted = find.value.trim().toLowerCase();
        const fits = (row) => wanted === "" || nameOf(row).toLowerCase().includes(wanted);
        for (const [what, item] of [["parts", partItem], ["materials", materialItem]]) {
            const rows = what === "materials" && picked ? lists[what] : lists[what].filter(fits);
            refill(places[what], [...rows.slice(0, MAX_SHOWN).map(item),
                ...(rows.length > MAX_SHOWN ? [make("li", {}, make("span", { className: "dim" }, t("more")))] : [])]);
        }
    }

    /** By their numbers; 0: without one. */
    function showVariants() {
        const all = app.state.variants ?? [], names = JSON.stringify(all);
        if (variants.names !== names) {
            variants.names = names;
            variants.made = choice(t("variant"), [t("variantNone"), ...all].map((name, at) => [String(at), name]),
                async (at) => {
                    await (at === "0" ? app.ask("variant leave") : app.ask("variant go", Number(at)));
                    showVariants();
                });
            refill(variants.place, all.length > 0 ? [variants.made.element] : []);
        }
        variants.made.show(String(all.indexOf(app.state.variant) + 1), app.mayEdit());
    }

    /** The part and the material in the middle of the image. */
    async function pick() {
        const answer = await app.ask("seen", 0.5, 0.5);
        if (!answer.ok) return;
        find.value = "";
        picked = true;
        if (answer.material) await choose(answer.material.number);
        find.value = answer.part?.name ?? "";
        list();
    }

    async function refresh() {
        const now = scene, [parts, materials] = await Promise.all([load("parts"), load("materials")]);
        if (now !== scene) return; // a later one is under way
        if (parts && materials) Object.assign(lists, { parts, materials });
        await showMaterial();
        list();
    }

    return {
        id: "model",
        fill(place) {
            scene = null;
            Object.assign(variants, { names: "", place: make("div") });
            find = make("input", { type: "search", placeholder: t("findPart"), "aria-label": t("findPart"),
                oninput: () => {
                picked = false;
                list();
            } });
            places = { parts: make("ul", { className: "list" }), materials: make("ul", { className: "list" }) };
            showAll = button(of("ModelPanel", "Show all"), () => app.ask("part show-all"));
            const parts = group(of("ModelPanel", "Parts"), make("div", { className: "actions" }, showAll),
                places.parts);
            const materials = group(of("ModelPanel", "Materials"), places.materials);
            parts.open = true;
            materials.open = true;
            place.append(variants.place, find, make("div", { className: "actions" }, button(t("seen"), pick)));
            addFields(place);
            place.append(materials, parts);
        },
        show() {
            showVariants();
            showAll.disabled = !app.mayEdit();
            const now = [app.state.scene, app.state.edits, JSON.stringify(app.state.redo), app.mayEdit(),
                app.welcome?.you].join("|");
            if (now === scene) return;
            scene = now;
            refresh();
        },
    };
}
