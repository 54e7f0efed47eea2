// The viewer's worker: decodes a file and lays it out for drawing.
import { decode, info as info_of } from '../ravel-decoder.mjs';
import { buffers_of } from '../geometry.mjs';
import { RavelError } from '../reply.mjs';
import { frame_of } from './frame.mjs';
import { draw_polygons } from './polygons.mjs';
import { draw_tets } from './tets.mjs';

async function open(bytes, tell) {
    const start = performance.now();
    const info = await info_of(bytes);
    tell({ stage: 'decode', info });
    const mesh = await decode(bytes, { faces: 'triangles', strip: true, memoryLimit: 3.5e9 });
    const decoded = performance.now();
    tell({ stage: 'draw' });
    const frame = frame_of(mesh.points);
    const draw = mesh.kind === 'polygon' ? draw_polygons(mesh, frame) : draw_tets(mesh, frame);
    const { strip } = mesh;
    // The strip in steps, not cells: where each step came from.
    const from = strip.from.map((cell) => (cell === 0xffffffff ? cell : draw.stepOf[cell]));
    let links = 0;
    for (const link of strip.link) links += link;
    const linkSteps = new Uint32Array(links);
    for (let k = 0, i = 0; k < strip.link.length; ++k) if (strip.link[k]) linkSteps[i++] = k;
    const { kind, cellCount, pointCount, attributes, tagNames, companions } = mesh;
    return {
        info, frame, draw, strip: { cell: strip.cell, from, linkSteps }, kind, cellCount, pointCount, attributes, tagNames,
        companions: companions.map(({ vtkType, count }) => ({ vtkType, count })),
        seconds: { decode: (decoded - start) / 1e3, draw: (performance.now() - decoded) / 1e3 },
    };
}

globalThis.onmessage = async ({ data: { id, bytes } }) => {
    const tell = (message) => globalThis.postMessage({ id, ...message });
    try {
        const model = await open(bytes, tell);
        globalThis.postMessage({ id, model }, buffers_of(model));
    } catch (error) {
        const { code, at, detail } = error instanceof RavelError ? error
            : { code: error instanceof RangeError ? 'limit_exceeded' : 'bug', at: 0, detail: error.message };
        tell({ error: { code, at, detail } });
    }
};
