// Decodes .ravel files in pages, workers and Node. The module is part of this file: nothing is
// fetched, nothing is evaluated.
import { packed, size, unpacker } from '../.build/wasm.mjs';
import { RavelError, ReplyReader, read_info, read_mesh } from './reply.mjs';
import { turn_outwards } from './surface.mjs';
import { triangulate } from './triangulate.mjs';

export { RavelError } from './reply.mjs';
export { edges_of as edgesOf } from './edges.mjs';
export { decode_stream as decodeStream } from './stream.mjs';

// What is kept of an instance between calls; its memory only grows.
const KEPT_BYTES = 16 << 20;
const DEFAULT_LIMIT = 2 ** 31;

let module, compiling, spare;

function bytes_of_text(text) {
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

// The module comes packed; a small one unpacks it (decoder/unpack_module.cpp).
async function compile() {
    const { instance } = await WebAssembly.instantiate(bytes_of_text(unpacker));
    const { memory, unpack } = instance.exports, bytes = bytes_of_text(packed);
    const from = memory.buffer.byteLength, to = from + bytes.length;
    memory.grow(Math.ceil((to + size - from) / 65536));
    new Uint8Array(memory.buffer).set(bytes, from);
    unpack(from, to, size);
    module = await WebAssembly.compile(new Uint8Array(memory.buffer, to, size));
}

// Resolves once decodeSync and infoSync may be called.
export function ready() {
    compiling ??= compile();
    return compiling;
}

function instance() {
    if (module === undefined) throw new Error('await ready() before decodeSync or infoSync');
    if (spare !== undefined) {
        const taken = spare;
        spare = undefined;
        return taken;
    }
    const out_of_memory = () => {
        throw new RavelError('limit_exceeded', 0, 'the page has not as much memory as the mesh needs');
    };
    const { exports } = new WebAssembly.Instance(module, { ravel: { out_of_memory } });
    exports._initialize();
    return exports;
}

function bytes_of(data) {
    if (data instanceof Uint8Array) return data;
    if (ArrayBuffer.isView(data)) return new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    if (data instanceof ArrayBuffer || Object.prototype.toString.call(data) === '[object SharedArrayBuffer]')
        return new Uint8Array(data);
    throw new TypeError('a .ravel file is an ArrayBuffer or a typed array');
}

// Runs `work` on an instance that has `data` as input, then reads its answer. An instance that
// threw is never used again.
function answer(data, work, read) {
    const bytes = bytes_of(data), decoder = instance();
    const at = decoder.input(bytes.length) >>> 0;
    new Uint8Array(decoder.memory.buffer, at, bytes.length).set(bytes);
    try {
        work(decoder);
    } catch (caught) {
        if (!(caught instanceof WebAssembly.RuntimeError)) throw caught;
        throw new RavelError('bug', 0, `the decoder stopped, please report it: ${caught.message}`);
    }
    const memory = decoder.memory.buffer;
    const find = (reader) => ({ buffer: memory, at: reader.number() });
    let result, error;
    try {
        result = read(new ReplyReader(memory, decoder.reply() >>> 0, find));
    } catch (caught) {
        if (!(caught instanceof RavelError)) throw caught;
        error = caught;
    }
    decoder.input(0);
    if (memory.byteLength <= KEPT_BYTES) spare = decoder;
    if (error !== undefined) throw error;
    return result;
}

function wanted_attributes(attributes) {
    if (attributes === undefined || attributes === true) return () => true;
    if (attributes === false) return () => false;
    const names = new Set(attributes);
    return (name) => names.has(name);
}

export function decodeSync(data, options = {}) {
    const { faces = 'polygons', tets = 'cells', attributes, strip = false } = options;
    if (faces !== 'polygons' && faces !== 'triangles')
        throw new TypeError(`faces: 'polygons' or 'triangles', not '${faces}'`);
    if (tets !== 'cells' && tets !== 'surface' && tets !== 'both')
        throw new TypeError(`tets: 'cells', 'surface' or 'both', not '${tets}'`);
    const limit = options.memoryLimit ?? DEFAULT_LIMIT;
    if (!(limit >= 0 && limit <= Number.MAX_SAFE_INTEGER)) throw new TypeError('memoryLimit: a number of bytes');
    const mesh = answer(data, (decoder) => decoder.decode(limit, strip, tets !== 'cells'),
        (reply) => read_mesh(reply, wanted_attributes(attributes)));
    if (mesh.surface !== undefined) {
        turn_outwards(mesh);
        if (tets === 'surface') delete mesh.tets;
    }
    if (mesh.kind === 'polygon' && faces === 'triangles')
        mesh.triangles = triangulate(mesh.points, mesh.polygons);
    return mesh;
}

export function infoSync(data) {
    return answer(data, (decoder) => decoder.info(), read_info);
}

export async function decode(data, options) {
    await ready();
    return decodeSync(data, options);
}

export async function info(data) {
    await ready();
    return infoSync(data);
}
