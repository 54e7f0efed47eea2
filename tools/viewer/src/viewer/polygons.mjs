// A polygon mesh as arrays to draw, all in the order of the strip: what is wound up to a step is a
// prefix of each.
import { find_role } from '../roles.mjs';
import { drawn } from './frame.mjs';
import { corner_normals } from './normals.mjs';

// An edge belongs to the first cell along the strip that has it.
function edges_in_order(begin, points) {
    let slots = 16;
    while (slots < 2 * points.length) slots *= 2;
    const table = new Int32Array(slots).fill(-1);
    const edges = new Uint32Array(2 * points.length), edgeBegin = new Uint32Array(begin.length);
    let count = 0;
    for (let cell = 0; cell + 1 < begin.length; ++cell) {
        const first = begin[cell], end = begin[cell + 1];
        for (let i = first; i < end; ++i) {
            const j = i + 1 < end ? i + 1 : first, a = points[i], b = points[j];
            if (a === b) continue;
            const low = a < b ? a : b, high = a < b ? b : a;
            let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
            slot = (slot ^ (slot >>> 15)) & (slots - 1);
            for (let e = table[slot]; e >= 0; e = table[slot]) {
                const p = points[edges[e]], q = points[edges[e + 1]];
                if ((p === low && q === high) || (p === high && q === low)) break;
                slot = (slot + 1) & (slots - 1);
            }
            if (table[slot] >= 0) continue;
            table[slot] = count;
            edges[count] = i;
            edges[count + 1] = j;
            count += 2;
        }
        edgeBegin[cell + 1] = count;
    }
    return { edges: edges.slice(0, count), edgeBegin };
}

// A normal per corner as the file has it, or undefined.
function own_normals(mesh, corner_of, point_of) {
    const source = find_role(mesh, 'normal');
    if (source === undefined) return undefined;
    const normals = new Int16Array(4 * corner_of.length), n = [0, 0, 0];
    for (let c = 0; c < corner_of.length; ++c) {
        source.read(source.place === 'corner' ? corner_of[c] : point_of[c], n, 0);
        const scale = 32767 / Math.hypot(...n);
        if (!Number.isFinite(scale)) return undefined;
        normals.set([n[0] * scale, n[1] * scale, n[2] * scale], 4 * c);
    }
    return normals;
}

// `mesh` as decoded with faces: 'triangles' and the strip.
export function draw_polygons(mesh, frame) {
    const { begin: old_begin, points } = mesh.polygons, { strip, triangles } = mesh, cells = mesh.cellCount;
    const begin = new Uint32Array(cells + 1), stepOf = new Uint32Array(cells);
    for (let k = 0; k < cells; ++k) {
        const cell = strip.cell[k];
        stepOf[cell] = k;
        begin[k + 1] = begin[k] + old_begin[cell + 1] - old_begin[cell];
    }
    const pointOf = new Uint32Array(points.length), cornerOf = new Uint32Array(points.length);
    for (let k = 0; k < cells; ++k)
        for (let from = old_begin[strip.cell[k]], at = begin[k]; at < begin[k + 1]; ++from, ++at) {
            pointOf[at] = points[from];
            cornerOf[at] = from;
        }
    const at_points = drawn(mesh.points, frame);
    const positions = new Float32Array(3 * pointOf.length);
    for (let c = 0; c < pointOf.length; ++c)
        for (let k = 0; k < 3; ++k) positions[3 * c + k] = at_points[3 * pointOf[c] + k];

    const triangleBegin = new Uint32Array(cells + 1);
    for (const cell of triangles.cells) triangleBegin[stepOf[cell] + 1] += 3;
    for (let k = 0; k < cells; ++k) triangleBegin[k + 1] += triangleBegin[k];
    const index = new Uint32Array(triangles.corners.length), at = triangleBegin.slice();
    for (let t = 0; t < triangles.cells.length; ++t) {
        const cell = triangles.cells[t], step = stepOf[cell], shift = begin[step] - old_begin[cell];
        for (let k = 0; k < 3; ++k) index[at[step]++] = triangles.corners[3 * t + k] + shift;
    }

    const centres = new Float32Array(3 * cells), gates = new Float32Array(3 * cells);
    for (let k = 0; k < cells; ++k) {
        const first = begin[k], degree = begin[k + 1] - first;
        if (degree === 0) continue;
        const i = first + (strip.entry[k] % degree), j = first + ((strip.entry[k] + 1) % degree);
        for (let axis = 0; axis < 3; ++axis) {
            let sum = 0;
            for (let c = first; c < first + degree; ++c) sum += positions[3 * c + axis];
            centres[3 * k + axis] = sum / degree;
            gates[3 * k + axis] = (positions[3 * i + axis] + positions[3 * j + axis]) / 2;
        }
    }
    const normals = own_normals(mesh, cornerOf, pointOf) ?? corner_normals(positions, begin, pointOf, mesh.pointCount);
    return {
        begin, pointOf, cornerOf, stepOf, positions, normals, index, triangleBegin, centres, gates,
        ...edges_in_order(begin, pointOf),
    };
}
