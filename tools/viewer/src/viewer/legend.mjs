// What the colours on the stage mean.
import { css_of, css_of_ramp, palette_bytes, PALETTE_SIZE } from './colours.mjs';

const tick = (x) => (x === 0 ? '0' : Math.abs(x) >= 1e-3 && Math.abs(x) < 1e6 ? `${+x.toPrecision(4)}` : x.toExponential(2));

function line(className, ...content) {
    const node = document.createElement('div');
    node.className = className;
    node.append(...content);
    return node;
}
function swatch(colour) {
    const node = document.createElement('i');
    if (colour) node.style.background = colour;
    return node;
}

export function show_legend(field, values, links) {
    const box = document.getElementById('legend');
    box.hidden = field.id === 'plain' && !links;
    box.replaceChildren();
    if (values.categories) {
        const list = document.createElement('ul'), palette = palette_bytes();
        for (const [i, { name }] of values.categories.entries()) {
            const item = document.createElement('li');
            item.append(swatch(css_of(palette, i % PALETTE_SIZE)), name);
            list.append(item);
        }
        if (values.categories.length < 4) list.style.columns = 1;
        box.append(line('of', field.label), list);
    } else if (field.id !== 'plain') {
        const ramp = line('ramp');
        ramp.style.background = css_of_ramp();
        const [low, high] = values.shown ? values.shown.map(tick) : ['first cell', 'last cell'];
        box.append(line('of', field.label), ramp, line('ends', ...[low, high].map((word) => Object.assign(document.createElement('span'), { textContent: word }))));
    }
    if (links) box.append(line('mark', swatch(), 'link: the strip passes here twice'));
}
