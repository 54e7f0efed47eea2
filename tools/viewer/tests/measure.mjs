// Size of the module and speed beside the native decoder.
//     measure.mjs PACKAGE RAVEL DUMP FOLDER
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import zlib from 'node:zlib';

const [, , dist, ravel, dump, folder] = process.argv;
const module_path = path.join(dist, 'ravel-decoder.mjs');
// Remembers how large the module's memory grew.
let memory;
const Instance = WebAssembly.Instance;
WebAssembly.Instance = function (...words) {
    const instance = new Instance(...words);
    memory = instance.exports.memory;
    return instance;
};
const decoder = await import(pathToFileURL(module_path));
const ALL = { strip: true, tets: 'both' };

function output_bytes(value) {
    if (ArrayBuffer.isView(value)) return value.byteLength;
    if (value === null || typeof value !== 'object') return 0;
    return Object.values(value).reduce((sum, item) => sum + output_bytes(item), 0);
}

const ratios = [];
for (const recipe of ['terrain:size=400x400', 'tets:box=28x28x28,jitter=0.2']) {
    const name = path.join(folder, recipe.split(':')[0]);
    execFileSync(ravel, ['-q', 'make', recipe, '-o', `${name}.vtk`, '--force']);
    execFileSync(ravel, ['-q', 'encode', `${name}.vtk`, '-o', `${name}.ravel`, '--force', '--position-bits', '14']);
    const bytes = fs.readFileSync(`${name}.ravel`);
    // Time of the processor, by turns, for other programs share the machine.
    let native = Infinity, web = Infinity, mesh;
    for (let turn = 0; turn < 3; ++turn) {
        native = Math.min(native, Number(execFileSync(dump, ['--time', `${name}.ravel`, `${name}.reply`])));
        const end = performance.now() + 2000;
        do {
            const start = process.cpuUsage();
            mesh = await decoder.decode(bytes, ALL);
            const { user, system } = process.cpuUsage(start);
            web = Math.min(web, (user + system) / 1e3);
        } while (performance.now() < end);
    }
    ratios.push(native / web);
    console.log(`${recipe}: ${mesh.cellCount} ${mesh.kind}s, native ${native.toFixed(0)} ms, web ${web.toFixed(0)} ms, ` +
        `speed ratio ${(native / web).toFixed(2)}, output ${(output_bytes(mesh) / 1e6).toFixed(1)} MB, ` +
        `module's memory ${(memory.buffer.byteLength / 1e6).toFixed(1)} MB`);
}
const gzipped = zlib.gzipSync(fs.readFileSync(module_path), { level: 9 }).length;
console.log(`module size: ${fs.statSync(module_path).size} bytes, ${gzipped} gzipped (wasm and glue)`);
console.log(`decode ratio: ${ratios.map((ratio) => ratio.toFixed(2)).join(' ')} x native speed (quads, tets)`);
// A module that outgrew its promise fails; speed depends on the machine and is only told.
process.exitCode = gzipped <= 65_500 ? 0 : 1;
