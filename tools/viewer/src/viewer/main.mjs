// The page: opens files, keeps what the user chose, and shows it.
import worker_source from '../../.build/viewer-worker.txt';
import { fields_of, values_of, css_of_ramp } from './colours.mjs';
import { bytes_of, given, watch_drops, words_for_mesh } from './files.mjs';
import { fill_help, watch_keys } from './keys.mjs';
import { show_legend } from './legend.mjs';
import { new_look } from './material.mjs';
import { bytes_in_words, fill_numbers, number, show_facts, show_peers } from './panel.mjs';
import { PolygonView } from './polygon_view.mjs';
import { Stage } from './stage.mjs';
import { TetView } from './tet_view.mjs';

const $ = (id) => document.getElementById(id);
const stage = new Stage($('canvas')), look = new_look();
const state = { model: undefined, view: undefined, steps: 0, field: undefined, flipped: false, playing: undefined };
const worker = new Worker(URL.createObjectURL(new Blob([worker_source], { type: 'text/javascript' })));
let task = 0;

const tell = (words) => { $('live').textContent = words; };

// -- What is drawn ------------------------------------------------------------------------------

function theme() {
    const style = getComputedStyle(document.documentElement), get = (name) => style.getPropertyValue(`--${name}`).trim();
    return { stage: get('stage'), line: get('line'), rest: get('rest'), plain: get('plain'), ink: get('curve'), accent: get('link'),
        lines: 0.55, pixel: stage.renderer.getPixelRatio() };
}

function paint() {
    const colours = theme();
    stage.set_background(colours.stage);
    look.plain.value.set(colours.plain);
    look.missing.value.set(colours.rest);
    look.line.value.set(colours.line);
    look.pixel.value = colours.pixel;
    state.view?.paint(colours);
    show();
}

function clip_plane() {
    if (state.model.kind !== 'tet' || !$('clip').checked) return undefined;
    const axis = Number(document.querySelector('input[name=axis]:checked').value), half = state.model.frame.half[axis];
    const at = (Number($('clip-at').value) / 500 - 1) * half * 1.001, sign = state.flipped ? -1 : 1, plane = [0, 0, 0, sign * at];
    plane[axis] = sign;
    return plane;
}

function show() {
    const { model, view, steps } = state;
    if (view === undefined) return;
    const clip = clip_plane();
    view.show({
        steps, clip, edges: $('edges').checked, curve: $('curve').checked, links: $('links').checked && model.strip.linkSteps.length > 0,
        rest: $('rest').checked, smooth: !$('flat').checked, shrink: model.kind === 'tet' ? Number($('shrink').value) / 100 : 0,
    });
    stage.draw_soon();
}
let waiting;
function show_soon() {
    waiting ??= requestAnimationFrame(() => { waiting = undefined; show(); });
}

function colour_by(id) {
    const { model, view } = state;
    state.field = state.fields.find((field) => field.id === id) ?? state.fields[0];
    const values = values_of(model, state.field);
    $('colour').value = state.field.id;
    look.mode.value = values.place === 'none' ? 0 : values.categories ? 2 : 1;
    look.low.value = values.low ?? 0;
    look.high.value = values.high ?? 1;
    view.colour(values);
    state.values = values;
    $('wind').style.setProperty('--track', state.field.id === 'strip' ? css_of_ramp() : '');
    legend();
    show();
}
function legend() {
    show_legend(state.field, state.values, $('links').checked && state.model.strip.linkSteps.length > 0);
    make_room();
}
// A legend across most of the stage would lie over the mesh; one in the corner does not.
function make_room() {
    const { offsetWidth: width, offsetHeight: height } = $('legend');
    stage.set_inset(width > 0.36 * $('stage').clientWidth ? height : 0);
}
new ResizeObserver(make_room).observe($('stage'));

// -- Winding ------------------------------------------------------------------------------------

function wind(steps, spoken = true) {
    const { model } = state, all = model.cellCount;
    state.steps = Math.max(0, Math.min(all, Math.round(steps)));
    $('wind').value = state.steps;
    const share = all ? Math.round((100 * state.steps) / all) : 100;
    $('wound').innerHTML = `<b>${number.format(state.steps)}</b> <span class="total">of ${number.format(all)} cells</span>`;
    $('wind').setAttribute('aria-valuetext', `${number.format(state.steps)} of ${number.format(all)} cells, ${share} percent`);
    if (spoken && state.playing === undefined) tell(`${share} percent wound`);
    show_soon();
}

