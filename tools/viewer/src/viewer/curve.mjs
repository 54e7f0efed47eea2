// The strip as a curve through the centres of its cells, and its links as marks. Both are in the order
// of the strip: what is wound is a prefix.
import { BufferAttribute, BufferGeometry, CanvasTexture, Color, Group, InstancedInterleavedBuffer,
    InterleavedBufferAttribute, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

import { ramp_bytes } from './colours.mjs';

const NONE = 0xffffffff;
// Above this lines are a pixel wide: so dense a curve would be a blot otherwise.
const MOST_WIDE = 150_000;

// Two segments per step: from the cell the strip came from through the shared side to the next cell.
function segments_of({ centres, gates }, from) {
    const steps = from.length, ends = new Float32Array(12 * steps), begin = new Uint32Array(steps + 1);
    let at = 0;
    for (let k = 0; k < steps; ++k) {
        if (from[k] !== NONE) {
            const a = 3 * from[k], b = 3 * k;
            for (let i = 0; i < 3; ++i) {
                ends[at + i] = centres[a + i];
                ends[at + 3 + i] = ends[at + 6 + i] = gates[b + i];
                ends[at + 9 + i] = centres[b + i];
            }
            at += 12;
        }
        begin[k + 1] = at / 6;
    }
    return { ends: ends.subarray(0, at), begin };
}

// Half the way from cell to cell: the mean of some segments.
function typical_length(ends) {
    const step = 6 * Math.max(1, Math.floor(ends.length / 6 / 4000));
    let sum = 0, count = 0;
    for (let e = 0; e + 5 < ends.length; e += step, ++count)
        sum += Math.hypot(ends[e] - ends[e + 3], ends[e + 1] - ends[e + 4], ends[e + 2] - ends[e + 5]);
    return count ? sum / count : 1;
}

// A colour per end, by how far along the strip it is.
function colours_of(begin) {
    const bytes = ramp_bytes(), steps = begin.length - 1, colour = new Color();
    const linear = new Float32Array(3 * 256);
    for (let i = 0; i < 256; ++i) colour.setRGB(bytes[4 * i] / 255, bytes[4 * i + 1] / 255, bytes[4 * i + 2] / 255, 'srgb').toArray(linear, 3 * i);
    const colours = new Float32Array(6 * begin[steps]);
    for (let k = 0; k < steps; ++k) {
        const entry = 3 * Math.floor((255 * k) / Math.max(1, steps - 1));
        for (let end = 6 * begin[k]; end < 6 * begin[k + 1]; ++end) colours[end] = linear[entry + (end % 3)];
    }
    return colours;
}

function disc() {
    const canvas = document.createElement('canvas'), size = 64;
    canvas.width = canvas.height = size;
    const pen = canvas.getContext('2d');
    pen.fillStyle = '#fff';
    pen.beginPath();
    pen.arc(size / 2, size / 2, size / 2 - 2, 0, 2 * Math.PI);
    pen.fill();
    return new CanvasTexture(canvas);
}

export class Curve extends Group {
    // `rainbow`: coloured along the strip, where there is no surface under it that is.
    constructor({ draw, strip }, rainbow) {
        super();
        const { ends, begin } = segments_of(draw, strip.from);
        this.begin = begin;
        this.rainbow = rainbow;
        const colours = rainbow ? colours_of(begin) : undefined;
        this.wide = begin.length <= MOST_WIDE;
        if (this.wide) {
            const geometry = new LineSegmentsGeometry();
            const buffer = new InstancedInterleavedBuffer(ends, 6, 1);
            geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(buffer, 3, 0));
            geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(buffer, 3, 3));
            if (rainbow) {
                const inks = new InstancedInterleavedBuffer(colours, 6, 1);
                geometry.setAttribute('instanceColorStart', new InterleavedBufferAttribute(inks, 3, 0));
                geometry.setAttribute('instanceColorEnd', new InterleavedBufferAttribute(inks, 3, 3));
            }
            this.line = new LineSegments2(geometry, new LineMaterial({ linewidth: 2.2, vertexColors: rainbow }));
        } else {
            const geometry = new BufferGeometry();
            geometry.setAttribute('position', new BufferAttribute(ends, 3));
            if (rainbow) geometry.setAttribute('color', new BufferAttribute(colours, 3));
            this.line = new LineSegments(geometry, new LineBasicMaterial({ transparent: true, opacity: 0.7, vertexColors: rainbow }));
        }
        this.line.frustumCulled = false;
        this.stride = typical_length(ends);
        this.linkSteps = strip.linkSteps;
        const marks = new Float32Array(3 * strip.linkSteps.length);
        strip.linkSteps.forEach((step, i) => marks.set(draw.gates.subarray(3 * step, 3 * step + 3), 3 * i));
        const geometry = new BufferGeometry();
        geometry.setAttribute('position', new BufferAttribute(marks, 3));
        this.links = new Points(geometry, new PointsMaterial({ size: 9, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }));
        this.links.frustumCulled = false;
        this.links.renderOrder = 2;
        this.add(this.line, this.links);
    }

    // Shows the first `steps` steps.
    wind(steps) {
        const count = this.begin[steps];
        if (this.wide) this.line.geometry.instanceCount = count;
        else this.line.geometry.setDrawRange(0, 2 * count);
        let low = 0, high = this.linkSteps.length;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.linkSteps[middle] < steps) low = middle + 1;
            else high = middle;
        }
        this.links.geometry.setDrawRange(0, low);
        // Drawn with a count of 0 some drivers draw everything.
        this.line.userData.empty = count === 0;
        this.links.userData.empty = low === 0;
    }
    show(curve, links) {
        this.line.visible = curve && !this.line.userData.empty;
        this.links.visible = links && !this.links.userData.empty;
    }
    // Cuts away what is on the far side of a plane.
    clip(planes) {
        this.line.material.clippingPlanes = this.links.material.clippingPlanes = planes;
    }
    // Thinner where cells are small, so that windings stay apart.
    before_draw(stage) {
        if (!this.wide) return;
        const pixels = (this.stride * stage.pixels_per_unit()) / stage.renderer.getPixelRatio();
        this.line.material.linewidth = Math.min(2.4, Math.max(0.8, 0.45 * pixels));
    }
    paint({ ink, accent, pixel }) {
        this.line.material.color.set(this.rainbow ? '#fff' : ink);
        this.links.material.color.set(accent);
        this.links.material.size = 9 * pixel;
    }
    dispose() {
        for (const part of [this.line, this.links]) part.geometry.dispose(), part.material.dispose();
    }
}
