// Polygons on the stage: the wound part, the rest as a shadow of itself, edges, curve and links.
import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Mesh } from 'three';

import { Curve } from './curve.mjs';
import { rest_material, surface_material } from './material.mjs';

export class PolygonView extends Group {
    constructor(model, look) {
        super();
        const { draw } = model;
        this.model = model;
        this.look = look;
        const part = () => {
            const geometry = new BufferGeometry();
            geometry.setIndex(this.index);
            for (const [name, attribute] of Object.entries(this.attributes)) geometry.setAttribute(name, attribute);
            return geometry;
        };
        this.index = new BufferAttribute(draw.index, 1);
        this.values = new BufferAttribute(new Float32Array(draw.pointOf.length), 1);
        this.attributes = {
            position: new BufferAttribute(draw.positions, 3), aValue: this.values,
            normal: new BufferAttribute(draw.normals, 4, true),
        };
        this.surface = new Mesh(part(), surface_material(look, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
        this.rest = new Mesh(part(), rest_material(0x888888));
        this.rest.renderOrder = 1;
        const lines = new BufferGeometry();
        lines.setAttribute('position', this.attributes.position);
        lines.setIndex(new BufferAttribute(draw.edges, 1));
        this.edges = new LineSegments(lines, new LineBasicMaterial({ transparent: true }));
        this.curve = new Curve(model, false);
        for (const object of [this.surface, this.rest, this.edges]) object.frustumCulled = false;
        this.add(this.surface, this.rest, this.edges, this.curve);
        this.edge_length = this.typical_edge();
    }

    // The mean of some edges, in drawn units.
    typical_edge() {
        const { edges, positions } = this.model.draw, step = 2 * Math.max(1, Math.floor(edges.length / 4000));
        let sum = 0, count = 0;
        for (let e = 0; e + 1 < edges.length; e += step, ++count) {
            const a = 3 * edges[e], b = 3 * edges[e + 1];
            sum += Math.hypot(positions[a] - positions[b], positions[a + 1] - positions[b + 1], positions[a + 2] - positions[b + 2]);
        }
        return count ? sum / count : 1;
    }

    colour({ place, read }) {
        const { begin, pointOf, cornerOf } = this.model.draw, { cell } = this.model.strip, values = this.values.array;
        for (let k = 0; k < cell.length && place === 'cell'; ++k) values.fill(read(cell[k]), begin[k], begin[k + 1]);
        if (place === 'point') for (let c = 0; c < values.length; ++c) values[c] = read(pointOf[c]);
        if (place === 'corner') for (let c = 0; c < values.length; ++c) values[c] = read(cornerOf[c]);
        this.values.needsUpdate = true;
    }

    show({ steps, edges, curve, links, rest, smooth }) {
        const { triangleBegin, edgeBegin, index } = this.model.draw, wound = triangleBegin[steps];
        this.surface.geometry.setDrawRange(0, wound);
        this.surface.visible = wound > 0;
        this.rest.geometry.setDrawRange(wound, index.length - wound);
        this.rest.visible = rest && wound < index.length;
        this.edges.geometry.setDrawRange(0, edgeBegin[steps]);
        this.edges.visible = edges && edgeBegin[steps] > 0;
        this.curve.wind(steps);
        this.curve.show(curve, links);
        if (this.surface.material.flatShading === smooth) {
            this.surface.material.flatShading = !smooth;
            this.surface.material.needsUpdate = true;
        }
    }

    paint(theme) {
        this.edges.material.color.set(theme.line);
        this.edge_strength = theme.lines;
        this.rest.material.color.set(theme.rest);
        this.curve.paint(theme);
    }
    // Edges fade where cells are hardly larger than a pixel.
    before_draw(stage) {
        this.curve.before_draw(stage);
        const pixels = (this.edge_length * stage.pixels_per_unit()) / stage.renderer.getPixelRatio();
        this.edges.material.opacity = this.edge_strength * Math.min(1, Math.max(0.04, (pixels - 1.5) / 9));
    }
    dispose() {
        for (const part of [this.surface, this.rest, this.edges]) part.geometry.dispose(), part.material.dispose();
        this.curve.dispose();
    }
}
