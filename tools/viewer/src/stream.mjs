// A file that arrives in pieces, a mesh that leaves in pieces.
import { decode, info } from './ravel-decoder.mjs';

async function* pieces_of(source) {
    const body = source.body ?? source;
    if (typeof body.getReader !== 'function') {
        yield* body;
        return;
    }
    const reader = body.getReader();
    try {
        for (;;) {
            const { done, value } = await reader.read();
            if (done) return;
            yield value;
        }
    } finally {
        reader.releaseLock();
    }
}

// Yields {type: 'loaded', bytes}, {type: 'info', info}, {type: 'mesh', mesh}, then ranges of the
// strip {type: 'range', first, count, points}: the next cells are strip.cell[first .. first + count);
// they and all before need no point at or above `points`. A page may draw between any two parts.
export async function* decode_stream(source, options = {}) {
    const pieces = [];
    let size = 0;
    for await (const piece of pieces_of(source)) {
        pieces.push(piece);
        size += piece.length;
        yield { type: 'loaded', bytes: size };
    }
    const bytes = new Uint8Array(size);
    size = 0;
    for (const piece of pieces) {
        bytes.set(piece, size);
        size += piece.length;
    }
    pieces.length = 0;
    yield { type: 'info', info: await info(bytes) };
    const mesh = await decode(bytes, { ...options, strip: true });
    yield { type: 'mesh', mesh };
    const { begin, points: corners } = mesh.polygons ?? { points: mesh.tets };
    const step = options.rangeCells ?? 4096;
    let points = 0;
    for (let first = 0; first < mesh.strip.cell.length; first += step) {
        const count = Math.min(step, mesh.strip.cell.length - first);
        for (let i = first; corners !== undefined && i < first + count; ++i) {
            const cell = mesh.strip.cell[i];
            const end = begin ? begin[cell + 1] : 4 * cell + 4;
            for (let c = begin ? begin[cell] : 4 * cell; c < end; ++c)
                if (corners[c] >= points) points = corners[c] + 1;
        }
        yield { type: 'range', first, count, points };
    }
}
