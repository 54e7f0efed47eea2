// A tet mesh as arrays to draw, all in the order of the strip.
import { drawn } from './frame.mjs';
import { corner_normals } from './normals.mjs';

export const FACETS = [1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1];
const NONE = 0xffffffff;

// Facet f = 4 * tet + corner has the facet twins[f] on its other side, or NONE. Facets that more than
// two tets share pair up in order; one may be left over.
export function twins_of(tets) {
    const facets = tets.length, twins = new Uint32Array(facets).fill(NONE);
    let slots = 16;
    while (slots < 2 * facets) slots *= 2;
    const table = new Int32Array(slots).fill(-1);
    const key = (f) => {
        const tet = f & ~3, k = 3 * (f & 3);
        let a = tets[tet + FACETS[k]], b = tets[tet + FACETS[k + 1]], c = tets[tet + FACETS[k + 2]], t;
        if (a > b) (t = a), (a = b), (b = t);
        if (b > c) (t = b), (b = c), (c = t);
        if (a > b) (t = a), (a = b), (b = t);
        key.a = a, key.b = b, key.c = c;
    };
    for (let f = 0; f < facets; ++f) {
        key(f);
        const { a, b, c } = key;
        let h = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b) ^ Math.imul(c, 0xc2b2ae35);
        h ^= h >>> 15;
        h = Math.imul(h, 0x2c1b3c6d);
        let slot = (h ^ (h >>> 13)) & (slots - 1), found = false;
        for (; table[slot] >= 0; slot = (slot + 1) & (slots - 1)) {
            if (twins[table[slot]] !== NONE) continue;
            key(table[slot]);
            if (key.a !== a || key.b !== b || key.c !== c) continue;
            twins[f] = table[slot];
            twins[table[slot]] = f;
            found = true;
            break;
        }
        if (!found) table[slot] = f;
    }
    return twins;
}

// Facets look outwards: where a tet's volume is negative, two of its corners change places.
function turn(tets, points) {
    for (let t = 0; t < tets.length; t += 4) {
        const a = 3 * tets[t], b = 3 * tets[t + 1], c = 3 * tets[t + 2], d = 3 * tets[t + 3];
        const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
        const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
        const wx = points[d] - points[a], wy = points[d + 1] - points[a + 1], wz = points[d + 2] - points[a + 2];
        if (ux * (vy * wz - vz * wy) + uy * (vz * wx - vx * wz) + uz * (vx * wy - vy * wx) >= 0) continue;
        const kept = tets[t + 2];
        tets[t + 2] = tets[t + 3];
        tets[t + 3] = kept;
    }
}

export function draw_tets(mesh, frame) {
    const { strip } = mesh, cells = mesh.cellCount;
    const points = drawn(mesh.points, frame), tets = new Uint32Array(4 * cells), stepOf = new Uint32Array(cells);
    const centres = new Float32Array(3 * cells), gates = new Float32Array(3 * cells);
    for (let k = 0; k < cells; ++k) {
        const cell = strip.cell[k], entry = strip.entry[k] & 3;
        stepOf[cell] = k;
        for (let i = 0; i < 4; ++i) tets[4 * k + i] = mesh.tets[4 * cell + i];
        for (let axis = 0; axis < 3; ++axis) {
            let sum = 0;
            for (let i = 0; i < 4; ++i) sum += points[3 * tets[4 * k + i] + axis];
            centres[3 * k + axis] = sum / 4;
            gates[3 * k + axis] = (sum - points[3 * tets[4 * k + entry] + axis]) / 3;
        }
    }
    turn(tets, points);
    const twins = twins_of(tets);

    // The boundary, with smooth normals: `bounds` are its facets, `normals` three int16 quadruples each.
    let count = 0;
    for (const twin of twins) count += twin === NONE;
    const bounds = new Uint32Array(count), corners = new Uint32Array(3 * count), positions = new Float32Array(9 * count);
    for (let f = 0, b = 0; f < twins.length; ++f) {
        if (twins[f] !== NONE) continue;
        for (let i = 0; i < 3; ++i) {
            const point = tets[(f & ~3) + FACETS[3 * (f & 3) + i]];
            corners[3 * b + i] = point;
            for (let axis = 0; axis < 3; ++axis) positions[9 * b + 3 * i + axis] = points[3 * point + axis];
        }
        bounds[b++] = f;
    }
    const begin = new Uint32Array(count + 1);
    for (let b = 0; b <= count; ++b) begin[b] = 3 * b;
    const normals = corner_normals(positions, begin, corners, mesh.pointCount);
    return { points, tets, twins, stepOf, centres, gates, bounds, normals };
}
