// Assertions of the tests of the page's modules. One that does not hold is noted with its line, and the test goes on.
const failures = [];

// The line of a test that a stack goes through.
function lineOf({ stack }) {
    const [, file = "", line = 0] = /([a-z_]+_test\.js):(\d+)/.exec(stack) ?? [];
    return { file, line: Number(line) };
}

function fail(text, note) {
    failures.push({ ...lineOf(new Error()), text: note === "" ? text : `${text} (${note})` });
}

export function isTrue(value, note = "") {
    if (value !== true) fail(`${JSON.stringify(value)} is not true`, note);
}

// Compares as JSON does, so lists and objects by what is in them; undefined counts as null.
export function equal(value, expected, note = "") {
    const [got, wanted] = [value, expected].map((each) => JSON.stringify(each ?? null));
    if (got !== wanted) fail(`${got} is not ${wanted}`, note);
}

export function atMost(value, limit, note = "") {
    if (!(value <= limit)) fail(`${value} is more than ${limit}`, note);
}

// Runs the function `name` of a test file with what it is given: what failed, as {file, line, text}.
export async function failuresOf(file, name, given) {
    failures.length = 0;
    try {
        await (await import(`./${file}`))[name](given);
    } catch (error) {
        failures.push({ ...lineOf(error), text: `it throws ${error}` });
    }
    return failures;
}
