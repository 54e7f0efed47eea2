/** Loads .ravel files into three.js. Used as DRACOLoader is. */
import type { BufferGeometry, Loader, LoadingManager } from 'three';
import type { Attribute, Bytes, Strip } from './ravel-decoder';

export { RavelError } from './ravel-decoder';

export interface RavelDecodeOptions {
    /** What a volume becomes: its boundary, or the four triangles of every tet. Default: 'surface'. */
    tets?: 'surface' | 'cells';
    /** Groups of triangles by material or region. Default: true. */
    groups?: boolean;
    /** All, none, or those with these names. Default: true. */
    attributes?: boolean | string[];
    /** Adds `ravel.strip`. Default: false. */
    strip?: boolean;
    /** Bytes the decoder may take. Default: 2 GiB. */
    memoryLimit?: number;
}

/** Attributes `position`, and where the file has them `normal`, `uv`, `color` (linear), and every other
 *  attribute of points under its own name. Copies of the geometry have neither `edges` nor `ravel`. */
export interface RavelGeometry extends BufferGeometry {
    /** The edges of the original polygons (not of the triangles), for LineSegments. */
    edges: BufferGeometry;
    ravel: {
        kind: 'polygon' | 'tet';
        pointCount: number;
        cellCount: number;
        /** The attribute that made the groups; group i has materialIndex i. */
        groupedBy?: string;
        groups: { start: number; count: number; value: number; name: string }[];
        /** The cell each triangle is a part of. */
        triangleCells: Uint32Array;
        /** Attributes of cells, by name. */
        cellData: Record<string, Attribute>;
        tagNames: { attribute: string; dimension: number; value: number; name: string }[];
        notes: { key: string; text: string }[];
        strip?: Strip;
    };
}

export class RavelLoader extends Loader<RavelGeometry> {
    constructor(manager?: LoadingManager);
    /** The folder of ravel-worker.mjs; not needed where it lies beside RavelLoader.mjs. */
    setDecoderPath(path: string): this;
    /** 0: decode in the page. Default: 4. */
    setWorkerLimit(limit: number): this;
    setDecodeOptions(options: RavelDecodeOptions): this;
    preload(): this;
    load(
        url: string,
        onLoad: (geometry: RavelGeometry) => void,
        onProgress?: (event: ProgressEvent) => void,
        onError?: (error: unknown) => void,
    ): void;
    loadAsync(url: string, onProgress?: (event: ProgressEvent) => void): Promise<RavelGeometry>;
    parse(bytes: Bytes, onLoad: (geometry: RavelGeometry) => void, onError?: (error: unknown) => void): void;
    /** The bytes stay the caller's. */
    parseAsync(bytes: Bytes): Promise<RavelGeometry>;
    dispose(): this;
}
