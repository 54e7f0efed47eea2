// A mesh as the arrays of a THREE.BufferGeometry: vertices, triangles by group, edges of the original
// polygons. Knows nothing of three.js, so that workers and Node can run it.
import { edges_of } from './edges.mjs';
import { find_role, find_tags, name_of_tag } from './roles.mjs';

const ROLES = ['normal', 'uv', 'color'];
const TET_FACETS = [1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1];

function linear_of_srgb(c) {
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
}

// Corners, triangles and cells, whatever kind the mesh is of. `triangles.corners` counts into `points`.
function pieces_of(mesh, tets) {
    if (mesh.kind === 'polygon')
        return { points: mesh.polygons.points, triangles: mesh.triangles, edges: edges_of(mesh.polygons) };
    let points = mesh.surface?.points, cells;
    if (tets === 'surface') {
        cells = mesh.surface.facets.map((facet) => facet >>> 2);
    } else {
        points = new Uint32Array(3 * mesh.tets.length);
        for (let t = 0, at = 0; t < mesh.tets.length; t += 4)
            for (const corner of TET_FACETS) points[at++] = mesh.tets[t + corner];
        cells = new Uint32Array(points.length / 3).map((_, i) => i >>> 2);
    }
    const corners = new Uint32Array(points.length).map((_, i) => i);
    const begin = new Uint32Array(points.length / 3 + 1).map((_, i) => 3 * i);
    return { points, triangles: { corners, cells }, edges: edges_of({ begin, points }) };
}

// Corners of one point share a vertex where their normals, texture coordinates and colours agree.
function split(points, pointCount, sources) {
    const width = sources.reduce((sum, source) => sum + source.arity, 0);
    const first = new Int32Array(pointCount).fill(-1), next = [];
    const point_of = [], vertex_of = new Uint32Array(points.length);
    let rows = new Float32Array(width * Math.max(16, pointCount + (pointCount >> 1)));
    for (let c = 0; c < points.length; ++c) {
        const at = width * point_of.length;
        if (at + width > rows.length) {
            const larger = new Float32Array(2 * rows.length);
            larger.set(rows);
            rows = larger;
        }
        let k = at;
        for (const source of sources) {
            source.read(source.place === 'corner' ? c : points[c], rows, k);
            k += source.arity;
        }
        let vertex = first[points[c]], last = -1;
        while (vertex >= 0) {
            let same = 0;
            while (same < width && Object.is(rows[vertex * width + same], rows[at + same])) ++same;
            if (same === width) break;
            last = vertex;
            vertex = next[vertex];
        }
        if (vertex < 0) {
            vertex = point_of.length;
            point_of.push(points[c]);
            next.push(-1);
            if (last < 0) first[points[c]] = vertex;
            else next[last] = vertex;
        }
        vertex_of[c] = vertex;
    }
    return { vertex_of, point_of: Uint32Array.from(point_of), first };
}

// Points as vertices; of the boundary of tets only those it has.
function share(points, pointCount, all) {
    if (all) {
        const same = new Uint32Array(pointCount).map((_, i) => i);
        return { vertex_of: points, point_of: same, first: same };
    }
    const first = new Int32Array(pointCount).fill(-1), point_of = [];
    const vertex_of = points.map((point) => {
        if (first[point] < 0) first[point] = point_of.push(point) - 1;
        return first[point];
    });
    return { vertex_of, point_of: Uint32Array.from(point_of), first };
}

// Triangles by group, in order within each; a counting sort.
function group(mesh, triangles, tags) {
    const cells = triangles.cells, groups = [];
    if (tags === undefined) return { order: undefined, groups };
    const values = [...new Set(tags.values)].map(Number).sort((a, b) => a - b);
    const slot = new Map(values.map((value, i) => [value, i]));
    const begin = new Uint32Array(values.length + 1);
    const slot_of = new Uint32Array(mesh.cellCount).map((_, c) => slot.get(Number(tags.values[c])));
    for (const cell of cells) ++begin[slot_of[cell] + 1];
    for (let i = 0; i < values.length; ++i) begin[i + 1] += begin[i];
    values.forEach((value, i) => groups.push({
        start: 3 * begin[i], count: 3 * (begin[i + 1] - begin[i]), value,
        name: name_of_tag(mesh, tags.name, value) ?? `${value}`,
    }));
    const order = new Uint32Array(cells.length), at = begin.slice();
    for (let t = 0; t < cells.length; ++t) order[at[slot_of[cells[t]]]++] = t;
    return { order, groups: groups.filter(({ count }) => count > 0) };
}

