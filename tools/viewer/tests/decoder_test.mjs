// The decoder for the web answers as the native one, on good files and broken ones.
//     decoder_test.mjs PACKAGE RAVEL DUMP FOLDER ROOT [CORPUS]
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';

import { read_mesh, ReplyReader, RavelError } from '../src/reply.mjs';
import { turn_outwards } from '../src/surface.mjs';
import { damaged } from './damage.mjs';
import { find_findings, find_vectors, make_files } from './files.mjs';

const [, , dist, ravel, dump, folder, root, corpus] = process.argv;
const module_path = path.join(dist, 'ravel-decoder.mjs');
const decoder = await import(pathToFileURL(module_path));
const ALL = { strip: true, tets: 'both', memoryLimit: 2 ** 34 };
const made = make_files(ravel, folder, corpus);
const vectors = find_vectors(root);

function native_replies(files) {
    const words = files.flatMap((file, i) => [file, path.join(folder, `${i}.reply`)]);
    execFileSync(dump, words);
    return files.map((_, i) => fs.readFileSync(path.join(folder, `${i}.reply`)));
}

// The native answer as the package would give it: a mesh, or an error.
function read_reply(bytes) {
    const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
    const inline = (reader, size) => {
        reader.at += size;
        return { buffer, at: reader.at - size };
    };
    try {
        const mesh = read_mesh(new ReplyReader(buffer, 0, inline), () => true);
        if (mesh.surface) turn_outwards(mesh);
        return { mesh };
    } catch (error) {
        if (!(error instanceof RavelError)) throw error;
        return { error: { code: error.code, at: error.at, detail: error.detail } };
    }
}

// NaN bits included: arrays are compared as bytes.
function bits_of(value) {
    if (ArrayBuffer.isView(value))
        return { type: value.constructor.name,
            bits: Buffer.from(value.buffer, value.byteOffset, value.byteLength).toString('latin1') };
    if (Array.isArray(value)) return value.map(bits_of);
    if (value !== null && typeof value === 'object')
        return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, bits_of(item)]));
    return value;
}

async function answer_of(bytes) {
    try {
        return { mesh: await decoder.decode(bytes, ALL) };
    } catch (error) {
        assert(error instanceof decoder.RavelError, `not a RavelError: ${error.stack}`);
        return { error: { code: error.code, at: error.at, detail: error.detail } };
    }
}

test('every generated mesh and every vector decodes as the native decoder does', async () => {
    const files = [...made, ...vectors];
    assert(files.length > 100);
    const replies = native_replies(files);
    for (const [i, file] of files.entries()) {
        const expected = read_reply(replies[i]), answer = await answer_of(fs.readFileSync(file));
        assert.deepEqual(bits_of(answer), bits_of(expected), file);
        if (made.includes(file)) assert(expected.mesh, file);
    }
});

test('info says what `ravel info` says', async () => {
    for (const file of made) {
        const info = await decoder.info(fs.readFileSync(file));
        const facts = JSON.parse(execFileSync(ravel, ['info', '--json', file]));
        const pairs = [['kind', 'cell_kind'], ['cells', 'cells'], ['points', 'vertices'], ['links', 'links'],
            ['fileBytes', 'bytes'], ['positionBits', 'position_bits'], ['corners', 'corners']];
        for (const [ours, theirs] of pairs) assert.equal(info[ours], facts[theirs], `${file}: ${ours}`);
        const sections = facts.sections.filter((section) => section.section !== 'header');
        assert.deepEqual(info.sections.map((s) => [s.name, s.bytes]), sections.map((s) => [s.section, s.bytes]));
    }
});

test('the points of a mesh are those `ravel decode` writes', async () => {
    const file = made.find((name) => name.includes('torus-quads-3000'));
    const mesh = await decoder.decode(fs.readFileSync(file));
    const obj = execFileSync(ravel, ['-q', 'decode', file, '-o', '-', '--to', 'obj']).toString().split('\n');
    const points = obj.filter((line) => line.startsWith('v ')).map((line) => line.split(/ +/).slice(1, 4).map(Number));
    const faces = obj.filter((line) => line.startsWith('f '))
        .map((line) => line.trim().split(/ +/).slice(1).map((corner) => Number(corner.split('/')[0]) - 1));
    assert.deepEqual([...mesh.points], points.flat().map(Math.fround));
    const { begin, points: corners } = mesh.polygons;
    assert.deepEqual(faces, [...begin.slice(1)].map((end, c) => [...corners.slice(begin[c], end)]));
});

test('broken files give the error of the native decoder: code, place and words', async () => {
    const bases = made.filter((_, i) => i % 7 === 0).map((file) => new Uint8Array(fs.readFileSync(file)));
    const broken = bases.flatMap((base, i) => damaged(base, 60, i + 1)).concat(find_findings(root).map((f) => fs.readFileSync(f)));
    const files = broken.map((bytes, i) => {
        const file = path.join(folder, `broken${i}.ravel`);
        fs.writeFileSync(file, bytes);
        return file;
    });
    // Two builds of zstd need not agree about a forged frame (its Huffman loops check the ends of
    // their streams differently); all other verdicts are ours.
    let refused = 0, forged = 0;
    const by_zstd = ({ error }) => error?.detail.startsWith('a packed section is broken');
    const seen = new Set();
    for (const [i, reply] of native_replies(files).entries()) {
        const expected = read_reply(reply), answer = await answer_of(broken[i]);
        if (by_zstd(answer) !== by_zstd(expected)) {
            ++forged;
            continue;
        }
        if (by_zstd(answer)) answer.error.detail = expected.error.detail;
        assert.deepEqual(bits_of(answer), bits_of(expected), files[i]);
        if (!answer.error) continue;
        ++refused;
        seen.add(answer.error.code);
        if (i % 8 > 0 || answer.error.code === 'limit_exceeded') continue;
        const told = spawnSync(ravel, ['decode', files[i], '-o', path.join(folder, 'x.ply')]).stderr.toString();
        assert(told.includes(`(${answer.error.code}, byte ${answer.error.at})`), `${files[i]}: ${told}`);
    }
    assert(refused > 200, `only ${refused} were refused`);
    assert(forged < broken.length / 30, `zstd disagrees with itself on ${forged} of ${broken.length}`);
    for (const code of ['not_a_ravel_file', 'truncated', 'checksum_mismatch', 'corrupt']) assert(seen.has(code), code);
});

