// Colour maps and the values they show. The ramps are straight paths in Oklab (Ottosson 2020) with
// evenly rising lightness, so equal steps of a value look equal and survive being printed grey.
export const MISSING = 3e38;

// Lightness, then a and b of a few stops.
const STOPS = [[0.42, 0.03, -0.15], [0.54, -0.05, -0.105], [0.66, -0.11, -0.005], [0.79, -0.115, 0.1], [0.92, -0.03, 0.155]];

function linear_of_oklab([L, a, b]) {
    const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3, m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3,
        s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
    return [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
        -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s];
}
function byte_of(linear) {
    const c = Math.min(1, Math.max(0, linear));
    return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
}

// sRGB bytes, four per entry.
export function ramp_bytes(size = 256) {
    const stops = STOPS, bytes = new Uint8Array(4 * size);
    for (let i = 0; i < size; ++i) {
        const x = (i / (size - 1)) * (stops.length - 1), k = Math.min(Math.floor(x), stops.length - 2);
        const lab = stops[k].map((from, c) => from + (x - k) * (stops[k + 1][c] - from));
        bytes.set([...linear_of_oklab(lab).map(byte_of), 255], 4 * i);
    }
    return bytes;
}

// Ten hues of one lightness and chroma, for values that are names.
export const PALETTE_SIZE = 10;
export function palette_bytes() {
    const bytes = new Uint8Array(4 * PALETTE_SIZE);
    for (let i = 0; i < PALETTE_SIZE; ++i) {
        // Neighbours in number are far apart in hue, and alternate in lightness.
        const hue = (((i * 3) % PALETTE_SIZE) * 2 * Math.PI) / PALETTE_SIZE + 4.5, chroma = 0.115;
        bytes.set([...linear_of_oklab([i % 2 ? 0.62 : 0.76, chroma * Math.cos(hue), chroma * Math.sin(hue)]).map(byte_of), 255], 4 * i);
    }
    return bytes;
}
export const css_of = (bytes, i) => `rgb(${bytes[4 * i]} ${bytes[4 * i + 1]} ${bytes[4 * i + 2]})`;
export const css_of_ramp = () => {
    const bytes = ramp_bytes(24);
    return `linear-gradient(to right, ${Array.from({ length: 24 }, (_, i) => css_of(bytes, i)).join(', ')})`;
};

// What a mesh can be coloured by: the strip, nothing, and its attributes component by component.
export function fields_of(model) {
    const fields = [{ id: 'strip', label: 'Along the strip' }, { id: 'plain', label: 'One colour' }];
    for (const [number, attribute] of model.attributes.entries()) {
        const { name, place, arity, values } = attribute;
        const shown = place === 'point' || place === 'cell' || (place === 'corner' && model.kind === 'polygon');
        if (!shown || values.length === 0) continue;
        const parts = arity === 1 ? [undefined] : [...(arity <= 4 ? Array(arity).keys() : []), 'length'];
        for (const part of parts) {
            const words = part === undefined ? '' : part === 'length' ? ', length' : `, ${arity <= 4 ? 'xyzw'[part] : part}`;
            fields.push({ id: `${number}:${part ?? ''}`, label: `${name}${words}`, place, attribute, part });
        }
    }
    return fields;
}

function reader_of({ attribute, part }) {
    const { values, index, arity } = attribute;
    return (element) => {
        const tuple = index === undefined ? element : index[element];
        if (tuple === 0xffffffff) return MISSING;
        let value;
        if (part === 'length') {
            value = 0;
            for (let k = 0; k < arity; ++k) value += Number(values[arity * tuple + k]) ** 2;
            value = Math.sqrt(value);
        } else {
            value = Number(values[arity * tuple + (part ?? 0)]);
        }
        return Number.isFinite(value) ? value : MISSING;
    };
}

// Names and numbers of an integer field of few values; undefined for all others.
function categories_of(model, { attribute, place }, read, elements) {
    if (!/^u?int/.test(attribute.type) || attribute.arity !== 1) return undefined;
    const values = new Set();
    for (let i = 0; i < elements && values.size <= 24; ++i) values.add(read(i));
    values.delete(MISSING);
    const named = model.tagNames.some((tag) => tag.attribute === attribute.name);
    if (values.size > 24 || (!named && values.size > 12) || values.size === 0) return undefined;
    const dimension = place === 'cell' ? (model.kind === 'tet' ? 3 : 2) : -1;
    const name_of = (value) => model.tagNames.find((tag) => tag.attribute === attribute.name && tag.value === value &&
        (tag.dimension < 0 || tag.dimension === dimension))?.name;
    return [...values].sort((a, b) => a - b).map((value) => ({ value, name: name_of(value) ?? `${value}` }));
}

// {place, read(element), low, high, categories}; the strip's values are steps.
export function values_of(model, field) {
    const { id, place } = field;
    if (id === 'plain') return { place: 'none' };
    if (id === 'strip') {
        const { stepOf } = model.draw;
        return { place: 'cell', read: (cell) => stepOf[cell], low: 0, high: Math.max(1, model.cellCount - 1) };
    }
    const raw = reader_of(field);
    const elements = place === 'point' ? model.pointCount : place === 'cell' ? model.cellCount : model.draw.pointOf.length;
    const categories = categories_of(model, field, raw, elements);
    if (categories !== undefined) {
        const slots = new Map(categories.map(({ value }, i) => [value, i % PALETTE_SIZE]));
        return { place, read: (element) => slots.get(raw(element)) ?? MISSING, categories, low: 0, high: PALETTE_SIZE };
    }
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < elements; ++i) {
        const value = raw(i);
        if (value >= MISSING) continue;
        if (value < low) low = value;
        if (value > high) high = value;
    }
    if (!(low <= high)) [low, high] = [0, 1];
    // The shader's numbers are 32-bit: they get the range moved to 0..1.
    const span = high - low || 1;
    return { place, read: (element) => { const v = raw(element); return v >= MISSING ? v : (v - low) / span; }, low: 0, high: 1, shown: [low, high] };
}
