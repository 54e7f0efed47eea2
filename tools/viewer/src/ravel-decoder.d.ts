/** Decodes .ravel files in pages, workers and Node. */

export type Bytes = ArrayBufferLike | ArrayBufferView;
export type Scalar =
    'uint8' | 'int8' | 'uint16' | 'int16' | 'uint32' | 'int32' | 'uint64' | 'int64' | 'float32' | 'float64';
export type Place = 'point' | 'corner' | 'cell' | 'companion' | 'mesh';
export type Numbers =
    | Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Int32Array
    | BigUint64Array | BigInt64Array | Float32Array | Float64Array;

/** An element without a tuple (Attribute.index), a step without a cell it came from (Strip.from). */
export type NoIndex = 0xffffffff;

export interface DecodeOptions {
    /** 'triangles' adds `triangles` to a polygon mesh. Default: 'polygons'. */
    faces?: 'polygons' | 'triangles';
    /** 'surface' gives the boundary of tets instead of the tets, 'both' gives both. Default: 'cells'. */
    tets?: 'cells' | 'surface' | 'both';
    /** All, none, or those with these names. Default: true. */
    attributes?: boolean | string[];
    /** How the strip runs over the cells. Default: false. */
    strip?: boolean;
    /** Bytes the decoder may take. Default: 2 GiB; a page never has more than 4 GiB. */
    memoryLimit?: number;
}

export interface Polygons {
    /** cellCount + 1 offsets into `points`. */
    begin: Uint32Array;
    /** Points of the corners, counter-clockwise. */
    points: Uint32Array;
}

export interface Triangles {
    /** Three points per triangle. */
    points: Uint32Array;
    /** Where each of them stands in Polygons.points: the number of a corner, for attributes of corners. */
    corners: Uint32Array;
    /** The polygon each triangle is a part of. */
    cells: Uint32Array;
}

export interface Surface {
    /** Three points per triangle, counter-clockwise seen from outside. */
    points: Uint32Array;
    /** 4 * tet + the corner that the triangle lies opposite to. */
    facets: Uint32Array;
}

/** One entry per cell, in the order of the strip's first visits. Facet f of a polygon is its side
 *  from corner f to f + 1; facet f of a tet lies opposite corner f. */
export interface Strip {
    cell: Uint32Array;
    /** The cell the strip came from; 0xffffffff where a component starts. */
    from: Uint32Array;
    /** Facet of `from`. */
    exit: Uint32Array;
    /** Facet of `cell`. */
    entry: Uint32Array;
    /** 1 where the step splits both cells once the strip is materialised. */
    link: Uint8Array;
}

export interface Attribute {
    name: string;
    place: Place;
    type: Scalar;
    /** Numbers per tuple. */
    arity: number;
    values: Numbers;
    /** Element i has tuple index[i]; 0xffffffff: none. Without it there is one tuple per element. */
    index?: Uint32Array;
    /** Components that are numbers of points or cells, counted from `base`. */
    references: { component: number; place: 'point' | 'cell'; base: number }[];
}

/** Cells that ride along: boundary triangles, lines, edge nodes of quadratic tets (vtkType 24, hosts). */
export interface Companions {
    vtkType: number;
    nodesPerCell: number;
    count: number;
    nodes: Uint32Array;
    hosts?: Uint32Array;
}

export interface Mesh {
    kind: 'polygon' | 'tet';
    pointCount: number;
    cellCount: number;
    /** x, y, z of each point. */
    points: Float32Array | Float64Array;
    polygons?: Polygons;
    triangles?: Triangles;
    /** Four points per tet, in VTK's order. */
    tets?: Uint32Array;
    surface?: Surface;
    companions: Companions[];
    attributes: Attribute[];
    tagNames: { attribute: string; dimension: number; value: number; name: string }[];
    notes: { key: string; text: string }[];
    strip?: Strip;
}

export interface Info {
    kind: 'polygon' | 'tet';
    positionType: 'float32' | 'float64';
    version: number;
    points: number;
    cells: number;
    corners: number;
    companions: number;
    components: number;
    links: number;
    lossless: boolean;
    keepsOrder: boolean;
    /** Along the longest side; 0 for exact positions. */
    positionBits: number;
    gridStep: number;
    positionBound: number;
    positionError: number;
    fileBytes: number;
    headerBytes: number;
    sections: { name: string; bytes: number; rawBytes: number }[];
    attributes: { name: string; place: Place; type: Scalar; arity: number }[];
}

export type Code =
    | 'not_a_ravel_file' | 'unsupported_version' | 'truncated' | 'checksum_mismatch' | 'corrupt'
    | 'limit_exceeded' | 'bug';

/** What is wrong with a file: the same code and place as the command line tool's. */
export class RavelError extends Error {
    code: Code;
    /** Byte of the file. */
    at: number;
    /** One sentence. */
    detail: string;
}

/** Unpacks. Any bytes are safe: they give a mesh or a RavelError. */
export function decode(data: Bytes, options?: DecodeOptions): Promise<Mesh>;
/** Reads headers only. */
export function info(data: Bytes): Promise<Info>;

/** Resolves once the functions below may be called. */
export function ready(): Promise<void>;
export function decodeSync(data: Bytes, options?: DecodeOptions): Mesh;
export function infoSync(data: Bytes): Info;

export type StreamPart =
    | { type: 'loaded'; bytes: number }
    | { type: 'info'; info: Info }
    | { type: 'mesh'; mesh: Mesh & { strip: Strip } }
    /** The next cells along the strip: strip.cell[first .. first + count). They and those before
     *  need no point at or above `points`. */
    | { type: 'range'; first: number; count: number; points: number };

/** A file that arrives in pieces (Response, ReadableStream or any async iterable of bytes), a mesh
 *  that leaves in ranges of the strip. */
export function decodeStream(
    source: Response | ReadableStream<Uint8Array> | AsyncIterable<Uint8Array>,
    options?: DecodeOptions & { rangeCells?: number },
): AsyncGenerator<StreamPart, void, void>;

/** The edges of polygons, each once, two points each: the index of a THREE.LineSegments. */
export function edgesOf(polygons: Polygons): Uint32Array;
