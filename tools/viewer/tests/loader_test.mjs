// RavelLoader gives three.js what the decoder gives, in the page and from workers.
//     loader_test.mjs PACKAGE RAVEL FOLDER
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

const [, , dist, ravel, folder] = process.argv;
const from_dist = (name) => import(pathToFileURL(path.join(dist, name)));
const { RavelLoader, RavelError } = await from_dist('RavelLoader.mjs');
const { decode } = await from_dist('ravel-decoder.mjs');

function make(recipe, ending = 'ply') {
    const mesh = path.join(folder, `loader.${ending}`);
    execFileSync(ravel, ['-q', 'make', recipe, '-o', mesh, '--force']);
    return pack(mesh);
}
function pack(mesh, ...options) {
    execFileSync(ravel, ['-q', 'encode', mesh, '-o', `${mesh}.ravel`, '--force', ...options]);
    return new Uint8Array(fs.readFileSync(`${mesh}.ravel`));
}
function pack_text(name, text, ...options) {
    const mesh = path.join(folder, name);
    fs.writeFileSync(mesh, text);
    return pack(mesh, ...options);
}
const position = (geometry, v) => [...geometry.getAttribute('position').array.slice(3 * v, 3 * v + 3)];
const sorted_edges = (pairs) => pairs.map((pair) => pair.toSorted((a, b) => a - b).join()).sort();

test('quads become two triangles each; their edges are those of the quads', async () => {
    const bytes = make('torus:quads=3000');
    const geometry = await new RavelLoader().parseAsync(bytes), mesh = await decode(bytes);
    assert(bytes.length > 0);
    assert.equal(geometry.index.count, 3 * 2 * mesh.cellCount);
    assert.equal(geometry.getAttribute('position').count, mesh.pointCount);
    assert.deepEqual([...geometry.getAttribute('position').array], [...mesh.points].map(Math.fround));
    const { begin, points } = mesh.polygons, edges = new Set();
    for (let c = 0; c < mesh.cellCount; ++c)
        for (let i = begin[c]; i < begin[c + 1]; ++i)
            edges.add([points[i], points[i + 1 < begin[c + 1] ? i + 1 : begin[c]]].sort((a, b) => a - b).join());
    const drawn = geometry.edges.index.array;
    assert.deepEqual(sorted_edges(Array.from({ length: drawn.length / 2 }, (_, e) => [drawn[2 * e], drawn[2 * e + 1]])), [...edges].sort());
    assert.equal(geometry.edges.getAttribute('position'), geometry.getAttribute('position'));
});

const BOX = `mtllib box.mtl
v 0 0 0 1 0 0
v 1 0 0 1 0 0
v 1 1 0 0 1 0
v 0 1 0 0 1 0
v 0 0 1 0 0 1
v 1 0 1 0 0 1
v 1 1 1 0.5 0.5 0.5
v 0 1 1 0.5 0.5 0.5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 -1
vn 0 0 1
vn 0 -1 0
usemtl wood
f 4/4/1 3/3/1 2/2/1 1/1/1
usemtl glass
f 5/1/2 6/2/2 7/3/2 8/4/2
usemtl wood
f 1/1/3 2/2/3 6/3/3 5/4/3
`;