test('a file that needs more memory than the limit is refused, and the next one decodes', async () => {
    const file = fs.readFileSync(made.find((name) => name.includes('tets-box-8x7x6')));
    await assert.rejects(decoder.decode(file, { memoryLimit: 1000 }), { code: 'limit_exceeded' });
    assert.equal((await decoder.decode(file)).cellCount, 8 * 7 * 6 * 6);
    await assert.rejects(decoder.decode('text'), TypeError);
    await assert.rejects(decoder.decode(file, { faces: 'hexagons' }), TypeError);
});

test('triangles cover each polygon once, also the concave ones', async () => {
    const mesh = await decoder.decode(fs.readFileSync(made.find((n) => n.includes('polygons-mixed'))), { faces: 'triangles' });
    const { begin, points } = mesh.polygons;
    const left = new Int32Array(mesh.cellCount);
    for (let c = 0; c < mesh.cellCount; ++c) left[c] = begin[c + 1] - begin[c] - 2;
    mesh.triangles.cells.forEach((cell, t) => {
        --left[cell];
        for (let k = 0; k < 3; ++k) {
            const corner = mesh.triangles.corners[3 * t + k];
            assert(corner >= begin[cell] && corner < begin[cell + 1]);
            assert.equal(mesh.triangles.points[3 * t + k], points[corner]);
        }
    });
    assert(left.every((count) => count === 0));
    // An L of six corners, which no fan from its first corner covers.
    const { triangulate } = await import('../src/triangulate.mjs');
    const L = new Float64Array([2, 1, 0, 1, 1, 0, 1, 2, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0]);
    const cut = triangulate(L, { begin: [0, 6], points: [0, 1, 2, 3, 4, 5] });
    let area = 0;
    for (let t = 0; t < 4; ++t) {
        const [a, b, c] = cut.points.slice(3 * t, 3 * t + 3).map((p) => 3 * p);
        const twice = (L[b] - L[a]) * (L[c + 1] - L[a + 1]) - (L[c] - L[a]) * (L[b + 1] - L[a + 1]);
        assert(twice > 0);
        area += twice / 2;
    }
    assert.equal(area, 3);
});

test('the boundary of a box of tets is closed, looks outwards and has its area', async () => {
    const file = made.find((name) => name.includes('tets-box-8x7x6'));
    const mesh = await decoder.decode(fs.readFileSync(file), { tets: 'both' });
    assert.equal(mesh.surface.facets.length, 2 * 2 * (8 * 7 + 7 * 6 + 8 * 6));
    let volume = 0;
    const half_edges = new Set();
    for (let t = 0; t < mesh.surface.points.length; t += 3) {
        const [a, b, c] = mesh.surface.points.slice(t, t + 3);
        const p = [a, b, c].map((i) => mesh.points.slice(3 * i, 3 * i + 3));
        volume += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) - p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
            p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
        for (const edge of [[a, b], [b, c], [c, a]]) half_edges.add(edge.join());
    }
    assert(volume > 0);
    for (const edge of half_edges) assert(half_edges.has(edge.split(',').reverse().join()));
});

test('attributes may be left out or chosen', async () => {
    const file = fs.readFileSync(made.find((name) => name.includes('torus-quads-3000')));
    const all = await decoder.decode(file);
    assert(all.attributes.length > 1);
    assert.equal((await decoder.decode(file, { attributes: false })).attributes.length, 0);
    const one = await decoder.decode(file, { attributes: [all.attributes[1].name] });
    assert.deepEqual(one.attributes, [all.attributes[1]]);
});

test('a stream gives the mesh and then the strip in ranges', async () => {
    const file = fs.readFileSync(made.find((name) => name.includes('torus-quads-3000')));
    const source = new Blob([file]).stream();
    let next = 0, mesh, points = 0;
    const types = new Set();
    for await (const part of decoder.decodeStream(source, { rangeCells: 500 })) {
        types.add(part.type);
        if (part.type === 'mesh') mesh = part.mesh;
        if (part.type !== 'range') continue;
        assert.equal(part.first, next);
        next += part.count;
        assert(part.points >= points);
        points = part.points;
    }
    assert.equal(next, mesh.cellCount);
    assert.equal(points, mesh.pointCount);
    assert.deepEqual([...types], ['loaded', 'info', 'mesh', 'range']);
});

test('it works in a worker', async () => {
    const source = `
        import { parentPort, workerData } from 'node:worker_threads';
        import { decode } from ${JSON.stringify(pathToFileURL(module_path).href)};
        const mesh = await decode(workerData);
        parentPort.postMessage(mesh.cellCount);`;
    const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(source)}`),
        { workerData: fs.readFileSync(made.find((name) => name.includes('moebius'))) });
    assert.equal(await new Promise((done, fail) => worker.once('message', done).once('error', fail)), 160);
});
