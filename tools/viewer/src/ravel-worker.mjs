// Decodes for RavelLoader: in a worker by messages, elsewhere by a call.
import { decode } from './ravel-decoder.mjs';
import { buffers_of, geometry_of } from './geometry.mjs';
import { RavelError } from './reply.mjs';

// {geometry} or {error}.
export async function answer(bytes, options = {}) {
    try {
        const { tets = 'surface', attributes, strip, memoryLimit } = options;
        const mesh = await decode(bytes, { faces: 'triangles', tets, attributes, strip, memoryLimit });
        return { geometry: geometry_of(mesh, options) };
    } catch (error) {
        if (!(error instanceof RavelError)) return { error: { code: 'bug', at: 0, detail: `${error}` } };
        return { error: { code: error.code, at: error.at, detail: error.detail } };
    }
}

if (typeof WorkerGlobalScope === 'function' && globalThis instanceof WorkerGlobalScope) {
    globalThis.onmessage = async ({ data: { id, bytes, options } }) => {
        const message = { id, ...(await answer(bytes, options)) };
        globalThis.postMessage(message, buffers_of(message.geometry ?? {}));
    };
}
