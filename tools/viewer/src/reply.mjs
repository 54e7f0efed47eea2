// Reads what decoder/describe.cpp wrote: fields one after the other.
const TYPES = {
    uint8: Uint8Array, int8: Int8Array, uint16: Uint16Array, int16: Int16Array,
    uint32: Uint32Array, int32: Int32Array, uint64: BigUint64Array, int64: BigInt64Array,
    float32: Float32Array, float64: Float64Array,
};
// By the number of the codec's enum Scalar.
const SCALARS = ['uint8', 'int8', 'uint16', 'int16', 'uint32', 'int32', 'uint64', 'int64', 'float32', 'float64'];
const text_decoder = new TextDecoder();

export class RavelError extends Error {
    constructor(code, at, detail) {
        super(`${detail} (${code}, byte ${at})`);
        this.name = 'RavelError';
        this.code = code;
        this.at = at;
        this.detail = detail;
    }
}

// `array(reader, size)` gives the bytes of an array as {buffer, at}; the copy is made only where
// an array is wanted.
export class ReplyReader {
    constructor(buffer, at, array) {
        this.view = new DataView(buffer);
        this.at = at;
        this.find = array;
    }
    number() {
        this.at += 8;
        return this.view.getFloat64(this.at - 8, true);
    }
    flag() { return this.number() !== 0; }
    text() {
        const size = this.number();
        const bytes = new Uint8Array(this.view.buffer, this.at, size);
        this.at += size;
        return text_decoder.decode(bytes);
    }
    array(type, wanted = true) {
        const size = this.number();
        const { buffer, at } = this.find(this, size);
        if (!wanted) return undefined;
        return new TYPES[type](buffer.slice(at, at + size));
    }
    list(item) {
        const items = [];
        for (let left = this.number(); left > 0; --left) items.push(item());
        return items;
    }
}

// The first field: the empty text, or what is wrong.
function check(reply) {
    const code = reply.text();
    if (code === '') return;
    const at = reply.number();
    throw new RavelError(code, at, reply.text());
}

export function read_info(reply) {
    check(reply);
    const info = { kind: reply.text(), positionType: reply.text() };
    for (const key of ['version', 'points', 'cells', 'corners', 'companions', 'components', 'links',
        'lossless', 'keepsOrder', 'positionBits', 'gridStep', 'positionBound', 'positionError',
        'fileBytes', 'headerBytes'])
        info[key] = reply.number();
    info.lossless = info.lossless !== 0;
    info.keepsOrder = info.keepsOrder !== 0;
    info.sections = reply.list(() => ({
        name: reply.text(), bytes: reply.number(), rawBytes: reply.number(),
    }));
    info.attributes = reply.list(() => ({
        name: reply.text(), place: reply.text(), type: reply.text(), arity: reply.number(),
    }));
    return info;
}

function read_attribute(reply, wants) {
    const name = reply.text(), place = reply.text();
    const type = SCALARS[reply.number()], arity = reply.number(), wanted = wants(name);
    const attribute = { name, place, type, arity, values: reply.array(type, wanted) };
    const indexed = reply.flag(), index = reply.array('uint32', wanted && indexed);
    if (indexed) attribute.index = index;
    attribute.references = reply.list(() => ({
        component: reply.number(), place: reply.text(), base: reply.number(),
    }));
    return wanted ? attribute : undefined;
}

// `wants` tells which attributes to copy, by name.
export function read_mesh(reply, wants) {
    check(reply);
    const mesh = { kind: reply.text(), cellCount: reply.number() };
    const type = SCALARS[reply.number()];
    reply.number();
    mesh.points = reply.array(type);
    mesh.pointCount = mesh.points.length / 3;
    const corners = reply.array('uint32'), begin = reply.array('uint32');
    if (mesh.kind === 'tet') mesh.tets = corners;
    else mesh.polygons = { begin: begin.length > 0 ? begin : new Uint32Array(1), points: corners };
    mesh.companions = reply.list(() => {
        const block = { vtkType: reply.number(), nodesPerCell: reply.number(), count: reply.number(),
            nodes: reply.array('uint32') };
        const hosts = reply.array('uint32');
        if (hosts.length > 0) block.hosts = hosts;
        return block;
    });
    mesh.attributes = reply.list(() => read_attribute(reply, wants)).filter((a) => a !== undefined);
    mesh.tagNames = reply.list(() => ({
        attribute: reply.text(), dimension: reply.number(), value: reply.number(), name: reply.text(),
    }));
    mesh.notes = reply.list(() => ({ key: reply.text(), text: reply.text() }));
    if (reply.flag()) {
        mesh.strip = {};
        for (const key of ['cell', 'from', 'exit', 'entry', 'link'])
            mesh.strip[key] = reply.array('uint32');
        mesh.strip.link = Uint8Array.from(mesh.strip.link);
    }
    if (reply.flag())
        mesh.surface = { points: reply.array('uint32'), facets: reply.array('uint32') };
    return mesh;
}