function stop() {
    if (state.playing === undefined) return;
    cancelAnimationFrame(state.playing);
    state.playing = undefined;
    $('play').setAttribute('aria-pressed', 'false');
    $('play').setAttribute('aria-label', 'Wind the strip');
}
function play() {
    if (state.playing !== undefined) return stop();
    const all = state.model.cellCount, from = state.steps >= all ? 0 : state.steps;
    // Ten seconds for all of it, and some for each cell where there are few.
    const seconds = Math.min(10, 1.5 + all / 60);
    const start = performance.now();
    $('play').setAttribute('aria-pressed', 'true');
    $('play').setAttribute('aria-label', 'Pause');
    tell('winding');
    const step = (now) => {
        const steps = from + ((now - start) / 1e3 / seconds) * all;
        wind(steps, false);
        if (steps < all) state.playing = requestAnimationFrame(step);
        else stop(), tell('all cells are wound');
    };
    state.playing = requestAnimationFrame(step);
}

// -- Opening ------------------------------------------------------------------------------------

function busy(words, share) {
    $('busy').hidden = words === undefined;
    if (words === undefined) return;
    $('drop').hidden = true;
    $('broken').hidden = true;
    $('busy-words').textContent = words;
    if (share === undefined) $('busy-bar').removeAttribute('value');
    else $('busy-bar').value = share;
}

function complain(name, { code, at, detail, commands = [] }) {
    busy();
    const box = $('broken');
    const heading = document.createElement('h2'), sentence = document.createElement('p');
    heading.textContent = commands.length ? `${name} is not packed yet` : code === 'bug' ? `${name}: the viewer failed` : `${name} can't be opened`;
    sentence.textContent = detail.charAt(0).toUpperCase() + detail.slice(1) + (/[.:!?]$/.test(detail) ? '' : '.');
    box.replaceChildren(heading, sentence);
    for (const command of commands) {
        const line = document.createElement('p'), words = document.createElement('code');
        words.textContent = command;
        line.append(words);
        box.append(line);
    }
    if (code !== undefined) {
        const list = document.createElement('dl');
        for (const [term, value] of [['Code', code], ['Place', `byte ${number.format(at)}`]]) {
            const dt = document.createElement('dt'), dd = document.createElement('dd');
            dt.textContent = term;
            dd.textContent = value;
            list.append(dt, dd);
        }
        box.append(list);
    }
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'primary';
    button.textContent = state.model ? 'Back to the mesh' : 'Open another file';
    button.onclick = () => { box.hidden = true; if (state.model) $('canvas').focus(); else { $('drop').hidden = false; $('open').focus(); $('open').click(); } };
    box.append(button);
    box.hidden = false;
    $('drop').hidden = true;
}

function ask_worker(bytes, progress) {
    const id = ++task;
    return new Promise((done, fail) => {
        const listen = ({ data }) => {
            if (data.id !== id) return;
            if (data.stage) return progress(data);
            worker.removeEventListener('message', listen);
            if (data.error) fail(data.error);
            else done(data.model);
        };
        worker.addEventListener('message', listen);
        worker.postMessage({ id, bytes }, [bytes.buffer]);
    });
}

async function open(file) {
    const { name } = file;
    const mine = (state.opening = (state.opening ?? 0) + 1);
    stop();
    busy(`Reading ${name}`);
    tell(`Reading ${name}`);
    try {
        const bytes = await bytes_of(file, (read, size) => busy(`Reading ${name}`, size ? read / size : undefined));
        const unpacked = words_for_mesh(name, bytes);
        if (unpacked) return complain(name, unpacked);
        const model = await ask_worker(bytes, ({ stage: part, info }) => {
            if (part === 'decode') busy(`Decoding ${number.format(info.cells)} cells`);
            else busy('Laying out the strip');
        });
        if (mine !== state.opening) return;
        busy('Drawing');
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        use(model, file);
        busy();
    } catch (error) {
        if (mine !== state.opening) return;
        complain(name, error.code === undefined ? { detail: error.message ?? `${error}` } : error);
    }
}

function use(model, file) {
    document.body.classList.remove('empty');
    for (const id of ['drop', 'broken']) $(id).hidden = true;
    if (state.view) {
        stage.scene.remove(state.view);
        state.view.dispose();
    }
    const tets = model.kind === 'tet';
    state.model = model;
    state.view = tets ? new TetView(model, look) : new PolygonView(model, look);
    state.flipped = false;
    stage.scene.add(state.view);
    stage.before_draw = [(s) => state.view.before_draw(s)];
    $('clip').checked = false;
    $('shrink').value = 0;
    $('clip-at').value = 500;
    $('volume').hidden = !tets;
    $('links').disabled = model.strip.linkSteps.length === 0;
    $('link-count').textContent = number.format(model.strip.linkSteps.length);
    const kind = `${tets ? 'tet' : 'polygon'}${model.cellCount === 1 ? '' : 's'}`;
    $('name').textContent = file.name;
    $('what').textContent = `${number.format(model.cellCount)} ${kind} · ${bytes_in_words(model.info.fileBytes)}`;
    $('canvas').setAttribute('aria-label', `${file.name}: ${number.format(model.cellCount)} ${kind}`);
    document.title = `${file.name} – Ravel viewer`;
    state.fields = fields_of(model);
    $('colour').replaceChildren(...state.fields.map(({ id, label }) => new Option(label, id)));
    $('wind').max = model.cellCount;
    show_facts(model);
    show_peers(file.rows);
    // Marks of thousands of links would hide what they mark.
    $('links').checked = model.strip.linkSteps.length > 0 && model.strip.linkSteps.length <= 400;
    wind(model.cellCount, false);
    stage.resize();
    colour_by('strip');
    stage.frame(model.frame.half, model.draw.positions ?? model.draw.points);
    paint();
    tell(`${file.name}: ${number.format(model.cellCount)} ${kind}, ${number.format(model.pointCount)} points, ${number.format(model.info.fileBytes)} bytes`);
}