// Values per vertex in a type that a vertex buffer takes.
function per_vertex(attribute, point_of) {
    const { values, index, arity, type } = attribute;
    const Type = /64$/.test(type) ? Float32Array : values.constructor;
    const array = new Type(arity * point_of.length);
    for (let v = 0; v < point_of.length; ++v) {
        const tuple = index === undefined ? point_of[v] : index[point_of[v]];
        for (let k = 0; k < arity; ++k)
            array[arity * v + k] = tuple === 0xffffffff ? NaN : Number(values[arity * tuple + k]);
    }
    return { array, arity };
}

// `mesh` as `decode` gives it with faces: 'triangles' and, for tets, `tets` or 'both'.
export function geometry_of(mesh, { tets = 'surface', groups: grouped = true } = {}) {
    const { points, triangles, edges } = pieces_of(mesh, tets);
    const roles = ROLES.map((name) => [name, find_role(mesh, name)]).filter(([, source]) => source !== undefined);
    // Corners of tets are in another order than those of triangles; nobody writes normals there.
    const used = mesh.kind === 'tet' ? roles.filter(([, { place }]) => place === 'point') : roles;
    const on_corners = used.some(([, { place }]) => place === 'corner');
    const { vertex_of, point_of, first } = on_corners
        ? split(points, mesh.pointCount, used.map(([, source]) => source))
        : share(points, mesh.pointCount, mesh.kind === 'polygon');

    const position = new Float32Array(3 * point_of.length);
    point_of.forEach((point, v) => {
        for (let k = 0; k < 3; ++k) position[3 * v + k] = mesh.points[3 * point + k];
    });
    const attributes = { position: { array: position, arity: 3 } };
    for (const [name, source] of used) {
        const { arity, scale, place } = source, array = new Float32Array(arity * point_of.length);
        if (place === 'point') point_of.forEach((point, v) => source.read(point, array, arity * v));
        else vertex_of.forEach((vertex, corner) => source.read(corner, array, arity * vertex));
        if (name === 'color')
            for (let i = 0; i < array.length; ++i)
                array[i] = i % arity === 3 ? array[i] * scale : linear_of_srgb(array[i] * scale);
        attributes[name] = { array, arity };
    }
    const taken = new Set(used.flatMap(([, source]) => source.attributes));
    const cellData = {};
    for (const attribute of mesh.attributes) {
        if (attribute.place === 'cell') cellData[attribute.name] = attribute;
        if (attribute.place !== 'point' || taken.has(attribute) || attribute.arity > 4) continue;
        if (!(attribute.name in attributes)) attributes[attribute.name] = per_vertex(attribute, point_of);
    }

    const tags = grouped ? find_tags(mesh) : undefined;
    const { order, groups } = group(mesh, triangles, tags);
    const count = triangles.cells.length, index = new Uint32Array(3 * count);
    const triangleCells = order === undefined ? triangles.cells : order.map((t) => triangles.cells[t]);
    for (let i = 0; i < count; ++i) {
        const t = order === undefined ? i : order[i];
        for (let k = 0; k < 3; ++k) index[3 * i + k] = vertex_of[triangles.corners[3 * t + k]];
    }
    return {
        attributes, index, edges: edges.map((point) => first[point]), groups, groupedBy: tags?.name,
        triangleCells, cellData, kind: mesh.kind, cellCount: mesh.cellCount, pointCount: mesh.pointCount,
        tagNames: mesh.tagNames, notes: mesh.notes, strip: mesh.strip,
    };
}

// Every buffer of a value, each once, to be handed to another thread instead of copied.
export function buffers_of(value, found = new Set()) {
    if (ArrayBuffer.isView(value)) found.add(value.buffer);
    else if (value !== null && typeof value === 'object') Object.values(value).forEach((item) => buffers_of(item, found));
    return [...found];
}
