// Tets on the stage: the surface of the cells that are wound and not cut away, or every such cell by
// itself, shrunk.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, Plane, Vector3, Vector4 } from 'three';

import { Curve } from './curve.mjs';
import { rest_material, surface_material } from './material.mjs';
import { FACETS } from './tets.mjs';

const NONE = 0xffffffff;

// Triangles in buffers that grow, three vertices each.
class Soup {
    constructor(geometry) {
        this.geometry = geometry;
        this.room(1024);
    }
    room(triangles) {
        this.capacity = triangles;
        const attribute = (Type, width, normalized) => new BufferAttribute(new Type(3 * width * triangles), width, normalized).setUsage(DynamicDrawUsage);
        this.attributes = { position: attribute(Float32Array, 3), normal: attribute(Int16Array, 4, true), aValue: attribute(Float32Array, 1) };
        for (const [name, a] of Object.entries(this.attributes)) this.geometry.setAttribute(name, a);
    }
}

export class TetView extends Group {
    constructor(model, look) {
        super();
        this.model = model;
        this.look = look;
        const { bounds } = model.draw;
        this.bound_of = new Int32Array(4 * model.cellCount).fill(-1);
        bounds.forEach((facet, b) => { this.bound_of[facet] = b; });
        this.soup = new Soup(new BufferGeometry());
        this.surface = new Mesh(this.soup.geometry, surface_material(look, { triangles: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
        this.rest = new Mesh(this.boundary(), rest_material(0x888888));
        this.rest.renderOrder = 1;
        this.curve = new Curve(model, true);
        this.plane = { value: new Vector4(0, 0, 0, 1) };  // cells with dot(xyz, centre) > w are cut away
        this.shrink = { value: 0 };
        for (const object of [this.surface, this.rest]) object.frustumCulled = false;
        this.add(this.surface, this.rest, this.curve);
    }

    boundary() {
        const { bounds, tets, points } = this.model.draw, index = new Uint32Array(3 * bounds.length);
        bounds.forEach((facet, b) => {
            for (let i = 0; i < 3; ++i) index[3 * b + i] = tets[(facet & ~3) + FACETS[3 * (facet & 3) + i]];
        });
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', new BufferAttribute(points, 3));
        geometry.setIndex(new BufferAttribute(index, 1));
        geometry.computeVertexNormals();
        return geometry;
    }

    // All cells as instances of one tet; made when first wanted, for it takes 52 bytes a cell.
    make_cells() {
        if (this.cells !== undefined) return;
        const { tets, points } = this.model.draw, geometry = new InstancedBufferGeometry(), cells = this.model.cellCount;
        const which = new Float32Array(4 * 12), corners = [0, 1, 2, 3].map(() => new Float32Array(3 * cells));
        FACETS.forEach((corner, v) => { which[4 * v + corner] = 1; });
        for (let k = 0; k < 4 * cells; ++k)
            for (let axis = 0; axis < 3; ++axis) corners[k & 3][3 * (k >> 2) + axis] = points[3 * tets[k] + axis];
        geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * 12), 3));
        geometry.setAttribute('which', new BufferAttribute(which, 4));
        corners.forEach((array, i) => geometry.setAttribute(`corner${i}`, new InstancedBufferAttribute(array, 3)));
        this.cell_values = new InstancedBufferAttribute(new Float32Array(cells), 1);
        geometry.setAttribute('aValue', this.cell_values);
        const material = surface_material(this.look, {
            triangles: true, flatShading: true,
            declare: 'attribute vec4 which; attribute vec3 corner0, corner1, corner2, corner3; uniform vec4 plane; uniform float shrink;',
            place: `vec3 centre = (corner0 + corner1 + corner2 + corner3) * 0.25;
                transformed = which.x * corner0 + which.y * corner1 + which.z * corner2 + which.w * corner3;
                transformed = dot(plane.xyz, centre) > plane.w ? centre : mix(transformed, centre, shrink);`,
        });
        material.userData.uniforms = { plane: this.plane, shrink: this.shrink };
        this.cells = new Mesh(geometry, material);
        this.cells.frustumCulled = false;
        this.add(this.cells);
        this.colour_cells();
    }

    // A cell by itself has one colour: of its corners' values the mean.
    colour_cells() {
        const { place, read } = this.values, { tets } = this.model.draw, { cell } = this.model.strip, values = this.cell_values.array;
        for (let k = 0; k < values.length; ++k) {
            if (place === 'cell') values[k] = read(cell[k]);
            if (place !== 'point') continue;
            let sum = 0;
            for (let i = 0; i < 4; ++i) sum += read(tets[4 * k + i]) / 4;
            values[k] = Math.min(sum, 3e38);
        }
        this.cell_values.needsUpdate = true;
    }

    colour(values) {
        this.values = values;
        if (this.cells !== undefined) this.colour_cells();
        this.stale = true;
    }

