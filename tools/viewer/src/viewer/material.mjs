// Lit surfaces whose colour is a value looked up in a ramp or a palette.
import { Color, DataTexture, DoubleSide, LinearFilter, MeshStandardMaterial, NearestFilter, SRGBColorSpace } from 'three';

import { palette_bytes, PALETTE_SIZE, ramp_bytes } from './colours.mjs';

function texture_of(bytes, filter) {
    const texture = new DataTexture(bytes, bytes.length / 4, 1);
    texture.colorSpace = SRGBColorSpace;
    texture.minFilter = texture.magFilter = filter;
    texture.needsUpdate = true;
    return texture;
}

// Shared by all materials: one change recolours everything.
export function new_look() {
    return {
        ramp: { value: texture_of(ramp_bytes(), LinearFilter) },
        palette: { value: texture_of(palette_bytes(), NearestFilter) },
        mode: { value: 1 },  // 0: plain, 1: ramp, 2: palette
        low: { value: 0 }, high: { value: 1 },
        plain: { value: new Color() }, missing: { value: new Color() }, line: { value: new Color() },
        lines: { value: 1 },  // how much of the edges shows
        pixel: { value: 1 },  // device pixels per CSS pixel
    };
}

const COLOUR = /* glsl */ `
    if (mode == 0) diffuseColor.rgb = plain;
    else if (vValue > 1e30) diffuseColor.rgb = missing;
    else if (mode == 1) diffuseColor.rgb = texture2D(ramp, vec2((vValue - low) / (high - low) * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
    else diffuseColor.rgb = texture2D(palette, vec2((floor(vValue + 0.5) + 0.5) / ${PALETTE_SIZE}.0, 0.5)).rgb;`;

// Edges of single triangles, by how near each of their sides is. They fade where triangles are hardly
// larger than a pixel.
const EDGES = /* glsl */ `
    vec3 across = fwidth(vSides);
    vec3 inked = 1.0 - smoothstep(across * 0.35 * pixel, across * (0.35 * pixel + 1.0), vSides);
    float small = max(across.x, max(across.y, across.z));
    diffuseColor.rgb = mix(diffuseColor.rgb, line, max(inked.x, max(inked.y, inked.z)) * lines * (1.0 - smoothstep(0.12, 0.5, small)));`;

// `triangles`: vertices come in threes, each triangle with its edges drawn. `place`: GLSL that moves a
// vertex, with what it declares.
export function surface_material(look, { triangles = false, declare = '', place = '', ...options } = {}) {
    const material = new MeshStandardMaterial({ side: DoubleSide, roughness: 0.72, metalness: 0, ...options });
    material.onBeforeCompile = (shader) => {
        Object.assign(shader.uniforms, look, material.userData.uniforms);
        shader.vertexShader = shader.vertexShader
            .replace('#include <common>', `#include <common>
                attribute float aValue;
                varying float vValue;
                ${triangles ? 'varying vec3 vSides;' : ''}
                ${declare}`)
            .replace('#include <begin_vertex>', `#include <begin_vertex>
                vValue = aValue;
                ${triangles ? 'vSides = vec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2)));' : ''}
                ${place}`);
        shader.fragmentShader = shader.fragmentShader
            .replace('#include <common>', `#include <common>
                uniform sampler2D ramp, palette;
                uniform int mode;
                uniform float low, high, lines, pixel;
                uniform vec3 plain, missing, line;
                varying float vValue;
                ${triangles ? 'varying vec3 vSides;' : ''}`)
            .replace('#include <color_fragment>', `${COLOUR}\n${triangles ? EDGES : ''}`);
    };
    material.customProgramCacheKey = () => `${triangles} ${place.length}`;
    return material;
}

// What is not wound yet: the same surface, hardly there.
export function rest_material(colour) {
    return new MeshStandardMaterial({ color: colour, side: DoubleSide, transparent: true, opacity: 0.16, depthWrite: false, roughness: 1 });
}