test('normals, texture coordinates, colours and materials of an OBJ file', async () => {
    const bytes = pack_text('box.obj', BOX), mesh = await decode(bytes);
    const geometry = await new RavelLoader().parseAsync(bytes);
    // Eight points; the two edges between faces split into two vertices per point.
    assert.equal(geometry.getAttribute('position').count, 12);
    const { begin, points } = mesh.polygons, corner = (name) => mesh.attributes.find((a) => a.name === name);
    const seen = new Set();
    geometry.ravel.triangleCells.forEach((cell, t) => {
        for (let k = 0; k < 3; ++k) {
            const v = geometry.index.array[3 * t + k], at = position(geometry, v).join();
            const c = [...points.slice(begin[cell], begin[cell + 1])].map((_, i) => begin[cell] + i)
                .find((i) => [...mesh.points.slice(3 * points[i], 3 * points[i] + 3)].join() === at);
            for (const [attribute, name, arity] of [['uv', 'obj:vt', 2], ['normal', 'obj:vn', 3]]) {
                const pool = corner(name), tuple = pool.index[c];
                assert.deepEqual([...geometry.getAttribute(attribute).array.slice(arity * v, arity * v + arity)],
                    [...pool.values.slice(arity * tuple, arity * tuple + arity)]);
            }
            seen.add(v);
        }
    });
    assert.equal(seen.size, 12);
    const color = geometry.getAttribute('color');
    assert.equal(color.itemSize, 3);
    const grey = [...seen].find((v) => position(geometry, v).join() === '1,1,1');
    assert(Math.abs(color.array[3 * grey] - 0.21404) < 1e-4, 'colours are linear');
    assert.equal(geometry.ravel.groupedBy, 'obj:material');
    assert.deepEqual(geometry.ravel.groups.map(({ name, count }) => [name, count]).sort(), [['glass', 6], ['wood', 12]]);
    assert.deepEqual(geometry.groups.map(({ start, count, materialIndex }) => [start, count, materialIndex]),
        geometry.ravel.groups.map(({ start, count }, i) => [start, count, i]));
    const tags = geometry.ravel.cellData['obj:material'].values;
    for (const { start, count, value } of geometry.ravel.groups)
        for (let t = start / 3; t < (start + count) / 3; ++t) assert.equal(Number(tags[geometry.ravel.triangleCells[t]]), value);
    // Every edge joins vertices, and none is drawn twice although vertices were split.
    const drawn = geometry.edges.index.array;
    const places = Array.from({ length: drawn.length / 2 }, (_, e) => [drawn[2 * e], drawn[2 * e + 1]]
        .map((v) => position(geometry, v).join()).sort().join(' '));
    assert.equal(new Set(places).size, 10);
    assert.equal(places.length, 10);
});

test('PLY\'s own names: bytes of colours, other attributes of points under their names', async () => {
    const text = `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z
property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float heat
element face 1\nproperty list uchar int vertex_indices\nend_header
0 0 0 255 0 0 1.5\n1 0 0 0 255 0 2.5\n0 1 0 0 0 255 3.5\n3 0 1 2\n`;
    const geometry = await new RavelLoader().parseAsync(pack_text('three.ply', text, '--keep-order'));
    assert.deepEqual([...geometry.getAttribute('color').array], [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    assert.deepEqual([...geometry.getAttribute('heat').array], [1.5, 2.5, 3.5]);
    assert.equal(geometry.groups.length, 0);
});

test('tets are their boundary, closed and seen from outside; or all facets', async () => {
    const bytes = make('tets:box=5x4x3', 'vtk');
    const loader = new RavelLoader(), geometry = await loader.parseAsync(bytes);
    const triangles = 2 * 2 * (5 * 4 + 4 * 3 + 5 * 3);
    assert.equal(geometry.index.count, 3 * triangles);
    assert.equal(geometry.getAttribute('position').count, triangles / 2 + 2, 'only points of the boundary');
    assert.equal(geometry.edges.index.count, 2 * (3 * triangles) / 2);
    let volume = 0;
    for (let t = 0; t < triangles; ++t) {
        const [a, b, c] = [0, 1, 2].map((k) => position(geometry, geometry.index.array[3 * t + k]));
        volume += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox;
    assert(Math.abs(volume / 6 - (max.x - min.x) * (max.y - min.y) * (max.z - min.z)) < 1e-3);
    const all = await loader.setDecodeOptions({ tets: 'cells' }).parseAsync(bytes);
    assert.equal(all.index.count, 12 * 5 * 4 * 3 * 6);
});

test('callbacks, a broken file, dispose', async () => {
    const loader = new RavelLoader().preload();
    const geometry = await new Promise((done, fail) => loader.parse(make('moebius:size=40x4'), done, fail));
    assert.equal(geometry.ravel.cellCount, 160);
    const error = await new Promise((done) => loader.parse(new Uint8Array(50), () => done(), done));
    assert(error instanceof RavelError);
    assert.equal(error.code, 'not_a_ravel_file');
    await assert.rejects(loader.setDecodeOptions({ memoryLimit: 10 }).parseAsync(make('moebius:size=40x4')), { code: 'limit_exceeded' });
    assert.equal(loader.dispose(), loader);
});