    // Facets between cells that are kept and cells that are not.
    fill({ steps, plane }) {
        const { tets, points, twins, centres, normals } = this.model.draw, { cell } = this.model.strip, { place, read } = this.values;
        const kept = new Uint8Array(this.model.cellCount), { x, y, z, w } = plane;
        const cut = x !== 0 || y !== 0 || z !== 0;
        for (let k = 0; k < steps; ++k)
            kept[k] = cut && x * centres[3 * k] + y * centres[3 * k + 1] + z * centres[3 * k + 2] > w ? 0 : 1;
        let count = 0;
        for (let f = 0; f < 4 * steps; ++f) if (kept[f >> 2] && (twins[f] === NONE || !kept[twins[f] >> 2])) ++count;
        if (count > this.soup.capacity || 4 * count < this.soup.capacity) {
            this.soup.geometry.dispose();
            this.soup.room(Math.max(1024, Math.ceil(1.25 * count)));
        }
        const { position, normal, aValue } = this.soup.attributes, p = position.array, n = normal.array, v = aValue.array;
        let at = 0;
        for (let f = 0; f < 4 * steps; ++f) {
            const k = f >> 2;
            if (!kept[k] || (twins[f] !== NONE && kept[twins[f] >> 2])) continue;
            const base = 3 * (f & 3), value = place === 'cell' ? read(cell[k]) : 0;
            for (let i = 0; i < 3; ++i) {
                const point = tets[4 * k + FACETS[base + i]];
                p[9 * at + 3 * i] = points[3 * point];
                p[9 * at + 3 * i + 1] = points[3 * point + 1];
                p[9 * at + 3 * i + 2] = points[3 * point + 2];
                v[3 * at + i] = place === 'point' ? read(point) : value;
            }
            const bound = this.bound_of[f];
            if (bound >= 0) {
                for (let i = 0; i < 12; ++i) n[12 * at + i] = normals[12 * bound + i];
            } else {
                const q = 9 * at, ux = p[q + 3] - p[q], uy = p[q + 4] - p[q + 1], uz = p[q + 5] - p[q + 2];
                const vx = p[q + 6] - p[q], vy = p[q + 7] - p[q + 1], vz = p[q + 8] - p[q + 2];
                const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
                const scale = 32767 / (Math.hypot(nx, ny, nz) || 1);
                for (let i = 0; i < 3; ++i) {
                    n[12 * at + 4 * i] = nx * scale;
                    n[12 * at + 4 * i + 1] = ny * scale;
                    n[12 * at + 4 * i + 2] = nz * scale;
                }
            }
            ++at;
        }
        for (const [attribute, width] of [[position, 9], [normal, 12], [aValue, 3]]) {
            attribute.clearUpdateRanges();
            attribute.addUpdateRange(0, width * at);
            attribute.needsUpdate = true;
        }
        this.soup.geometry.setDrawRange(0, 3 * at);
        this.facets = at;
    }

    show({ steps, edges, curve, links, rest, smooth, clip, shrink }) {
        const plane = this.plane.value, whole = steps === this.model.cellCount && !clip;
        if (clip) plane.set(...clip);
        else plane.set(0, 0, 0, 1);
        this.curve.clip(clip ? [new Plane(new Vector3(-plane.x, -plane.y, -plane.z), plane.w)] : []);
        this.look.lines.value = edges ? this.edge_strength : 0;
        const apart = shrink > 0;
        if (apart) {
            this.make_cells();
            this.shrink.value = shrink;
            this.cells.geometry.instanceCount = steps;
        }
        if (this.cells !== undefined) this.cells.visible = apart && steps > 0;
        const asked = [steps, plane.x, plane.y, plane.z, plane.w].join();
        if (!apart && (this.stale || asked !== this.filled)) {
            this.fill({ steps, plane });
            this.filled = asked;
            this.stale = false;
        }
        this.surface.visible = !apart && this.facets > 0;
        this.rest.visible = rest && !whole && !clip;
        this.curve.wind(steps);
        this.curve.show(curve, links);
        // The curve runs inside: with it, surfaces become glass.
        for (const { material } of [this.surface, this.cells ?? []].flat()) {
            if (material.transparent === curve) continue;
            material.transparent = curve;
            material.opacity = curve ? 0.13 : 1;
            material.depthWrite = !curve;
            material.needsUpdate = true;
        }
        if (this.surface.material.flatShading === smooth) {
            this.surface.material.flatShading = !smooth;
            this.surface.material.needsUpdate = true;
        }
    }

    paint(theme) {
        this.edge_strength = theme.lines;
        this.rest.material.color.set(theme.rest);
        this.curve.paint(theme);
    }
    before_draw(stage) {
        this.curve.before_draw(stage);
    }
    dispose() {
        for (const part of [this.surface, this.rest, this.cells ?? []].flat()) part.geometry.dispose(), part.material.dispose();
        this.curve.dispose();
    }
}