// -- Wiring -------------------------------------------------------------------------------------

for (const id of ['edges', 'curve', 'rest', 'clip']) $(id).addEventListener('change', show);
$('links').addEventListener('change', () => { legend(); show(); });
for (const radio of document.querySelectorAll('input[name=shading]')) radio.addEventListener('change', show);
for (const radio of document.querySelectorAll('input[name=up]')) radio.addEventListener('change', () => { stage.set_up(Number(radio.value)); stage.frame(); });
for (const radio of document.querySelectorAll('input[name=axis]')) radio.addEventListener('change', () => { $('clip').checked = true; show(); });
$('clip-at').addEventListener('input', () => { $('clip').checked = true; show_soon(); });
$('shrink').addEventListener('input', show_soon);
$('flip').addEventListener('click', () => { state.flipped = !state.flipped; $('clip').checked = true; show(); });
$('wind').addEventListener('input', () => { stop(); wind(Number($('wind').value)); });
$('play').addEventListener('click', play);
$('colour').addEventListener('change', () => { colour_by($('colour').value); tell(`coloured by ${state.field.label}`); });
for (const id of ['open', 'open-large']) $(id).addEventListener('click', () => $('picker').click());
$('picker').addEventListener('change', () => { const [file] = $('picker').files; $('picker').value = ''; if (file) open(file); });
$('help').addEventListener('click', () => $('keys').showModal());
fill_help($('key-list'));
watch_drops(open);

$('canvas').addEventListener('keydown', (event) => {
    const turn = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.12], ArrowDown: [0, 0.12] }[event.key];
    if (turn) stage.orbit(...turn);
    else if (event.key === '+' || event.key === '=') stage.zoom(0.85);
    else if (event.key === '-') stage.zoom(1 / 0.85);
    else return;
    event.preventDefault();
});
const step = (direction) => (event) => { stop(); wind(state.steps + direction * (event.shiftKey ? Math.max(1, state.model.cellCount / 100) : 1)); };
const cut = (by) => () => { $('clip').checked = true; $('clip-at').value = Number($('clip-at').value) + by; show_soon(); };
const axis = (event) => { document.querySelectorAll('input[name=axis]')['xyz'.indexOf(event.key.toLowerCase())].click(); };
const actions = {
    ',': step(-1), '.': step(1), 0: () => { stop(); wind(state.steps === state.model.cellCount ? 0 : state.model.cellCount); },
    s: () => document.querySelector('input[name=shading]:not(:checked)').click(),
    t: () => document.querySelector('input[name=up]:not(:checked)').click(),
    n: () => { const next = (state.fields.indexOf(state.field) + 1) % state.fields.length; colour_by(state.fields[next].id); tell(`coloured by ${state.field.label}`); },
    '[': cut(-20), ']': cut(20), x: axis, y: axis, z: axis,
    b: () => { $('shrink').value = Number($('shrink').value) >= 60 ? 0 : Number($('shrink').value) + 20; show(); },
    f: () => stage.frame(),
};
const without_mesh = new Set(['o', '?']);
for (const [key, action] of Object.entries(actions)) actions[key] = (event) => { if (state.model) action(event); };
watch_keys(new Proxy(actions, {
    get: (all, key) => all[key] ?? (state.model || without_mesh.has(key) || key === undefined ? undefined : () => {}),
}), () => state.model?.kind === 'tet');

matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
paint();

const data = given();
if (data?.rows?.length) {
    fill_numbers($('all-rows'), data.rows, data.summary);
    $('numbers-open').addEventListener('click', () => $('all-numbers').showModal());
}
if (data?.files?.length) {
    const { files } = data;
    if (files.length > 1) {
        $('files-box').hidden = false;
        $('files').replaceChildren(...files.map(({ name }, i) => new Option(name, i)));
        $('files').addEventListener('change', () => open(files[Number($('files').value)]));
    }
    open(files[0]);
}
