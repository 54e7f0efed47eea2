// Numbers about the file and its peers, as tables that a screen reader reads and bars that an eye does.
export const number = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
const short = (x) => (x === 0 ? '0' : Math.abs(x) >= 0.01 && Math.abs(x) < 1e5 ? `${+x.toPrecision(3)}` : x.toExponential(1));
export const bytes_in_words = (n) => (n < 10_000 ? `${number.format(n)} B` : n < 1e6 ? `${(n / 1e3).toFixed(1)} kB` : `${(n / 1e6).toFixed(2)} MB`);
const bits = (bytes, cells) => (cells ? ((8 * bytes) / cells).toFixed(2) : '–');

function element(tag, content, properties = {}) {
    const node = Object.assign(document.createElement(tag), properties);
    for (const part of [content].flat()) if (part !== undefined) node.append(part);
    return node;
}
function bar(share) {
    const node = element('span', undefined, { className: 'bar' });
    node.style.width = `${Math.max(0.5, 100 * Math.min(1, share))}%`;
    node.setAttribute('aria-hidden', 'true');
    return node;
}

export function words_of_positions(info) {
    if (info.lossless) return `exact ${info.positionType}`;
    return `${info.positionBits} bits, within ${short(info.positionBound)}`;
}

export function show_facts(model) {
    const { info } = model, kind = info.kind === 'tet' ? 'tet' : 'polygon';
    const facts = [
        [`${number.format(info.cells)}`, undefined, `${kind}${info.cells === 1 ? '' : 's'}`, bytes_in_words(info.fileBytes), `${bits(info.fileBytes, info.cells)} bits per ${kind}`],
    ];
    const list = document.getElementById('facts');
    list.replaceChildren();
    for (const [left, , under, right, right_under] of facts) {
        list.append(element('dt', [left, element('small', under)], { className: 'lead' }));
        const value = element('dd', right, { className: 'lead' });
        value.append(element('small', right_under, { className: 'note' }));
        list.append(value);
    }
    const pair = (name, value) => list.append(element('dt', name), element('dd', value));
    pair('Points', number.format(info.points));
    pair('Positions', words_of_positions(info));
    pair('Strips', `${number.format(info.components)}, with ${number.format(info.links)} link${info.links === 1 ? '' : 's'}`);
    if (info.companions > 0) pair('Companions', number.format(info.companions));
    pair('Decoded in', `${model.seconds.decode.toFixed(2)} s`);

    const parts = [['header', info.headerBytes], ...info.sections.map((s) => [s.name, s.bytes])].filter(([, n]) => n > 0);
    const most = Math.max(...parts.map(([, n]) => n));
    const table = element('table', element('caption', 'Sections'), { className: 'bars plainly' });
    table.append(element('thead', element('tr', [element('th', 'Section', { scope: 'col' }), element('th', 'Bytes', { scope: 'col' }),
        element('th', `Bits per ${kind}`, { scope: 'col' })])));
    const body = element('tbody');
    for (const [name, size] of parts)
        body.append(element('tr', [element('th', [name, bar(size / most)], { scope: 'row' }), element('td', number.format(size)),
            element('td', bits(size, info.cells))]));
    table.append(body);
    document.getElementById('sections').replaceChildren(table);
}

// Rows of `ravel compare`.
export function show_peers(rows) {
    const box = document.getElementById('peers');
    box.hidden = !(rows?.length > 0);
    if (box.hidden) return;
    const sized = rows.filter((row) => row.bytes !== null).toSorted((a, b) => a.bytes - b.bytes);
    const most = Math.max(...sized.map((row) => row.bytes)), ours = sized.find((row) => row.codec === 'ravel');
    // What all settings begin with is said once.
    const [common] = sized.map((row) => row.settings.split('; ')[0]).filter((words, _, all) => all.every((other) => other === words));
    const table = element('table', element('caption', `Bytes of cells and positions${common ? `, ${common}` : ''}`), { className: 'bars' });
    table.append(element('thead', element('tr', [element('th', 'Codec', { scope: 'col' }), element('th', 'Bytes', { scope: 'col' }), element('th', '× Ravel', { scope: 'col' })])));
    const body = element('tbody');
    for (const row of sized) {
        const name = element('th', [row.codec, bar(row.bytes / most)], { scope: 'row' });
        const kept = row.connectivity_kept && row.codec !== 'ravel' && row.connectivity_kept !== 'tets' && row.connectivity_kept !== 'quads' ? row.connectivity_kept : '';
        const settings = row.settings.split('; ').slice(common ? 1 : 0).join('; ');
        if (settings || kept) name.append(element('span', [settings, kept && `cells ${kept}`].filter(Boolean).join('; '), { className: 'note' }));
        body.append(element('tr', [name, element('td', number.format(row.bytes)),
            element('td', ours && row !== ours ? (row.bytes / ours.bytes).toFixed(2) : '')], { className: row === ours ? 'ours' : '' }));
    }
    table.append(body);
    const none = rows.filter((row) => row.bytes === null);
    document.getElementById('peer-rows').replaceChildren(table,
        ...none.map((row) => element('span', `${row.codec}: ${row.note || 'no result'}`, { className: 'note' })));
}

// Every row of every mesh, as `ravel compare --json` has them.
const COLUMNS = [['mesh', 'Mesh'], ['cells', 'Cells'], ['codec', 'Codec'], ['settings', 'Settings'], ['bytes', 'Bytes'], ['bits_per_cell', 'Bits per cell'],
    ['connectivity_bits_per_cell', 'of these for cells'], ['encode_seconds', 'Encoding, s'], ['decode_seconds', 'Decoding, s'],
    ['max_error', 'Largest error'], ['connectivity_kept', 'Cells kept'], ['note', 'Note']];
export function fill_numbers(box, rows, summary) {
    const text = (value) => (value === null ? '–' : typeof value !== 'number' ? `${value}` : Number.isInteger(value) ? number.format(value) : short(value));
    const table = element('table', element('thead', element('tr', COLUMNS.map(([, title]) => element('th', title, { scope: 'col' })))), { className: 'all' });
    const body = element('tbody');
    for (const row of rows)
        body.append(element('tr', COLUMNS.map(([key]) => element('td', text(row[key]), { className: typeof row[key] === 'number' ? 'figure' : '' })),
            { className: row.codec === 'ravel' ? 'ours' : '' }));
    table.append(body);
    box.replaceChildren(table, element('pre', summary ?? ''));
}
