// Loads .ravel files into three.js, in workers. Used as DRACOLoader is:
//     const loader = new RavelLoader();
//     const geometry = await loader.loadAsync('chair.ravel');
//     scene.add(new Mesh(geometry, material), new LineSegments(geometry.edges, lines));
import { BufferAttribute, BufferGeometry, FileLoader, Loader } from 'three';

import { RavelError } from './reply.mjs';

export { RavelError } from './reply.mjs';

const WORKER = 'ravel-worker.mjs';

function buffer_geometry({ attributes, index, edges, groups, ...rest }) {
    const geometry = new BufferGeometry();
    for (const [name, { array, arity }] of Object.entries(attributes))
        geometry.setAttribute(name, new BufferAttribute(array, arity));
    geometry.setIndex(new BufferAttribute(index, 1));
    groups.forEach(({ start, count }, material) => geometry.addGroup(start, count, material));
    // Line segments over the same vertices.
    geometry.edges = new BufferGeometry();
    geometry.edges.setAttribute('position', geometry.getAttribute('position'));
    geometry.edges.setIndex(new BufferAttribute(edges, 1));
    geometry.ravel = { ...rest, groups };
    return geometry;
}

export class RavelLoader extends Loader {
    constructor(manager) {
        super(manager);
        this.decoderPath = undefined;
        this.workerLimit = 4;
        this.options = {};
        this.workers = [];
        this.next_id = 1;
    }

    // The folder that ravel-worker.mjs lies in; not needed where it lies beside this file.
    setDecoderPath(path) {
        this.decoderPath = new URL(path.endsWith('/') ? path : `${path}/`, globalThis.location?.href ?? import.meta.url).href;
        return this;
    }
    // 0: decode in the page.
    setWorkerLimit(limit) {
        this.workerLimit = limit;
        return this;
    }
    // {tets: 'surface' | 'cells', groups, attributes, strip, memoryLimit}
    setDecodeOptions(options) {
        this.options = { ...options };
        return this;
    }

    preload() {
        if (this.has_workers()) this.take_worker();
        else this.page_decoder();
        return this;
    }

    load(url, onLoad, onProgress, onError) {
        const loader = new FileLoader(this.manager);
        loader.setPath(this.path);
        loader.setResponseType('arraybuffer');
        loader.setRequestHeader(this.requestHeader);
        loader.setWithCredentials(this.withCredentials);
        loader.load(url, (bytes) => this.parse(bytes, onLoad, onError), onProgress, onError);
    }

    parse(bytes, onLoad, onError = (error) => console.error(error)) {
        this.parseAsync(bytes).then(onLoad).catch(onError);
    }

    // Copies `bytes`: they stay the caller's.
    async parseAsync(bytes) {
        const { geometry, error } = this.has_workers()
            ? await this.ask_worker(bytes)
            : await (await this.page_decoder()).answer(bytes, this.options);
        if (error !== undefined) throw new RavelError(error.code, error.at, error.detail);
        return buffer_geometry(geometry);
    }

    dispose() {
        for (const { worker, tasks } of this.workers) {
            worker.terminate();
            for (const { fail } of tasks.values()) fail(new Error('the loader was disposed of'));
        }
        this.workers.length = 0;
        return this;
    }

    has_workers() {
        return this.workerLimit > 0 && typeof Worker === 'function';
    }

    page_decoder() {
        this.page ??= this.decoderPath === undefined ? import('./ravel-worker.mjs') : import(this.decoderPath + WORKER);
        return this.page;
    }

    new_worker() {
        if (this.decoderPath === undefined)
            return new Worker(new URL('./ravel-worker.mjs', import.meta.url), { type: 'module' });
        const url = this.decoderPath + WORKER;
        if (new URL(url).origin === globalThis.location?.origin) return new Worker(url, { type: 'module' });
        // A page may not start another site's worker, but its own may import from there.
        const source = URL.createObjectURL(new Blob([`import ${JSON.stringify(url)};`], { type: 'text/javascript' }));
        return new Worker(source, { type: 'module' });
    }

    // The worker with the fewest bytes to decode; a new one while all are busy and the limit allows.
    take_worker() {
        const load = (entry) => [...entry.tasks.values()].reduce((sum, { cost }) => sum + cost, 0);
        const idle = this.workers.reduce((best, entry) => (best && load(best) <= load(entry) ? best : entry), undefined);
        if (idle && (idle.tasks.size === 0 || this.workers.length >= this.workerLimit)) return idle;
        const entry = { worker: this.new_worker(), tasks: new Map() };
        entry.worker.onmessage = ({ data }) => {
            entry.tasks.get(data.id)?.done(data);
            entry.tasks.delete(data.id);
        };
        entry.worker.onerror = (event) => {
            event.preventDefault?.();
            this.workers = this.workers.filter((other) => other !== entry);
            for (const { fail } of entry.tasks.values()) fail(new Error(`the worker stopped: ${event.message ?? 'it did not load'}`));
        };
        this.workers.push(entry);
        return entry;
    }

    ask_worker(bytes) {
        return new Promise((done, fail) => {
            const entry = this.take_worker(), id = this.next_id++;
            const copy = ArrayBuffer.isView(bytes)
                ? bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) : bytes.slice(0);
            entry.tasks.set(id, { done, fail, cost: copy.byteLength + 1 });
            entry.worker.postMessage({ id, bytes: copy, options: this.options }, [copy]);
        });
    }
}
